"""What is given, and the coordinates."""

from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.base.enumeration import listed
from vibcli.language.record_calls import own
from vibcli.notation.names import NAMED
from vibcli.notation.numbers import figure, with_unit
from vibcli.report.blocks import (
    Definition,
    Definitions,
    Maths,
    Name,
    Paragraph,
    Section,
    Typed,
    maths,
    paragraph,
    section,
    separated,
)
from vibcli.report.sections.too_long import brief, passed_over, places_told
from vibcli.symbolic.evaluation import Floats

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.language.reader import Expression, Record
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene

MOVES = {"slide": "displacement", "pin": "rotation", "roll": "rolling", "turn": "rotation"}
FREELY = "displacement of {} to the right", "displacement of {} upwards", "rotation of {}"    # of `move: [x, y, phi]`

OF_MEMBERS = {"u": "displacement", "along": "displacement along", "across": "displacement across", "phi": "turn",
              "slope": "slope", "oscillator": "oscillator"}


def given(problem: "Problem", _: "Report") -> Iterator[Section]:
    items, letters, names = [], [], frozenset(problem.spec.parameters)
    for name, record in problem.spec.parameters.items():
        if name in problem.spec.choices:
            continue
        if "value" in record or "about" in record:
            items.append(Definition(_valued(problem, name, record, names), _about(problem, record)))
        else:
            letters.append(maths(Name(name)))
    known = Definitions(tuple(items), "   ", not any(item.about for item in items)) if items else None
    free = Paragraph((*separated(letters), "  (in letters)"), None) if letters else None
    yield from section("Given", known, free, measured(problem))


def _valued(problem: "Problem", name: str, record: "Record", names: frozenset[str]) -> tuple[Any, ...]:
    """`m = 3 kg`, in words but for a formula, whose number follows where its letters have some."""
    if "value" not in record:
        return (maths(Name(name)),)
    told = as_given(record["value"], names)
    if isinstance(told, str):
        return maths(Name(name)), f" = {told}"
    value = problem.scene.parameters.values(Floats).get(name)
    number = () if value is None else (f" = {_in_unit(value, problem.spec.dimensions.of(name))}",)
    return maths(Name(name), " = ", *told.parts), *number


def _in_unit(value: float, dimension: "Mapping[str, Fraction | int]") -> str:
    """A number and its SI unit, that of a pure one alone."""
    return with_unit(value, dimension) if dimension else figure(value)


def as_given(value: "Expression", names: Collection[str]) -> str | Maths:
    """A value as the file gives it, set in print: 3 kg in words, 2·L/3 as a formula; `names`: those of the scene."""
    from vibcli.notation.as_printed import as_printed

    if value.parts.whole:
        return as_printed(value.text, names)
    return maths(Typed(value.text, value.tree, names))


def measured(problem: "Problem") -> Definitions | None:
    """The records of a scene, None where it has none."""
    records = problem.scene.table.records
    items = tuple(Definition((f"{name}(t)",), _record(problem, name, records[name])) for name in records)
    return Definitions(items) if items else None


def _record(problem: "Problem", name: str, samples: Any) -> str:
    """A record in words: its samples, their span and the largest of them."""
    peak = max(samples.values, key=abs)
    found = f"{len(samples.times)} samples of {problem.spec.get('records')[name]['file'].text}, from " \
        f"{samples.times[0]:.6g} s to {samples.times[-1]:.6g} s, the largest {peak:.6g}"
    return f"{found} {units.text(problem.spec.dimensions.of(own(name)))}".rstrip()


def coordinates(problem: "Problem", _: "Report") -> Iterator[Section]:
    names = list(problem.scene.coordinates)
    n, told = len(names), places_told(len(names))
    items = [Definition((maths(Name(names[i])), f" [{unit(problem.system.dimension(names[i]))}]"),
                        words_of(problem, names[i])) for i in told]
    if problem.scene.held:
        yield from section("Freedom", *_no_freedom(problem))
        return
    degrees = f" ({n} degree{'s' if n != 1 else ''} of freedom)" if not problem.scene.pieces else \
        ", and those of places between which members move"
    yield from section("Generalised coordinates" + degrees,
                       Definitions(tuple(items)) if items else None, passed_over(len(told), n), *tied(problem.scene))


