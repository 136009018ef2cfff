"""Positions of a scene in motion: those of a mode shape, and those of any motion given in time.

A mode displaces q − q_equilibrium = a Re(shape e^{iθ}), a > 0, by the shape that the table tells; a is such that the
largest displacement is a readable part of the figure, and smaller where the loops of the scene cannot follow so far.
"""

from cmath import exp, phase
from collections.abc import Sequence
from math import pi, tau
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.lumped_place import most
from vibcli.drawing.member_motion import mode_along_members
from vibcli.drawing.symbols import bodies
from vibcli.language.parameters import require_values
from vibcli.notation.numbers import figure as printed

if TYPE_CHECKING:
    from vibcli.drawing.layout.compose import Scenery
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.drawing.symbols.member import Bend

READABLE, LUMPED, VISIBLE, SWING, SMALL, FARTHEST = 30.0, 22.0, 12.0, 0.7, 1e-4, 0.9
SQUEEZED, ROUNDS = 0.4, 24
QUARTERS = 0.0, pi / 2, pi, 3 * pi / 2


def mode(problem: Any, index: int) -> Any:
    """The Mode of a number; PhysicsError where there is none, and of a scene in letters."""
    if problem.numeric.has_free_symbols:
        require_values(problem.scene.parameters, "the picture of a mode")
    modes = problem.modal.modes
    found = modes.numbered(index, index)
    if not found:
        if not modes:
            why = problem.configuration.linear_system.why_modeless
            raise PhysicsError(f"this scene has no mode {index}: {why}",
                               "look at its motion in time, as `vibcli animate --response` shows it")
        count = ("those from 1 on" if not modes.finite else
                 "only mode 1" if len(modes) == 1 else f"modes 1 to {len(modes)}")
        raise PhysicsError(f"this scene has no mode {index}", f"it has {count}")
    return found[0]


def caption(found: Any) -> str:
    """What a mode is called: its number and its frequency."""
    head = f"mode {found.index}: "
    if found.rigid:
        return head + "ω = 0"
    parts = [f"ω = {printed(float(found.omega), found.error)} rad/s"] if found.omega else []
    if found.growth_rate is not None:
        rate = float(found.growth_rate)
        parts.append(f"{'grows' if rate > 0 else 'decays'} at {printed(abs(rate), found.error)} 1/s")
    return head + ", ".join(parts)


class Vibration:
    """A mode about the equilibrium: `at(theta)` is the Sketch at a phase, `unit` the points for one metre of lumped
    bodies, `room` that in which bodies slide on the ground, `rest` the equilibrium."""

    def __init__(self, problem: Any, index: int, stage: "Scenery", normalise: str = "first") -> None:
        if not stage.scene.bodies and not stage.scene.members:
            raise PhysicsError("this scene has no bodies, so no mode can be drawn on it",
                               "`vibcli frequencies` prints the shapes in numbers")
        found = mode(problem, index)
        self.stage, self.names = stage, problem.scene.coordinates
        self.base = problem.configuration.equilibrium.values
        shape = [complex(value) for value in problem.modal.shape(found, normalise)]
        turn = exp(-1j * _lead(max(shape, key=abs))) if shape else 1.0
        self.shape = [value * turn for value in shape]
        self.fields = mode_along_members(problem, found, stage, normalise, turn)
        self.rest = self._required(0.0, 0.0)
        self._scale()

    def at(self, theta: float) -> "Sketch":
        """The Sketch at a phase, 0 being that of the largest displacement."""
        return self._required(self.amplitude, theta)

    def bends(self, theta: float | None) -> "dict[str, Bend]":
        """{member: Bend} at a phase; at rest without one."""
        factor = self.amplitude * exp(1j * theta) if theta is not None else 0.0
        return {field.strip.name: field.bend(self.rest, self.at(theta) if theta is not None else self.rest, factor,
                                             self.unit, self.turn_unit) for field in self.fields}

    def _required(self, amplitude: float, theta: float) -> "Sketch":
        found = self._sketch(amplitude, theta)
        if found is None:
            raise PhysicsError("the loops of this scene cannot close in the displaced position", "ask for another mode")
        return found

    def _sketch(self, amplitude: float, theta: float) -> "Sketch":
        factor = exp(1j * theta) if theta else 1.0
        position = {name: self.base[name] + amplitude * (value * factor).real
                    for name, value in zip(self.names, self.shape, strict=True)}
        return self.stage.at({**self.base, **position} if amplitude else self.base)

    def _unit(self, farthest: float) -> float:
        """Points for one metre of lumped bodies, of which one goes so far."""
        if not farthest:
            return 1.0
        moved = [self._sketch(self.amplitude, theta) for theta in QUARTERS] if self.stage.rows else []
        return min(LUMPED / farthest, most(self.stage.rows, [sketch.lumped for sketch in moved if sketch]))

    def _scale(self) -> None:
        """Set the amplitude and the unit."""
        tops = {kind: max((max(field.top, field.hung) for field in self.fields if field.kind == kind), default=0.0)
                for kind in ("placed", "slides", "turns")}
        trial = SMALL / max([*map(abs, self.shape), *tops.values()])
        moved = self._required(trial, 0.0)
        placed = max(largest_displacement(self.rest, moved, self.stage) / trial,
                     tops["placed"] * self.stage.sketch.scale)
        slides, turns = lumped_displacements(self.rest, moved, self.stage)
        slides, turns = max(slides / trial, tops["slides"]), max(turns / trial, tops["turns"])
        angles = max([abs(moved.frames[name].angle - self.rest.frames[name].angle) / trial
                      for name in self.stage.looks] or [0.0])
        limits = [READABLE / placed if placed else 0.0, SWING / turns if turns else 0.0]
        limits = [limit for limit in limits if limit] or [1.0]
        self.amplitude = min([*limits, FARTHEST / angles] if angles else limits)
        self.unit = self._unit(slides * self.amplitude)
        self.turn_unit = LUMPED / (turns * self.amplitude) if turns else 1.0
        for _ in range(ROUNDS):
            both = [self._sketch(sign * self.amplitude, 0.0) for sign in (1, -1)]
            if None not in both and shortest(self.rest, both, self.stage) > SQUEEZED:
                self.room = sliding_room(self.stage, [self.rest, *both])
                return
            self.amplitude *= 0.7
        raise PhysicsError("the loops of this scene cannot follow this mode", "ask for another mode")


