"""The pair of springs, and of dampers, that resists like those that end together at one place."""

from collections.abc import Iterator, Sequence
from math import atan2, degrees, pi
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.language.reader import Record, Reference
from vibcli.mechanics.told_zeros import told_values
from vibcli.notation.numbers import figure
from vibcli.quantities.equivalents import PARTS, SECTIONS, asked_places, elements_at, elements_in_letters
from vibcli.report import blocks
from vibcli.report.blocks import Section, TableBlock, line, maths, paragraph, section
from vibcli.report.keys import Key
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.mechanics.concurrent import Concurrent
    from vibcli.mechanics.equivalents import Equivalent
    from vibcli.report.blocks import Equations, Paragraph
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem

UNITS = {"springs": "N/m", "dampers": "N·s/m"}
OTHERS = ("springs", "dampers", "inerters", "constraints", "bars", "beams", "strings")
NAMED_BY = {"springs": "the torsion spring", "dampers": "the torsion damper", "inerters": "the inerter",
            "constraints": "the constraint", "bars": "the bar", "beams": "the beam", "strings": "the string"}


def places(problem: "Problem") -> list[str]:
    """Those, and where else several springs, or dampers, end at one place that moves; each place once."""
    from vibcli.mechanics.concurrent import ending_at, same_place

    spec, scene, found = problem.spec, problem.scene.resting, asked_places(problem.spec)
    known = {name for place in found for name in same_place(spec, scene, place)}
    for name in (*scene.bodies, *(spec.get("points") or {})) if "equivalents" in spec.get("find", ()) else ():
        has_place = name not in scene.bodies or scene.bodies[name].frame is not None
        moves = has_place and any(node.mask for node in scene.place(Reference(name, None))[1])
        several = any(len(ending_at(spec, scene, name, which)) > 1 for which in SECTIONS.values())
        if moves and several and name not in known:
            found.append(name)
            known |= same_place(spec, scene, name)
    return found


def equivalents(problem: "Problem", _: "Report") -> Iterator[Section]:
    """A section to each place."""
    found = places(problem)
    if not found:
        yield from section("Equivalent springs and dampers", paragraph(
            "Nowhere do two springs, or two dampers, end at one place that moves.", hang=0))
    for place in found:
        yield from section(f"Equivalent springs and dampers at '{place}', other ends held", *_told(problem, place))


def _told(problem: "Problem", place: str) -> "Iterator[Equations | Paragraph | TableBlock]":
    from vibcli.mechanics.concurrent import ending_at

    spec, scene = problem.spec, problem.scene.resting
    there = [which for which in SECTIONS.values() if ending_at(spec, scene, place, which)]
    for which in there:
        yield from (_in_letters if problem.numeric.has_free_symbols else _in_numbers)(problem, place, which)
    if len(there) == 2:
        yield _axes(problem, place)
    left_out = [f"{NAMED_BY[kind]} '{record.name}'" for kind in OTHERS for record in (spec.get(kind) or {}).values()
                if (kind not in there or "torsion" in record) and place in _names(record)]
    if left_out:
        yield paragraph(f"Not counted: {', '.join(left_out)}.", hang=0)


def _names(value: "Expression | list[Reference] | Record | Reference") -> set[str]:
    """All names that a record refers to."""
    if isinstance(value, Reference):
        return {value.text}
    inner = value.values() if isinstance(value, Record) else value if isinstance(value, list) else ()
    return {name for one in inner for name in _names(one)}


def _in_numbers(problem: "Problem", place: str, which: str) -> Iterator[Any]:
    """Each element, and the pair."""
    found = equivalent_at(problem, place, which)
    rows = [(one.name, figure(degrees(angle)), figure(k + around), figure(around)) for one, (k, angle, around) in zip(
        found.elements, _each(problem, found.elements), strict=True)]
    size = sum(abs(float(row)) for row in _sizes(problem, found.elements))
    largest, least = (_shown(getattr(found, part).value, size) for part in ("max", "min"))
    if found.isotropic:
        rows.append(("together", "every direction", largest, ""))
    else:
        angle = degrees(found.angle.value)
        rows += [("largest", figure(angle), largest, ""), ("least", figure(angle + 90 if angle <= 0 else angle - 90),
                                                           least, "")]
    columns = 4 if which == "springs" else 3
    head = ("", "along [°]", f"{'k' if which == 'springs' else 'c'} [{UNITS[which]}]", "N/l [N/m]")
    yield TableBlock(head[:columns], tuple(row[:columns] for row in rows))
    if found.isotropic:
        yield _alike(which)


def _shown(value: float, size: float) -> str:
    """A number, zero where only rounding is left."""
    return figure(0.0 if abs(value) < 1e-13 * size else value)


