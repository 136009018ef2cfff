"""A beam guided at its foot, where mass and spring act, its u to the left; transfer matrices in 40 digits."""
from mpmath import mp, mpf
from support.transfer_matrices import beam, condition, first_roots, mass, point


def answers(p):
    with mp.workdps(40):
        L, EI, mu, M, k, m = (mpf(p[n]) for n in ("L", "EI", "mu", "M", "k", "m"))
        half, foot = beam(L / 2, EI, mu), point(4, lambda w: k - M * w**2)
        roots = first_roots(condition([foot, half, mass(4, m), half], "guided", "free"), 3, mpf(4))
        w = roots[0]
        start, whole = foot(w), half(w) * mass(4, m)(w) * half(w) * foot(w)
        V = -whole[2, 0] / whole[2, 2]                  # moment at the foot for u = 1 there: the free end has none
        state = half(w) * start
        return {**{f"omega[{i}]": x for i, x in enumerate(roots, 1)},
                "mode[1][mast.u(L/2)]": -(state[0, 0] + state[0, 2] * V)}
