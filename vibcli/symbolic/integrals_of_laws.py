"""V(u) = ∫₀ᵘ F(x) dx of a law F that no rule integrates, by quadrature; ∂V/∂u = F(u), ∂V/∂p = ∫₀ᵘ ∂F/∂p dx."""

from collections.abc import Callable
from functools import cache
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.antiderivatives import from_zero
from vibcli.symbolic.defined_functions import DefinedFunction
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
from vibcli.symbolic.expression import Table
from vibcli.symbolic.expression_graph import evaluable, reachable
from vibcli.symbolic.kinks import kinks_of
from vibcli.symbolic.running_errors import RunningErrors, error_in
from vibcli.symbolic.transfer_between_tables import written_in

if TYPE_CHECKING:
    from collections.abc import Sequence

    import mpmath
    import numpy as np

    from vibcli.symbolic.graded_quadrature import Integrals
    from vibcli.symbolic.node import Node

HALVINGS, DEGREE = 200, 4       # of panels in many digits; of the rule on one: 24 places
SPARE = 2**40                   # in units of rounding: the halves of a panel where f is smooth are nearer by 2⁻⁴⁸


def by_quadrature(name: str, force: "Node", x: "Node") -> "Node":
    """∫₀ˣ force dx as the function `name` of x and of the symbols of the force."""
    table = x.table
    symbols = [part for part in evaluable([force])
               if part.op == "symbol" and part is not x and part not in table.definitions]
    own = Table()
    place, parameters = own.variable("x"), [own.variable(f"p{i}") for i in range(len(symbols))]
    known = {symbol.name: p for symbol, p in zip(symbols, parameters, strict=True)}
    integrand, = written_in(own, [force], {**known, x.name: place})
    table.functions[name] = IntegralOfLaw(name, integrand, place, parameters)
    return table.call(name, x, *symbols)


