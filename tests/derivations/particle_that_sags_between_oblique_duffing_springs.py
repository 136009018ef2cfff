"""The place of rest from the forces along the springs, the energies differenced there with 60 digits."""
from math import factorial

from mpmath import diff, findroot, hypot, mp, mpf

ORDERS = {"x^2": (2, 0), "x*y": (1, 1), "y^2": (0, 2), "x^3": (3, 0), "x^2*y": (2, 1), "x*y^2": (1, 2), "y^3": (0, 3),
          "x^4": (4, 0), "x^2*y^2": (2, 2), "y^4": (0, 4)}


def answers(p):
    with mp.workdps(60):
        m, k, g3, g = (mpf(p[name]) for name in ("m", "k", "g3", "g"))
        springs = [(k, mpf("-0.5"), mpf("0.4")), (k, mpf("0.6"), mpf("0.3")), (2 * k, mpf("0.1"), mpf("-0.7"))]

        def forces(x, y):
            total = [mpf(0), -m * g]
            for stiffness, X, Y in springs:
                length = hypot(X - x, Y - y)
                d = length - hypot(X, Y)
                pull = (stiffness * d + g3 * d**3) / length
                total = [total[0] + pull * (X - x), total[1] + pull * (Y - y)]
            return total

        def V(x, y):
            stretches = [(stiffness, hypot(X - x, Y - y) - hypot(X, Y)) for stiffness, X, Y in springs]
            return sum(stiffness * d**2 / 2 + g3 * d**4 / 4 for stiffness, d in stretches) + m * g * y

        place = tuple(findroot(forces, (mpf(0), mpf("-0.03"))))
        found = {f"V[{name}]": float(diff(V, place, orders)) / (factorial(orders[0]) * factorial(orders[1]))
                 for name, orders in ORDERS.items()}
        return {"V[x]": 0.0, "V[y]": 0.0} | found
