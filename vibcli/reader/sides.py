"""Parts of a text that are expressions of their own, such as the sides of an equation: messages mark them alone."""

from typing import TYPE_CHECKING

from vibcli.language.document.document import Scalar
from vibcli.language.reader import Expression
from vibcli.symbolic.parser import parse

if TYPE_CHECKING:
    from vibcli.language.reader import Reader
    from vibcli.symbolic.syntax import ExpressionError


def side(node: Scalar, start: int, end: int, reader: "Reader") -> Expression:
    """The Expression of node.text[start:end], which the reader knows from here on; ExpressionError where it is none."""
    text = node.text[start:end].rstrip()
    inset = None if node.inset is None else 0
    scalar = Scalar(text, node.place(start, len(text)), node.quoted, inset)
    found = Expression(scalar, reader.at_places(parse(text)))
    reader.expressions[scalar] = found
    return found


def report_unreadable(node: Scalar, error: "ExpressionError", reader: "Reader", start: int = 0) -> None:
    """Report why what begins at a place of a text can not be read."""
    reader.report(node.place(start + error.offset, error.width), error.message, error.hint)
