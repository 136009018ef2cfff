"""Transfer matrices of the two parts and the bead; the third overtone has its node at the bead."""
from mpmath import mp, mpf, pi, sqrt
from support.transfer_matrices import bar, condition, first_roots, mass


def answers(p):
    with mp.workdps(40):
        L, mu, T, m = (mpf(p[n]) for n in ("L", "mu", "T", "m"))
        found = condition([bar(L / 3, T, mu), mass(2, m), bar(2 * L / 3, T, mu)], "clamped", "clamped")
        third = 3 * pi / L * sqrt(T / mu)
        roots = first_roots(found, 4, third / 151)
        assert abs(roots[2] / third - 1) < mpf(10) ** -20
        return {f"frequency[{i}]": w / (2 * pi) for i, w in enumerate(roots, 1)}
