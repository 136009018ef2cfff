"""Diagrams of the forces and moments within members, as textbooks draw them: along each as base line, below the scene.

Bending moments stand on the side in tension, all else to the left of the way from the left end to the right where it is
positive, which is upwards on what runs to the right. Members in the plane stand together where they are drawn, one
picture for each kind of force; each of the others has panels of its own, below one another.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.canvas import primitives
from vibcli.drawing.canvas.primitives import (
    BEHIND,
    ELEMENT,
    JOINT,
    SURFACE,
    Circle,
    Polygon,
    Polyline,
    Primitive,
    extent,
)
from vibcli.drawing.layout import lettering, plane
from vibcli.drawing.layout.compose import Scenery
from vibcli.drawing.layout.diagram_values import error_of_zero, told, zeros
from vibcli.drawing.layout.space import Space
from vibcli.drawing.layout.strips import Strip, resting
from vibcli.drawing.symbols import member_ends
from vibcli.drawing.symbols.member import Bend
from vibcli.notation.numbers import supported, wrapped
from vibcli.plots.prefixes import readable

if TYPE_CHECKING:
    from vibcli.drawing.canvas.primitives import LetterRuns
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.mechanics.internal_forces import InternalForce
    from vibcli.numerics.stretches import CurveStretch

HIGH, GAP, HEAD, ORDINATES, DOT = 40.0, 18.0, 7.0, 7.0, 2.0     # points: of the largest value, between panels, …
SMALL_SIZE, DIGITS, NOTHING = 10.0, 4, 1e-9                     # the last: of the largest value
LINE, BASELINES = 70, 14.0      # letters in a line, points between lines
CLOSE = 30.0        # points between two places of one value
NAMES = {("bar", "force"): "tension", ("string", "force"): "tension", ("beam", "force"): "tension",
         ("shaft", "moment"): "torque GIo φ′", ("beam", "shear"): "shear (EI u″)′", ("beam", "moment"): "moment EI u″"}
ALONG = {True: "positive upwards", False: "positive to the left of the way to the right end"}
TENSION = "on the side in tension"


class DiagramPanel(NamedTuple):
    """What is drawn together: the Strips of members and what is within each, on one scale of `points` for one unit;
    `unit`, of which `factor` make one SI unit."""

    title: str
    drawn: list[tuple[Strip, "InternalForce"]]
    largest: float
    factor: float
    unit: str
    amplitudes: bool = False

    def side(self, strip: Strip, force: "InternalForce", value: float) -> float:
        """How far to the left of the member a value is drawn."""
        below = strip.member.kind.bends and force.part == "moment" and not self.amplitudes
        return (-value if below else value) * self.points

    @property
    def points(self) -> float:
        return HIGH / self.largest if self.largest else 0.0

    def words(self, value: float, error: float) -> str:
        """A value with its unit, as far as it is known."""
        if abs(value) <= NOTHING * self.largest and error <= NOTHING * self.largest:
            return "0"
        text = supported(value * self.factor, error * self.factor, DIGITS, "")
        return f"{text} {self.unit}".replace("-", "−")


def draw(scene: Any, forces: "Sequence[InternalForce]", top: Sequence[Any], notes: Sequence[str] = (),
         amplitudes: bool = False) -> list[Any]:
    """The primitives of `top`, a figure of the scene, with the diagrams below it, and words under all; `amplitudes`
    stand on no side."""
    stage = Scenery(scene)
    found = list(top)
    for panel in _panels(stage, forces, amplitudes):
        made, box = _panel(panel, stage.sketch), extent(found)
        found += [primitives.shifted(part, (0.0, (box[1] - GAP if box else 0.0) - extent(made)[3])) for part in made]
    left, bottom, *_ = extent(found)
    lines = [line for note in notes for line in wrapped(note, LINE, 0)]
    return [*found, *(lettering.text(lettering.words(line), left, bottom - GAP - (number + 1) * BASELINES)
                      for number, line in enumerate(lines))]


def _panels(stage: Scenery, forces: "Sequence[InternalForce]", amplitudes: bool) -> list[DiagramPanel]:
    """The Panels of all that is not zero; PhysicsError where everything is."""
    strips = {strip.name: strip for strip in stage.strips}
    groups: dict[tuple[str, str, str], list[tuple[Strip, InternalForce]]] = {}
    for force in forces:
        strip = strips[force.member]
        kind = strip.member.kind.name, force.part
        groups.setdefault(("", *kind) if strip.placed else (force.member, *kind), []).append((strip, force))
    found = []
    for (_, element, part), drawn in groups.items():
        largest = max(force.largest for _, force in drawn)
        if largest:
            level = all(abs(strip.e[1]) < 1e-9 and strip.e[0] > 0 for strip, _ in drawn)
            side = TENSION if (element, part) == ("beam", "moment") else ALONG[level]
            title = NAMES[element, part] + (f" of {drawn[0][0].name}" if len(drawn) == 1 else "")
            found.append(DiagramPanel(f"amplitude of {title}" if amplitudes else f"{title}, {side}", drawn, largest,
                               *readable(largest, drawn[0][1].unit), amplitudes))
    if not found:
        strung = all(strip.member.kind.name == "string" for strip in stage.strips)
        raise PhysicsError("nothing acts within the members here: all diagrams are zero",
                           "small motions leave the tension of strings as it is: `vibcli draw FILE --diagrams` draws it"
                           if strung else "`vibcli draw FILE --diagrams --mode N` draws those of a mode that deforms "
                           "members, `vibcli draw FILE --diagrams --at 20ms` those of the motion in time")
    return found


def _panel(panel: DiagramPanel, sketch: "Sketch") -> "list[LetterRuns | Primitive]":
    """The primitives of a DiagramPanel."""
    found: list[LetterRuns | Primitive] = []
    for strip, _ in panel.drawn:
        bend = Bend(resting(strip, sketch.values), 0.0)
        found += primitives.ghost(iter(member_ends.supports(strip, bend, sketch)))
    labels: list[Any] = []
    for strip, force in panel.drawn:
        found += _diagram(panel, strip, force)
        labels += _labels(panel, strip, force)
    space = Space(found)
    for text, places, role in labels:
        found.append(space.put(lettering.words(text, SMALL_SIZE), places, role))
    box = extent(found)
    return [*found, lettering.text(lettering.words(panel.title), box[0], box[3] + HEAD, "note")]


def _diagram(panel: DiagramPanel, strip: Strip, force: "InternalForce") -> list[Primitive]:
    """The areas between base line and curve, light and with ordinates, both in outline; where they change their
    sides."""
    found: list[Primitive] = [Polyline((strip.at(0.0), strip.end), "ink", 1.4, layer=ELEMENT)]
    outline = [strip.at(force.stretches[0].start)]
    for stretch in force.stretches:
        cuts = [stretch.start, *stretch.zeros(force.largest), stretch.end]
        places, _ = stretch.points()
        places = sorted({*places.tolist(), *cuts, *stretch.extremes()})
        values = dict(zip(places, stretch.values(np.array(places)).tolist(), strict=True))
        tips = {x: strip.at(x, panel.side(strip, force, values[x])) for x in places}
        outline += [tips[x] for x in places]
        for low, high in pairwise(cuts):
            within = [x for x in places if low <= x <= high]
            positive = sum(values[x] for x in within) > 0
            found.append(Polygon((strip.at(low), *(tips[x] for x in within), strip.at(high)),
                                 "positive" if positive else "negative", "paper", 0.01, layer=SURFACE))
            found += _ordinates(panel, strip, force, stretch, low, high)
    found += [Circle(strip.at(x), DOT, "paper", "diagram", 0.9, layer=JOINT) for x in zeros(force)]
    return [*found, Polyline((*outline, strip.at(force.stretches[-1].end)), "diagram", 1.4, layer=ELEMENT)]


def _ordinates(panel: DiagramPanel, strip: Strip, force: "InternalForce", stretch: "CurveStretch", low: float,
               high: float) -> list[Primitive]:
    count = int((high - low) * strip.scale / ORDINATES)
    places = [low + (high - low) * i / count for i in range(1, count)]
    values = stretch.values(np.array(places)).tolist() if places else []
    return [Polyline((strip.at(x), strip.at(x, panel.side(strip, force, y))), "diagram", 0.35, layer=BEHIND)
            for x, y in zip(places, values, strict=True)]


def _labels(panel: DiagramPanel, strip: Strip,
            force: "InternalForce") -> list[tuple[str, list[tuple[float, float]], str]]:
    """[(text, places for it, role)] of the values at ends, jumps and extremes, once where two that read alike are
    close together, and of where the curve crosses zero."""
    found: list[tuple[str, list[tuple[float, float]], str]] = []
    for x, value in told(force):
        side, words = panel.side(strip, force, value), panel.words(value, force.error(x))
        tip = strip.at(x, side)
        if found and found[-1][0] == words and plane.distance(found[-1][1][1], tip) < CLOSE:
            found.pop()
        found.append((words, [plane.plus(tip, plane.left(strip.e), 3.0 if side >= 0 else -3.0), tip], "ink"))
    return found + [(f"{supported(x, error_of_zero(force, x), DIGITS, '')} m", [strip.at(x)], "note")
                    for x in zeros(force)]
