"""Variants of a problem for homework: the values that its parameters take, what is asked, which mistakes are known."""

import re
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from vibcli.base.diagnostics import quoted
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.document.document import Mapping, Scalar
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Choice, Kind, Many, OneOf, Quantity, WholeNumber
from vibcli.language.named_elements import Named
from vibcli.language.reader import ByName, Expression, Record
from vibcli.language.sections.parameter import UNIT
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import ExpressionError

if TYPE_CHECKING:
    from vibcli.language.document.nodes import DocumentNode
    from vibcli.language.reader import Reader

MOST_VALUES, MOST_ASKED, MOST_MISTAKES = 10_000, 20, 40
MOST_CANDIDATES, MOST_SAMPLED = 1_000_000, 100_000
SERIES = ("R5", "R10", "R20", "R40")
GATES = {
    "require": "the comparisons under `require`",
    "regime": "the same kind of solution as the scene itself: damping, stability, number of modes",
    "readable": "keys between 0.001 and 100000 in their unit, none within its band of a given value or another key",
    "told": "every parameter on which a key depends is quoted in the question or lettered in the figure",
    "apart": "no mistake leads into the band of its key",
    "routes": "the key found by a shared derivation is the one of the scene read anew, and of its closed form",
}
OFF = "off"         # of a known mistake that is not looked for
SIGNS = re.compile(r"<=|>=|<|>")


class Requirement(NamedTuple):
    """left < right, likewise with <=, > and >=; `text`: as written, `where`: its place."""

    left: Expression
    sign: str
    right: Expression
    text: str
    where: Any


class _Requirement(Kind):
    """The Comparisons that a text says: two of 0.1 < zeta[1] < 0.7."""

    wants = "a comparison such as zeta[1] < 0.7"

    def read(self, node: Any, reader: Any) -> Any:
        text = node.text if isinstance(node, Scalar) else ""
        signs = list(SIGNS.finditer(text))
        if not 1 <= len(signs) <= 2:
            return reader.expected(node, self.wants)
        starts, ends = [0, *(sign.end() for sign in signs)], [*(sign.start() for sign in signs), len(text)]
        for start, end in zip(starts, ends, strict=True):
            if not text[start:end].strip():
                return reader.report(node.place(max(start - 1, 0), 1), "a side of this comparison is missing",
                                     f"write {self.wants.partition(' as ')[2]}")
        sides = [_side(node, start, end, reader) for start, end in zip(starts, ends, strict=True)]
        reader.later.update(side.scalar for side in sides if side is not None)
        if None in sides:
            return None
        return [Requirement(left, sign.group(), right, text, node.where)
                for (left, right), sign in zip(pairwise(sides), signs, strict=True)]

    def schema(self) -> dict[str, Any]:
        return {"type": "string"}


def _side(node: Scalar, start: int, end: int, reader: "Reader") -> Expression | None:
    """One side of a comparison, None where something was reported."""
    from vibcli.reader.sides import report_unreadable, side

    start += len(node.text[start:end]) - len(node.text[start:end].lstrip())
    try:
        return side(node, start, end, reader)
    except ExpressionError as error:
        return report_unreadable(node, error, reader, start)


class AskedQuantity(NamedTuple):
    """A quantity that is asked of a variant: in which unit, '' where that is left open, for how many points, and the
    relative tolerance, an Expression until it is checked, None where it follows from rounding."""

    asked: Expression
    unit: str
    points: int
    rtol: Any


class _Asked(Kind):
    wants = "a mapping from quantities to {unit, points}"

    def read(self, node: Any, reader: Any) -> Any:
        if not isinstance(node, Mapping):
            return reader.expected(node, self.wants)
        if not node.entries:
            return reader.report(node.where, "nothing is asked", "name quantities, as in omega[1]: rad/s, or leave "
                                 "`ask` out: then those of `answers` are asked")
        if len(node.entries) > MOST_ASKED:
            return reader.report(node.where, f"{len(node.entries)} quantities are asked; the limit is {MOST_ASKED}",
                                 "divide the problem")
        return [one for key, value in node.entries.values() if (one := self._one(key, value, reader)) is not None]

    def _one(self, key: Scalar, value: "DocumentNode", reader: "Reader") -> AskedQuantity | None:
        try:
            tree = reader.at_places(parse(key.text))
        except ExpressionError as error:
            from vibcli.reader.sides import report_unreadable

            return report_unreadable(key, error, reader)
        nothing = isinstance(value, Scalar) and not value.text.strip()
        named = key.text, key.where
        record = Record(None, *named, {}, {}) if nothing else ASKED.read(value, reader, *named)
        if record is None:
            return None
        return AskedQuantity(Expression(key, tree), record.get("unit", ""), record.get("points", 1), record.get("rtol"))

    def schema(self) -> dict[str, Any]:
        return {"type": "object", "additionalProperties": {"anyOf": [{"type": "null"}, ASKED.schema()]}}


