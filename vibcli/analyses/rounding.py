"""What the rounding of the data does to damped eigenvalues, to first order.

δλ = −y (λ² δM + λ δC + δK) x with the vectors normalised to y Q'(λ) x = 1.
"""

import math

import numpy as np

from vibcli.analyses import fixed as fx
from vibcli.analyses.quadratic import turning


def add_data_error(found, system, elements, scale, unit):
    """Widens every radius by the effect of a relative rounding 2^unit of every weight and component.

    K given with K_size carries 2⁻⁵³ of it even where the other data are exact.
    """
    basis, p = np.abs(fx.floats(system.basis, system.bits)), scale.coordinates
    sums = elements.K_size or elements.K
    exact = not math.isfinite(unit)
    m = _size(elements.inertias, elements.M, p, scale.mass, basis) * (not exact)
    c = _size(elements.dampers, turning(elements), p, scale.damping, basis) * (not exact)
    k = _size(elements.springs, {}, p, scale.stiffness, basis) * (not exact)
    k += _size((), sums, p, scale.stiffness, basis) / 3
    unit = -53.0 if exact else unit
    for d in found:
        if d.re or d.im:
            value = math.hypot(fx.to_float(d.re, system.bits), fx.to_float(d.im, system.bits))
            change = (value * value * m + value * c + k) @ np.abs(d.x)
            first = float(np.abs(d.left) @ change) if np.isfinite(d.left).all() else math.inf
            if d.mode is not None:
                first = min(first, math.sqrt(float(change[d.mode])) * 2.0 ** min(-unit / 2, 1000.0))
            if first:
                d.radius = float(np.logaddexp2(d.radius, math.log2(first) + unit))


def _size(terms, matrix, powers, scale, basis):
    """3 Σ |w| |sᵀ basis|ᵀ|sᵀ basis| + 3 |basis|ᵀ |matrix| |basis|, in scaled coordinates."""
    out = np.zeros((basis.shape[1], basis.shape[1]))
    for weight, row in terms:
        felt = sum(abs(_scaled(x, powers[i])) * basis[i] for i, x in row.items())
        out += abs(_scaled(weight, -scale)) * np.multiply.outer(felt, felt)
    for (i, j), x in matrix.items():
        out += abs(_scaled(x, powers[i] + powers[j] - scale)) * np.multiply.outer(basis[i], basis[j])
    return 3 * out


def _scaled(x, power):
    m, e = fx.mantissa(x)
    return fx.to_float(m, -(e + power))
