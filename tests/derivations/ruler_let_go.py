"""u(L) is the sum of -4F/(mu L w_n^2) cos w_n t: a cantilever whose tip moves by 1 has the modal mass mu L/4.

Of that so many terms that the rest, which falls as n^-3, is below the digits told.
"""
from math import cos, pi, sqrt

from mpmath import cos as precise_cos
from mpmath import cosh, findroot, mp, mpf


def answers(p):
    L, EI, mu, F = (p[n] for n in ("L", "EI", "mu", "F"))
    with mp.workdps(20):
        first = [float(findroot(lambda x: precise_cos(x) + 1 / cosh(x), mpf(n - 0.5) * mp.pi)) for n in range(1, 8)]
    w = [x * x / L**2 * sqrt(EI / mu) for x in first + [(n - 0.5) * pi for n in range(8, 4001)]]

    def u(t):
        return sum(-4 * F / (mu * L * z**2) * cos(z * t) for z in w)

    return {"ruler.u(L)(0 s)": u(0.0), "ruler.u(L)(10 ms)": u(0.01), "ruler.u(L)(50 ms)": u(0.05)}
