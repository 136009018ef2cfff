"""First-order bounds of the errors of H(iΩ) = cᵀD⁻¹b + d, D = K + sC + s²M.

With x = D⁻¹b and y = D⁻ᵀc:   |δH| <= |y|ᵀ (|δD| |x| + |δb|) + |δc|ᵀ|x| + |δd| + |D′x| |y| |δs|,   δD by elements and
the rounding of their sums and of the elimination.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.frequency_response.quadratics import polynomial, slope
from vibcli.analyses.transient.data_errors import DATA

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.transfer_function import TransferFunction
    from vibcli.analyses.transient.data_errors import DataErrors

EPSILON = 2.0**-52
GIVEN = 4 * DATA        # relative, of the rows of inputs and outputs


def of_value(system: "TransferFunction", data: "DataErrors", Omega: float) -> float:
    """|δH| at a frequency, given the DataErrors of the matrices."""
    large, n = abs(Omega), system.n
    s = np.array([1j * Omega])
    b, c, d = (polynomial(part, s)[0] for part in (system.b, system.c, system.d))
    of_b, of_c, of_d = (polynomial(np.abs(part), np.array([large]))[0] for part in (system.b, system.c, system.d))
    D = system.K + s[0] * system.C + s[0]**2 * system.M
    terms = np.abs(system.K) + large * np.abs(system.C) + large**2 * np.abs(system.M)
    x, y = _solved(D, b), np.abs(_solved(D.T, c))
    missed = GIVEN * of_b + (n + 4) * EPSILON * terms @ np.abs(x)
    for k, ((weights, rows), entries) in enumerate(zip(data.weights, data.entries, strict=True)):
        missed = missed + large**k * (np.abs(rows).T @ (weights * np.abs(rows @ x)) + entries @ np.abs(x))
    turned = np.abs(system.C @ x + 2 * s[0] * (system.M @ x)) + np.abs(slope(system.b, s)[0])
    found = y @ (missed + 2 * DATA * large * turned) + (GIVEN + n * EPSILON) * of_c @ np.abs(x)
    found = found + 2 * DATA * large * abs(slope(system.c, s)[0] @ x + slope(system.d, s)[0])
    found = float(abs(found) + GIVEN * of_d + 8 * EPSILON * abs(c @ x + d))
    return found * large**system.order * (1.0 + 2 * system.order * DATA)


def _solved(D, right):
    """D⁻¹ of a vector, of least squares where D is singular."""
    try:
        return np.linalg.solve(D, right)
    except np.linalg.LinAlgError:
        return np.linalg.pinv(D) @ right
