"""Along the slope the top point is a cycloid's; the potential energy of its spring is differentiated by mpmath, the
tension follows from moments about the contact, 2 N = M g - m g sin(beta)."""
from math import sin

import mpmath


def answers(p):
    m, r, k1, k2, L, M, Jp, rp, beta, g = (p[n] for n in ("m", "r", "k1", "k2", "l", "M", "Jp", "rp", "beta", "g"))
    N = (M * g - m * g * sin(beta)) / 2

    def stretch(s):
        return mpmath.hypot(L + s + r * mpmath.sin(s / r), r * mpmath.cos(s / r) - r) - L

    def energy(s):
        return N * stretch(s) + k1 / 2 * stretch(s) ** 2 + k2 / 2 * s * s + (m * sin(beta) - M) * g * s

    assert abs(mpmath.diff(energy, 0)) < 1e-9
    K = mpmath.diff(energy, 0, 2)
    inertia = 1.5 * m + M + Jp / rp**2
    return {"M[s,s]": inertia, "K[s,s]": float(K), "omega[1]": float(mpmath.sqrt(K / inertia))}
