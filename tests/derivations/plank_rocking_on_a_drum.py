"""Places of the plank from the arc that it has rolled over, energies from them; the motion by d'Alembert.

The contact lies at the angle theta on the drum, and the plank's middle s = R theta back along the plank and h above it.
Rates are numerical differences of the place. With I = J + m(h^2 + R^2 theta^2) about the contact, energy gives the
rate, the moment of the weight about the moving contact the acceleration, Newton's law of the mass centre the forces.
"""
from math import cos, sin, sqrt


def answers(p):
    m, g, b, h, R = (p[n] for n in ("m", "g", "b", "h", "R"))
    J = m * (4 * b**2 + 4 * h**2) / 12

    def place(theta):
        n, along = (-sin(theta), cos(theta)), (cos(theta), sin(theta))
        return tuple((R + h) * u + R * theta * w for u, w in zip(n, along, strict=True))

    def slope(theta, d=1e-4):
        far, near = ([(a - c) / (2 * e) for a, c in zip(place(theta + e), place(theta - e), strict=True)]
                     for e in (2 * d, d))
        return [(4 * y - x) / 3 for x, y in zip(far, near, strict=True)]

    def inertia(theta):
        return J + m * sum(x**2 for x in slope(theta))

    def height(theta):
        return place(theta)[1] - (R + h)

    # the mass centre lies at C + (h n + R theta e): c' = theta' (R theta n - h e), the contact being at rest
    start = 0.3
    lever = R * start * cos(start) - h * sin(start)     # of the weight about the contact
    forward = -m * g * lever / (J + m * (h**2 + (R * start) ** 2))
    # c'' = theta'' (R theta n - h e) + theta'^2 (R n + ...): at the start theta' is 0
    n, e = (-sin(start), cos(start)), (cos(start), sin(start))
    pull = [m * forward * (R * start * u - h * w) for u, w in zip(n, e, strict=True)]
    pull[1] += m * g
    fall = sqrt(2 * m * g * height(start) / (J + m * h**2))
    return {
        "T": lambda q, v: inertia(q["theta"]) * v["theta"] ** 2 / 2,
        "V": lambda q: m * g * height(q["theta"]),
        "omega[1]": sqrt(m * g * (R - h) / (J + m * h**2)),
        "max(theta')": fall,
        "max(plank.normal)": m * g + m * (R - h) * fall**2,
        "plank.normal(0s)": pull[0] * n[0] + pull[1] * n[1],
        "plank.friction(0s)": pull[0] * e[0] + pull[1] * e[1],
    }
