"""Without the dashpot the end answers by all modes w = (n − 1/2) a, a = (pi/L) √(EA/mu),

    G(s) = 2/(mu L) Σ 1/(w² + 2 z s w + s²) = 2/(mu L) (ψ(1/2 − l'/a) − ψ(1/2 − l/a))/(a (l − l')),

l, l' = s (−z ± i √(1 − z²)), ψ the digamma function. The dashpot pulls with c s H, so that H = G (1 − c s H).
"""
from mpmath import digamma, mp, mpc, mpf, pi, sqrt


def answers(p):
    with mp.workdps(25):
        L, EA, mu, c, z, F, W = (mpf(p[n]) for n in ("L", "EA", "mu", "c", "zeta", "F", "Omega"))
        a = pi / L * sqrt(EA / mu)

        def H(s):
            one, two = s * mpc(-z, sqrt(1 - z**2)), s * mpc(-z, -sqrt(1 - z**2))
            G = 2 / (mu * L) * (digamma(0.5 - two / a) - digamma(0.5 - one / a)) / (a * (one - two))
            return G / (1 + c * s * G)

        return {"omega[1]": a / 2, "amplitude(rod.u(L))": F * abs(H(1j * W)),
                "abs(frf[rod.u(L), shaker](omega[1]))": abs(H(1j * a / 2))}
