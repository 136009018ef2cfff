"""By symmetry half of it: a column, a corner and half of the girder, whose middle is pinned across and free along where
the frame sways, guided across and held along where it does not.

States (u, u', M, V) and (w, N) go from the foot to the middle. At the corner x = -u, y = w of the column, which are w
and u of the girder; the corner has no mass, so that its forces go over likewise.
"""
from mpmath import det, matrix, mp, mpf
from support.transfer_matrices import bar, beam, first_roots


def answers(p):
    with mp.workdps(40):
        H, L, EI, EA, mu = (mpf(p[n]) for n in ("H", "L", "EI", "EA", "mu"))
        across, along = beam(H, EI, mu), bar(H, EA, mu)
        across_half, along_half = beam(L / 2, EI, mu), bar(L / 2, EA, mu)

        def middle(w, across_foot, along_foot):
            """The states of the middle of the girder by those of the foot."""
            (u, turn, M, V), (stretch, N) = across(w) * across_foot, along(w) * along_foot
            return across_half(w) * matrix([stretch, turn, M, N]), along_half(w) * matrix([-u, -V])

        def condition(of_u, of_w):
            def at(w):
                rows = []
                for i in range(3):
                    foot = matrix([0, 0, i == 0, i == 1]), matrix([0, i == 2])
                    u, stretch = middle(w, *foot)
                    rows.append([*(u[k] for k in of_u), stretch[of_w]])
                return det(matrix(rows))
            return at

        sway, upright = condition((0, 2), 1), condition((1, 3), 0)
        found = sorted(first_roots(sway, 3, mpf(7)) + first_roots(upright, 3, mpf(7)))
        return {f"omega[{i}]": w for i, w in enumerate(found[:5], 1)}
