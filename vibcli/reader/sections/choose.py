"""Inverse questions: parameters that conditions determine."""

from typing import TYPE_CHECKING, Any

from vibcli.base.spelling import near
from vibcli.language.document.document import Scalar, Sequence
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Kind, Quantity
from vibcli.language.reader import Expression
from vibcli.reader.sides import report_unreadable, side
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import ExpressionError

if TYPE_CHECKING:
    from vibcli.base.errors import Where

BALANCE, LIMIT = "equilibrium", "stability limit"


class Condition:
    """A condition that determines a parameter: `word` BALANCE or LIMIT, or the two sides of an equation (then `word` is
    None)."""

    __slots__ = ("left", "right", "text", "where", "word")

    def __init__(self, text: str, where: "Where", word: str | None = None, left: Expression | None = None,
                 right: Expression | None = None) -> None:
        self.text, self.where, self.word, self.left, self.right = text, where, word, left, right

    @property
    def is_balance(self) -> bool:
        """Is it that the drawn position is one of equilibrium?"""
        return self.word == BALANCE

    @property
    def is_limit(self) -> bool:
        """Is it that the equilibrium is at its limit of stability?"""
        return self.word == LIMIT

    @property
    def sides(self) -> tuple[Expression, ...]:
        return () if self.word else (self.left, self.right)


class _Condition(Kind):
    wants = "an equation, or one of equilibrium, stability limit"
    hint = "write for example zeta[1] = 1"

    def read(self, node: Any, reader: Any) -> Any:
        if isinstance(node, Sequence):
            return reader.expected(node, self.wants, "one condition to a parameter: choose as many as there are")
        if not isinstance(node, Scalar) or not node.text.strip():
            return reader.expected(node, self.wants, self.hint)
        words = " ".join(node.text.split())
        if words in (BALANCE, LIMIT):
            return Condition(words, node.where, words)
        meant = near(words, (BALANCE, LIMIT))
        if "=" not in words:
            return reader.expected(node, self.wants, f"did you mean '{meant}'?" if meant else self.hint)
        try:
            equation = parse(node.text, "omega[1] = 20 rad/s")
        except ExpressionError as error:
            return report_unreadable(node, error, reader)
        sides = [side(node, tree.start, tree.end, reader) for tree in equation.children]
        return Condition(words, node.where, None, *sides)

    def schema(self) -> dict[str, Any]:
        return {"type": "string"}


ELEMENT = Element(
    "choice",
    "A parameter that a condition determines: `c: zeta[1] = 1`, an equation between quantities and parameters; "
    "`P: equilibrium`, which makes the drawn position one of equilibrium; `k: stability limit`, at which a natural "
    "frequency passes through zero, or a limit point (fold), at which the equilibrium that is followed as the "
    "parameter goes vanishes together with an unstable one. Several entries are solved together. Chosen parameters "
    "need no line under `parameters`; they are positive unless that says `sign: any`. All solutions are given, those "
    "in letters with the conditions under which they count; the scene is solved with the first, the smallest. "
    "`answers` may ask for them: `c: 2*sqrt(k*m)`, `c[2]: …`.",
    {
        "so": Field(_Condition(), "the condition that must hold", required=True),
        "from": Field(Quantity(), "the least value that is admissible; else all of the sign of the parameter are"),
        "to": Field(Quantity(), "the largest value that is admissible; angles are looked for within a turn"),
    },
    short="so",
    example="two_springs_for_two_frequencies",
)
