"""Each weight and the pulley are freed, with the rope tensions S1 and S2; the tension of the first
spring at rest follows from the balance of moments. The three equations are solved for the angular
acceleration at a given turn. V is the work of gravity and of both spring forces along the turn, by
quadrature.
"""


def answers(p):
    from math import sqrt

    import numpy as np

    J, m1, m2, R, r, g = (p[name] for name in ("J", "m1", "m2", "R", "r", "g"))
    tight = (m2 * g * r - m1 * g * R) / R

    def acceleration(phi):
        first, second = tight + p["k1"] * R * phi, -p["k2"] * r * phi
        # Unknowns phi'', S1, S2. First weight goes up, second goes down as phi grows.
        rows = [[m1 * R, -1, 0], [m2 * r, 0, 1], [J, R, -r]]
        right = [-m1 * g - first, m2 * g + second, 0]
        return np.linalg.solve(rows, right)[0]

    def potential(q):
        nodes, weights = np.polynomial.legendre.leggauss(4)
        turned = (nodes + 1) / 2 * q["phi"]
        moment = (tight + p["k1"] * R * turned + m1 * g) * R + (p["k2"] * r * turned - m2 * g) * r
        return float(np.sum(weights / 2 * moment) * q["phi"])

    rest = acceleration(0)
    square = rest - acceleration(1)
    return {
        "equilibrium[phi]": rest / square,
        "equation[phi]": lambda q, v, a: a["phi"] - acceleration(q["phi"]),
        "V": potential,
        "omega[1]": sqrt(square),
    }
