"""Newton along the rod: a bead at the place x + i e of the turning rod has the acceleration x'' - Omega^2 x along it.

Rest: the pulls of the springs give that acceleration to each bead, two linear equations solved by elimination.
Frequencies: the same with the forces of small displacements, omega^2 from the quadratic equation of the determinant.
"""
from math import sqrt


def answers(p):
    m1, m2, k1, k2, a, e, Omega = (p[n] for n in ("m1", "m2", "k1", "k2", "a", "e", "Omega"))

    def along(x, x1, x2):
        """The acceleration along the rod of a place x + i e in the turning plane."""
        return (x2 + 2j * Omega * x1 - Omega**2 * (x + 1j * e)).real

    def inner(q, v, acc):
        tension = k1 * q["s1"], k2 * (q["s2"] - q["s1"])
        return m1 * along(a + q["s1"], v["s1"], acc["s1"]) - tension[1] + tension[0]

    def outer(q, v, acc):
        return m2 * along(2 * a + q["s2"], v["s2"], acc["s2"]) + k2 * (q["s2"] - q["s1"])

    w1, w2 = m1 * Omega**2, m2 * Omega**2
    A, B, D = k1 + k2 - w1, -k2, k2 - w2
    det = A * D - B * B
    b, c = m1 * D + m2 * A, det
    root = sqrt(b * b - 4 * m1 * m2 * c)
    squares = (b - root) / (2 * m1 * m2), (b + root) / (2 * m1 * m2)
    return {
        "motion[s1]": inner,
        "motion[s2]": outer,
        "equilibrium[s1]": (w1 * a * D - B * w2 * 2 * a) / det,
        "equilibrium[s2]": (A * w2 * 2 * a - B * w1 * a) / det,
        "K[s1,s1]": A,
        "K[s2,s2]": D,
        "omega[1]": sqrt(squares[0]),
        "omega[2]": sqrt(squares[1]),
        "mode[1][s2]": (A - m1 * squares[0]) / k2,
    }