def words_of(problem: "Problem", name: str) -> str:
    """What a coordinate is, in words; a unit that stands in their place tells nothing beside that of the coordinate."""
    record = problem.spec.coordinates.get(name)
    about = _about(problem, record or {})
    return (about if about not in units.UNITS else "") or _moves(problem).get(name) or _on_member(name)


def _about(problem: "Problem", record: Any) -> str:
    """What the file says about a parameter or coordinate, with φ₁ for phi1 where that is the name of one."""
    from vibcli.notation.plain import plain

    names = {*problem.spec.parameters, *problem.spec.coordinates}
    return NAMED.sub(lambda found: plain.symbol(found[1]) if found[1].rstrip("'") in names else found[1],
                     record.get("about", ""))


def _on_member(name: str) -> str:
    """A coordinate that a member brings, in words."""
    from vibcli.notation.plain import plain
    from vibcli.notation.typed_values import set_in_print

    signal, bracket, place = name.partition("(")
    member, _, part = signal.partition(".")
    place = set_in_print(place.removesuffix(")"), plain.symbol)
    return f"{OF_MEMBERS[part.partition('.')[0]]} of {member} at {place}" if bracket else ""


def _no_freedom(problem: "Problem") -> list[Paragraph]:
    """Paragraphs on what holds a scene of statics, and whether rigid bodies alone fix its forces."""
    found = problem.symbolic.reactions
    kind = paragraph("none: all bodies are held, statically determinate")
    if found.degree:
        shared = [signal for signal, value in found.values.items() if value is None]
        more = f"{found.degree} force{'s' if found.degree > 1 else ''} more than statics fixes"
        kind = paragraph(f"none: all bodies are held by {more}; {listed(shared)} share the loads in any proportion")
    return [kind, *tied(problem.scene)]


def unit(dimension: "Mapping[str, Fraction | int]") -> str:
    """The SI unit of a dimension."""
    return "rad" if dimension == {} else units.text(dimension)


def _moves(problem: "Problem") -> dict[str, str]:
    """{coordinate: what it moves}, where the file does not say: the first body whose motion is that coordinate."""
    found = {}
    for body, record in (problem.spec.get("bodies") or {}).items():
        for key, words in MOVES.items():
            motion = record.get(key)
            for value in motion.values() if hasattr(motion, "values") else (motion,):
                text = getattr(value, "text", None)
                if text is not None:
                    found.setdefault(text, f"{words} of {body}")
        if "move" in record and "carrier" not in record["move"]:
            for value, words in zip(record["move"]["by"], FREELY, strict=True):
                found.setdefault(value.text, words.format(body))
    return found


def tied(scene: "Scene") -> list[Paragraph]:
    """Paragraphs on how constraints leave the independent coordinates."""
    freedom = scene.freedom
    if not freedom.conditions:
        return []
    from vibcli.report.steps.in_motion import short_form

    closed = [maths(Name(name)) for name in scene.loops.names] if scene.loops and not scene.held else []
    explicit = [maths(Name(name), " = ", brief(short_form(node))) for name, node in scene.dependent.items()
                if maths(Name(name)) not in closed and not scene.held]
    told = [paragraph(f"{freedom.coordinates} coordinate{'s' if freedom.coordinates > 1 else ''} less "
                      f"{freedom.conditions} independent condition{'s' if freedom.conditions > 1 else ''}"
                      + (": " if explicit else ""),
                      *separated(explicit))]
    if closed:
        told.append(paragraph(*separated(closed), (" follow" if len(closed) > 1 else " follows")
                              + " by closing the loops", hang=None))
    return told + [paragraph(f"'{name}' is redundant: it follows from the other constraints", hang=None)
                   for name in freedom.redundant]
