"""Expected answers: a quantity and its value or expression, which `vibcli check` compares."""

from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.language.document.document import Mapping
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Kind, Quantity
from vibcli.language.reader import Expression
from vibcli.quantities.quantity import EQUATION, declared
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import ExpressionError, QuantityRef

if TYPE_CHECKING:
    from vibcli.language.document.nodes import DocumentNode
    from vibcli.language.reader import Reader

ELEMENT = Element(
    "answer",
    "What the scene is known to answer: `omega[1]: 21.9 rad/s`, `equation[phi]: m*phi'' + k*phi = 0`, or of "
    "parameters `k_t: 5.00 N/m`. A written number allows half a unit of its last digit, never more than 0.5 %; one of "
    "fewer than three digits is exact, and so is an expression, unless `rtol` is given.",
    {
        "value": Field(Quantity(), "the expected value", required=True),
        "rtol": Field(Quantity("1"), "relative tolerance"),
    },
    short="value",
    example="mass_spring_damper",
)
_EQUATION = Element("equation", "An expected equation of motion, up to a non-zero factor.",
                    {"value": Field(Quantity(equation="m*x'' + k*x = 0"), "the equation, as `left = right`",
                                    required=True)},
                    short="value")


class Answer(NamedTuple):
    """One expected answer: the quantity asked for, the expected expression, and the tolerance."""

    asked: Expression
    expected: Expression
    rtol: Expression | None


class Answers(Kind):
    wants = "a mapping from quantities to expected values"

    def read(self, node: "DocumentNode", reader: "Reader") -> list[Answer] | None:
        if not isinstance(node, Mapping):
            return reader.expected(node, self.wants)
        answers = []
        for key, value in node.entries.values():
            try:
                tree = reader.at_places(parse(key.text))
            except ExpressionError as error:
                reader.report(key.place(error.offset, error.width), error.message, error.hint)
                continue
            quantity = declared(tree) if isinstance(tree, QuantityRef) else None
            equation = key.text.startswith(("equation", "motion")) or (
                quantity is not None and quantity.kind == EQUATION)
            element = _EQUATION if equation else ELEMENT
            record = element.read(value, reader, key.text, key.where)
            if record is not None:
                answers.append(Answer(Expression(key, tree), record["value"], record.get("rtol")))
        return answers

    def schema(self) -> dict[str, Any]:
        return {"type": "object", "additionalProperties": ELEMENT.schema()}


KIND = Answers()
