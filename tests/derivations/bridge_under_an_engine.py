"""The series of sines; that of the moment as the static one and a rest that converges as 1/n^6."""
from mpmath import mp, mpf, pi, sin


def answers(p):
    with mp.workdps(20):
        L, EI, mu, F, W = (mpf(p[n]) for n in ("L", "EI", "mu", "F", "Omega"))
        a = L / 3

        def term(n, x, order):
            k = n * pi / L
            bare = 2 * F / L * sin(k * a) * sin(k * x)
            return bare / (EI * k**4 - mu * W**2) if order == 0 else bare * EI * k**2 * (
                1 / (EI * k**4 - mu * W**2) - 1 / (EI * k**4))

        def u(x):
            return sum(term(n, x, 0) for n in range(1, 3000))

        x = L / 2
        static = F * a * (L - x) / L            # of the simply supported beam, x > a
        moment = static + sum(term(n, x, 2) for n in range(1, 3000))
        return {"omega[1]": (pi / L) ** 2 * (EI / mu) ** mpf("0.5"), "amplitude(bridge.u(L/3))": abs(u(a)),
                "amplitude(bridge.u(L/2))": abs(u(x)), "amplitude(bridge.moment(L/2))": abs(moment)}
