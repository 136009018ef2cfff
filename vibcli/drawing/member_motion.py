"""Modes along members, from their exact fields."""

from bisect import bisect_right
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.layout.strips import Strip, resting
from vibcli.drawing.symbols.member import LEAST, Bend
from vibcli.drawing.symbols.member_ends import hanging

if TYPE_CHECKING:
    from vibcli.analyses.continuous.mode_fields import ModeFields
    from vibcli.drawing.layout.compose import Scenery
    from vibcli.drawing.layout.sketch import Sketch

RESTS = 1e-9        # of the most that a member moves
PLACES = 32         # along a member at which its motion in time is found
STRETCHED = 1.7     # by which what stretches a spring counts more than what moves
BEDDED = 2.6        # the same of what rests on a row of small springs
SEEN, ACROSS = 30.0, 22.0       # points that the largest displacement has in the plane, and beside it


class MemberMode(NamedTuple):
    """A mode along a member: its fields times a factor, where it rests, the most that it moves; `stretch`: the most
    that a beam moves along, None of what keeps its length; `hung`: the most that its oscillators do, or stretch their
    springs, which need more room."""

    strip: Strip
    fields: Any
    factor: complex
    nodes: list[float]
    top: float
    stretch: float | None = None
    hung: float = 0.0

    @property
    def kind(self) -> str:
        """What its displacements are measured with: those of the plane, of what slides or of what turns."""
        return "placed" if self.strip.placed else "turns" if self.strip.member.kind.torsional else "slides"

    def bend(self, rest: "Sketch", moved: "Sketch", factor: complex, unit: float, turn_unit: float) -> Bend:
        """The Bend about the position `rest`, the mode times the real part of `factor`."""
        strip, still, now = self.strip, resting(self.strip, rest.values), resting(self.strip, moved.values)
        bar = strip.placed and not strip.sideways

        def of(name: str, places: "list[float]") -> "list[float]":
            found: list[float] = (self.fields.displacements(name, places) * (self.factor * factor)).real.tolist()
            return found

        def at(places: "list[float]") -> "list[tuple[float, float]]":
            u = of(strip.name, places)
            if self.stretch is not None:
                w = of(f"{strip.name}.along", places)
                return [(along + a, across + b) for (along, across), a, b in zip(still(places), w, u, strict=True)]
            return [(along + part, there) if bar else (here, across + part)
                    for (along, across), (here, there), part in zip(still(places), now(places), u, strict=True)]

        scale = strip.scale if strip.placed else turn_unit if strip.member.kind.torsional else unit
        lengthwise = self.stretch is not None and self.stretch == self.top
        return Bend(at, scale, self.nodes, lengthwise, abs(factor) * self.top * scale >= LEAST)


def mode_along_members(problem: Any, mode: Any, stage: "Scenery", normalise: str, turn: complex) -> list[MemberMode]:
    """The MemberModes of a mode, `turn` being the factor of its shape."""
    if not stage.strips or not hasattr(mode, "motion"):
        return []
    told = problem.modal.told_apart(mode)
    shape = dict(zip(problem.scene.coordinates, map(complex, problem.modal.shape(mode, normalise)), strict=True))
    fields, factor, found = problem.modal.fields(told), complex(problem.modal.scale(told, normalise)) * turn, []
    for strip in stage.strips:
        found.append(_with_nodes(strip, fields, factor))
        for x, name in hanging(strip, stage.sketch):
            moved, carrier = shape[name] * turn, fields.displacements(strip.name, [x])[0] * factor
            found[-1] = found[-1]._replace(hung=max(found[-1].hung, abs(moved), STRETCHED * abs(moved - carrier)))
    most = {kind: max(one.top for one in found if one.kind == kind) for kind in {one.kind for one in found}}
    return [one if one.top > RESTS * most[one.kind] else one._replace(nodes=[], top=0.0) for one in found]


def _with_nodes(strip: Strip, fields: "ModeFields", factor: complex) -> MemberMode:
    """The MemberMode of a member; a beam that moves both ways rests nowhere."""
    top = abs(complex(fields.largest(strip.name)[1]) * factor)
    moving, stretch = strip.name if top else None, None
    if strip.member.stretching:
        stretch = abs(complex(fields.largest(f"{strip.name}.along")[1]) * factor)
        if top <= RESTS * stretch:
            moving, top = f"{strip.name}.along", stretch
        elif stretch > RESTS * top:
            moving, top = None, max(top, stretch * (1 - RESTS))
    nodes = [float(x) for x in fields.node_places(moving)] if moving and top else []
    return MemberMode(strip, fields, factor, nodes, top, stretch, BEDDED * top * strip.bedded)


