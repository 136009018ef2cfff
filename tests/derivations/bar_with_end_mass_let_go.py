"""u(L) = u0 (2 - t - e^-t) to t = 2, the strain at the clamp u0/L (2 e^(1 - t) - 1) from 1 to 3; t in L/c = 2 ms."""
from math import exp, sqrt


def answers(p):
    L, EA, mu, u0 = (p[n] for n in ("L", "EA", "mu", "u0"))
    c = sqrt(EA / mu)
    return {**{f"rod.u(L)({n} ms)": u0 * (2 - t - exp(-t)) for n in (2, 3, 4) for t in [n * 1e-3 * c / L]},
            "rod.force(0 m)(4 ms)": EA * u0 / L * (2 * exp(1 - 4e-3 * c / L) - 1)}
