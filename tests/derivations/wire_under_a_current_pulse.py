"""Waves: u = h(t) + f(t − x/c) + f(t − (L − x)/c), h = q (t² − (t − 2L/c)²₊)/2μ what a wire without ends would do.

u(0, t) = 0 gives f(t) = −h(t) − f(t − L/c), f = 0 before 0.
"""
from mpmath import mp, mpf


def answers(p):
    with mp.workdps(20):
        L, N, mu, q = (mpf(p[n]) for n in ("L", "N", "mu", "q"))
        c = (N / mu) ** mpf("0.5")

        def free(t, order):     # h or h′
            return sum(sign * q / mu * max(t - start, 0) ** (2 - order) / (2 - order)
                       for sign, start in ((1, mpf(0)), (-1, 2 * L / c)))

        def f(t, order=0):
            return -free(t, order) - f(t - L / c, order) if t > 0 else mpf(0)

        def u(x, t):
            return free(t, 0) + f(t - x / c) + f(t - (L - x) / c)

        middle, top = L / 2, L / c
        return {"wire.u(L/2)(L/(4*c))": u(middle, top / 4), "wire.u(L/2)(L/c)": u(middle, top),
                "max(wire.u(L/2))": u(middle, top), "argmax(wire.u(L/2))": top,
                "wire.slope(0 m)(L/c)": (f(top - L / c, 1) - f(top, 1)) / c,
                "wire.u(L/2)(7*L/(4*c))": u(middle, 7 * top / 4), "wire.u(L/3)(3*L/c)": u(L / 3, 3 * top)}
