"""Signals of a place on a member: `rod.u(L/2)` is a name, `rod.u(L/2)(1 ms)` its value at an instant."""

from collections.abc import Container
from typing import TYPE_CHECKING, Any

from vibcli.language.reader import Expression
from vibcli.language.signal_names import signal_name
from vibcli.symbolic.parser import VALUE, plain_name
from vibcli.symbolic.syntax import NameRef, QuantityRef, rebuilt

if TYPE_CHECKING:
    from vibcli.language.spec import Spec


def with_places(tree: Any, members: Container[str]) -> Any:
    """The tree in which `rod.u(…)` is the name of a signal, where rod is a member."""
    def change(part):
        if not isinstance(part, QuantityRef) or part.head != VALUE or part.component or len(part.args) != 2:
            return part
        of = part.args[0]
        if not isinstance(of, NameRef):
            return part
        signal = signal_name(of.name)
        if signal.name not in members or signal.place:
            return part
        return NameRef(part.start, part.end, signal_name(plain_name(part.text)).still.text, of.primes)

    return rebuilt(tree, change) if members else tree


def at_places(spec: "Spec", expression: Expression) -> Expression:
    """An Expression given beside the scene, with the signals of places on its members."""
    tree = with_places(expression.tree, spec.members)
    return expression if tree is expression.tree else Expression(expression.scalar, tree)
