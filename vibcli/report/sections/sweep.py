"""Quantities over one or two parameters: tables, where branches of natural modes meet, why values are missing."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.base.enumeration import listed
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Name, Section, TableBlock, Words, maths, paragraph, section
from vibcli.report.keys import Key
from vibcli.report.sections.requested_signals import symbol

if TYPE_CHECKING:
    import numpy as np

    from vibcli.plots.figure import Figure
    from vibcli.quantities.sweep import Gap, Sweep
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem

SHOWN_COLUMNS, ORDERS = 7, (1, 2)       # of a grid as text; lines of a Campbell diagram
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
SYMBOLS = {"omega": "ω", "zeta": "ζ", "frequency": "f", "period": "T", "decay": "δ"}


def sweep(problem: "Problem", report: "Report") -> Iterator[Section]:
    """A table over one parameter, or one for each quantity over two."""
    found = report.wanted.sweep
    told = [paragraph(text) for text in (*_meetings(found), *_gaps(found), *_stopped(found))]
    if len(found.axes) == 1:
        yield from section(f"Over {_range(found.axes[0])}", _table(found), *told)
        return
    for text, unit, values in zip(_labels(found), found.units, found.columns, strict=True):
        yield from section(f"{text}{_in(unit)} over {' and '.join(map(_range, found.axes))}", _grid(found, values))
    yield from section("What has to be said of these values", *told)


def _range(axis):
    return f"{symbol(axis.name)} from {_told(axis, axis.shown[0])} to {_told(axis, axis.shown[-1])}"


def _told(axis, value):
    return f"{figure(value)} {_unit_told(axis)}".rstrip()


def _unit_told(axis):
    return axis.unit.replace("*", "·").replace("^2", "²").replace("^3", "³")


def _in(unit):
    return f" [{unit}]" if unit not in ("", "1") else ""


def _labels(found):
    return [_label(one) for one in found.asked]


def _label(expression):
    """A quantity or an expression of some as it is printed: ω₁ of omega[1], f₁ of frequency[1], L·φ̇."""
    tree = expression.tree
    head = SYMBOLS.get(getattr(tree, "head", ""))
    if head is None or tree.args or len(tree.indices) != 1:
        return symbol(expression.text)
    return head + str(tree.indices[0]).translate(SUBSCRIPTS)


def _table(found):
    axis, changed = found.axes[0], _changed(found)
    head: list[Any] = [maths(Name(axis.name), *[Words(f" [{_unit_told(axis)}]")] * bool(axis.unit))]
    columns = [[figure(value) for value in axis.shown]]
    for expression, text, unit, values in zip(found.asked, _labels(found), found.units, found.columns, strict=True):
        head.append(text + _in(unit))
        columns.append([figure(float(value)) if value == value else "–" for value in values])
        if changed and (branch := found.branch(expression)) is not None:
            head.append("branch")
            columns.append([str(number) if number else "–" for number in branch])
    return TableBlock(tuple(head), tuple(zip(*(column[:found.done] for column in columns), strict=True)))


def _changed(found):
    """Do branches change places?"""
    return found.branches is not None and any(one.crosses for one in found.branches.meetings)


def _grid(found, values):
    down, across = found.axes
    shown = sorted({round(k * (len(across.values) - 1) / (SHOWN_COLUMNS - 1)) for k in range(SHOWN_COLUMNS)})
    head = (maths(Name(down.name), *[Words(f" [{_unit_told(down)}]")] * bool(down.unit)),
            *(maths(Name(across.name), Words(" = " + _told(across, across.shown[k]))) for k in shown))
    rows = ((figure(down.shown[i]), *(figure(float(values[i, k])) if values[i, k] == values[i, k] else "–"
                                      for k in shown)) for i in range(len(down.values)))
    return TableBlock(head, tuple(rows))


def _meetings(found):
    """Where branches cross or veer, in words."""
    if found.branches is None:
        return
    axis, name = found.axes[0], symbol(found.axes[0].name)
    for one in found.branches.meetings:
        first, second = one.branches
        where = f"at {name} = {_told(axis, one.value)}"
        if one.crosses:
            yield f"Branches {first} and {second} cross {where}: each keeps its shape."
        else:
            yield (f"Branches {first} and {second} veer {where}: their frequencies come as near as "
                   f"{figure(100 * one.gap, digits=3)} %, and each takes the other's shape.")


def _gaps(found):
    """Why there are no values, and where."""
    for gap in found.gaps:
        texts = [text for text, one in zip(_labels(found), found.asked, strict=True) if one.text in gap.texts]
        yield f"{listed(texts)}: no value {_where(found, gap)}: {gap.reason}."


def _where(found, gap: "Gap"):
    if len(found.axes) > 1:
        return f"at {len(gap.places)} of {found.columns[0].size} places"
    axis, numbers = found.axes[0], [place[0] for place in gap.places]
    runs, start = [], numbers[0]
    for one, two in [*pairwise(numbers), (numbers[-1], None)]:
        if two != one + 1:
            runs.append((start, one))
            start = two
    return f"for {symbol(axis.name)} = " + listed([
        _told(axis, axis.shown[a]) if a == b else f"{figure(axis.shown[a])} … {_told(axis, axis.shown[b])}"
        for a, b in runs])


def _stopped(found):
    if found.problem.work.interrupted:
        yield f"Interrupted: {found.done} of {found.columns[0].size} values were found."


def sweep_figure(found: "Sweep") -> "Figure":
    """Curves over one parameter, a panel for each unit; over two, contours of each quantity."""
    from vibcli.plots.figure import Figure

    panels = _contours(found) if len(found.axes) > 1 else _panels(found)
    return Figure(found.problem.spec.get("title") or "", tuple(panels))


def _panels(found):
    from vibcli.plots.figure import Panel
    from vibcli.plots.prefixes import labelled

    axis, groups = found.axes[0], {}
    for number, unit in enumerate(found.units):
        groups.setdefault(unit, []).append(number)
    for unit, numbers in groups.items():
        curves = [curve for number in numbers for curve in _curves(found, number, numbers)]
        names = ", ".join(_labels(found)[number] for number in numbers)
        yield Panel(labelled(symbol(axis.name), _unit_told(axis)), labelled(names, unit if unit != "1" else ""),
                    curves=(*_engine_orders(found, unit, numbers), *curves), x_range=(axis.shown[0], axis.shown[-1]))


def _curves(found, number, together):
    """The curve of a quantity; of natural modes that belong to branches, that of the branch of its number."""
    from vibcli.plots.figure import Curve

    text, expression, x = _labels(found)[number], found.asked[number], found.axes[0].shown
    kinds = {n: found.asked[n].tree.head for n in together if found.numbered(found.asked[n]) is not None}
    own = [n for n in together if kinds.get(n) == kinds.get(number)]
    if number not in kinds or not _changed(found):
        return [Curve(text, x, tuple(map(float, found.columns[number])))]
    branch = found.numbered(expression)
    y = [_of_branch(found, own, branch, k) for k in range(len(x))]
    return [Curve(f"{text.rstrip('₀₁₂₃₄₅₆₇₈₉')}, branch {branch}", x, tuple(y))]


def _of_branch(found, numbers, branch, k):
    return next((float(found.columns[n][k]) for n in numbers if found.branch(found.asked[n])[k] == branch),
                float("nan"))


def _engine_orders(found, unit, numbers):
    """The lines ω = Ω and 2Ω of a Campbell diagram, where a rate is swept over."""
    from vibcli.plots.figure import Curve

    axis = found.axes[0]
    rate = found.problem.spec.dimensions.of(axis.name) == units.RATE
    if unit not in ("rad/s", "Hz") or not rate:
        return []
    import numpy as np

    top = max((float(np.nanmax(found.columns[n])) for n in numbers if np.isfinite(found.columns[n]).any()), default=0.0)
    per = np.array(axis.in_si) / (2 * np.pi if unit == "Hz" else 1.0)
    lines = []
    for order in ORDERS:
        y = np.where(order * per <= top, order * per, np.nan)
        last = int(np.flatnonzero(np.isfinite(y))[-1]) if np.isfinite(y).any() else 0
        lines.append(Curve(f"{order}×", axis.shown, tuple(map(float, y)), "guide",
                           tuple(f"{order}×" * (k == last) for k in range(len(y)))))
    return lines


def _contours(found):
    """Lines of one value each over two parameters."""
    import numpy as np
    from contourpy import contour_generator

    from vibcli.plots.figure import Curve, Panel
    from vibcli.plots.prefixes import labelled

    down, across = found.axes
    for text, unit, values in zip(_labels(found), found.units, found.columns, strict=True):
        made, curves = contour_generator(across.shown, down.shown, _masked(values)), []
        for level in _levels(values):
            x, y = [], []
            for line in made.lines(level):
                places = np.asarray(line)
                x += [*places[:, 0].tolist(), float("nan")]
                y += [*places[:, 1].tolist(), float("nan")]
            curves.append(Curve(f"{text} = {figure(level)}{'' if unit == '1' else ' ' + unit}", tuple(x), tuple(y)))
        yield Panel(labelled(symbol(across.name), _unit_told(across)), labelled(symbol(down.name), _unit_told(down)),
                    curves=tuple(curve for curve in curves if curve.x),
                    x_range=(across.shown[0], across.shown[-1]), y_range=(down.shown[0], down.shown[-1]))


def _masked(values):
    import numpy as np

    return np.ma.masked_invalid(values)


def _levels(values: "np.ndarray") -> "Sequence[float]":
    """Round values within those that are met."""
    import numpy as np

    from vibcli.plots.ticks import ticks

    known = values[np.isfinite(values)]
    low, high = (float(known.min()), float(known.max())) if known.size else (0.0, 0.0)
    if not low < high:
        return []
    return [place for place, _ in ticks(low, high, lambda found: len(found) <= 6) if low < place < high]


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


def sweep_data(found: "Sweep") -> dict:
    """The sweep with the keys of --json."""
    def listed_values(values):
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
