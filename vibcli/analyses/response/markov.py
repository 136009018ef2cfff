"""How the forces enter the derivatives of the coordinates directly, without the inertia's delay.

    q⁽ᵒ⁾ = Re Σ X Bᵒ c + Σ H_{o−1−i} f⁽ⁱ⁾,  i = 0 … o − 2,  H₁ = M⁻¹,  M H_{i+1} = −C Hᵢ − K H_{i−1},  H₀ = 0
"""

import numpy as np


def markov(M, C, K, count):
    """[H₀, H₁, …], `count` of them from H₁ on."""
    found = [np.zeros_like(M), np.linalg.inv(M)]
    while len(found) <= count:
        found.append(-found[1] @ (C @ found[-1] + K @ found[-2]))
    return found


def direct(output, order, H, channels):
    """{i: row over the channels}: the order-th derivative of the output has the parts row · f⁽ⁱ⁾."""
    n, found = len(H[0]), {}
    for lead, coefficients in enumerate((output.q, output.v, output.a)):
        total = order + lead
        for i in range(total - 1):
            row = found.setdefault(i, np.zeros(channels))
            for place, x in coefficients.items():
                row[:n] += x * H[total - 1 - i][place]
    if output.channels:
        row = found.setdefault(order, np.zeros(channels))
        for channel, x in output.channels.items():
            row[channel] += x
    return found
