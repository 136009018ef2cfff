"""Records in the expressions of a file: `ag(t)` is a call of the record ag, of an argument in seconds."""

from collections.abc import Sequence
from typing import Any

from vibcli.symbolic.parser import FUNCTIONS, OF_SIGNALS, VALUE
from vibcli.symbolic.syntax import Call, Equation, NameRef, Power, Product, QuantityRef, Sum

RESERVED = ("pi", "t", "power", *FUNCTIONS, *OF_SIGNALS)      # names that mean something else before a bracket


def own(name: str) -> str:
    """The name by which the dimension of the values of a record is known, and that it is used."""
    return name + "()"


def with_record_calls(tree: Any, names: Sequence[str]):
    """The tree in which `ag(…)` is a call, where ag is the name of a record."""
    if isinstance(tree, QuantityRef):
        args = tuple(with_record_calls(arg, names) for arg in tree.args)
        if tree.head == VALUE and isinstance(args[0], NameRef) and args[0].name in names and not (
                args[0].primes or tree.component):
            return Call(tree.start, tree.end, args[0].name, args[1:])
        return tree._replace(args=args)
    if isinstance(tree, (Sum, Product)):
        return tree._replace(parts=tuple((sign, with_record_calls(part, names)) for sign, part in tree.parts))
    if isinstance(tree, Call):
        return tree._replace(args=tuple(with_record_calls(arg, names) for arg in tree.args))
    if isinstance(tree, Power):
        return tree._replace(base=with_record_calls(tree.base, names), exponent=with_record_calls(tree.exponent, names))
    if isinstance(tree, Equation):
        return tree._replace(left=with_record_calls(tree.left, names), right=with_record_calls(tree.right, names))
    return tree
