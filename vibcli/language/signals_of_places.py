"""Signals of a place on a member: `rod.u(L/2)` is a name, `rod.u(L/2)(1 ms)` its value at an instant."""

from collections.abc import Container
from typing import TYPE_CHECKING, Any

from vibcli.language.signal_names import signal_name
from vibcli.symbolic.parser import VALUE, plain_name
from vibcli.symbolic.syntax import NameRef, QuantityRef, rebuilt

if TYPE_CHECKING:
    from vibcli.symbolic.syntax import SyntaxTree


def with_places(tree: Any, members: Container[str]) -> Any:
    """The tree in which `rod.u(…)` is the name of a signal, where rod is a member."""
    def change(part: "SyntaxTree") -> "SyntaxTree":
        if not isinstance(part, QuantityRef) or part.head != VALUE or part.component or len(part.args) != 2:
            return part
        of = part.args[0]
        if not isinstance(of, NameRef):
            return part
        signal = signal_name(of.name)
        if signal.name not in members or signal.place:
            return part
        return NameRef(part.start, part.end, signal_name(plain_name(part.text)).still.text, of.primes)

    return rebuilt(tree, change)
