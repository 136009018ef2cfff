"""Mass centre and inertia of the sector by quadrature in polar coordinates. For small rocking the body
turns about its contact point: the moments of both weights about that point, taken at a small tilt with
the contact moved under the vertex, against the moment of inertia about it.
"""


def answers(p):
    from math import cos, sin, sqrt

    from scipy.integrate import dblquad

    R, alpha, g = p["R"], p["alpha"], p["g"]
    area = dblquad(lambda u, s: s, 0, R, -alpha, alpha)[0]
    density = p["m"] / area

    def total(f):
        return density * dblquad(lambda u, s: f(s, u) * s, 0, R, -alpha, alpha)[0]

    below = total(lambda s, u: s * cos(u)) / p["m"]
    inertia = total(lambda s, u: (s * sin(u)) ** 2 + (R - s * cos(u)) ** 2) + p["m0"] * R**2

    def moment(phi):
        vertex, contact = -R * phi, -R * phi
        centre = vertex + below * sin(phi)
        return -g * (p["m"] * (centre - contact) + p["m0"] * (vertex - contact))

    step = 1e-5
    stiffness = -(moment(step) - moment(-step)) / (2 * step)
    return {
        "equation[phi]": lambda q, v, a: inertia * a["phi"] + stiffness * q["phi"],
        "omega[1]": sqrt(stiffness / inertia),
    }
