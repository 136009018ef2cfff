"""Quantities over one or two parameters: tables, where branches of natural modes meet, why values are missing."""

from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from vibcli.base.enumeration import listed
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Name, Section, TableBlock, Words, maths, paragraph, section
from vibcli.report.keys import Key
from vibcli.report.sections.requested_signals import symbol

if TYPE_CHECKING:
    import numpy as np

    from vibcli.language.reader import Expression
    from vibcli.quantities.sweep import Gap, Sweep, SweptAxis
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem

SHOWN_COLUMNS = 7       # of a grid as text
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
SYMBOLS = {"omega": "ω", "zeta": "ζ", "frequency": "f", "period": "T", "decay": "δ"}


def sweep(problem: "Problem", report: "Report") -> Iterator[Section]:
    """A table over one parameter, or one for each quantity over two."""
    found = report.wanted.sweep
    words = [paragraph(text) for text in (*_meetings(found), *_gaps(found), *_mode_counts(found), *_stopped(found))]
    if len(found.axes) == 1:
        yield from section(f"Over {_range(found.axes[0])}", _table(found), *words)
        return
    for text, unit, values in zip(labels(found), found.units, found.columns, strict=True):
        yield from section(f"{text}{_in(unit)} over {' and '.join(map(_range, found.axes))}", _grid(found, values))
    yield from section("What has to be said of these values", *words)


def _range(axis: "SweptAxis") -> str:
    return f"{symbol(axis.name)} from {told(axis, axis.shown[0])} to {told(axis, axis.shown[-1])}"


def told(axis: "SweptAxis", value: float) -> str:
    """A value with its unit."""
    return f"{figure(value)} {unit_told(axis)}".rstrip()


def unit_told(axis: "SweptAxis") -> str:
    """The unit of an axis as it is printed."""
    return axis.unit.replace("*", "·").replace("^2", "²").replace("^3", "³")


def _in(unit: str) -> str:
    return f" [{unit}]" if unit not in ("", "1") else ""


def labels(found: "Sweep") -> list[str]:
    """The quantities as they are printed."""
    return [_label(one) for one in found.asked]


def _label(expression: "Expression") -> str:
    """A quantity or an expression of some as it is printed: ω₁ of omega[1], f₁ of frequency[1], L·φ̇."""
    tree = expression.tree
    head = SYMBOLS.get(getattr(tree, "head", ""))
    if head is None or tree.args or len(tree.indices) != 1:
        return symbol(expression.text)
    return head + str(tree.indices[0]).translate(SUBSCRIPTS)


def _table(found: "Sweep") -> TableBlock:
    axis, changed = found.axes[0], branches_change(found)
    head: list[Any] = [maths(Name(axis.name), *[Words(f" [{unit_told(axis)}]")] * bool(axis.unit))]
    columns = [[figure(value) for value in axis.shown]]
    for expression, text, unit, values in zip(found.asked, labels(found), found.units, found.columns, strict=True):
        head.append(text + _in(unit))
        columns.append([figure(float(value)) if value == value else "–" for value in values])
        if changed and (branch := found.branch(expression)) is not None:
            head.append("branch")
            columns.append([str(number) if number else "–" for number in branch])
    return TableBlock(tuple(head), tuple(zip(*(column[:found.done] for column in columns), strict=True)))


def branches_change(found: "Sweep") -> bool:
    """Do branches change places?"""
    return found.branches is not None and any(one.crosses for one in found.branches.meetings)


def _grid(found: "Sweep", values: "np.ndarray") -> TableBlock:
    down, across = found.axes
    shown = sorted({round(k * (len(across.values) - 1) / (SHOWN_COLUMNS - 1)) for k in range(SHOWN_COLUMNS)})
    head = (maths(Name(down.name), *[Words(f" [{unit_told(down)}]")] * bool(down.unit)),
            *(maths(Name(across.name), Words(" = " + told(across, across.shown[k]))) for k in shown))
    rows = ((figure(down.shown[i]), *(figure(float(values[i, k])) if values[i, k] == values[i, k] else "–"
                                      for k in shown)) for i in range(len(down.values)))
    return TableBlock(head, tuple(rows))


def _meetings(found: "Sweep") -> Iterator[str]:
    """Where branches cross or veer, in words."""
    if found.branches is None:
        return
    axis, name = found.axes[0], symbol(found.axes[0].name)
    for one in found.branches.meetings:
        first, second = one.branches
        where = f"at {name} = {told(axis, one.value)}"
        if one.crosses:
            yield f"Branches {first} and {second} cross {where}: each keeps its shape."
        else:
            yield (f"Branches {first} and {second} veer {where}: their frequencies come as near as "
                   f"{figure(100 * one.gap, digits=3)} %, and each takes the other's shape.")


