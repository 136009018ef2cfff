"""Variants of a file: their values in full, each of a parameter that may be varied and in its dimension."""

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.base.spelling import nearest
from vibcli.language.document.document import Scalar
from vibcli.language.given_values import FIGURES, GivenValue, converted, giver, number_and_unit, unit_of_text
from vibcli.language.reader import ByName, Expression, Reader
from vibcli.quantities.quantity import FUNCTION, OF_STATE, TRUTH, kind_of
from vibcli.reader.answer_check import as_quantity, check_question, checked
from vibcli.reader.quantity_check import can_be_asked
from vibcli.reader.sections.answer import Answer
from vibcli.reader.sections.variants import MOST_CANDIDATES, MOST_VALUES, SERIES, AskedQuantity, Requirement
from vibcli.symbolic.parser import parse

if TYPE_CHECKING:
    from vibcli.base.errors import Where
    from vibcli.language.reader import Record
    from vibcli.language.spec import Spec

PREFERRED = {       # ISO 3 (1973), between 1 and 10
    "R5": "1 1.6 2.5 4 6.3",
    "R10": "1 1.25 1.6 2 2.5 3.15 4 5 6.3 8",
    "R20": "1 1.12 1.25 1.4 1.6 1.8 2 2.24 2.5 2.8 3.15 3.55 4 4.5 5 5.6 6.3 7.1 8 9",
    "R40": "1 1.06 1.12 1.18 1.25 1.32 1.4 1.5 1.6 1.7 1.8 1.9 2 2.12 2.24 2.36 2.5 2.65 2.8 3 3.15 3.35 3.55 3.75 4 "
           "4.25 4.5 4.75 5 5.3 5.6 6 6.3 6.7 7.1 7.5 8 8.5 9 9.5",
}
DECADES = range(-60, 60)


class VariantRules(NamedTuple):
    """axes: {parameter: values} of those that go together, the grid of all axes being the candidates; require, ask: as
    checked; printed: {chosen parameter: its figures or series}; mistakes: {name: part of the scene, the word `off` of a
    known one that is not looked for}; sample: how many candidates are taken, None of all; without: the gates that are
    switched off; places: of the grid, where only some are solved."""

    axes: list[dict[str, list[GivenValue]]]
    require: list[Requirement]
    printed: dict[str, str]
    ask: list[AskedQuantity]
    mistakes: ByName
    sample: int | None
    without: tuple[str, ...]
    where: "Where"
    places: list[tuple[int, ...]] | None = None

    @property
    def candidates(self) -> int:
        """How many there are in the grid."""
        count = 1
        for axis in self.axes:
            count *= len(next(iter(axis.values())))
        return count


def preferred(series: str, low: Fraction, high: Fraction) -> list[Fraction]:
    """The preferred numbers of a series from one number to another, both positive."""
    tens = [ten for decade in DECADES if low < 10 * (ten := Fraction(10)**decade) and ten <= high]
    every = (Fraction(text) * ten for ten in tens for text in PREFERRED[series].split())
    return [number for number in every if low <= number <= high]


def stays_in_letters(spec: "Spec", axes: "list[dict[str, list[GivenValue]]]") -> bool:
    """Are there parameters left that no variant gives a value, so that keys are expressions?"""
    given = {name for axis in axes for name in axis} | set(spec.choices)
    return any("value" not in record and name not in given for name, record in spec.parameters.items())


def varied(spec: "Spec") -> Iterator[tuple[Expression, str]]:
    """(value as written, its parameter) of all that a file gives to vary."""
    record = spec.get("variants")
    for name, values in record.get("parameters", {}).items():
        written = values if isinstance(values, list) else [values[key] for key in ("from", "to", "step")
                                                           if key in values]
        yield from ((value, name) for value in written)
    for row in record.get("rows", ()):
        yield from ((value, name) for name, value in row.items())


def with_variants(spec: "Spec", reader: Reader) -> "Spec":
    """The Spec with its VariantRules; reports whatever is wrong with them."""
    record, before = spec.get("variants"), len(reader.diagnostics)
    axes = _axes(spec, reader, record)
    require = [found for pairs in record.get("require", ()) for one in pairs
               if (found := _comparison(spec, reader, one)) is not None]
    for name in record.get("printed", {}):
        if name not in spec.named.get("choose", ()):
            reader.report(record["printed"].place(name), f"'{name}' is not chosen: `printed` says how chosen "
                          "parameters are rounded",
                          nearest(name, spec.choices) if spec.choices else "this scene chooses none")
    letters = stays_in_letters(spec, axes)
    ask = [found for one in record.get("ask", ()) if (found := _asked(spec, reader, one, letters)) is not None]
    seen: set[str] = set()
    for one in ask:
        if (plain := "".join(one.asked.text.split())) in seen:
            reader.report(one.asked.where, f"'{one.asked.text}' is asked twice", "leave it out once")
        seen.add(plain)
        if one.asked.text in record.get("printed", {}):
            reader.report(one.asked.where, f"'{one.asked.text}' is asked: it cannot be printed in the question",
                          "take it out of `printed` or of `ask`")
    if len(reader.diagnostics) > before:
        return spec
    rules = VariantRules(axes, require, record.get("printed", {}), ask or _from_answers(spec, letters),
                         record.get("mistakes", ByName({}, {})), record.get("sample"), tuple(record.get("without", ())),
                         record.where)
    if not rules.ask:
        reader.report(record.where, "nothing is asked: " + ("there are no `answers`" if letters else
                                                            "no quantity of `answers` is a number"),
                      "name quantities under `ask`, as in omega[1]: {unit: rad/s}")
    elif rules.candidates > MOST_CANDIDATES and rules.sample is None:
        reader.report(record.place("parameters"), f"{rules.candidates} candidates; the limit is {MOST_CANDIDATES}",
                      "widen the steps, or take some: sample: 5000")
    return spec.with_sections(variants=rules)


