"""k (D − d) = gamma d^3 by mpmath; by orders: D = d + (gamma/k) d^3, reversed
d = D − (gamma/k) D^3 + 3 (gamma/k)^2 D^5, and F = gamma d^3."""

import mpmath


def answers(p):
    k, gamma, D = p["k"], p["gamma"], p["D"]
    with mpmath.workdps(40):
        high = min(D, (k * D / gamma) ** (1 / 3))
        d = mpmath.findroot(lambda d: k * (D - d) - gamma * d**3, (0, high), solver="anderson")
        force = float(gamma * d**3)
    r = gamma / k
    return {"law[s](D)": force, "law[s, d]": 0.0, "law[s, d^3]": gamma, "law[s, d^5]": gamma * -3 * r,
            "law[s, d^7]": gamma * (3 * 3 * r**2 + 3 * r**2)}
