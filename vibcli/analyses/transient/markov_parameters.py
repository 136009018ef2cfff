"""How the forces enter the derivatives of the coordinates directly, without the delay of an inertia or a damper.

    q⁽ᵒ⁾ = Re Σ X Bᵒ c + Σ H_{o−1−i} f⁽ⁱ⁾,  i = 0 … o,  H₁ = M⁻¹,  M H_{i+1} = −C Hᵢ − K H_{i−1},  H₀ = H₋₁ = 0

Where coordinates have no inertia H₋₁ is what follows the forces statically, and Hᵢ = T [Aⁱ (0; L⁻¹)] of the others.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.transient.eigenvalue_clusters import first_order
from vibcli.analyses.transient.static_condensation import leading

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.linear_response import LinearMotion
    from vibcli.analyses.transient.static_condensation import Condensed


def markov(motion: "LinearMotion", count: int) -> list[np.ndarray]:
    """[H₋₁, H₀, H₁, …], `count` of them from H₁ on."""
    if motion.system is not None:
        return _without_inertia(motion.system, count)
    M, C, K = motion.M, motion.C, motion.K
    found = [np.zeros_like(M), np.zeros_like(M), np.linalg.inv(M)]
    while len(found) <= count + 1:
        found.append(-found[2] @ (C @ found[-1] + K @ found[-2]))
    return found


def _without_inertia(system: "Condensed", count: int) -> list[np.ndarray]:
    (h, lead), n = leading(system.M, system.C), len(system.M)
    A = first_order(system.M, system.C, system.K)
    state = np.concatenate([np.zeros((h, n)), np.linalg.inv(lead)])
    found = [system.follow]
    while len(found) <= count + 1:
        found.append(system.T @ state[:n] @ system.left.T)
        state = A @ state
    return found


def direct(output: "LinearOutput", order: int, H: Sequence[np.ndarray], channels: int) -> dict[int, np.ndarray]:
    """{i: row over the channels}: the order-th derivative of the output has the parts row · f⁽ⁱ⁾; H from H₋₁ on."""
    n, found = len(H[0]), {}
    for lead, coefficients in enumerate((output.q, output.v, output.a)):
        total = order + lead
        for i in range(total + 1) if coefficients else ():
            row = found.setdefault(i, np.zeros(channels))
            for place, x in coefficients.items():
                row[:n] += x * H[total - i][place]
    if output.channels:
        row = found.setdefault(order, np.zeros(channels))
        for channel, x in output.channels.items():
            row[channel] += x
    return found
