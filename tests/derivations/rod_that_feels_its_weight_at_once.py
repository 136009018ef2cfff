"""Waves: u = g t²/2 less what the clamp sends out, so that the end falls freely until L/c and is slowed from then on.

With u = g t²/2 + f(t − x/c) + f(t + x/c − 2L/c), the second the wave come back from the free end, u(0, t) = 0 gives
f(t) = −g t²/2 − f(t − 2L/c), f = 0 before 0.
"""
from mpmath import mp, mpf


def answers(p):
    with mp.workdps(20):
        L, E, rho, g = (mpf(p[n]) for n in ("L", "E", "rho", "g"))
        c = (E / rho) ** mpf("0.5")

        def f(t):
            return -g * t**2 / 2 - f(t - 2 * L / c) if t > 0 else mpf(0)

        def slope(t):           # f′
            return -g * t - slope(t - 2 * L / c) if t > 0 else mpf(0)

        def end(t):
            return g * t**2 / 2 + 2 * f(t - L / c)

        def stress(t):          # E u′ at x = 0
            return E / c * (slope(t - 2 * L / c) - slope(t))

        top = 2 * L / c
        return {"rod.u(L)(L/c)": end(L / c), "rod.u(L)(L/(2*c))": end(L / (2 * c)), "max(rod.u(L))": end(top),
                "argmax(rod.u(L))": top, "rod.stress(0 m)(L/c)": stress(L / c), "rod.stress(0 m)(2*L/c)": stress(top)}
