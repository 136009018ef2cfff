"""A scene answered twice: each number of the program beside that of the mechanics here."""

import ast
import random
import re
from collections import Counter, namedtuple

import numpy as np

from . import coverage, doors, friction, mechanics, motion, other_doors, signals, words
from .figure import Figure

Difference = namedtuple("Difference", "what expected found")
EXACT, IN_TIME, IN_FULL = 1e-9, 1e-8, 1e-6
FRF_EACH, SIGNALS = 7, 6
TIMES, FULL_EACH, EQUATIONS_EACH = (0.11, 0.74), 23, 9


class Comparison:
    """One scene; `path` is a file that holds its text. What disagrees gathers in `differences`."""

    def __init__(self, text, path, command="solve"):
        self.text, self.path, self.differences, self.refusals, self.compared = text, path, [], [], 0
        self.kinds = Counter()      # of what was compared
        self.instants = {}          # {full: {quantity: value}} of motions in time
        self.rubs = "friction:" in text
        self.data = doors.data("solve" if self.rubs else command, path)
        self.figure = figure_of(text, self.data["coordinates"], folder=path.parent)
        if self.rubs:
            self.q = [self.figure.drawn_values[name] for name in self.figure.independent]
        else:
            self.q = self._equilibrium()
            self.small = mechanics.small(self.figure, self.q)

    def meet(self, what, expected, found, tolerance):
        self.compared += 1
        if not abs(expected - found) <= tolerance:
            self.differences.append(Difference(what, expected, found))

    def _equilibrium(self):
        """The program's, if the forces vanish there and no other lies between: polished by Newton's method."""
        names = self.figure.independent
        given = self.figure.scene.get("equilibrium", {})
        start = [self.figure.number(given[name]) if name in given else self.figure.drawn_values[name]
                 for name in names]
        theirs = self.data["equilibrium"]["coordinates"]
        ours = mechanics.equilibrium(self.figure, start)
        if ours is None or max(abs(a - theirs[n]) for a, n in zip(ours, names, strict=True)) > 1e-3:
            ours = mechanics.equilibrium(self.figure, [theirs[name] for name in names]) or start
        for name, value in zip(names, ours, strict=True):
            self.meet(f"equilibrium[{name}]", value, theirs[name], EXACT * max(1, abs(value)))
        return ours

    def matrices(self, data=None, door=""):
        n = len(self.q)
        zero = np.zeros((n, n))
        given = (data or self.data)["matrices"]
        found = {key: zero if given[key] is None else np.array(given[key]) for key in "MCGK"}
        for key, ours, theirs in (("M", self.small.M, found["M"]), ("C", self.small.C, found["C"] + found["G"]),
                                  ("K", self.small.K, found["K"])):
            scale = max(np.abs(ours).max(), np.abs(theirs).max(), 1e-6 * np.abs(self.small.K).max())
            for i in range(n):
                for j in range(n):
                    self.meet(f"{door}{key}[{i + 1},{j + 1}]", ours[i, j], theirs[i, j], EXACT * scale)

    def eigenvalues(self, data=None, door=""):
        data = data or self.data
        gyroscopic = self.small.C - (self.small.C + self.small.C.T) / 2
        natural = [value for mode in data["modes"] for value in _of_mode(mode)]
        self._match(door + "eigenvalue of the undamped system", spectrum(self.small, gyroscopic), natural)
        if data.get("damped"):
            damped = [complex(re, sign * im) for re, im in (mode["eigenvalue"] for mode in data["damped"])
                      for sign in ((1, -1) if im else (1,))]
            self._match(door + "eigenvalue", spectrum(self.small, self.small.C), damped)

    def _match(self, what, ours, theirs):
        """Each of ours has one of theirs nearby, those of the square root of rounding being let through near zero."""
        scale, left = max(abs(ours)), list(theirs)
        self.meet("number of values: " + what, len(ours), len(theirs), 0)
        for value in sorted(ours, key=abs, reverse=True):
            if not left:
                return
            near = min(left, key=lambda other: abs(other - value))
            left.remove(near)
            defect = abs(value - near) * max(abs(value), abs(near), 1e-7 * scale)
            self.meet(what, value, near, abs(value - near) if defect <= 1e-9 * abs(value) ** 2 + 1e-12 * scale**2
                      else 0)

    def equations(self, dice):
        """The printed equations of motion and T at random states, up to a factor for each equation."""
        n, names, rows = len(self.q), self.figure.independent, []
        texts = [equation["text"] for equation in self.data["equations"]]
        if len(texts) != n:             # with multipliers, of closed loops
            return
        trees = [[words.read(side) for side in text.split("=")] if text else None for text in texts]
        kinetic = words.read(self.data["energies"]["T"])
        for _ in range(3):
            t = dice.uniform(0.01, 1)
            u, u1, u2 = self.figure.driven(t)
            q, v, a = ([x + dice.uniform(-size, size) for x in at] for at, size in (
                (self.q, 0.05), ([0.0] * n, 0.5), ([0.0] * n, 2.0)))
            state = mechanics.State(q, v, a, u, u1, u2)
            known = {**self.figure.parameters, "t": t, **{
                name + mark: value for mark, values in (("", q), ("__1", v), ("__2", a))
                for name, value in zip(names, values, strict=True)}}
            self.figure.held = friction.slipping(self.figure, state)
            ours = mechanics.residual(self.figure, state, t)
            self.figure.held = {}
            rows.append([(ours[i], _difference(tree, known, self.figure)) for i, tree in enumerate(trees)])
            if not self.figure.drives and set(words.names(kinetic)) <= set(known):
                T = signals.energies(self.figure, state)["T"]
                self.meet("T", T, words.value(kinetic, known, self.figure.literal), EXACT * abs(T))
        for i, name in enumerate(names):
            ours, theirs = (np.array([row[i][side] for row in rows], dtype=float) for side in (0, 1))
            if np.isnan(theirs).any():
                continue
            factor = ours @ theirs / (theirs @ theirs) if theirs.any() else 0.0
            for one, other in zip(ours, factor * theirs, strict=True):
                self.meet(f"motion[{name}]", one, other, EXACT * np.abs(ours).max())

    def start(self):
        initial, names = self.figure.scene.get("initial", {}), self.figure.independent
        q0 = [self.figure.number(initial[name]) if name in initial else at
              for name, at in zip(names, self.q, strict=True)]
        v0 = [self.figure.number(initial.get(name + "'", "0")) for name in names]
        return q0, v0

    def in_time(self, times, dice, full=False):
        """Coordinates and velocities at instants."""
        names = self.figure.independent
        q0, v0 = self.start()
        if full:
            found = (friction if self.rubs else motion).full_motion(self.figure, [*q0, *v0], times)
        else:
            start = [*(a - b for a, b in zip(q0, self.q, strict=True)), *v0]
            found = motion.small_motion(self.figure, self.small, start, times)
        ours, largest = {}, 1e-6
        for t, (q, v) in zip(times, found, strict=True):
            for name, x, rate in zip(names, q, v, strict=True):
                ours[f"{name}({t} s)"], ours[f"{name}'({t} s)"] = x, rate
                largest = max(largest, abs(x), abs(rate))
        units = self._units()
        asked = {quantity: units[quantity.partition("(")[0].rstrip("'")] + ("/s" if "'" in quantity else "")
                 for quantity in ours}
        text = self.text
        if full:
            text = re.sub("motion: (full|small)\n", "", text) + (
                f"motion: full\nfind: [{{response: {{until: {times[-1]} s}}}}]\n")
        self.instants[full] = {quantity: ours[quantity] for quantity in asked}
        told = self._signals(times[-1], *found[-1], full, dice)
        asked |= {quantity: "1 " + signals.unit(self.figure, quantity.partition("(")[0]) for quantity in told}
        for quantity, value in doors.values(text, asked, self.path).items():
            if isinstance(value, doors.Refusal):
                self.refusals.append(value)
                continue
            self.kinds["full " * full + coverage.of_signal(quantity.partition("(")[0])] += 1
            size = largest if quantity in ours else max(largest, abs(told[quantity]), self._force(quantity))
            self.meet(("full " if full else "") + quantity, {**ours, **told}[quantity], value,
                      (IN_FULL if full else IN_TIME) * size)

    def _signals(self, t, q, v, full, dice):
        """Some of the signals at an instant, energies among them."""
        if any(drive.steady for drive in self.figure.drives) and not full:
            return {}
        found = signals.of_full(self.figure, q, v, t) if full else signals.of_small(self.figure, self.small, q, v, t)
        self.forces = max([0.0, *(abs(value) for name, value in found.items()
                                  if name.endswith(("force", "reaction.x", "reaction.y", "drive")))])
        kinds = {}
        for name in found:
            if name not in self.figure.coordinates and name.rstrip("'") not in self.figure.coordinates:
                kinds.setdefault(coverage.of_signal(name), []).append(name)
        some = dice.sample(list(kinds), min(SIGNALS, len(kinds)))
        return {f"{name}({t} s)": found[name] for name in (dice.choice(kinds[kind]) for kind in some)}

    def _force(self, quantity):
        """The largest force, for those that are differences of others."""
        return self.forces if re.search(r"reaction|drive|force|energy|V\(", quantity) else 0.0

    def frequency_responses(self, speeds):
        """frf[x, x] of each coordinate: what (K + iΩC − Ω²M)⁻¹ says."""
        small, units = self.small, self._units()
        for W in speeds:
            inverse = np.linalg.inv(small.K + 1j * W * small.C - W**2 * small.M)
            ours, asked = {}, {}
            for i, name in enumerate(self.figure.independent):
                for part, value in (("re", inverse[i, i].real), ("im", inverse[i, i].imag)):
                    quantity = f"{part}(frf[{name}, {name}]({W} rad/s))"
                    ours[quantity] = value
                    asked[quantity] = "1 m/N" if units[name] == "1 m" else "1 rad/N/m"
            for quantity, value in doors.values(self.text, asked, self.path).items():
                if isinstance(value, doors.Refusal):
                    raise value
                self.kinds["frf"] += 1
                self.meet(quantity, ours[quantity], value, IN_TIME * np.abs(inverse).max())

    def in_part(self, ask, *args, **options):
        """Ask for what may be refused while the rest is answered."""
        try:
            ask(*args, **options)
        except doors.Refusal as refusal:
            self.refusals.append(refusal)

    def _units(self):
        return {name: "1 m" if name.startswith("x") else "1 rad" for name in self.figure.coordinates}


