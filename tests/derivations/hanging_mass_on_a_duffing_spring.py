"""The cubic equation of rest; V is a polynomial of the fourth degree, so that its expansion is V itself; the period by
quadrature between its turning points."""
from mpmath import findroot, mp, mpf, pi, quad, sin, sqrt


def answers(p):
    with mp.workdps(30):
        m, k, g3, g, A = (mpf(p[name]) for name in ("m", "k", "g3", "g", "A"))
        y = findroot(lambda d: k * d + g3 * d**3 - m * g, mpf("0.05"))

        def V(d):
            return k * d**2 / 2 + g3 * d**4 / 4 - m * g * d

        low = findroot(lambda d: V(d) - V(A), 2 * y - A)
        half, mid = (A - low) / 2, (A + low) / 2

        def rest(d):
            """(V(A) − V(d))/((A − d)(d − low)), by dividing the polynomial by its two roots."""
            b2 = g3 / 4
            b1 = b2 * (A + low)
            b0 = k / 2 + b1 * (A + low) - b2 * A * low
            return b2 * d**2 + b1 * d + b0

        period = 2 * quad(lambda a: 1 / sqrt(2 * rest(mid + half * sin(a)) / m), [-pi / 2, 0, pi / 2])
        return {"equilibrium[y]": float(y), "V[y]": 0.0, "V[y^2]": float(k / 2 + 3 * g3 * y**2 / 2),
                "V[y^3]": float(g3 * y), "V[y^4]": float(g3 / 4), "period(y)": float(period)}
