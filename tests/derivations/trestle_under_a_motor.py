"""By symmetry one strut with half of the motor: its head goes up and down without turning, or to and fro and turns.

A head that moves by (x, y) and turns by t bends the left strut by u = -x s + y c and lengthens it by w = x c + y s, c
and s being the cosine and sine of its slope; the forces on the head do the same work.
"""
from mpmath import det, matrix, mp, mpf, sqrt
from support.transfer_matrices import bar, beam, first_roots


def answers(p):
    with mp.workdps(40):
        a, h, EI, EA, mu, M = (mpf(p[n]) for n in ("a", "h", "EI", "EA", "mu", "M"))
        length = sqrt(a * a / 4 + h * h)
        c, s = a / 2 / length, h / length
        across, along = beam(length, EI, mu), bar(length, EA, mu)

        def head(w):
            """Of a unit moment, shear force and tension at the foot: (x, y, turn) and the forces on the head."""
            A, B = across(w), along(w)
            for foot in (matrix([0, 0, 1, 0]), matrix([0, 0, 0, 1])):
                u, turn, moment, shear = A * foot
                yield (-u * s, u * c, turn), (-shear * s, shear * c, moment)
            stretch, tension = B * matrix([0, 1])
            yield (stretch * c, stretch * s, 0), (tension * c, tension * s, 0)

        def upright(w):
            return det(matrix([[x, turn, Y - w**2 * M / 2 * y] for (x, y, turn), (_, Y, _) in head(w)]))

        def sway(w):
            return det(matrix([[y, X - w**2 * M / 2 * x, T] for (x, y, _), (X, _, T) in head(w)]))

        found = sorted(first_roots(sway, 3, mpf(11)) + first_roots(upright, 3, mpf(11)))
        return {f"omega[{i}]": w for i, w in enumerate(found[:4], 1)}