def _gaps(found: "Sweep") -> Iterator[str]:
    """Why there are no values, and where."""
    for gap in found.gaps:
        texts = [text for text, one in zip(labels(found), found.asked, strict=True) if one.text in gap.texts]
        yield f"{listed(texts)}: no value {_where(found, gap)}: {gap.reason}."


def _mode_counts(found: "Sweep") -> Iterator[str]:
    """Where the number of natural modes changes, as where one that turns comes to rest."""
    known = [one for one in found.mode_counts if one.number]
    for k, one in enumerate(known[1:], 1):
        if one.number != known[0].number:
            axis, begins, ends = found.axes[0], found.axes[0].shown[one.first], found.axes[0].shown[one.last]
            where = told(axis, begins) if begins == ends else f"{figure(begins)} … {told(axis, ends)}"
            yield (f"At {symbol(axis.name)} = {where} there are {one.number} natural modes, {known[k - 1].number} "
                   "before: they are numbered anew, rigid ones first, and curves break.")


def _where(found: "Sweep", gap: "Gap") -> str:
    if len(found.axes) > 1:
        return f"at {len(gap.places)} of {found.columns[0].size} places"
    axis, numbers = found.axes[0], [place[0] for place in gap.places]
    runs, start = [], numbers[0]
    for one, two in [*pairwise(numbers), (numbers[-1], None)]:
        if two != one + 1:
            runs.append((start, one))
            start = two
    return f"for {symbol(axis.name)} = " + listed([
        told(axis, axis.shown[a]) if a == b else f"{figure(axis.shown[a])} … {told(axis, axis.shown[b])}"
        for a, b in runs])


def _stopped(found: "Sweep") -> Iterator[str]:
    if found.problem.work.interrupted:
        yield f"Interrupted: {found.done} of {found.columns[0].size} values were found."


def sweep_columns(found: "Sweep") -> "list[tuple[str, str, np.ndarray]]":
    """[(name, unit, array)] of a sweep; over two parameters a row for each place of the grid."""
    import numpy as np

    mesh = np.meshgrid(*(axis.shown for axis in found.axes), indexing="ij")
    columns = [(axis.name, axis.unit, values.ravel()) for axis, values in zip(found.axes, mesh, strict=True)]
    for expression, unit, values in zip(found.asked, found.units, found.columns, strict=True):
        columns.append((expression.text, unit, values.ravel()))
        if (branch := found.branch(expression)) is not None:
            columns.append((f"branch of {expression.text}", "", np.where(branch, branch, np.nan).astype(float)))
    return [(name, unit, values[:found.done]) for name, unit, values in columns]


def sweep_data(found: "Sweep") -> dict[str, Any]:
    """The sweep with the keys of --json."""
    def listed_values(values: "np.ndarray") -> "list[Any]":
        return [None if x != x else x for x in values.ravel().tolist()]

    over = [{"name": axis.name, "unit": axis.unit, "values": list(axis.shown)} for axis in found.axes]
    quantities = [
        {"name": one.text, "unit": unit, "values": listed_values(values),
         "branch": None if (branch := found.branch(one)) is None else [int(b) or None for b in branch]}
        for one, unit, values in zip(found.asked, found.units, found.columns, strict=True)]
    gaps = [{"quantities": list(gap.texts), "places": [list(place) for place in gap.places], "reason": gap.reason}
            for gap in found.gaps]
    meetings = [] if found.branches is None else [
        {"branches": list(one.branches), "value": one.value, "crosses": one.crosses, "gap": one.gap}
        for one in found.branches.meetings]
    return KEY.row(over, quantities, meetings, gaps, found.done)


KEY = Key("sweep", "quantities over one or two parameters", of=(
    Key("over", "the parameters, a list", each=(
        Key("name", "the parameter"), Key("unit", "the unit of its values"), Key("values", "its values, ascending"))),
    Key("quantities", "a list of what is asked", each=(
        Key("name", "the quantity"), Key("unit", "its unit"),
        Key("values", "its values; over two parameters those of each value of the first follow one another; null where "
                      "there is none"),
        Key("branch", "to which branch, followed by its shape, a natural mode belongs at each value; null of other "
                      "quantities, and over two parameters"))),
    Key("meetings", "where branches of natural modes meet over one parameter, a list", each=(
        Key("branches", "the two"), Key("value", "of the parameter"),
        Key("crosses", "do they cross? else they veer"),
        Key("gap", "the least relative distance of frequencies that veer"))),
    Key("gaps", "why there are no values, a list", each=(
        Key("quantities", "which have none"), Key("places", "at which places of the lists of values, from 0"),
        Key("reason", "why"))),
    Key("reached", "how many values, or places of two parameters, were come to, from the first: all unless it was "
                   "interrupted")))