def _axes(spec: "Spec", reader: Reader, record: "Record") -> list[dict[str, list[GivenValue]]]:
    """[{parameter: values}] of all axes."""
    axes, taken = [], []
    for name, values in record.get("parameters", {}).items():
        taken.append(name)
        if _free(spec, reader, name, record["parameters"].place(name)):
            found = _values(spec, reader, name, values)
            axes += [{name: found}] if found else []
    rows = record.get("rows", [])
    if not all(rows) or not (axes or rows or taken):
        reader.report(record.where if all(rows) else record.place("rows"), "nothing is varied", "name parameters with "
                      "their values, as in m: [1 kg, 2 kg]")
        return axes
    for row in rows:
        if set(row) != set(rows[0]):
            other = min(set(row) ^ set(rows[0]))
            place = row.place(other if other in row else next(iter(row)))
            reader.report(place, "this row and the first one give values to different parameters: "
                          f"'{other}' stands in one of them", "all rows have the same names")
            return axes
    for name in rows[0] if rows else ():
        place = rows[0].place(name)
        if name in taken:
            reader.report(place, f"'{name}' stands under `parameters` and under `rows`", "leave it out of one")
        if not _free(spec, reader, name, place):
            return axes
    together = {name: [_given(reader, name, row[name]) for row in rows] for name in (rows[0] if rows else ())}
    return axes + [together] * bool(together)


def _free(spec: "Spec", reader: Reader, name: str, where: "Where") -> bool:
    """May a parameter be varied?"""
    if name not in spec.parameters:
        reader.report(where, f"there is no parameter '{name}'", nearest(name, spec.parameters))
    elif name in spec.choices:
        reader.report(where, f"'{name}' is chosen by the scene: it has the values that fulfil its condition",
                      "vary the parameters of its condition")
    elif name not in spec.independent_parameters:
        others = dict.fromkeys(f"'{other}'" for other, *_ in spec.parameters[name]["value"].parts.names
                               if other in spec.parameters)
        reader.report(where, f"'{name}' is defined by {' and '.join(others)}", "vary "
                      + ("that" if len(others) == 1 else "one of these"))
    else:
        return True
    return False


def _given(reader: Reader, name: str, value: Expression) -> GivenValue | None:
    """The GivenValue of one value; None where it is none."""
    found = number_and_unit(value)
    if found is None:
        return reader.report(value.where, "expected a number with its unit", "variants have numbers")
    return giver(found[1], name)(found[0])


def _values(spec: "Spec", reader: Reader, name: str, values: "Record | list[Expression]") -> list[GivenValue] | None:
    """The GivenValues of a list or range."""
    if isinstance(values, list):
        found = [_given(reader, name, value) for value in values]
        exact = [one and one.exact for one in found]
        for i, (value, number) in enumerate(zip(values, exact, strict=True)):
            if number is not None and number in exact[:i]:
                reader.report(value.where, f"'{value.text}' stands twice among the values of '{name}'")
        return None if None in found else found
    ends = [number_and_unit(values[key]) for key in ("from", "to")]
    if None in ends:
        return reader.report(values.where, "expected numbers with their units", "write {from: 1 kg, to: 5 kg, step: "
                             "0.5 kg}")
    (low, unit), high = ends[0], _in_unit(ends[1], ends[0][1])
    if high is None:
        return reader.report(values.place("to"), "the ends have different units", "give both one unit")
    if not low < high:
        return reader.report(values.place("to"), f"the range is empty: '{values['to'].text}' is not above "
                             f"'{values['from'].text}'", "write the smaller value first")
    numbers = _series(reader, values, low, high) if "series" in values else _steps(reader, values, unit, low, high)
    return None if numbers is None else list(map(giver(unit, name), numbers))


