"""The load acts on the tip with the impedance -k m w^2/(k - m w^2); multiplied out, so that nothing has a pole."""
from mpmath import mp, mpf, pi
from support.transfer_matrices import beam, condition, first_roots, point


def answers(p):
    with mp.workdps(40):
        L, EI, mu, m, k = (mpf(p[n]) for n in ("L", "EI", "mu", "m", "k"))
        jib = beam(L, EI, mu)
        tip = point(4, lambda w: -k * m * w**2 / (k - m * w**2))
        found = condition([jib, tip], "clamped", "free")
        roots = first_roots(lambda w: found(w) * (k - m * w**2), 3, mpf("1.3"))
        return {**{f"frequency[{i}]": w / (2 * pi) for i, w in enumerate(roots, 1)},
                "mode[1][y]/mode[1][jib.u(L)]": k / (k - m * roots[0] ** 2)}
