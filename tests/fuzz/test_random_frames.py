"""Random frames of bodies on pins, clamps, links and rollers, against NumPy.

Held: each body's three conditions of equilibrium, ΣFx = ΣFy = ΣM = 0, are solved for all forces, in numbers and
letters. With links taken out they fall from rest: M a = F λ + loads, with Fᵀ a = 0, since what forces do no work on
does not move.
"""

import random

import numpy as np
import pytest

from tests.support.scenes import problem
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.parser import parse

SEEDS, WORST = range(30), 1e5      # of the conditions' matrix
GRAVITY = 9.81


class Frame:
    """A scene as YAML, and by hand: `columns`, {signal: [(body, place, force, moment) of its unit]}; `loads`, the
    same of what is given."""

    def __init__(self, seed, loose=False):
        self.draw, self.bodies, self.columns, self.loads, self.masses = random.Random(seed), {}, {}, [], []
        self.lines = {"coordinates": [], "points": [], "surfaces": [], "bodies": [], "constraints": [], "forces": []}
        for number in range(self.draw.randint(1, 4)):
            self.body(f"b{number}")
        for number in range(self.draw.randrange(self.free) if loose and self.free else self.free):
            self.tie(f"t{number}")
        for number in range(self.draw.randint(1, 4)):
            self.load(f"f{number}")

    free = 0

    def place(self):
        return np.array([round(self.draw.uniform(-3, 3), 2) for _ in "xy"])

    def body(self, name):
        """A body pinned or clamped to the ground or another, or free in the plane; and its weight."""
        kind, at, centre = self.draw.choice(("pin", "pin", "clamp", "move")), self.place(), self.place()
        carrier = self.draw.choice((None, *self.bodies))
        mass, to = round(self.draw.uniform(0.5, 5), 1), f", carrier: {carrier}" if carrier else ""
        self.bodies[name] = centre
        motion = {"pin": f"pin: {{at: {_text(at)}, by: {name}_phi{to}}}", "clamp": f"clamp: {{at: {_text(at)}{to}}}",
                  "move": f"move: [{name}_x, {name}_y, {name}_phi]"}[kind]
        inertia = round(self.draw.uniform(0.1, 2), 2)
        self.lines["bodies"].append(f"{name}: {{mass: {mass}, inertia: {inertia}, at: {_text(centre)}, {motion}}}")
        self.masses.append((mass, inertia, *centre))
        self.lines["coordinates"] += {"pin": [f"{name}_phi:"], "clamp": [],
                                      "move": [f"{name}_x:", f"{name}_y:", f"{name}_phi:"]}[kind]
        self.free += {"pin": 1, "clamp": 0, "move": 3}[kind]
        self.loads.append((name, centre, np.array([0, -mass * GRAVITY]), 0.0))
        if kind != "move":
            for part, force in (("x", (1, 0)), ("y", (0, 1))):
                self.acts(f"{name}.reaction.{part}", name, carrier, at, force)
        if kind == "clamp":
            self.acts(f"{name}.reaction.moment", name, carrier, at, (0, 0), 1.0)

    def acts(self, signal, on, by, at, force, moment=0.0):
        """An unknown force on a body, and the opposite on what exerts it."""
        force = np.array(force, dtype=float)
        found = [(on, at, force, moment), (by, at, -force, -moment)]
        self.columns[signal] = [each for each in found if each[0] is not None]

    def point(self, body):
        at, name = self.place(), f"p{len(self.lines['points'])}"
        self.lines["points"].append(f"{name}: {{body: {body}, at: {_text(at)}}}")
        return name, at

    def tie(self, name):
        """A link to the ground or another body, or a roller on an inclined plane."""
        one = self.draw.choice(list(self.bodies))
        label, at = self.point(one)
        other = self.draw.choice((None, *(body for body in self.bodies if body != one)))
        if self.draw.random() < 0.4:
            along = self.place()
            normal = np.array([-along[1], along[0]]) / np.hypot(*along)
            self.lines["surfaces"].append(f"s{name}: {{line: [{_text(at - along)}, {_text(at + along)}]}}")
            self.lines["constraints"].append(f"{name}: {{point: {label}, surface: s{name}}}")
            self.acts(f"{name}.force", one, None, at, normal)
            return
        end, far = (_text(far := self.place()), far) if other is None else self.point(other)
        self.lines["constraints"].append(f"{name}: {{link: [{label}, {end}]}}")
        pull = (far - at) / np.hypot(*(far - at))
        self.columns[f"{name}.force"] = [(one, at, pull, 0.0)] + [(other, far, -pull, 0.0)] * (other is not None)

    def load(self, name):
        body = self.draw.choice(list(self.bodies))
        if self.draw.random() < 0.3:
            moment = round(self.draw.uniform(-9, 9), 1)
            self.lines["forces"].append(f"{name}: {{body: {body}, moment: {moment}}}")
            self.loads.append((body, np.zeros(2), np.zeros(2), moment))
            return
        (label, at), force = self.point(body), self.place()
        self.lines["forces"].append(f"{name}: {{at: {label}, force: {_text(force)}}}")
        self.loads.append((body, at, force, 0.0))

    @property
    def text(self):
        sections = [f"{key}:\n  " + "\n  ".join(lines) for key, lines in self.lines.items() if lines]
        return f"gravity: {GRAVITY}\n" + "\n".join(sections) + "\n"

    def share(self, parts):
        """The column [ΣFx, ΣFy, ΣM about the origin] of all bodies."""
        order, found = list(self.bodies), np.zeros(3 * len(self.bodies))
        for body, at, force, moment in parts:
            i = 3 * order.index(body)
            found[i:i + 3] += *force, at[0] * force[1] - at[1] * force[0] + moment
        return found

    @property
    def matrix(self):
        return np.array([self.share(parts) for parts in self.columns.values()]).T

    @property
    def inertia(self):
        """M of (ax, ay of the point at the origin, alpha) of each body, so that M a are ΣFx, ΣFy, ΣM there."""
        found = np.zeros((3 * len(self.masses), 3 * len(self.masses)))
        for i, (m, J, x, y) in enumerate(self.masses):
            found[3 * i:3 * i + 3, 3 * i:3 * i + 3] = [[m, 0, -m * y], [0, m, m * x],
                                                       [-m * y, m * x, J + m * (x * x + y * y)]]
        return found

    @property
    def fall(self):
        """({signal: force}, {body: (acceleration of its mass centre, angular acceleration)}) from rest."""
        M, F = self.inertia, self.matrix
        full = np.block([[M, -F], [F.T, np.zeros((F.shape[1], F.shape[1]))]])
        a, forces = np.split(np.linalg.solve(full, np.concatenate([self.share(self.loads), np.zeros(F.shape[1])])),
                             [len(M)])
        moved = {}
        for (name, (x, y)), (ax, ay, alpha) in zip(self.bodies.items(), a.reshape(-1, 3), strict=True):
            moved[name] = ax - alpha * y, ay + alpha * x, alpha
        return dict(zip(self.columns, forces, strict=True)), moved

    @property
    def solution(self):
        """{signal: value} by hand."""
        return dict(zip(self.columns, np.linalg.solve(self.matrix, -self.share(self.loads)), strict=True))


