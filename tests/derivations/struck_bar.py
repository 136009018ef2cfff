"""Until the wave is back, 0.4 ms: M v' = -Z v, Z = A sqrt(E rho); the force -Z v travels, and doubles at the clamp."""
from math import exp, sqrt


def answers(p):
    L, E, A, rho, M, v = (p[n] for n in ("L", "E", "A", "rho", "M", "v"))
    Z, c = A * sqrt(E * rho), sqrt(E / rho)

    def velocity(t):
        return -v * exp(-Z * t / M)

    return {"rod.force(L)(0.2 ms)": Z * velocity(2e-4), "rod.force(0 m)(0.25 ms)": 2 * Z * velocity(2.5e-4 - L / c),
            "x'(0.2 ms)": velocity(2e-4)}
