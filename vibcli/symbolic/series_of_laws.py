"""Parts in series, functions of their deflection D and of their parameters p: the inner deflections dᵢ, at which
Σ dᵢ = D and all forces Fᵢ(dᵢ, p) are one, in floats and in more digits.

Where all Fᵢ rise and vanish at 0 there is one inner equilibrium; others are followed from rest.
"""

from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.expression import Table
from vibcli.symbolic.functions_of_series import Deflection, Energy, Force, InnerState, Stiffness
from vibcli.symbolic.transfer_between_tables import written_in

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import mpmath
    import numpy as np

    from vibcli.symbolic.branch_in_series import BranchInSeries
    from vibcli.symbolic.node import Node


KEPT, ROUNDS, SIDED = 64, 60, 5     # branches; of Newton in many digits, and beyond a kink
NEAR = 2.0**-40             # of a deflection: its next step would be the square of that


class PartLaw(NamedTuple):
    """The force F(x) of a part and its energy V(x), expressions of one symbol x."""

    force: Any
    energy: Any

    def over(self, x: "Node", u: "Node") -> "PartLaw":
        """Itself at the deflection u instead of x."""
        return PartLaw(*substitute(self, {x: u}))


class SidedLaws:
    """Laws that bend, as functions that are smooth while each of `kinks`, expressions of dᵢ and p, has a sense."""

    def __init__(self, kinks: "list[Node]", compiled: "Callable[..., Any]", count: int) -> None:
        self.kinks, self._compiled, self.count = kinks, compiled, count

    def __call__(self, d: "np.ndarray", p: "Sequence[Any]", senses: "Sequence[Any]") -> "tuple[np.ndarray, ...]":
        """(forces, stiffnesses, energies), each of the shape of d."""
        import numpy as np

        found = np.array([value + 0 * d[0] for value in self._compiled(d, p, senses)])
        return found[:self.count], found[self.count:2 * self.count], found[2 * self.count:]


