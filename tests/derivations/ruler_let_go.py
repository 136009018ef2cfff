"""u(L) is the sum of -4F/(mu L w_n^2) cos w_n t: a cantilever whose tip moves by 1 has the modal mass mu L/4.

Of that so many terms that the rest, which falls as n^-3, is below the digits told. The moment at the clamp is each term
times EI X''(0)/X(L); the end of its series, whose terms fall as n^-2, is smoothed by weights.
"""
from math import cos, cosh, pi, sin, sinh, sqrt

from mpmath import cos as precise_cos
from mpmath import cosh as precise_cosh
from mpmath import findroot, mp, mpf


def answers(p):
    L, EI, mu, F = (p[n] for n in ("L", "EI", "mu", "F"))
    with mp.workdps(20):
        first = [float(findroot(lambda x: precise_cos(x) + 1 / precise_cosh(x), mpf(n - 0.5) * mp.pi))
                 for n in range(1, 8)]
    b = first + [(n - 0.5) * pi for n in range(8, 4001)]
    w = [x * x / L**2 * sqrt(EI / mu) for x in b]

    def u(t):
        return sum(-4 * F / (mu * L * z**2) * cos(z * t) for z in w)

    def moment(t):
        total = 0.0
        for n, (x, z) in enumerate(zip(b, w, strict=True), 1):
            smooth = 1.0 if n < 2000 else (1 + cos(pi * (n - 2000) / 2000)) / 2
            total += smooth * -4 * F / (mu * L * z**2) * curvature(x, n) * EI * x**2 / L**2 * cos(z * t)
        return total

    def curvature(x, n):
        """X''(0)/(b^2 X(L)) of cosh - cos - s (sinh - sin)."""
        if x > 20:
            return 1.0 if n % 2 else -1.0
        s = (cosh(x) + cos(x)) / (sinh(x) + sin(x))
        return 2 / (cosh(x) - cos(x) - s * (sinh(x) - sin(x)))

    return {"ruler.u(L)(0 s)": u(0.0), "ruler.u(L)(10 ms)": u(0.01), "ruler.u(L)(50 ms)": u(0.05),
            "ruler.moment(0 m)(10 ms)": moment(0.01)}
