"""Functions that an expression calls by a name of its table, `table.functions`, which elements of a scene define.

Their arguments are all that they depend on, so that they are functions in the sense of the algebra. Their slopes are
expressions again, which may call them: derivatives of any order follow.
"""

from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.expression import Table

if TYPE_CHECKING:
    from collections.abc import Sequence

    import mpmath
    import numpy as np

    from vibcli.symbolic.node import Node


class Ending(NamedTuple):
    """Why a function has no value beyond some argument, as a clause, and what may be done."""

    what: str
    hint: str


class DefinedFunction:
    """A function f(u, …) that is called `name`, and written as `symbol` of its first argument: the others are numbers
    and parameters that stay as they are."""

    name: str
    symbol: str
    about: str          # what it is, for a message
    ends = False        # has it no value beyond some argument?

    def at(self, *args: "float | mpmath.mpf") -> "float | mpmath.mpf":
        """The value for floats or mpmath numbers; NaN where there is none."""
        raise NotImplementedError

    def on_arrays(self, *args: "float | np.ndarray") -> "np.ndarray":
        """The values for arrays of one shape, or some of them floats."""
        raise NotImplementedError

    def rounding(self, unit: Any, found: Any, _args: "Sequence[Any]") -> Any:
        """How far `found`, its value in numbers, may be off by rounding alone."""
        return 4 * unit * abs(found)

    def coefficients(self, ring: Any, args: "Sequence[Any]") -> list[Any]:
        """Those of its Taylor expansion by its first argument about numbers of the arithmetic inside truncated
        polynomials, to their order; NoDerivative where there is none."""
        table = Table(functions={self.name: self})
        symbols = [table.variable(f"u{i}") for i in range(len(args))]
        nodes = [table.call(self.name, *symbols)]
        for k in range(1, ring.order + 1):
            nodes.append(gradient(nodes[-1]).get(symbols[0], table.zero) / k)
        values = {symbol.name: c for symbol, c in zip(symbols, args, strict=True)}
        return evaluate(nodes, ring.inner, values)

    def on_senses(self, args: "Sequence[float | np.ndarray]", _senses: "Sequence[float | np.ndarray]") -> "np.ndarray":
        """The values for arrays where each of `kinks` has a sense, ±1; smooth beyond its zero, where that is known."""
        return self.on_arrays(*args)

    def ending(self, _args: "Sequence[float]") -> Ending | None:
        """Why it has no value beyond some first argument, the others being these; None where it has one everywhere."""
        return None

    def kinks(self, _node: "Node") -> "Sequence[Node]":
        """What vanishes where a call bends or jumps, in its table."""
        return ()

    def slope(self, node: "Node", i: int) -> "Node":
        """∂f/∂uᵢ of a call `node`, in its table."""
        raise NotImplementedError

    def folded(self, _table: Table, _args: "Sequence[Node]") -> "Node | None":
        """The simpler node that a call equals exactly, or None."""
        return None

    def positive_where(self, _node: "Node", _x: "Node") -> "list[Node] | None":
        """What has to be positive, free of x, so that a call is for all x but single ones; None where nothing tells."""
        return None


def slopes_at(function: DefinedFunction, arithmetic: Any, args: "Sequence[Any]", wanted: "Sequence[int]") -> list[Any]:
    """∂f/∂uᵢ of each i wanted, in the numbers of an arithmetic."""
    table = Table(functions={function.name: function})
    symbols = [table.variable(f"u{i}") for i in range(len(args))]
    call = table.call(function.name, *symbols)
    values = {symbol.name: arg for symbol, arg in zip(symbols, args, strict=True)}
    return evaluate([function.slope(call, i) for i in wanted], arithmetic, values)
