"""Evidence in words and tables, as a report that every format renders, and as data."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby
from typing import TYPE_CHECKING, Any

from vibcli.evidence.timing import SPENT, STOPPED
from vibcli.evidence.verdict import beside, verdict
from vibcli.report.blocks import Document, Paragraph, Picture, Section, TableBlock, paragraph

if TYPE_CHECKING:
    from vibcli.evidence.compared import Evidence, WorkPrecision
    from vibcli.evidence.reference.settled import TrueValues
    from vibcli.evidence.timing import Point

MANY = 6                # settings of a method, of which not all are told in a table
SHORT = 32              # characters of a reason that stand in a table, longer ones below it
HEAD = ("method", "with", "ms (quartiles)", "error", "bound")


def document(found: "Evidence", pictures: bool = False) -> Document:
    """A section for each quantity, with its table and its sentence, and what was left out."""
    title = found.problem.spec.get("title") or "Run time and true error"
    sections = [_section(one, pictures, number) for number, one in enumerate(found.compared, 1)]
    return Document(title, None, (), (*drawn_values(found.drawn), *sections, *_left_out(found), *_stages(found)))


def drawn_values(drawn: Mapping[str, str]) -> tuple[Section, ...]:
    """A section with the values that letters without one are given."""
    if not drawn:
        return ()
    values = ", ".join(f"{name} = {value}" for name, value in drawn.items())
    return (Section("Values", (paragraph(
        f"{values}: drawn for letters that have none, the same at every run; --set gives others."),)),)


def _section(one: "WorkPrecision", pictures: bool, number: int) -> Section:
    true, points = one.subject.true, one.points
    blocks: list[Any] = [
        paragraph(_reference(true)),
        TableBlock(HEAD, tuple(_row(point, true.digits) for point in _shown(points))), *_reasons(points[1:]),
        paragraph(f"{verdict(points)}.")]
    if pictures and worth_a_picture(one):
        from vibcli.evidence.picture import figure, picture_of

        blocks.insert(1, Picture(f"curve-{number}", "Run time over true error", picture_of(figure([one]))))
    return Section(f"{one.subject.asked}: {one.subject.title}", tuple(blocks))


def _reference(true: "TrueValues") -> str:
    """How true values are known: alike in two precisions, or in one, as far as what is cut off does not count."""
    if true.before == true.working:
        return (f"True values: mpmath, {true.digits} digits of {true.working}; "
                "what sums and integrals leave out changes later ones.")
    return f"True values: mpmath, {true.digits} digits alike with {true.before} and {true.working}."


def markdown(one: "WorkPrecision") -> str:
    """The table of a quantity and its sentence, without a title."""
    from vibcli.report.formats.markdown import render

    page = render([Document("", None, (), (_section(one, False, 1),))], None)
    return page.split("\n## ", 1)[1].split("\n", 1)[1].strip()


def _shown(points: "list[Point]") -> "Iterator[Point]":
    """Those of a table: of a method with many settings every third, the last, and the one that the sentence names."""
    named = beside(points)
    for _, some in groupby(points, key=lambda point: point.method):
        found = list(some)
        yield from (point for i, point in enumerate(found) if len(found) < MANY or not i % 3 or i == len(found) - 1
                    or point is named)


def worth_a_picture(one: "WorkPrecision") -> bool:
    """Did another method than ours answer?"""
    return any(point.error is not None for point in one.points[1:])


def _row(point: "Point", digits: int) -> tuple[str, str, str, str, str]:
    """Errors are told as far as so many digits of the true value go; what did not end takes longer than its time."""
    low, middle, high = map(_in_ms, point.seconds)
    if point.error is None:
        over = "over " * (point.why in (STOPPED, SPENT))
        return point.method, point.setting, over + middle if point.seconds[1] else "", _brief(point.why), ""
    least = 10.0**-digits
    return (point.method, point.setting, f"{middle} ({low} … {high})" if point.runs > 1 else f"{middle} (one run)",
            f"< {least:.0e}" if point.error <= least else f"{point.error:.1e}",
            "" if point.bound is None else f"{float(point.bound):.1e}")


def _brief(why: str) -> str:
    return why if len(why) <= SHORT else "none"


def _reasons(points: "Sequence[Point]") -> list[Paragraph]:
    """Why others than ours have no answer, where that is long; of ours the sentence tells it."""
    methods: dict[str, list[str]] = {}
    for point in points:
        if point.error is None and _brief(point.why) != point.why:
            methods.setdefault(point.why, []).append(point.method)
    return [_reason(why, names) for why, names in methods.items()]


def _left_out(found: "Evidence") -> tuple[Section, ...]:
    if not found.left_out:
        return ()
    by_reason: dict[str, list[str]] = {}
    for asked, why in found.left_out:
        by_reason.setdefault(why, []).append(asked)
    return (Section("Not compared", tuple(_reason(*pair) for pair in by_reason.items())),)


def _stages(found: "Evidence") -> tuple[Section, ...]:
    if not found.stages:
        return ()
    rows = tuple((one.stage, _ms(one) if one.taken else "",
                  one.why.partition(":")[0] or _ms(one) if not one.taken else "") for one in found.stages)
    reasons: dict[str, list[str]] = {}
    for one in found.stages:
        if not one.taken and ": " in one.why:
            reasons.setdefault(one.why.partition(": ")[2], []).append(one.stage)
    return (Section("Stages, and what was skipped [ms]", (
        TableBlock(("stage", "taken", "skipped, would cost"), rows),
        *(_reason(why, stages) for why, stages in reasons.items()))),)


def _ms(cost: Any) -> str:
    return "" if cost.seconds is None else _in_ms(cost.seconds)


def _in_ms(seconds: float) -> str:
    """To three digits, never with an exponent of what is long."""
    return f"{1e3 * seconds:.3g}" if seconds < 0.9995 else f"{1e3 * seconds:.0f}"


def _reason(why: str, asked: Sequence[str]) -> Paragraph:
    return paragraph(f"{', '.join(dict.fromkeys(asked))}: {why}.")


def data(found: "Evidence") -> dict[str, Any]:
    """The same as data; seconds are of processor time."""
    return {"title": found.problem.spec.get("title"), "drawn": found.drawn or None,
            "compared": [_data(one) for one in found.compared],
            "stages": [{"stage": one.stage, "taken": one.taken, "seconds": one.seconds, "why": one.why or None}
                       for one in found.stages],
            "not compared": [{"asked": asked, "why": why} for asked, why in found.left_out]}


def _data(one: "WorkPrecision") -> dict[str, Any]:
    true = one.subject.true
    return {"asked": one.subject.asked, "about": one.subject.title, "kind": one.subject.kind,
            "reference": {"digits": true.digits, "working digits": [true.before, true.working]},
            "verdict": verdict(one.points),
            "points": [{"method": point.method, "with": point.setting or None, "seconds": point.seconds[1],
                        "quartiles": [point.seconds[0], point.seconds[2]], "runs": point.runs, "error": point.error,
                        "error below": None if point.error is None else point.error <= 10.0**-true.digits,
                        "bound": None if point.bound is None else float(point.bound), "why": point.why or None}
                       for point in one.points]}
