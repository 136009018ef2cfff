"""Transfer matrices of the three tubes, clamped below and free above, in 40 digits."""
from mpmath import mp, mpf, pi
from support.transfer_matrices import beam, condition, first_roots


def answers(p):
    with mp.workdps(40):
        h = mpf(p["h"])
        tubes = [beam(h, mpf(p[f"EI{i}"]), mpf(p[f"mu{i}"])) for i in (1, 2, 3)]
        roots = first_roots(condition(tubes, "clamped", "free"), 3, mpf(2))
        return {f"frequency[{i}]": w / (2 * pi) for i, w in enumerate(roots, 1)}
