"""Parts in series as functions of their deflection D and of their parameters p: energy, force, stiffness and the inner
deflections dᵢ, where Σ dᵢ = D and all forces Fᵢ(dᵢ, p) are one. With rᵢ = ∂dᵢ/∂D = Π_{j≠i} Fⱼ′ / Σₖ Π_{j≠k} Fⱼ′,

    V = Σ Vᵢ       ∂V/∂D = F           ∂V/∂p = Σ ∂Vᵢ/∂p
    F = Fᵢ(dᵢ)     ∂F/∂D = K           ∂F/∂p = Σ rᵢ ∂Fᵢ/∂p
    K = Fᵢ′ rᵢ     ∂K/∂D = Σ rᵢ³ Fᵢ″    ∂K/∂p = Σ rᵢ² (∂Fᵢ′/∂p + Fᵢ″ ∂dᵢ/∂p)
    dᵢ             ∂dᵢ/∂D = rᵢ         ∂dᵢ/∂p = (∂F/∂p − ∂Fᵢ/∂p)/Fᵢ′
"""

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.defined_functions import DefinedFunction, Ending
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import multiprecision
from vibcli.symbolic.expression import Table
from vibcli.symbolic.transfer_between_tables import written_in

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import mpmath
    import numpy as np

    from vibcli.symbolic.node import Node
    from vibcli.symbolic.series_of_laws import SeriesOfLaws


class InnerState(NamedTuple):
    """Inner deflections, and the force."""

    deflections: "np.ndarray"
    force: "np.ndarray"


class FunctionOfSeries(DefinedFunction):
    """One function of a SeriesOfLaws: `from_parts(state, of_parts)` is its value, of_parts("stiffnesses") or
    ("energies") being those of the parts there; `template(i)` its slope by an argument as an expression of D, p and
    dᵢ."""

    kind: Any
    letter = ""

    def __init__(self, parts: "SeriesOfLaws") -> None:
        self.parts, self.name = parts, f"{parts.name}.{self.kind}"
        self.about = f"the inner equilibrium of '{parts.name.partition('.')[0]}' is solved in floats along a motion"
        self.templates: dict[int, Node] = {}

    @property
    def symbol(self) -> str:
        return f"{self.letter}_{self.name.removesuffix('.' + str(self.kind)).replace('.', '')}"

    def template(self, i: int) -> "Node":
        raise NotImplementedError

    def from_parts(self, found: InnerState, of_parts: "Callable[[str], Any]") -> Any:
        raise NotImplementedError

    def slope(self, node: "Node", i: int) -> "Node":
        if i not in self.templates:
            self.templates[i] = self.template(i)
        return self.parts.written(self.templates[i], node)

    def from_series(self, force: list[Any], inner: list[list[Any]], number: Any, value: Any) -> list[Any]:
        """Its coefficients from those of F and dᵢ, to one order less than theirs; value(): that of order 0."""
        raise NotImplementedError

    def coefficients(self, ring: Any, args: "Sequence[Any]") -> list[Any]:
        from vibcli.symbolic.series_reversion import expanded

        rests = ring.side(args[0]) == 0
        force, inner = expanded(self.parts, ring, args, ring.order + 1)

        def value(function: DefinedFunction = self) -> Any:
            return ring.inner.number(0) if rests else ring.inner.called(function)(*args)
        force[0] = value(self.parts.functions[f"{self.parts.name}.force"])
        return self.from_series(force, inner, ring.inner.number, value)[:ring.order + 1]

    def at(self, *args: "float | mpmath.mpf") -> "float | mpmath.mpf":
        if any(hasattr(arg, "_mpf_") for arg in args):
            deflections, force = self.parts.precisely(args)
            found = self._value(InnerState(deflections[:, 0], force[0]), args, multiprecision())
            return found.item() if hasattr(found, "item") else found
        return float(self.on_arrays(*args))

    def on_arrays(self, *args: "float | np.ndarray") -> "np.ndarray":
        from vibcli.symbolic.array_arithmetic import Arrays

        found: np.ndarray = self._value(self.parts.solution(args), args, Arrays)
        return found

    def _value(self, found: InnerState, args: tuple[Any, ...], arithmetic: Any) -> Any:
        return self.from_parts(found, lambda what: self.parts.evaluated(what, args, arithmetic, found.deflections))

    def on_senses(self, args: "Sequence[float | np.ndarray]", senses: "Sequence[float | np.ndarray]") -> "np.ndarray":
        found, of_parts = self.parts.on_senses(args, senses)
        result: np.ndarray = self.from_parts(found, of_parts.__getitem__)
        return result

    def folded(self, table: Table, args: "Sequence[Node]") -> "Node | None":
        return table.zero if args[0].is_zero else None

    def ending(self, args: "Sequence[float]") -> Ending | None:
        found = None if self.parts.rises else self.parts.branch(args).ending(self.parts.unit)
        if found is None:
            return None
        name = self.parts.name.partition(".")[0]
        return Ending(f"the parts of '{name}' in series {found}", "their branch from rest alone is followed: "
                                "ask for what stays on it, or put bodies between the parts")

    def kinks(self, node: "Node") -> "list[Node]":
        return [self.parts.written(u, node) for u in self.parts.sided.kinks]