def _in_unit(found: tuple[Fraction, str], unit: str) -> Fraction | None:
    """A number of another unit in this one; None where they do not go together."""
    number, other = found
    if other == unit or not other:
        return number
    if not unit:
        return None
    own, its = unit_of_text(unit), unit_of_text(other)
    return converted(number, its, own) if own.dimension == its.dimension else None


def _series(reader: Reader, values: "Record", low: Fraction, high: Fraction) -> list[Fraction] | None:
    if not low > 0:
        return reader.report(values.place("from"), "preferred numbers are positive", "begin above zero")
    return preferred(values["series"], low, high) or reader.report(
        values.where, f"no number of {values['series']} lies between these ends", f"take one of {', '.join(SERIES)}")


def _steps(reader: Reader, values: "Record", unit: str, low: Fraction, high: Fraction) -> list[Fraction] | None:
    """From one end to the other, which the last step reaches but for 1e-12 of it: decimals stand for radians too."""
    found = number_and_unit(values["step"])
    step = None if found is None else _in_unit(found, unit)
    if step is None:
        return reader.report(values.place("step"), "expected a number with the unit of the ends")
    if not step > 0:
        return reader.report(values.place("step"), "the step leads nowhere: it is not above zero")
    count = (high - low) / step
    if count > MOST_VALUES:
        return reader.report(values.place("step"), f"{int(count) + 1} values; the limit is {MOST_VALUES}",
                             "widen the step")
    if not round(count) or abs(count - round(count)) > Fraction(1, 10**FIGURES):
        last = giver(unit, "")(low + int(count) * step).expression.text
        return reader.report(values.place("to"), f"the steps miss '{values['to'].text}'", f"the last one is {last}")
    return [*(low + k * step for k in range(round(count))), high]


def _comparison(spec: "Spec", reader: Reader, one: Requirement) -> Requirement | None:
    """A Requirement with its sides finished; None where something is wrong with it."""
    from vibcli.reader.choices import check_sides, finished_sides

    left, right = finished_sides(spec, one.left, one.right)
    before = len(reader.diagnostics)
    for side in (left, right):
        for tree in side.parts.quantities:
            place = side.scalar.place(tree.start, tree.end - tree.start)
            if can_be_asked(spec, reader, side, tree) and kind_of(spec, tree) in (*OF_STATE, TRUTH):
                reader.report(place, f"'{tree.text}' cannot be compared: it is no number")
    if len(reader.diagnostics) > before or not check_sides(spec, reader, left, right):
        return None
    return one._replace(left=left, right=right)


def _asked(spec: "Spec", reader: Reader, one: AskedQuantity, letters: bool) -> AskedQuantity | None:
    """An AskedQuantity that can be asked, in a unit that it can have; None where something is wrong with it. letters:
    are parameters left without value?"""
    asked, before = as_quantity(spec, one.asked), len(reader.diagnostics)
    kind = kind_of(spec, asked.tree)
    if kind == TRUTH:
        return reader.report(asked.where, f"'{asked.text}' is true or false: variants ask for numbers, equations and "
                             "expressions")
    if kind == FUNCTION and not letters:
        return reader.report(asked.where, f"'{asked.text}' has numbers here, and is asked where letters are left alone",
                             "ask for its value in a motion, or for equation[…]")
    if one.unit and (letters or kind in OF_STATE):
        return reader.report(asked.where, f"'{asked.text}' is " + ("an equation" if kind in OF_STATE else "an "
                             "expression in letters") + ": it is asked in no unit", "leave the unit out")
    if one.rtol is not None and letters:
        return reader.report(one.rtol.where, f"'{asked.text}' is an expression in letters, which is exact",
                             "leave rtol out")
    if one.unit:
        text = f"1 {one.unit}"
        checked(spec, reader, Answer(asked, Expression(Scalar(text, asked.where), parse(text)), None))
    else:
        check_question(spec, reader, asked)
    if one.rtol is not None and (number_and_unit(one.rtol) is None or not 0 < _share(one.rtol) < 1):
        reader.report(one.rtol.where, f"expected a part between 0 and 1, found '{one.rtol.text}'", "write for example "
                      "rtol: 1 %")
    return one._replace(asked=asked, rtol=one.rtol and _share(one.rtol)) if len(reader.diagnostics) == before else None


def _share(expression: Expression) -> float:
    """The number that a literal such as 1 % is."""
    number, unit = number_and_unit(expression)
    return float(number) * (unit_of_text(unit).in_si(1) if unit else 1.0)


def _from_answers(spec: "Spec", letters: bool) -> list[AskedQuantity]:
    """What `answers` say that is a number once the parameters have values, in the units written there; where letters
    are left, all that is expected in them."""
    found = []
    for answer in spec.answers:
        kind = kind_of(spec, answer.asked.tree)
        if kind == TRUTH or (kind in OF_STATE and not letters):
            continue
        written = None if letters else number_and_unit(answer.expected)
        found.append(AskedQuantity(answer.asked, written[1] if written else "", 1, None))
    return found