class MemberMotion:
    """A motion in time of a scene with members, magnified so that it can be seen: `positions` {coordinate: value} and
    the signals of places, `values(name)` being those of one at all instants; `laid_out(stage, positions)`: their
    Sketches, unit and room."""

    def __init__(self, problem: Any, stage: "Scenery", positions: Any, values: Any, laid_out: Any) -> None:
        self.placed = any(strip.placed for strip in stage.strips)
        self.curves = {strip.name: (strip, *_curve(strip, strip.member.signal_stem, values)) for strip in stage.strips}
        self.stretches = {strip.name: _curve(strip, f"{strip.name}.along", values)[1] for strip in stage.strips
                          if strip.member.stretching}
        histories = [positions, *(rows for _, _, rows in self.curves.values()), *self.stretches.values()]
        self.rests = all(one == history[0] for history in histories for one in history)
        tops = {kind: max((abs(u) * (BEDDED if strip.bedded else 1.0) for strip, _, rows in self.curves.values()
                           for row in rows for u in row if _kind(strip) == kind), default=0.0)
                for kind in ("placed", "slides", "turns")}
        base = problem.configuration.equilibrium.values
        for strip in stage.strips:
            for _, name in hanging(strip, stage.sketch):
                tops[_kind(strip)] = max(tops[_kind(strip)],
                                         *(STRETCHED * abs(one[name] - base[name]) for one in positions))
        seen = tops["placed"] * stage.sketch.scale
        self.factor = max(1.0, SEEN / seen) if seen else 1.0
        larger = [{name: base[name] + self.factor * (x - base[name]) for name, x in one.items()} for one in positions]
        self.sketches, unit, self.room = laid_out(stage, larger)
        self.unit = ACROSS / (tops["slides"] * self.factor) if tops["slides"] else unit
        self.turn_unit = ACROSS / (tops["turns"] * self.factor) if tops["turns"] else 1.0

    def bends(self, number: int) -> dict[str, Bend]:
        """{member: Bend} in one frame."""
        found = {}
        for name, (strip, places, rows) in self.curves.items():
            unit = {"placed": strip.scale, "slides": self.unit, "turns": self.turn_unit}[_kind(strip)]
            still = resting(strip, self.sketches[number].values)
            stretch = self.stretches[name][number] if name in self.stretches else None
            at = _interpolated(strip, places, rows[number], stretch, still, self.factor)
            most = max((abs(u) for row in rows for u in row), default=0.0)
            found[name] = Bend(at, unit, seen=most * self.factor * unit >= LEAST)
        return found


def _kind(strip: Strip) -> str:
    return "placed" if strip.placed else "turns" if strip.member.kind.torsional else "slides"


def _curve(strip: Strip, stem: str,
           values: Callable[[str], list[float]]) -> tuple[list[float], list[tuple[float, ...]]]:
    """(places, a signal at them at each instant) of a member."""
    places = [strip.metres * i / PLACES for i in range(PLACES + 1)]
    columns = [values(f"{stem}({x!r} m)") for x in places]
    return places, list(zip(*columns, strict=True))


def _interpolated(strip: Strip, places: list[float], row: tuple[float, ...], stretch: Sequence[float] | None,
                  still: Callable[[list[float]], list[tuple[float, float]]],
                  factor: float) -> Callable[[list[float]], list[tuple[float, float]]]:
    """[(along, u)] between places at which u is known, and of a beam that stretches what it does along."""
    bar = strip.placed and not strip.sideways

    def at(xs: "list[float]") -> "list[tuple[float, float]]":
        found = []
        for x, (along, across) in zip(xs, still(xs), strict=True):
            i = min(max(bisect_right(places, x) - 1, 0), len(places) - 2)
            t = (x - places[i]) / (places[i + 1] - places[i])
            u = factor * (row[i] + t * (row[i + 1] - row[i]))
            if stretch is not None:
                along = factor * (stretch[i] + t * (stretch[i + 1] - stretch[i]))
            found.append((u, across) if bar else (along, u))
        return found

    return at
