"""k1 (D − d) = k2 d − γ d³ is solved between 0 and the stretch at which the insert gives way; the period is
4 ∫ dx/√(2 (V(a) − V(x))/m) with x = a sin θ. Small stretches share D by k1/(k1 + k2)."""
from mpmath import cos, findroot, mp, mpf, pi, quad, sin, sqrt


def answers(p):
    with mp.workdps(25):
        m, k1, k2, gamma, a = (mpf(p[n]) for n in ("m", "k1", "k2", "gamma", "a"))

        def inner(D):
            return findroot(lambda d: k1 * (D - d) - k2 * d + gamma * d**3, (mpf(0), sqrt(k2 / (3 * gamma))),
                            solver="anderson", tol=1e-40)

        def V(D):
            d = inner(D)
            return k1 * (D - d) ** 2 / 2 + k2 * d**2 / 2 - gamma * d**4 / 4

        top = V(a)

        def part(theta):
            return a * cos(theta) / sqrt(2 * (top - V(a * sin(theta))) / m)

        end = pi / 2 - mpf(10) ** -9
        period = 4 * (quad(part, [0, pi / 4, end], maxdegree=5) + part(end) * mpf(10) ** -9)
        share = k1 / (k1 + k2)
        return {"law[cable](a)": k1 * (a - inner(a)), "cable.stretch.2(0 s)": inner(a), "period(x)": period,
                "omega[1]": sqrt(k2 * share / m), "law[cable, d^3]": -gamma * share**4}
