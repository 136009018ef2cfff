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


def of_values(system: "TransferFunction", data: "DataErrors", Omega: np.ndarray) -> np.ndarray:
    """|δH| at frequencies (N,), given the DataErrors of the matrices."""
    large, s, n = np.abs(Omega), 1j * Omega, system.n
    at = large[:, None]
    c, d = (polynomial(part, s) for part in (system.c, system.d))
    of_b, of_c, of_d = (polynomial(np.abs(part), large) for part in (system.b, system.c, system.d))
    x, y = system.fields(s)
    size, y = np.abs(x), np.abs(y)
    missed = GIVEN * of_b
    for k, (matrix, (weights, rows), entries) in enumerate(zip((system.K, system.C, system.M), data.weights,
                                                               data.entries, strict=True)):
        lost = (weights * np.abs(x @ rows.T)) @ np.abs(rows) + size @ (entries + (n + 4) * EPSILON * np.abs(matrix)).T
        missed = missed + at**k * lost
    turned = np.abs(x @ system.C.T + 2 * s[:, None] * (x @ system.M.T)) + np.abs(slope(system.b, s))
    found = (y * (missed + 2 * DATA * at * turned)).sum(axis=1) + (GIVEN + n * EPSILON) * (of_c * size).sum(axis=1)
    found = found + 2 * DATA * large * np.abs((slope(system.c, s) * x).sum(axis=1) + slope(system.d, s))
    found = found + GIVEN * of_d + 8 * EPSILON * np.abs((c * x).sum(axis=1) + d)
    result: np.ndarray = found * large**system.order * (1.0 + 2 * system.order * DATA)
    return result