def figure_of(text, coordinates, **options):
    figure = Figure(text, **options)
    figure.independent = list(coordinates)
    mechanics.settle_statics(figure)
    return figure


def spectrum(small, C):
    """The values λ of (λ² M + λ C + K) φ = 0."""
    n = len(small.q)
    inverse = np.linalg.inv(small.M)
    return np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ small.K, -inverse @ C]]))


def _of_mode(mode):
    """The values λ that a line of the table of modes stands for."""
    omega, growth = mode["omega"], mode["growth_rate"]
    if growth is None:
        return [1j * omega, -1j * omega]
    if omega is None:
        return [growth, -growth]
    return [complex(growth, omega), complex(growth, -omega)]


def _difference(tree, known, figure):
    """Left side less right side of an equation; nan where it holds what is not known here (multipliers)."""
    if tree is None or any(name not in known for side in tree for name in words.names(side)
                           if name != "pi" or isinstance(side, ast.Name)):
        return float("nan")
    left, right = (words.value(side, known, figure.literal, figure.functions) for side in tree)
    return left - right


def compared(draft, path, seed):
    """The Comparison of a drawn scene: matrices, eigenvalues, equations and motions in time."""
    dice = random.Random(f"compare {seed}")
    with_equations = seed % EQUATIONS_EACH == 0
    found = Comparison(draft.text(), path, "solve" if with_equations else "frequencies")
    if not found.rubs:
        found.matrices()
        found.eigenvalues()
    if with_equations or found.rubs:
        found.equations(dice)
    full = draft.sections.get("motion") == "full"
    if not full:
        found.in_part(found.in_time, TIMES, dice)
        if seed % FRF_EACH == 0:
            found.in_part(found.frequency_responses, (5.3,))
    if full or seed % FULL_EACH == 0:
        found.in_part(found.in_time, TIMES[:2], dice, full=True)
    if not found.rubs:
        door = list(other_doors.ALL)[seed % len(other_doors.ALL)]
        before = found.compared
        found.in_part(other_doors.ALL[door], found)
        found.kinds["door " + door] += found.compared > before
    return found
