"""A quarter of a turn behind, spring and inertia balance each other, and the dashpot takes in a turn what the unbalance
gives: c Ω² X² / 2 = u Ω² X Ω / 2; the force on the ground is that of spring and dashpot, square to each other."""
from math import hypot, pi, sqrt


def answers(p):
    m, u, n, X = (p[name] for name in ("m", "u", "n", "X1"))
    k = m * n**2
    given = pi * u * n**2 * X               # work of the unbalance in a turn
    c = given / (pi * n * X**2)
    return {
        "k": k,
        "c": c,
        "zeta[1]": c / (2 * sqrt(k * m)),
        "amplitude(ground.force.y)": hypot(k * X, c * n * X),
    }
