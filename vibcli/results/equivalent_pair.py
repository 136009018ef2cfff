"""A scene with the perpendicular pair that resists like the springs, and the dampers, that end at one place."""

from collections.abc import Iterator, Sequence
from math import atan2, cos, hypot, pi, sin
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.language.document.document import Scalar
from vibcli.language.parameters import require_values
from vibcli.language.reader import Expression, Record, Reference
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.parser import parse

if TYPE_CHECKING:
    from vibcli.mechanics.concurrent import Concurrent
    from vibcli.mechanics.equivalents import Equivalent
    from vibcli.results.problem import Problem

KEYS = {"springs": ("k", "N/m"), "dampers": ("c", "N·s/m")}
NONE = 1e-12        # relative: a stiffness that is rounding, which has no symbol


def with_pair(problem: "Problem", place: str) -> "Problem":
    """The problem with that pair in their stead, for a picture; PhysicsError where nothing ends there."""
    from vibcli.mechanics.concurrent import concurrent, ending_at
    from vibcli.mechanics.equivalents import equivalent, share_axes

    if problem.numeric.has_free_symbols:
        require_values(problem.scene.parameters, "a picture of the equivalent pair")
    spec, scene = problem.spec, problem.scene.resting
    if place in scene.bodies and scene.bodies[place].frame is None:
        raise PhysicsError(f"'{place}' has no place", "say where it is drawn with `at: [x, y]`")
    if place not in scene.bodies and place not in (spec.get("points") or {}):
        raise PhysicsError(f"there is no body or point '{place}'", "name the place at which springs or dampers end")
    if not any(node.mask for node in scene.place(Reference(place, None))[1]):
        raise PhysicsError(f"'{place}' does not move: nothing there is resisted", "name what moves")
    there = [which for which in KEYS if ending_at(spec, scene, place, which)] or ["springs"]
    found = {which: equivalent(problem.configuration, concurrent(spec, scene, place, which)) for which in there}
    heading, length = _middle(problem, place, [one for pair in found.values() for one in pair.elements])
    centre = evaluate(scene.at_drawn(*scene.place(Reference(place, None))[1]), Floats, scene.sample)
    sections = {}
    for which, pair in found.items():
        names = {one.name for one in pair.elements}
        kept = {name: record for name, record in spec.get(which).items() if name not in names}
        model = next(record for name, record in spec.get(which).items() if name in names)
        apart = which == "dampers" and len(found) == 2 and not share_axes(*found.values())
        ends = _ends(pair, centre, heading + pi * apart, length)
        sections[which] = kept | {name: _record(model, name, which, value, end, place)
                                  for name, value, end in ends}
    return problem.with_spec(spec.with_sections(**sections))


def _middle(problem: "Problem", place: str, elements: "list[Concurrent]") -> tuple[float, float]:
    """The mean direction of elements from the place to their other ends, and their mean length, as drawn."""
    from vibcli.mechanics.concurrent import same_place

    scene, spans = problem.scene.resting, []
    names = same_place(problem.spec, scene, place)
    for one in elements:
        first, second = problem.spec.connection(one.name)["between"]
        (ax, ay), (bx, by) = (evaluate(scene.at_drawn(*scene.place_of(end)), Floats, scene.sample)
                              for end in (first, second))
        side = 1 if getattr(first, "text", None) in names else -1
        spans.append((side * (bx - ax), side * (by - ay)))
    return atan2(sum(y for _, y in spans), sum(x for x, _ in spans)), sum(hypot(*span) for span in spans) / len(spans)


def _ends(pair: "Equivalent", centre: Sequence[float], heading: float,
          length: float) -> Iterator[tuple[str, float, tuple[float, float]]]:
    """[(name, value, place of the other end)] of the two; of what is one in every direction along x and y."""
    angle = 0.0 if pair.isotropic else float(pair.angle.value)
    for name, part, turned in (("max", "max", angle), ("min", "min", angle + pi / 2)):
        value = float(getattr(pair, part).value)
        if abs(value) > NONE * abs(float(pair.max.value)):
            if cos(turned - heading) < -1e-9:
                turned += pi
            yield name, value, (centre[0] + length * cos(turned), centre[1] + length * sin(turned))


def _record(model: Record, name: str, which: str, value: float, end: tuple[float, float], place: str) -> Record:
    key, unit = KEYS[which]
    coordinates = [_number(f"{x!r}", model) for x in end]
    values = {key: _number(f"{value!r}", model, f"{value:.4g} {unit}"),
              "between": [coordinates, Reference(place, model.where)]}
    return Record(model.element, f"{which}.{name}", model.where, values, {})


def _number(text: str, model: Record, shown: str | None = None) -> Expression:
    return Expression(Scalar(shown or text, model.where), parse(text))
