"""Each sine n pi x/L is an oscillator of the modal mass mu L/2, damped by 0.6 %; even ones rest. From rest it moves by

    q = Im(H (e^{i W t} − e^{l t} (i W − l')/(l − l') + e^{l' t} (i W − l)/(l − l'))),      l, l' = w (−z ± i √(1 − z²))
"""
from mpmath import exp, expj, mp, mpc, mpf, pi, sqrt

Z = mpf(6) / 1000


def answers(p):
    with mp.workdps(20):
        L, EI, mu, F, W = (mpf(p[n]) for n in ("L", "EI", "mu", "F", "Omega"))
        w = [(n * pi / L) ** 2 * sqrt(EI / mu) for n in range(1, 2000, 2)]

        def H(W):
            return sum(2 / (mu * L) / (x**2 - W**2 + 2j * Z * x * W) for x in w)

        def q(x, t):
            one = x * mpc(-Z, sqrt(1 - Z**2))
            two = one.conjugate()
            free = ((1j * W - two) * exp(one * t) - (1j * W - one) * exp(two * t)) / (one - two)
            return ((expj(W * t) - free) / (x**2 - W**2 + 2j * Z * x * W)).imag * 2 * F / (mu * L)

        return {"omega[1]": w[0], "zeta[2]": Z, "amplitude(bridge.u(L/2))": F * abs(H(W)),
                "amplitude(bridge.u''(L/2))": F * W**2 * abs(H(W)), "bridge.u(L/2)(2 s)": sum(q(x, 2) for x in w),
                "abs(frf[bridge.u(L/2), steps](omega[1]))": abs(H(w[0]))}
