"""d'Alembert: u = F(x - at) + G(x + at), F continued at the clamp as -G, G at the dashpot by its coefficient."""
from math import sqrt


def answers(p):
    L, EA, mu, e, c = (p[n] for n in ("L", "EA", "mu", "e", "c"))
    speed, Z = sqrt(EA / mu), sqrt(EA * mu)
    back = (Z - c) / (Z + c)

    def half(s):
        return e * min(s, L / 2) / 2

    def F(s):
        return half(s) if s >= 0 else -G(-s)

    def G(s):
        return half(s) if s <= L else half(L) + back * (F(2 * L - s) - half(L))

    def u(x, t):
        return F(x - speed * t) + G(x + speed * t)

    return {"rod.u(L)(13 ms)": u(L, 0.013), "rod.u(L/2)(31 ms)": u(L / 2, 0.031), "rod.u(L)(40 ms)": u(L, 0.04)}