class SeriesOfLaws:
    """The functions `name.energy`, `name.force`, `name.stiffness`, `name.1`, `name.2`, … of parts in series, of which
    the laws are functions of x and of the symbols `parameters`; `positive`: what has to be so that they all rise, None
    where they may not: then they are followed from rest (branch_in_series.py)."""

    def __init__(self, name: str, laws: "Sequence[PartLaw]", x: "Node", parameters: "Sequence[Node]",
                 positive: "Sequence[Node] | None" = (), unit: str = "m") -> None:
        self.name, self.count = name, len(laws)
        self.table = table = Table()
        self.D = table.variable("D")
        self.p = [table.variable(f"p{i}") for i in range(len(parameters))]
        self.d = [table.variable(f"d{i}") for i in range(self.count)]
        known = {symbol.name: p for symbol, p in zip(parameters, self.p, strict=True)}
        own = [written_in(table, law, {**known, x.name: d}) for law, d in zip(laws, self.d, strict=True)]
        self.forces, self.energies = [force for force, _ in own], [energy for _, energy in own]
        self.rises, self.unit = positive is not None, unit
        self.positive = written_in(table, list(dict.fromkeys(positive or ())), known)
        self.stiffnesses = [gradient(force).get(d, table.zero) for force, d in zip(self.forces, self.d, strict=True)]
        kinds = [Energy(self), Force(self), Stiffness(self), *(Deflection(self, i) for i in range(self.count))]
        self.functions = {function.name: function for function in kinds}
        table.functions.update(self.functions)
        self.calls = {name: table.call(name, self.D, *self.p) for name in self.functions}
        self._compiled: Callable[..., Any] | None = None
        self._solved: tuple[list[Any], InnerState | None] = [], None
        self._sided: tuple[list[Any], tuple[InnerState, dict[str, Any]] | None] = [], None
        self._branches: dict[tuple[float, ...], BranchInSeries] = {}

    @cached_property
    def sided(self) -> SidedLaws:
        """The laws as smooth functions between their kinks."""
        switches: dict[Node, str] = {}
        found = self._function([*self.forces, *self.stiffnesses, *self.energies], switches)
        return SidedLaws(list(switches), found, self.count)

    def on_senses(self, args: "Sequence[Any]", senses: "Sequence[Any]") -> "tuple[InnerState, dict[str, Any]]":
        """The inner state where the kinks have senses, going on smoothly beyond their zeros, and the stiffnesses and
        energies of the parts there."""
        import numpy as np

        from vibcli.symbolic.branch_in_series import newton_step

        given = [*args, *senses]
        if len(self._sided[0]) == len(given) and all(map(np.array_equal, self._sided[0], given)):
            return self._sided[1]
        D, *p = np.broadcast_arrays(*args) if np.ndim(args[0]) else args
        d = self.solution(args).deflections
        with np.errstate(all="ignore"):
            for _ in range(SIDED):
                step = newton_step(d, D, *self.sided(d, p, senses)[:2])
                d = np.where(np.isfinite(step), d + step, d)
                if not np.any(np.abs(step) > NEAR * np.abs(d)):
                    break
            forces, slopes, energies = self.sided(d, p, senses)
        force = np.take_along_axis(forces, np.argmin(np.abs(slopes), axis=0)[None], axis=0)[0]
        found = InnerState(d, force), {"stiffnesses": slopes, "energies": energies}
        self._sided = [np.array(one) for one in given], found
        return found

    def called(self, kind: Any, D: "Node", parameters: "Sequence[Node]") -> "Node":
        """The call of a function of it in the table of D."""
        D.table.functions.update(self.functions)
        return D.table.call(f"{self.name}.{kind}", D, *parameters)

    def ratio(self, i: int) -> "Node":
        """∂dᵢ/∂D."""
        return self._product_without(i) / self.table.total([self._product_without(k) for k in range(self.count)])

    def _product_without(self, i: int) -> "Node":
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
        if not self.rises:
            found = self._from_rest(total, p)
        else:
            near = None if found is None else found.deflections
            found = InnerState(*deflections(lambda d: laws(d, p), total, self.count, near=near))
            lost = np.isfinite(total) & ~np.isfinite(found.force)
            if np.any(lost):
                found = self._beyond_floats(found, lost, args)
        self._solved = [np.array(arg) for arg in args], found
        return found

    def _from_rest(self, total: "np.ndarray", p: "Sequence[Any]") -> InnerState:
        """On the branch from rest."""
        import numpy as np

        if all(np.ndim(value) == 0 or np.all(value == np.ravel(value)[0]) for value in p):
            return InnerState(*self.branch([float(np.ravel(value)[0]) for value in p]).deflections(total))
        total, *p = np.broadcast_arrays(total, *p)
        each = [self.branch(list(map(float, row))).deflections(np.array([D]))
                for D, *row in zip(total.ravel(), *(value.ravel() for value in p), strict=True)]
        d, force = (np.stack([one[k] for one in each], axis=-1)[..., 0, :] for k in (0, 1))
        return InnerState(d.reshape(-1, *total.shape), force.reshape(total.shape))

    def branch(self, p: "Sequence[float]") -> "BranchInSeries":
        """That from rest, where the parameters are numbers."""
        from vibcli.symbolic.branch_in_series import BranchInSeries

        key = tuple(p)
        if key not in self._branches:
            laws = self._laws()
            if len(self._branches) >= KEPT:
                self._branches.clear()
            self._branches[key] = BranchInSeries(lambda d: laws(d, p), self.count)
        return self._branches[key]

    def _beyond_floats(self, found: InnerState, lost: "np.ndarray", args: "Sequence[Any]") -> InnerState:
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

    def _laws(self) -> "Callable[[np.ndarray, Sequence[Any]], tuple[np.ndarray, np.ndarray]]":
        """(d, p) -> (forces, slopes), compiled."""
        import numpy as np

        if self._compiled is None:
            self._compiled = self._function([*self.forces, *self.stiffnesses], None)
        compiled, n = self._compiled, self.count

        def laws(d: "np.ndarray", p: "Sequence[Any]") -> "tuple[np.ndarray, np.ndarray]":
            found = compiled(d, p, ())
            forces, slopes = (np.array([value + 0 * d[0] for value in half]) for half in (found[:n], found[n:]))
            return forces, slopes
        return laws

    def _function(self, nodes: "list[Node]", switches: "dict[Node, str] | None") -> "Callable[..., Any]":
        """Expressions as a function of (d, p, senses of the switches)."""
        from vibcli.symbolic.numeric_code import Source, function

        source = Source({symbol: symbol.name for symbol in (*self.d, *self.p)}, {}, switches)
        texts = source.add(nodes)
        given = ([d.name for d in self.d], "d"), ([p.name for p in self.p], "p"), ((switches or {}).values(), "g")
        heads = [f"{','.join(names)},={name}" for names, name in given if names]
        return function("d,p,g", heads + source.lines, f"({','.join(texts)},)", source.called.values())

    def precisely(self, args: "Sequence[mpmath.mpf]") -> InnerState:
        """The same for mpmath numbers."""
        import mpmath
        import numpy as np

        from vibcli.symbolic.series_deflections import NumberKind, deflections

        arithmetic, known = multiprecision(), self._values(args[1:])
        nodes = [*self.forces, *self.stiffnesses]
        log, exp = (np.frompyfunc(function, 1, 1) for function in (mpmath.log, mpmath.exp))
        kind = NumberKind(log, exp, mpmath.mpf(2) ** -mpmath.mp.prec)

        def laws(d: "np.ndarray") -> "tuple[np.ndarray, np.ndarray]":
            found = evaluate(nodes, arithmetic, {**known, **{s.name: x[0] for s, x in zip(self.d, d, strict=True)}})
            column = np.array([[mpmath.mpf(value)] for value in found], dtype=object)
            return column[:self.count], column[self.count:]
        if not all(sign > 0 for sign in evaluate(self.positive, arithmetic, known)):
            args = mpmath.nan, *args[1:]
        total = np.array([mpmath.mpf(args[0])], dtype=object)
        if self.rises:
            return InnerState(*deflections(laws, total, self.count, kind))
        return self._polished(laws, total, self.solution([float(arg) for arg in args]).deflections)

    def _polished(self, laws: "Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]", total: "np.ndarray",
                  near: "np.ndarray") -> InnerState:
        """In more digits, from deflections in floats."""
        import mpmath
        import numpy as np

        from vibcli.symbolic.branch_in_series import newton_step

        d = np.array([[mpmath.mpf(float(x))] for x in near], dtype=object)
        for _ in range(ROUNDS if total[0] and mpmath.isfinite(sum(d[:, 0])) else 0):
            step = newton_step(d, total, *laws(d))
            d = d + step
            if max(abs(step[:, 0])) <= mpmath.eps * max(abs(d[:, 0])):
                break
        forces, slopes = laws(d)
        return InnerState(d, forces[int(np.argmin(abs(slopes[:, 0])))])

    def _values(self, p: "Sequence[Any]") -> dict[str, Any]:
        return {symbol.name: value for symbol, value in zip(self.p, p, strict=True)}

    def evaluated(self, what: str, args: "Sequence[Any]", arithmetic: Any, inner: "np.ndarray") -> list[Any]:
        """The `stiffnesses` or `energies` of the parts in numbers."""
        return evaluate(getattr(self, what), arithmetic, {**self._values(args[1:]),
                                            **{d.name: x for d, x in zip(self.d, inner, strict=True)}})