def _sizes(problem: "Problem", elements: "Sequence[Concurrent]") -> list[float]:
    return evaluate([node for one in elements for node in (one.kappa, one.around)], Floats,
                    problem.configuration.at_rest)


def _each(problem: "Problem", elements: "list[Concurrent]") -> Iterator[tuple[float, float, float]]:
    """(κ, angle, N/l) of each."""
    nodes = [node for one in elements for node in one.nodes]
    size = sum(abs(one) for one in _sizes(problem, elements))
    values = told_values(problem.configuration, nodes, [1.0 if i % 4 in (1, 2) else size for i in range(len(nodes))])
    for i in range(0, len(values), 4):
        kappa, x, y, around = values[i:i + 4]
        angle = atan2(y, x)
        yield kappa, angle - pi if angle > pi / 2 else angle + pi if angle <= -pi / 2 else angle, around


def equivalent_at(problem: "Problem", place: str, which: str) -> "Equivalent":
    """That of the springs or dampers at a place, in numbers."""
    from vibcli.mechanics.equivalents import equivalent

    return equivalent(problem.configuration, elements_at(problem, place, which))


def _in_letters(problem: "Problem", place: str, which: str) -> Iterator[Any]:
    """The largest and the least, and the direction of the largest."""
    from vibcli.mechanics.concurrent import in_letters

    elements, letter = elements_in_letters(problem, place, which), "k" if which == "springs" else "c"
    yield blocks.equations(line(f"{letter}_{part} = ", in_letters(elements, part)) for part in ("max", "min"))
    try:
        yield blocks.equations([line(f"α_{letter} = ", in_letters(elements, "angle"))])
    except PhysicsError:
        yield _alike(which)


def _alike(which: str) -> "Paragraph":
    return paragraph(f"The {which} act alike in every direction.", hang=0)


def _axes(problem: "Problem", place: str) -> "Paragraph":
    """Do both pairs have the same axes?"""
    from vibcli.mechanics.concurrent import axes_differ
    from vibcli.mechanics.equivalents import share_axes

    if problem.numeric.has_free_symbols:
        differ = axes_differ(*(elements_in_letters(problem, place, which) for which in SECTIONS.values()))
        if not differ.is_zero:
            return paragraph("Springs and dampers share their axes, so that the modes of a particle on these alone are "
                             "real, only where ", maths(differ, " = 0"), ".", hang=0)
    elif not share_axes(*(equivalent_at(problem, place, which) for which in SECTIONS.values())):
        return paragraph("Springs and dampers do not share their axes: where a particle on these alone oscillates, its "
                         "modes are complex.", hang=0)
    return paragraph("Springs and dampers share their axes: the modes of a particle on these alone are real.", hang=0)


def _data(problem: "Problem") -> list[dict[str, bool | dict[str, float | list[str] | None] | str | None]] | None:
    """{place: {section: numbers}}; None of a scene with letters."""
    if problem.numeric.has_free_symbols:
        return None
    return [_row(problem, place) for place in places(problem)]


def _row(problem: "Problem", place: str) -> dict[str, bool | dict[str, float | list[str] | None] | str | None]:
    from vibcli.mechanics.concurrent import ending_at
    from vibcli.mechanics.equivalents import share_axes

    found = {which: equivalent_at(problem, place, which) for which in SECTIONS.values()
             if ending_at(problem.spec, problem.scene.resting, place, which)}
    pairs = [_pair(found.get(which)) for which in SECTIONS.values()]
    return KEY.row(place, *pairs, share_axes(*found.values()) if len(found) == 2 else None)


def _pair(one: "Equivalent | None") -> dict[str, float | list[str] | None] | None:
    if one is None:
        return None
    numbers = {part: getattr(one, part).value for part in PARTS if part != "angle"}
    return {**numbers, "angle": None if one.isotropic else one.angle.value,
            "of": [element.name for element in one.elements]}


_PAIR = (Key("max", "the largest of all directions"), Key("min", "the least"),
         Key("angle", "the direction of the largest, in (−π/2, π/2] from +x; null where all are equal"),
         Key("xx", "entry along x"), Key("xy", "entry between x and y"), Key("yy", "entry along y"),
         Key("of", "names of the elements that the pair stands for"))
KEY = Key("equivalents", "the pairs of springs and dampers that resist like those that end at one place, a list; null "
          "of a scene with letters", _data, each=(
    Key("place", "the point or body at which they end"),
    Key("stiffness", "the pair of springs; null where no spring ends there", of=_PAIR),
    Key("damping", "the pair of dampers; null where no damper ends there", of=_PAIR),
    Key("share_axes", "have both pairs the same axes; null where there is one alone")))