def _lead(amplitude: complex) -> float:
    """By how much of a period an amplitude leads its largest displacement to either side, at most a quarter: what is
    in phase with it moves as its sign in the table says."""
    lead = phase(amplitude)
    return lead - pi if lead > pi / 2 else lead + pi if lead <= -pi / 2 else lead


def largest_displacement(rest: "Sketch", moved: "Sketch", stage: "Scenery") -> float:
    """The largest displacement of a place of a body, in points."""
    return max((plane.distance(rest.frames[name].point(p), moved.frames[name].point(p))
                for name, look in stage.looks.items() for part in look.pieces for p in part.points), default=0.0)


def lumped_displacements(rest: "Sketch", moved: "Sketch", stage: "Scenery") -> list[float]:
    """The largest displacement in metres and the largest angle of lumped bodies."""
    found = [0.0, 0.0]
    for layout in stage.rows:
        for name, place in layout.places.items():
            found[place.turns] = max(found[place.turns], abs(moved.lumped[name] - rest.lumped[name]))
    found[0] = max([found[0], *(abs(moved.lumped[one.body] - rest.lumped[one.body]) for one in stage.hung)])
    return found


def shortest(rest: "Sketch", sketches: "Sequence[Sketch]", stage: "Scenery") -> float:
    """The least part of its length at rest that a spring or damper keeps."""
    parts = [plane.distance(sketch.now(bunch.one), sketch.now(bunch.two)) / length for bunch in stage.bunches
             if (length := plane.distance(rest.now(bunch.one), rest.now(bunch.two))) > 1.0 for sketch in sketches]
    return min(parts, default=1.0)


def sliding_room(stage: "Scenery", sketches: "Sequence[Sketch]") -> dict[str, tuple[float, float]]:
    """{body: (how far back, how far on)} of what slides on the ground or along a rod, from the drawn position."""
    found = {}
    for name in stage.looks:
        if (carrier := bodies.rail_of(name, stage.sketch)) is not None:
            steps = [_along(name, carrier, sketch) for sketch in sketches]
            found[name] = min(0.0, *steps), max(0.0, *steps)
            continue
        moves = [plane.minus(sketch.frames[name].place, sketch.frames[name].drawn) for sketch in sketches]
        along = [plane.distance(move, (0.0, 0.0)) * (1 if move[0] >= 0 else -1) for move in moves]
        found[name] = min(0.0, *along), max(0.0, *along)
    return found


def _along(name: str, carrier: str, sketch: "Sketch") -> float:
    """How far a body has slid along the rod that carries it."""
    centre, rod = sketch.centre(name), sketch.frames[carrier]
    moved = plane.minus(sketch.frames[name].point(centre), rod.point(centre))
    return plane.dot(moved, rod.turned(bodies.along(name, sketch)))


def phases(count: int) -> list[float]:
    """Phases of one period from rest on: 0 the largest displacement."""
    return [tau * i / count - pi / 2 for i in range(count)]


def response(stage: "Scenery", positions: Sequence[dict[str, float]],
             times: Sequence[float] | None = None) -> "tuple[list[Sketch], float, dict[str, tuple[float, float]]]":
    """(Sketches, unit, room) of a motion: `positions` are {coordinate: value} of all or only the independent
    coordinates, one for each frame, `times` the instants for what is driven; PhysicsError where the loops of the scene
    cannot follow."""
    positions = list(positions)
    sketches = []
    for position, time in zip(positions, times or [0.0] * len(positions), strict=True):
        found = stage.at(dict(position), time)
        if found is None:
            raise PhysicsError("the loops of this scene cannot follow this motion", "ask for a smaller one")
        sketches.append(found)
    slides = max((lumped_displacements(stage.sketch, sketch, stage)[0] for sketch in sketches), default=0.0)
    unit = min(LUMPED / slides, most(stage.rows, [sketch.lumped for sketch in sketches])) if slides else 1.0
    return sketches, unit, sliding_room(stage, [stage.sketch, *sketches])


def magnification(stage: "Scenery", middle: "Sketch", sketches: "Sequence[Sketch]") -> float:
    """1, or a round number by which a motion about the Sketch `middle` is to be magnified so that it can be seen."""
    size = max((largest_displacement(middle, sketch, stage) for sketch in sketches if middle), default=0.0)
    if not 0 < size < VISIBLE:
        return 1.0
    factor, power = READABLE / size, 1.0
    while power * 10 <= factor:
        power *= 10
    return max(part * power for part in (1.0, 2.0, 5.0) if part * power <= factor)