def _text(place):
    return f"[{place[0]:.12g}, {place[1]:.12g}]"


def _frames(loose=False):
    """The first frames that are held, or fall, whose forces are clearly independent of one another."""
    found, seed = [], 0
    while len(found) < len(SEEDS):
        frame = Frame(seed, loose)
        seed += 1
        if not frame.columns or (loose and len(frame.columns) == 3 * len(frame.bodies)):
            continue
        if np.linalg.cond(frame.matrix) < WORST:
            found.append(frame)
    return found


FRAMES, FALLING = _frames(), _frames(loose=True)


@pytest.mark.parametrize("seed", SEEDS)
def test_forces_are_those_of_three_conditions_for_each_body(seed):
    frame = FRAMES[seed]
    scene, wanted = problem(frame.text), frame.solution
    size = max(map(abs, wanted.values()))
    found = {reaction.signal: reaction.value for reaction in scene.configuration.reactions}
    in_letters = scene.symbolic.reactions
    assert in_letters.degree == 0
    for signal, value in wanted.items():
        assert found[signal] == pytest.approx(value, abs=1e-9 * size), signal
        other, = evaluate([in_letters.values[signal]], Floats, scene.numeric.floats)
        assert other == pytest.approx(value, abs=1e-9 * size), signal
    for signal in found.keys() - wanted.keys():
        assert abs(found[signal]) <= 1e-9 * size


@pytest.mark.parametrize("seed", SEEDS[:16])
def test_what_falls_from_rest_obeys_newton_and_euler(seed):
    """In letters, and of some as values at t = 0 of the motion."""
    frame = FALLING[seed]
    scene, (wanted, moved) = problem(frame.text), frame.fall
    found = scene.symbolic.forces_from_rest
    size = max(map(abs, wanted.values()))
    for signal, value in wanted.items():
        other, = evaluate([found.values[signal]], Floats, scene.numeric.floats)
        assert other == pytest.approx(value, abs=1e-8 * size), signal
    values, reach = scene.symbolic.accelerations.values, max(abs(x) for parts in moved.values() for x in parts)
    for name, (ax, ay, alpha) in moved.items():
        for coordinate, value in ((f"{name}_phi", alpha), (f"{name}_x", ax), (f"{name}_y", ay)):
            if coordinate in values:
                other, = evaluate([values[coordinate]], Floats, scene.numeric.floats)
                assert other == pytest.approx(value, rel=1e-8, abs=1e-8 * reach), coordinate
    if seed % 5 == 0:
        free = scene.scene.coordinates
        starts = "\nmotion: full\ninitial: {" + ", ".join(f"{name}: 0" for name in free) + "}\n"
        motion = problem(frame.text + starts).response
        for signal, value in wanted.items():
            assert motion.signal(parse(signal)).values(np.zeros(1))[0] == pytest.approx(value, abs=1e-7 * size), signal