class _Mistakes(Kind):
    """Each mistake is a part of a scene: a node, merged over the scene as a case is; the word `off` where it is off."""

    wants = "a mapping from mistakes, in words, to what they change in the scene"

    def read(self, node: Any, reader: Any) -> Any:
        if not isinstance(node, Mapping):
            return reader.expected(node, self.wants)
        if len(node.entries) > MOST_MISTAKES:
            return reader.report(node.where, f"{len(node.entries)} mistakes; the limit is {MOST_MISTAKES}")
        for key, (key_node, value) in node.entries.items():
            if isinstance(value, Scalar) and value.text == OFF:
                continue
            if not isinstance(value, Mapping) or not value.entries:
                reader.expected(value, f"the part of the scene that this mistake changes, or the word {OFF}")
            for word in {"cases", "variants"} & set(value.entries if isinstance(value, Mapping) else ()):
                reader.report(key_node.where, f"the mistake {quoted(key)} cannot hold {word}")
        return ByName({key: value for key, (_, value) in node.entries.items()},
                      {key: key_node.where for key, (key_node, _) in node.entries.items()})

    def schema(self) -> dict[str, Any]:
        return {"type": "object", "additionalProperties": {"anyOf": [{"type": "object"}, {"enum": [OFF, False]}]}}


RANGE = Element(
    "range",
    "Values of a varied parameter, evenly spaced, or preferred numbers of ISO 3 between two ends.",
    {
        "from": Field(Quantity(), "the first value, whose unit all have", required=True),
        "to": Field(Quantity(), "the last value, which the steps reach", required=True),
        "step": Field(Quantity(), "from one value to the next"),
        "series": Field(Choice(*SERIES), "preferred numbers: R5, R10, R20 or R40"),
    },
    exclusive=(("step", "series"),),
    needs=(("step", "series"),),
    example="set_of_variants",
)
ASKED = Element(
    "asked quantity",
    "What is asked of each variant: its unit and its points.",
    {
        "unit": Field(UNIT, "the unit in which the answer is asked; that of `answers` unless given"),
        "points": Field(WholeNumber(1000), "how many points it gives, 1 unless given"),
        "rtol": Field(Quantity("1"), "relative tolerance; that of rounding to three figures on the way unless given"),
    },
    short="unit",
    example="set_of_variants",
)
VALUES = OneOf("a list of values, or a range {from, to, step}", sequence=Many(Quantity(), 1, MOST_VALUES),
               mapping=RANGE)
ELEMENT = Element(
    "set of variants",
    "Homework of this problem: each candidate of the grid of `parameters` and `rows` is solved, and kept as a variant "
    "where it passes all gates (`vibcli variants`). What `solve` and `check` find does not hang on it.",
    {
        "parameters": Field(Named(VALUES, "a mapping from parameters to their values"),
                            "the values of each parameter, a list or a range; a parameter without a value may be "
                            "varied too"),
        "rows": Field(Many(Named(Quantity(), "a mapping from parameters to values"), 1, MOST_VALUES),
                      "values of parameters that go together"),
        "require": Field(Many(_Requirement(), 1, 20), "comparisons that a variant fulfils, as in zeta[1] < 0.7"),
        "printed": Field(Named(Choice("2", "3", "4", "5", "6", *SERIES), "a mapping from parameters to figures"),
                         "to how many figures, or in which series, a parameter that is chosen is printed: the scene is "
                         "solved again with that"),
        "ask": Field(_Asked(), "the quantities that are asked; those of `answers` that are numbers, or in letters, "
                               "unless given"),
        "mistakes": Field(_Mistakes(), "known mistakes: parts of the scene, merged over it as cases are, and wrong "
                                       "values by quantities, as in {answers: {\"omega_d[1]\": \"omega[1]\"}}; `off` "
                                       "where one that `vibcli explain mistakes` lists is not looked for"),
        "sample": Field(WholeNumber(MOST_SAMPLED), "how many candidates of a larger grid are taken"),
        "without": Field(Many(Choice(*GATES), 1, len(GATES)), "gates that are switched off"),
    },
    needs=(("parameters", "rows"),),
    example="set_of_variants",
)
