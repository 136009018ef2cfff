"""By symmetry half of it: a column that carries half of the girder, which is pinned at its middle (sway) or guided.

The column's head, displaced by u and turned by t, feels the half girder's mass and its moment; transfer matrices.
"""
from mpmath import det, matrix, mp, mpf
from support.transfer_matrices import beam, first_roots


def answers(p):
    with mp.workdps(60):
        H, L, EI, mu = (mpf(p[n]) for n in ("H", "L", "EI", "mu"))
        column, half = beam(H, EI, mu), beam(L / 2, EI, mu)

        def turning(w, held):
            """(a, b): the moment on the end of the half girder is a/b times its turn; that end does not move across."""
            T = half(w)
            rows = (0, 2) if held == "pinned" else (1, 3)
            A = matrix([[T[i, j] for j in (2, 3)] for i in rows])
            return T[rows[0], 1] * A[1, 1] - T[rows[1], 1] * A[0, 1], det(A)

        def sway(w):
            T, (a, b) = column(w), turning(w, "pinned")
            rows = [[T[3, j] - mu * L / 2 * w**2 * T[0, j] for j in (2, 3)],
                    [b * T[2, j] + a * T[1, j] for j in (2, 3)]]
            return det(matrix(rows))

        def upright(w):
            T, (a, b) = column(w), turning(w, "guided")
            rows = [[T[0, j] for j in (2, 3)], [b * T[2, j] + a * T[1, j] for j in (2, 3)]]
            return det(matrix(rows))

        found = sorted(first_roots(sway, 3, mpf("0.7")) + first_roots(upright, 3, mpf("0.7")))
        return {f"omega[{i}]": w for i, w in enumerate(found[:3], 1)}
