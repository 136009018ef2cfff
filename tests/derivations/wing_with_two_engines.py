"""Transfer matrices between free ends; the first two modes are rigid."""
from mpmath import mp, mpf, pi
from support.transfer_matrices import beam, condition, first_roots, mass


def answers(p):
    with mp.workdps(40):
        L, EI, mu, M, m = (mpf(p[n]) for n in ("L", "EI", "mu", "M", "m"))
        part = beam(L / 4, EI, mu)
        chain = [part, mass(4, m), part, mass(4, M), part, mass(4, m), part]
        roots = first_roots(condition(chain, "free", "free"), 3, mpf("1.1"))
        return {f"frequency[{i}]": w / (2 * pi) for i, w in enumerate(roots, 3)}
