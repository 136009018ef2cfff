"""Inner products of element data: yᴴ A x = Σ w (∇s·y)* (∇s·x) + Σ A₊ᵢⱼ yᵢ* xⱼ, by element and never assembled.

Of a stiff spring that hardly stretches, (∇s·φ) is small though the components of φ are not: squaring it afterwards
keeps the digits.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.mechanics.factored_system import FactoredSystem, WeightedRow

if TYPE_CHECKING:
    import mpmath
    import numpy as np

    from vibcli.symbolic.dual_numbers import Dual


def inner(terms: Iterable[WeightedRow], extra: "Mapping[tuple[int, int], mpmath.mpf | Dual]",
          y: "Sequence[float | mpmath.mpc] | np.ndarray", x: "Sequence[float | mpmath.mpc] | np.ndarray") -> Any:
    """yᴴ A x of rows and weights and a matrix {(i, j): number}; A is real."""
    y = [conjugate(part) for part in y]
    total = sum(weight * along(row, y) * along(row, x) for weight, row in terms)
    return total + sum(entry * y[i] * x[j] for (i, j), entry in extra.items())


def along(row: Mapping[int, Any],
          x: "Mapping[int, mpmath.mpf] | Sequence[Any] | np.ndarray") -> "float | mpmath.mpc | mpmath.mpf | Dual":
    """∇s·x."""
    return sum(slope * x[i] for i, slope in row.items())


def conjugate(x: "mpmath.mpc | mpmath.mpf") -> "mpmath.mpc | mpmath.mpf":
    return x.conjugate() if hasattr(x, "_mpc_") or isinstance(x, complex) else x


def only(elements: FactoredSystem, kept: Callable[..., bool]) -> FactoredSystem:
    """The element data of which a number is `kept`: the terms in which one is, and such entries of the matrices."""
    def terms(found: "Iterable[WeightedRow]") -> "list[WeightedRow]":
        return [(weight, row) for weight, row in found if kept(weight) or any(map(kept, row.values()))]

    def entries(found: "Mapping[tuple[int, int], Any]") -> "dict[tuple[int, int], Any]":
        return {pair: x for pair, x in found.items() if kept(x)}

    return FactoredSystem(
        elements.n, terms(elements.inertias), terms(elements.springs), terms(elements.dampers), M=entries(elements.M),
        C=entries(elements.C), G=entries(elements.G), K=entries(elements.K), drag=entries(elements.drag))