class IntegralOfLaw(DefinedFunction):
    """∫₀ᵘ f(x, p) dx as a function of u and p, f being an expression of the symbols x and p."""

    def __init__(self, name: str, integrand: "Node", x: "Node", p: "Sequence[Node]") -> None:
        self.name, self.integrand, self.x, self.p = name, integrand, x, list(p)
        self.about = f"the energy of the law of '{name.partition('.')[0]}' is found by quadrature along a motion"
        self.places = _marked_places(integrand, x)
        self._slopes: dict[int, Node] = {}
        self._known: tuple[Any, dict[Any, Any]] = None, {}

    @property
    def symbol(self) -> str:
        return "V_" + self.name.removesuffix(".integral").replace(".", "")

    def at(self, *args: "float | mpmath.mpf") -> "float | mpmath.mpf":
        if any(hasattr(arg, "_mpf_") for arg in args):
            return self._precisely(*args)
        return float(self.on_arrays(*args))

    def on_arrays(self, *args: "float | np.ndarray") -> "np.ndarray":
        return self._found(args).value

    def rounding(self, unit: Any, found: Any, args: "Sequence[Any]") -> Any:
        """By the integral of |f|, the rounding of f, and what the quadrature leaves open."""
        if any(hasattr(arg, "_mpf_") for arg in args):
            return super().rounding(unit, found, args)
        known, (u, *p) = self._found(args), args
        lost = max(error_in(evaluate([self.integrand], RunningErrors(Floats), self._values(share * u, p))[0])
                   for share in (0.5, 1.0))
        return 4 * unit * float(known.size) + float(known.open) + abs(u) * lost

    def _found(self, args: "Sequence[Any]") -> "Integrals":
        """The Integrals, NaN where one did not settle, in the shape of the arguments."""
        import numpy as np

        from vibcli.symbolic.array_arithmetic import Arrays
        from vibcli.symbolic.graded_quadrature import ENOUGH, Integrals, integrals

        columns = np.broadcast_arrays(*(np.asarray(arg, dtype=float) for arg in args))
        u, *p = (column.ravel() for column in columns)

        def f(x: "np.ndarray", owner: "np.ndarray") -> "np.ndarray":
            found: np.ndarray = evaluate([self.integrand], Arrays, self._values(x, [c[owner][:, None] for c in p]))[0]
            return found
        with np.errstate(all="ignore"):
            places = evaluate(self.places, Arrays, self._values(u, p))
            found = integrals(f, u, [place + 0 * u for place in places])
        value = np.where(found.open > ENOUGH * found.size, np.nan, found.value)
        return Integrals(*(part.reshape(columns[0].shape) for part in (value, found.size, found.open)))

    def _values(self, x: Any, p: "Sequence[Any]") -> dict[str, Any]:
        return {self.x.name: x, **{symbol.name: value for symbol, value in zip(self.p, p, strict=True)}}

    def _precisely(self, u: "mpmath.mpf", *p: "mpmath.mpf") -> "mpmath.mpf":
        """From the nearest place at which it was asked for."""
        import mpmath

        arithmetic, zero = multiprecision(), mpmath.mpf(0)
        key = p, mpmath.mp.prec
        if self._known[0] != key:
            self._known = key, {zero: zero}
        known = self._known[1]
        if u not in known:
            start = min(known, key=lambda place: abs(place - u))

            def f(x: "mpmath.mpf") -> "mpmath.mpf":
                return evaluate([self.integrand], arithmetic, self._values(x, p))[0]
            places = evaluate(self.places, arithmetic, self._values(u, p)) if self.places else []
            low, high = min(u, start), max(u, start)
            edges = [low, *sorted({place for place in [*places, zero] if low < place < high}), high]
            way = _between(f, edges, abs(known[start]))
            known[u] = known[start] + (way if u > start else -way)
        return known[u]

    def slope(self, node: "Node", i: int) -> "Node":
        if i not in self._slopes:
            self._slopes[i] = self.integrand if i == 0 else self._by_parameter(i - 1)
        table = node.table
        return written_in(table, [self._slopes[i]], dict(zip(
            [self.x.name, *(p.name for p in self.p)], node.args, strict=True)))[0]

    def _by_parameter(self, i: int) -> Any:
        slope = gradient(self.integrand).get(self.p[i], self.x.table.zero)
        return from_zero(slope, self.x) or by_quadrature(f"{self.name}.{i + 1}", slope, self.x)

    def folded(self, table: Table, args: "Sequence[Node]") -> "Node | None":
        return table.zero if args[0].is_zero else None

    def kinks(self, node: "Node") -> "list[Node]":
        return written_in(node.table, kinks_of([self.integrand], self.x), dict(zip(
            [self.x.name, *(p.name for p in self.p)], node.args, strict=True)))


def _marked_places(node: "Node", x: "Node") -> "list[Node]":
    """Where what is linear in x vanishes, as a function bends or changes fast there."""
    found = {}
    for part in [*reachable([node]), *kinks_of([node], x)]:
        if part.op == "sum" and part.mask & x.mask:
            slope = gradient(part).get(x)
            if slope is not None and not slope.mask & x.mask:
                found[x - part / slope] = None
    return list(found)


def _between(f: "Callable[[mpmath.mpf], mpmath.mpf]", edges: "Sequence[mpmath.mpf]",
             size: "mpmath.mpf") -> "mpmath.mpf":
    """∫ f dx between places next to each other, on panels that are halved until the halves tell no more than the whole;
    `size`: of what it is added to."""
    import mpmath

    def over(low: "mpmath.mpf", high: "mpmath.mpf") -> "mpmath.mpf":
        return sum((weight * f(x) for x, weight in _rule().get_nodes(low, high, DEGREE, mpmath.mp.prec)), mpmath.mpf(0))
    panels = [(*piece, over(*piece), HALVINGS) for piece in pairwise(edges)]
    size, found = size + sum(abs(whole) for _, _, whole, _ in panels), mpmath.mpf(0)
    while panels:
        low, high, whole, halvings = panels.pop()
        middle = (low + high) / 2
        first, second = over(low, middle), over(middle, high)
        size = max(size, abs(first) + abs(second))
        if halvings and abs(first + second - whole) > mpmath.eps * SPARE * size:
            panels += [(low, middle, first, halvings - 1), (middle, high, second, halvings - 1)]
        else:
            found += first + second
    return found


@cache
def _rule() -> Any:
    import mpmath
    from mpmath.calculus.quadrature import GaussLegendre

    return GaussLegendre(mpmath.mp)
