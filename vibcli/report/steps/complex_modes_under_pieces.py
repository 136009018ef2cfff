"""Several degrees of freedom whose damping couples the modes, under loads that begin, end and strike, or any other, in
numbers by their complex modes (Foss 1958):

    q = Σ uₖ zₖ,   żₖ − λₖ zₖ = gₖᵀQ,   gₖ = uₖ/(uₖᵀ(2λₖM + C)uₖ),

each piece of a load with its particular part and, as that begins from zₖ = 0, the constant of e^{λₖτ} beside it."""

from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.complex_numbers import complex_told, factor_told, shape_told
from vibcli.report.steps.complex_unit_responses import ComplexUnitResponses, particular_and_constant
from vibcli.report.steps.from_complex_modes import ComplexMode, complex_modes_of
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.loads_on_modes import LoadsOnModes, is_of_engine
from vibcli.report.steps.motion_by_pieces import MotionByModes, MotionByPieces, PartOfMode, ToldPiece
from vibcli.report.steps.pieces import KINDS, WAVES, LoadPiece
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, indexed
from vibcli.report.steps.waves_in_numbers import know_decay
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.symbolic.node import Node

LETTERS = {"impulse": "h", "step": "s", "ramp": "r", "sin": "v", "cos": "w"}       # of unit responses
RULE = "the motion is the sum of complex modes, of the shape  "
PAIRS = ", a pair of roots adding twice the real part of one"
WEIGHTS = "s/kg", "s/(kg·m)", "s/(kg·m²)"      # units of what a mode takes of loads, by how many coordinates turn
NOTHING = 1e-9          # of a part of a shape beside others: rounding


class ComplexModesUnderLoads(NamedTuple):
    """Complex modes with their parts of the start, and {row of the load: by each mode how much of it that takes}."""

    modes: "Sequence[ComplexMode]"
    taken: "Mapping[int, Sequence[complex]]"
    started: bool


def complex_modes_under(about: AboutRest, rows: "Sequence[int]", start: "Sequence[Sequence[float]]"
                        ) -> ComplexModesUnderLoads | None:
    """Those of a scene that starts so from rest, under loads on some rows; None where they do not all die out. A mode
    takes of a load what it has of the speeds that a unit impulse of that makes."""
    import numpy as np

    n, M = len(about.scene.q), about.problem.configuration.linear_system.matrices()[0]
    masses = np.array([[M.get((i, j), 0.0) for j in range(n)] for i in range(n)])
    struck = {row: complex_modes_of(about.problem, [[0.0] * n, np.linalg.solve(masses, np.eye(n)[row]).tolist()])
              for row in rows}
    started = any(map(any, start))
    modes = complex_modes_of(about.problem, start) if started else next(iter(struck.values()))
    if not (modes and all(struck.values())):
        return None
    return ComplexModesUnderLoads(modes, {row: [mode.part for mode in found] for row, found in struck.items()}, started)


def tell_complex_modes_under(about: AboutRest, sheet: WorkedSolution, found: SmallEquations,
                             start: "Sequence[Sequence[float]]", loads: LoadsOnModes) -> bool:
    """Are they written down?"""
    under = complex_modes_under(about, loads.rows, start)
    if under is None:
        return False
    lines = ComplexModesUnderPieces(about, sheet, found, under)
    uses = lines.equations()
    if loads.pieces is not None:
        return lines.superposed(loads, uses)
    lines.integrals(uses)
    return True