class Energy(FunctionOfSeries):
    """V(D) = Σ Vᵢ(dᵢ)."""

    kind, letter = "energy", "V"

    def template(self, i: int) -> "Node":
        if i == 0:
            return self.parts.calls[f"{self.parts.name}.force"]
        p = self.parts.p[i - 1]
        return self.parts.table.total([gradient(energy).get(p, self.parts.table.zero)
                                       for energy in self.parts.energies])

    def from_parts(self, found: InnerState, of_parts: "Callable[[str], Any]") -> Any:
        return sum(of_parts("energies"))

    def from_series(self, force: list[Any], inner: list[list[Any]], number: Any, value: Any) -> list[Any]:
        return [value(), *(c * number(Fraction(1, k + 1)) for k, c in enumerate(force))]


class Force(FunctionOfSeries):
    """F(D)."""

    kind, letter = "force", "F"

    def template(self, i: int) -> "Node":
        if i == 0:
            return self.parts.calls[f"{self.parts.name}.stiffness"]
        return self.parts.force_by(self.parts.p[i - 1])

    def from_parts(self, found: InnerState, of_parts: "Callable[[str], Any]") -> Any:
        return found.force

    def from_series(self, force: list[Any], inner: list[list[Any]], number: Any, value: Any) -> list[Any]:
        return force


class Stiffness(FunctionOfSeries):
    """K(D) = F′(D)."""

    kind, letter = "stiffness", "K"

    def template(self, i: int) -> "Node":
        parts, table = self.parts, self.parts.table
        bends = [gradient(slope) for slope in parts.stiffnesses]
        if i == 0:
            return table.total([parts.ratio(j) ** 3 * bends[j].get(d, table.zero) for j, d in enumerate(parts.d)])
        p = parts.p[i - 1]
        return table.total([parts.ratio(j) ** 2 * (
            bends[j].get(p, table.zero) + bends[j].get(d, table.zero) * parts.deflection_by(j, p))
            for j, d in enumerate(parts.d)])

    def from_parts(self, found: InnerState, of_parts: "Callable[[str], Any]") -> Any:
        import numpy as np

        slopes = of_parts("stiffnesses")
        with np.errstate(divide="ignore"):
            soft = sum(slope == 0 for slope in slopes) > 0
            give = sum(1 / np.where(slope == 0, slope + 1, slope) for slope in slopes)
            return np.where(soft, 0 * give, 1 / give)

    def from_series(self, force: list[Any], inner: list[list[Any]], number: Any, value: Any) -> list[Any]:
        return [c * number(k) for k, c in enumerate(force)][1:]

    def positive_where(self, node: "Node", x: "Node") -> "list[Node] | None":
        if not self.parts.rises or any(arg.mask & x.mask for arg in node.args[1:]):
            return None
        return written_in(node.table, self.parts.positive, {p.name: arg for p, arg in zip(
            self.parts.p, node.args[1:], strict=True)})

    def folded(self, table: Table, args: "Sequence[Node]") -> "Node | None":
        if not args[0].is_zero:
            return None
        parts = self.parts
        values = dict(zip([p.name for p in parts.p], args[1:], strict=True)) | {d.name: table.zero for d in parts.d}
        try:
            slopes = written_in(table, parts.stiffnesses, values)
            return table.zero if any(s.is_zero for s in slopes) else 1 / table.total([1 / s for s in slopes])
        except ZeroDivisionError:
            return None


class Deflection(FunctionOfSeries):
    """dᵢ(D)."""

    def __init__(self, parts: "SeriesOfLaws", i: int) -> None:
        self.i, self.kind = i, i + 1
        super().__init__(parts)

    @property
    def symbol(self) -> str:
        return f"d_{self.name.replace('.', '')}"

    def template(self, i: int) -> "Node":
        return self.parts.deflection_by(self.i, self.parts.p[i - 1]) if i else self.parts.ratio(self.i)

    def from_parts(self, found: InnerState, of_parts: "Callable[[str], Any]") -> Any:
        return found.deflections[self.i]

    def from_series(self, force: list[Any], inner: list[list[Any]], number: Any, value: Any) -> list[Any]:
        return inner[self.i]
