"""Records in the expressions of a file: `ag(t)` is a call of the record ag, of an argument in seconds."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.parser import FUNCTIONS, OF_SIGNALS, VALUE
from vibcli.symbolic.syntax import Call, NameRef, QuantityRef, rebuilt

if TYPE_CHECKING:
    from vibcli.symbolic.syntax import SyntaxTree

RESERVED = ("pi", "t", "power", *FUNCTIONS, *OF_SIGNALS)      # names that mean something else before a bracket


def own(name: str) -> str:
    """The name by which the dimension of the values of a record is known, and that it is used."""
    return name + "()"


def with_record_calls(tree: Any, names: Sequence[str]) -> Any:
    """The tree in which `ag(…)` is a call, where ag is the name of a record."""
    def change(part: "SyntaxTree") -> "SyntaxTree":
        if isinstance(part, QuantityRef) and part.head == VALUE and isinstance(part.args[0], NameRef) and (
                part.args[0].name in names and not (part.args[0].primes or part.component)):
            return Call(part.start, part.end, part.args[0].name, part.args[1:])
        return part

    return rebuilt(tree, change)