class ComplexModesUnderPieces:
    """The lines of such a motion."""

    def __init__(self, about: AboutRest, sheet: WorkedSolution, found: SmallEquations,
                 under: ComplexModesUnderLoads) -> None:
        self.about, self.sheet, self.found, self.table = about, sheet, found, about.table
        self.modes, self.taken, self.started = under
        self.names, self.tau = about.scene.coordinates, about.letter(sheet.letter("tau"))
        self.units = ["m" if about.problem.system.dimension(name) else "rad" for name in self.names]
        self.z = [Name(sheet.letter(f"z{k}")) for k in range(1, len(self.modes) + 1)]

    def equations(self) -> list[int]:
        """Write down the equation of each mode; the numbers of the lines."""
        M, C, u, z, Q, root = *(Name(self.sheet.matrix(letter)) for letter in "MC"), *(
            Name(self.sheet.letter(letter)) for letter in ("u", "z", "Q", "lambda"))
        pairs, sides = any(mode.root.imag for mode in self.modes), []
        for j in self.taken:
            side = Name(self.sheet.letter(indexed(Q.text, j + 1)))
            sides += [Words(", " if sides else "  with the right sides  "), side]
        first = self.sheet.write(
            Words(RULE), u, Words("  times  "), z, Words(PAIRS * pairs + ":  "), u, "·(2·", root, "·", M, " + ", C,
            ")·", u, "·(", Name(z.text + "'"), " − ", root, "·", z, ") = ", u, "·", Q,
            *sides, settles="equations of complex modes", uses=self.found.lines)
        return [first, *(self._equation(k, mode, [first]) for k, mode in enumerate(self.modes))]

    def _equation(self, k: int, mode: ComplexMode, uses: list[int]) -> int:
        """The line of a mode: its root, its shape, what drives it, and its part of the start."""
        z, Q, root = self.z[k], self.sheet.letter("Q"), Name(self.sheet.letter(f"lambda{k + 1}"))
        loads = [part for j, taken in self.taken.items() for part in (
            " + ", f"{factor_told(taken[k])}·", Name(self.sheet.letter(indexed(Q, j + 1))))][1:]
        start = [Words(",  "), z, f"(0) = {complex_told(mode.part)}", Words(f" {self.units[0]}")] * self.started
        line = self.sheet.write(root, f" = {complex_told(mode.root)}", Words(" 1/s:  "), *shape_told(
            self.names, mode.shape), Words(",  "), Name(z.text + "'"), " − ", root, "·", z, " = ", *loads, *start,
            settles=f"equation of complex mode {k + 1}", uses=uses)
        if mode.root.imag:
            know_decay(self.sheet, mode.order, -mode.root.real, mode.root.imag, line)
        elif mode.root:
            alpha = self.sheet.letter(f"alpha{k + 1}")
            self.sheet.write(settles=alpha, letter=alpha, value=-mode.root.real, unit="1/s", joined=True, uses=[line])
        return line

    def integrals(self, uses: "Sequence[int]") -> None:
        """Write down z under any loads, as the sum of the impulses that these consist of, and the coordinates."""
        t, tau = self.about.scene.time, self.tau
        root, g, z, Q = (Name(self.sheet.letter(letter)) for letter in ("lambda", "g", "z", "Q"))
        start = [z, "(0)·exp(", root, "·", t, ") + "] if self.started else []
        line = self.sheet.write(
            Words("of the impulses from "), tau, " = 0", Words(" to "), t, Words(" that loads consist of, with  "), g,
            "·", Q, Words(" for the right side:  "), z, " = ", *start, Words("∫ "), "exp(", root, "·(", t, " − ", tau,
            "))·", g, "·", Q, "(", tau, ")·d", tau, settles="convolution", uses=uses)
        for i, name in enumerate(self.names):
            parts = MotionByModes(MotionByPieces([], tau, line, None), self._parts_of(i)).told([], None)
            self.sheet.write(*([Words("and  ")] if i == 0 else []), Name(name), " = ", *parts,
                             settles=f"motion of {name}", uses=[line], joined=i > 0)

    def superposed(self, loads: LoadsOnModes, uses: "list[int]") -> bool:
        """Write down z by the pieces of loads, and the coordinates; False where the engine finds others."""
        self.loads = loads.pieces or {}
        lines, self.Omega = list(uses), loads.frequency(self.about, self.sheet, uses)
        kinds = dict.fromkeys(piece.kind for pieces in self.loads.values() for piece in pieces)
        lines += [self._unit(kind, uses) for kind in kinds]
        lines = [self._sum(k, lines) for k in range(len(self.modes))]
        motions = [self._motion(i, self.sheet.last + 1) for i in range(len(self.names))]
        for i, (name, motion) in enumerate(zip(self.names, motions, strict=True)):
            self.sheet.write(*([Words("and  ")] if i == 0 else []), Name(name), " = ", *motion.told([], None),
                             settles=f"motion of {name}", uses=lines, joined=i > 0)
            self._know(i)
            self.sheet.by_pieces[name] = motion
        return all(is_of_engine(self.about, self.sheet, *pair) for pair in zip(self.names, motions, strict=True))

    def _unit(self, kind: str, uses: list[int]) -> int:
        """The line of what a unit of a kind brings about: its particular part, and the constant at its start."""
        root, tau = self.about.letter(self.sheet.letter("lambda")), self.tau
        name = Name(self.sheet.letter(LETTERS[kind], "k"))
        of = Words(f"{KINDS[kind]} at τ = 0{',' * (kind in WAVES)} ")
        kept, constant = particular_and_constant(kind, root, tau, self.Omega)
        free = self.table.call("exp", root * tau)
        if kept.is_zero:
            return self.sheet.write(of, Words("makes z = 1 in mode k, which dies out:  "), name, "(τ) = ", free,
                                    settles=name.text, uses=uses)
        known = [part for k in range(len(self.modes)) for part in self._constant(kind, k, root, constant)]
        return self.sheet.write(of, Words("has in mode k the particular part  "), kept, Words(
            ",  and as z = 0 at its start the constant  "), constant, Words("  of  "), free, Words(":  "), name,
            "(τ) = ", constant * free + kept, *known, settles=name.text, uses=uses)

    def _constant(self, kind: str, k: int, root: "Node", constant: "Node") -> "list[Name | Node | str | Words]":
        """Parts of that of a mode in numbers; of one whose λ is zero, of what stands in its place."""
        mode, own = self.modes[k], self.about.letter(self.sheet.letter(f"lambda{k + 1}"))
        if mode.root:
            known = evaluate([constant], Floats, {**self.about.numbers(), root.name: mode.root})[0]
            return [Words(",  "), *substitute([constant], {root: own}), f" = {complex_told(complex(known))}", Words(
                " s²" if kind == "ramp" else " s")]
        name = self.sheet.letter(f"{LETTERS[kind]}{k + 1}")
        return [Words(",  but as "), own, " = 0", Words("  "), Name(name), "(τ) = ", self._units(k).added_up(kind)]

    def _units(self, k: int) -> ComplexUnitResponses:
        """What units bring about in a mode, by the letters of its λ, −α of one that is real: two of these may have the
        number of one mode."""
        mode = self.modes[k]
        names = (f"delta{mode.order}", f"omega_d{mode.order}") if mode.root.imag else (f"alpha{k + 1}", "")
        delta, omega = (self.about.letter(self.sheet.letter(name)) if part else self.table.zero
                        for name, part in zip(names, (mode.root.real or mode.root.imag, mode.root.imag), strict=True))
        return ComplexUnitResponses(delta, omega, self.tau, self.Omega)

    def _sum(self, k: int, uses: list[int]) -> int:
        """The line of z of a mode by the pieces of loads."""
        time, parts, mode = self.about.scene.time, [], self.modes[k]
        if self.started:
            root = Name(self.sheet.letter(f"lambda{k + 1}"))
            parts = [f"{factor_told(mode.part)}·exp(", root, "·", time, ")"]
        for j, pieces in self.loads.items():
            told = MotionByPieces(self._named(k, pieces), self.tau, 0, None).told(self._named(k, pieces), time)
            size = [" + "] * bool(parts) + [f"{factor_told(self.taken[j][k])}·"]
            parts += [*size, *(["(", *told, ")"] if len(pieces) > 1 else told)]
        several = [Words("   (each from when its argument is positive)")] * (k == 0)
        return self.sheet.write(Words("so by superposition  "), self.z[k], " = ", *parts, *several,
                                settles=self.z[k].text, uses=uses)

    def _named(self, k: int, pieces: "Sequence[LoadPiece]") -> list[ToldPiece]:
        """Pieces by the names of the unit responses of a mode, what these are left out."""
        return [ToldPiece(piece.factor, piece.begins, None, self.sheet.letter(f"{LETTERS[piece.kind]}{k + 1}"),
                          piece.kind) for piece in pieces]

    def _parts_of(self, i: int) -> list[PartOfMode]:
        """What a coordinate has of each mode."""
        size = max(abs(mode.shape[i]) for mode in self.modes)
        return [PartOfMode(complex(mode.shape[i]), z, bool(mode.root.imag)) for mode, z in zip(
            self.modes, self.z, strict=True) if abs(mode.shape[i]) > NOTHING * size]

    def _motion(self, i: int, line: int) -> MotionByModes:
        """The motion of a coordinate: by the real and the imaginary part of what each piece brings about in each mode,
        whose factors have letters."""
        zero, told = self.table.zero, []
        for k, mode in enumerate(self.modes):
            unit = self._units(k)
            of_load = [(self._weights(i, k, j + 1, taken[k]), piece) for j, taken in self.taken.items()
                       for piece in self.loads[j]]
            start = [(self._weights(i, k, 0, mode.part), LoadPiece("impulse", self.table.one, zero))] * self.started
            told += [ToldPiece(piece.factor * weight, piece.begins, part, "", piece.kind)
                     for weights, piece in (*start, *of_load)
                     for weight, part in zip(weights, unit.of(piece.kind), strict=True) if not weight.is_zero]
        return MotionByModes(MotionByPieces(told, self.tau, line, None), self._parts_of(i))

    def _weights(self, i: int, k: int, j: int, taken: complex) -> "list[Node]":
        """Of a coordinate by load j, or by the start where that is 0: a and b of Re (a − ib) f, by their letters."""
        mode = self.modes[k]
        whole = (2 if mode.root.imag else 1) * complex(mode.shape[i]) * complex(taken)
        found = []
        for letter, value in (("g", whole.real), ("b", -whole.imag)):
            name = self.sheet.letter(f"{letter}{k + 1}", f"{self.names[i]}{j}")
            self.sheet.in_numbers[name] = abs(value)
            symbol = self.table.parameter(name)
            found.append(symbol if value > 0 else -symbol if value else self.table.zero)
        return found

    def _know(self, i: int) -> None:
        """Let the last line tell the letters of the factors of a coordinate."""
        for k in range(len(self.modes)):
            for j in (*([-1] if self.started else []), *self.taken):
                unit = self.units[i] if j < 0 else WEIGHTS[(self.units[i] == "rad") + (self.units[j] == "rad")]
                for letter in "gb":
                    name = self.sheet.letter(f"{letter}{k + 1}", f"{self.names[i]}{j + 1}")
                    self.sheet.write(settles=name, letter=name, value=self.sheet.in_numbers[name], joined=True,
                                     unit=unit, uses=[self.sheet.last])
