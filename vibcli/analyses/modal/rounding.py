"""What the rounding of the data does to damped eigenvalues, to first order.

δλ = −y (λ² δM + λ δC + δK) x with the vectors normalised to y Q'(λ) x = 1.
"""

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.damped_in_modal_coordinates import Eigenvalue, ModalDamping, turning
from vibcli.numerics import fixed_point as fx

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath

    from vibcli.analyses.modal.massless_coordinates import MassiveSystem
    from vibcli.analyses.modal.scaling import Scaling


def with_data_error(found: Sequence[Eigenvalue], system: "ModalDamping | MassiveSystem", elements: Any,
                    scale: "Scaling", unit: float) -> list[Eigenvalue]:
    """The eigenvalues, every radius widened by the effect of a relative rounding 2^unit of every weight and component.

    K given with K_size carries 2⁻⁵³ of it even where the other data are exact.
    """
    m, c, k = magnitudes(system, elements, scale, unit)
    unit = last_bit(unit)

    def widened(d: Eigenvalue) -> Eigenvalue:
        value = math.hypot(fx.to_float(d.re, system.bits), fx.to_float(d.im, system.bits))
        change = (value * value * m + value * c + k) @ np.abs(d.x)
        first = float(np.abs(d.left) @ change) if np.isfinite(d.left).all() else math.inf
        if d.mode is not None:
            first = min(first, math.sqrt(float(change[d.mode])) * 2.0 ** min(-unit / 2, 1000.0))
        return d._replace(radius=float(np.logaddexp2(d.radius, math.log2(first) + unit))) if first else d

    return [widened(d) if d.re or d.im else d for d in found]


def last_bit(unit: float) -> float:
    """log2 of the rounding that numbers carry which are exact but for the sums in K."""
    return unit if math.isfinite(unit) else -53.0


def magnitudes(system: "ModalDamping | MassiveSystem", elements: Any, scale: "Scaling",
               unit: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """What the roundings of M, C and K are proportional to, in the columns of the system."""
    right, p = np.abs(fx.floats(system.basis, system.bits)), scale.coordinates
    left = np.abs(fx.floats(system.left, system.bits)) if hasattr(system, "left") else right
    rounded = math.isfinite(unit)
    m = _size(elements.inertias, elements.M, p, scale.mass, left, right) * rounded
    c = _size(elements.dampers, turning(elements), p, scale.damping, left, right) * rounded
    k = _size(elements.springs, {}, p, scale.stiffness, left, right) * rounded
    k += _size((), elements.K_size or elements.K, p, scale.stiffness, left, right) / 3
    return m, c, k


def _size(terms: "tuple[tuple[float | Fraction | mpmath.mpf, dict[int, float | Fraction | mpmath.mpf]], ...]",
          matrix: "Mapping[tuple[int, int], float | Fraction | mpmath.mpf]", powers: Sequence[int], scale: int,
          left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """3 Σ |w| |sᵀ left|ᵀ|sᵀ right| + 3 |left|ᵀ |matrix| |right|, in scaled coordinates."""
    out = np.zeros((left.shape[1], right.shape[1]))
    for weight, row in terms:
        ends = [sum(abs(fx.times_power(x, powers[i])) * basis[i] for i, x in row.items()) for basis in (left, right)]
        out += abs(fx.times_power(weight, -scale)) * np.multiply.outer(*ends)
    for (i, j), x in matrix.items():
        out += abs(fx.times_power(x, powers[i] + powers[j] - scale)) * np.multiply.outer(left[i], right[j])
    return 3 * out
