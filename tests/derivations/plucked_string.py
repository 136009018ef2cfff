"""D'Alembert: the mean of two odd periodic copies of the first shape; after half a period mirrored and turned over."""
from math import sqrt


def answers(p):
    L, mu, T, h = (p[n] for n in ("L", "mu", "T", "h"))
    c = sqrt(T / mu)

    def first(x):
        x %= 2 * L
        if x > L:
            return -first(2 * L - x)
        return h * min(4 * x / L, 4 * (L - x) / (3 * L))

    def u(x, t):
        return (first(x - c * t) + first(x + c * t)) / 2

    return {"string.u(L/2)(1 ms)": u(L / 2, 1e-3), "string.u(3*L/4)(L/sqrt(T/mu))": u(3 * L / 4, L / c),
            "max(string.u(L/2))": max(u(L / 2, i * 2 * L / c / 4000) for i in range(4000))}
