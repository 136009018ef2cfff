"""Parts in series, functions of their deflection D and of their parameters p: the inner deflections dᵢ, at which
Σ dᵢ = D and all forces Fᵢ(dᵢ, p) are one, in floats and in more digits.

All Fᵢ rise and vanish at 0, so that there is one inner equilibrium.
"""

from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.expression import Table
from vibcli.symbolic.functions_of_series import Deflection, Energy, Force, InnerState, Stiffness
from vibcli.symbolic.transfer_between_tables import written_in

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import mpmath
    import numpy as np

    from vibcli.symbolic.node import Node


class PartLaw(NamedTuple):
    """The force F(x) of a part and its energy V(x), expressions of one symbol x."""

    force: Any
    energy: Any

    def over(self, x: "Node", u: "Node") -> "PartLaw":
        """Itself at the deflection u instead of x."""
        return PartLaw(*substitute(self, {x: u}))


class SeriesOfLaws:
    """The functions `name.energy`, `name.force`, `name.stiffness`, `name.1`, `name.2`, … of parts in series, of which
    the laws are functions of x and of the symbols `parameters`; `positive`: what has to be so that they all rise."""

    def __init__(self, name: str, laws: "Sequence[PartLaw]", x: "Node", parameters: "Sequence[Node]",
                 positive: "Sequence[Node]" = ()):
        self.name, self.count = name, len(laws)
        self.table = table = Table()
        self.D = table.variable("D")
        self.p = [table.variable(f"p{i}") for i in range(len(parameters))]
        self.d = [table.variable(f"d{i}") for i in range(self.count)]
        known = {symbol.name: p for symbol, p in zip(parameters, self.p, strict=True)}
        own = [written_in(table, law, {**known, x.name: d}) for law, d in zip(laws, self.d, strict=True)]
        self.forces, self.energies = [force for force, _ in own], [energy for _, energy in own]
        self.positive = written_in(table, positive, known)
        self.stiffnesses = [gradient(force).get(d, table.zero) for force, d in zip(self.forces, self.d, strict=True)]
        kinds = [Energy(self), Force(self), Stiffness(self), *(Deflection(self, i) for i in range(self.count))]
        self.functions = {function.name: function for function in kinds}
        table.functions.update(self.functions)
        self.calls = {name: table.call(name, self.D, *self.p) for name in self.functions}
        self._compiled: Callable | None = None
        self._solved: tuple[list[Any], Any] = [], None

    def called(self, kind: Any, D: "Node", parameters: "Sequence[Node]") -> "Node":
        """The call of a function of it in the table of D."""
        D.table.functions.update(self.functions)
        return D.table.call(f"{self.name}.{kind}", D, *parameters)

    def ratio(self, i: int) -> "Node":
        """∂dᵢ/∂D."""
        return self._product_without(i) / self.table.total([self._product_without(k) for k in range(self.count)])

    def _product_without(self, i):
        return self.table.product(*((slope, 1) for j, slope in enumerate(self.stiffnesses) if j != i))

    def force_by(self, p: "Node") -> "Node":
        """∂F/∂p."""
        return self.table.total([self.ratio(i) * gradient(force).get(p, self.table.zero)
                                 for i, force in enumerate(self.forces)])

    def deflection_by(self, i: int, p: "Node") -> "Node":
        """∂dᵢ/∂p."""
        own = gradient(self.forces[i]).get(p, self.table.zero)
        return (self.force_by(p) - own) / self.stiffnesses[i]

    def written(self, template: "Node", node: "Node") -> "Node":
        """An expression of D, p and dᵢ for the arguments of a call, in its table."""
        here = node.table
        here.functions.update(self.functions)
        values = dict(zip([self.D.name, *(p.name for p in self.p)], node.args, strict=True))
        values |= {d.name: here.call(f"{self.name}.{i + 1}", *node.args) for i, d in enumerate(self.d)}
        return written_in(here, [template], values)[0]

    def solution(self, args: "Sequence[Any]") -> InnerState:
        """The inner deflections where the arguments are arrays; kept, since several functions are wanted there."""
        import numpy as np

        from vibcli.symbolic.array_arithmetic import Arrays
        from vibcli.symbolic.series_deflections import deflections

        known, found = self._solved
        if len(known) == len(args) and all(map(np.array_equal, known, args)):
            return found
        D, *p = args
        laws, total = self._laws(), np.asarray(D, dtype=float)
        signs = evaluate(self.positive, Arrays, self._values(p))
        if not all(np.all(sign > 0) for sign in signs):
            total = total * np.nan
        near = None if found is None else found.deflections
        found = InnerState(*deflections(lambda d: laws(d, p), total, self.count, near=near))
        lost = np.isfinite(total) & ~np.isfinite(found.force)
        if np.any(lost):
            found = self._beyond_floats(found, lost, args)
        self._solved = [np.array(arg) for arg in args], found
        return found

    def _beyond_floats(self, found, lost, args):
        """The solution where forces on the way to it are larger or smaller than floats can be."""
        import mpmath
        import numpy as np

        d, force = found.deflections.copy(), np.array(found.force)
        args = np.broadcast_arrays(*args)
        with mpmath.workdps(30):
            for place in np.argwhere(lost):
                there = tuple(place)
                exact = self.precisely([mpmath.mpf(float(arg[there])) for arg in args])
                d[(slice(None), *there)], force[there] = exact.deflections[:, 0], exact.force[0]
        return InnerState(d, force)

    def _laws(self) -> "Callable":
        """(d, p) -> (forces, slopes), compiled."""
        import numpy as np

        from vibcli.symbolic.numeric_code import Source, function

        if self._compiled is None:
            slots = {symbol: symbol.name for symbol in (*self.d, *self.p)}
            source = Source(slots, {}, None)
            texts = source.add([*self.forces, *self.stiffnesses])
            heads = [f"{','.join(symbol.name for symbol in symbols)},={name}"
                     for symbols, name in ((self.d, "d"), (self.p, "p")) if symbols]
            self._compiled = function("d,p", heads + source.lines, f"({','.join(texts)},)", source.called.values())
        compiled, n = self._compiled, self.count

        def laws(d, p):
            found = compiled(d, p)
            return tuple(np.array([value + 0 * d[0] for value in half]) for half in (found[:n], found[n:]))
        return laws

    def precisely(self, args: "Sequence[mpmath.mpf]") -> InnerState:
        """The same for mpmath numbers."""
        import mpmath
        import numpy as np

        from vibcli.symbolic.series_deflections import NumberKind, deflections

        arithmetic, known = multiprecision(), self._values(args[1:])
        nodes = [*self.forces, *self.stiffnesses]
        log, exp = (np.frompyfunc(function, 1, 1) for function in (mpmath.log, mpmath.exp))
        kind = NumberKind(log, exp, mpmath.mpf(2) ** -mpmath.mp.prec)

        def laws(d):
            found = evaluate(nodes, arithmetic, {**known, **{s.name: x[0] for s, x in zip(self.d, d, strict=True)}})
            column = np.array([[mpmath.mpf(value)] for value in found], dtype=object)
            return column[:self.count], column[self.count:]
        if not all(sign > 0 for sign in evaluate(self.positive, arithmetic, known)):
            args = mpmath.nan, *args[1:]
        found = deflections(laws, np.array([mpmath.mpf(args[0])], dtype=object), self.count, kind)
        return InnerState(*found)

    def _values(self, p: "Sequence[Any]") -> dict[str, Any]:
        return {symbol.name: value for symbol, value in zip(self.p, p, strict=True)}

    def evaluated(self, nodes: "Sequence[Node]", args: "Sequence[Any]", arithmetic: Any,
                  inner: "np.ndarray") -> list[Any]:
        """Expressions of dᵢ and p in numbers."""
        return evaluate(nodes, arithmetic, {**self._values(args[1:]),
                                            **{d.name: x for d, x in zip(self.d, inner, strict=True)}})
