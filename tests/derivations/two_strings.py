"""Transfer matrices of both; at the knot displacement and force go on."""
from mpmath import mp, mpf, pi
from support.transfer_matrices import bar, condition, first_roots


def answers(p):
    with mp.workdps(40):
        a, b, mu1, mu2, T = (mpf(p[n]) for n in ("a", "b", "mu1", "mu2", "T"))
        roots = first_roots(condition([bar(a, T, mu1), bar(b, T, mu2)], "clamped", "clamped"), 3, mpf(30))
        return {f"frequency[{i}]": w / (2 * pi) for i, w in enumerate(roots, 1)}
