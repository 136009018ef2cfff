"""u(L) is the sum of 4F/(mu L w^2) times what η̈ + c η̇ + w² η = 0 makes of 1, c = alpha + beta w^2 through both ratios.

High modes are over-damped: their two eigenvalues are real. The lowest place is where u′ = 0 in the first half period.
"""
from mpmath import cos, cosh, exp, findroot, mp, mpf, pi, sqrt

COUNT = 300


def answers(p):
    with mp.workdps(20):
        L, EI, mu, F = (mpf(p[n]) for n in ("L", "EI", "mu", "F"))
        first = [findroot(lambda x: cos(x) + 1 / cosh(x), (n - mpf("0.5")) * pi) for n in range(1, 12)]
        w = [x**2 / L**2 * sqrt(EI / mu) for x in first + [(n - mpf("0.5")) * pi for n in range(12, COUNT)]]
        beta = 2 * (mpf("0.02") * w[1] - mpf("0.01") * w[0]) / (w[1] ** 2 - w[0] ** 2)
        alpha = mpf("0.02") * w[0] - beta * w[0] ** 2
        eigenvalues = []
        for x in w:
            c = alpha + beta * x**2
            fast = -c / 2 - sqrt(c**2 / 4 - x**2 + 0j)
            eigenvalues.append((x, x**2 / fast, fast))

        def u(t, rate=0):
            return sum(4 * F / (mu * L * x**2) * ((one**rate * two * exp(one * t) - two**rate * one * exp(two * t))
                                                  / (two - one)).real for x, one, two in eigenvalues)

        back = findroot(lambda t: u(t, 1), (pi / w[0] * mpf("0.98"), pi / w[0] * mpf("1.02")), tol=1e-12)
        return {"zeta[3]": alpha / (2 * w[2]) + beta * w[2] / 2, "decay[1]": w[0] / 100,
                "chimney.u(L)(0 s)": F * L**3 / (3 * EI), "chimney.u(L)(4 s)": u(mpf(4)),
                "chimney.u(L)(15 s)": u(mpf(15)), "min(chimney.u(L))": u(back)}
