"""d₀(N), the deflection at which a law F(d, p) has the force N, as a function of N and of the parameters p:

    F(d₀, p) = N        ∂d₀/∂N = 1/F′        ∂d₀/∂p = −(∂F/∂p)/F′
"""

from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.defined_functions import DefinedFunction
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
from vibcli.symbolic.expression import Table
from vibcli.symbolic.expression_graph import evaluable
from vibcli.symbolic.running_errors import RunningErrors, error_in
from vibcli.symbolic.transfer_between_tables import written_in

if TYPE_CHECKING:
    from collections.abc import Sequence

    import mpmath
    import numpy as np

    from vibcli.symbolic.branch_of_law import Reached
    from vibcli.symbolic.node import Node

STEPS, KNOWN = 80, 64       # of Newton in many digits; roots that are kept


class RootOfLaw(DefinedFunction):
    """d₀(N, p) of a law F, an expression of d and of other symbols, on its branch through d = 0."""

    def __init__(self, name: str, force: "Node", d: "Node") -> None:
        while name in d.table.functions:
            name += "′"
        self.name, self.symbols, own = name, [
            part for part in evaluable([force])
            if part.op == "symbol" and part is not d and part not in d.table.definitions], Table()
        self.about = f"the deflection of '{name.partition('.')[0]}' under its preload is found by a root"
        self.d, self.N = own.variable("d"), own.variable("N")
        self.p = [own.variable(f"p{i}") for i in range(len(self.symbols))]
        known = {symbol.name: p for symbol, p in zip(self.symbols, self.p, strict=True)}
        self.force, = written_in(own, [force], {**known, d.name: self.d})
        own.functions[name] = self
        self.call = own.call(name, self.N, *self.p)
        self._roots: dict[Any, float] = {}

    @property
    def symbol(self) -> str:
        return "d_" + self.name.partition(".")[0]

    def called(self, N: "Node") -> "Node":
        """Its call in the table of the law."""
        N.table.functions[self.name] = self
        return N.table.call(self.name, N, *self.symbols)

    @cached_property
    def stiffness(self) -> "Node":
        """F′(d)."""
        return gradient(self.force).get(self.d, self.d.table.zero)

    def followed(self, N: float, p: "Sequence[float]") -> "Reached":
        """The root in floats, or what is known of the branch without one."""
        from vibcli.symbolic.array_arithmetic import Arrays
        from vibcli.symbolic.branch_of_law import reached

        return reached(lambda d: tuple(evaluate([self.force, self.stiffness], Arrays, self._values(d, p))), N)

    def _values(self, d: Any, p: "Sequence[Any]") -> dict[str, Any]:
        return {self.d.name: d, **{symbol.name: value for symbol, value in zip(self.p, p, strict=True)}}

    def at(self, *args: "float | mpmath.mpf") -> "float | mpmath.mpf":
        many = any(hasattr(arg, "_mpf_") for arg in args)
        N, *p = (float(arg) for arg in args)
        if (N, *p) not in self._roots:
            found = self.followed(N, p)
            if len(self._roots) >= KNOWN:
                self._roots.clear()
            self._roots[(N, *p)] = float("nan") if found.jumps else found.d
        root = self._roots[(N, *p)]
        return self._precisely(root, *args) if many else root

    def _precisely(self, d: float, N: "mpmath.mpf", *p: "mpmath.mpf") -> "mpmath.mpf":
        """Newton's steps from the root in floats."""
        import mpmath

        arithmetic, d = multiprecision(), mpmath.mpf(d)
        for _ in range(STEPS if d else 0):
            F, slope = evaluate([self.force, self.stiffness], arithmetic, self._values(d, p))
            step = (F - N) / slope
            d -= step
            if not abs(step) > 4 * mpmath.eps * abs(d):
                break
        return d

    def on_arrays(self, *args: "float | np.ndarray") -> "np.ndarray":
        import numpy as np

        found: np.ndarray = np.vectorize(self.at, otypes=[float])(*args)
        return found

    def rounding(self, unit: Any, found: Any, args: "Sequence[Any]") -> Any:
        """By that of F there, over F′."""
        inner = multiprecision() if any(hasattr(arg, "_mpf_") for arg in args) else Floats
        F, slope = evaluate([self.force, self.stiffness], RunningErrors(inner, unit), self._values(found, args[1:]))
        return 4 * unit * abs(found) + (error_in(F) / abs(slope.value) if slope.value else float("inf"))

    def slope(self, node: "Node", i: int) -> "Node":
        part = 1 / self.stiffness if i == 0 else -gradient(self.force).get(
            self.p[i - 1], self.d.table.zero) / self.stiffness
        there, = substitute([part], {self.d: self.call})
        return written_in(node.table, [there], dict(zip(
            [self.N.name, *(p.name for p in self.p)], node.args, strict=True)))[0]

    def folded(self, table: Table, args: "Sequence[Node]") -> "Node | None":
        at_zero, = substitute([self.force], {self.d: self.d.table.zero})
        return table.zero if args[0].is_zero and at_zero.is_zero else None
