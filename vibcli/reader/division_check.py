"""What divides by zero whatever its letters are."""

from typing import TYPE_CHECKING

from vibcli.symbolic.expression import Table
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import ExpressionError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.language.reader import Expression, Reader


def check_divisions(reader: "Reader", expressions: "Sequence[Expression]") -> None:
    """Report those that divide by zero."""
    table = Table()
    for expression in expressions:
        try:
            lower(expression.tree, table, lambda name, primes, part: table.variable(name + "'" * primes))
        except ExpressionError as error:
            reader.report(expression.scalar.place(error.offset, error.width), error.message, error.hint)
