"""Mass centre and inertia of the sector by quadrature in polar coordinates. For small rocking the body
turns about its contact point: the moments of both weights about that point, taken at a small tilt with
the contact moved under the vertex, against the moment of inertia about it.
"""


def answers(p):
    from math import sin, sqrt

    import mpmath as mp

    R, alpha, g = p["R"], p["alpha"], p["g"]
    area = mp.quad(lambda s: mp.quad(lambda u: s, [-alpha, alpha]), [0, R])
    density = p["m"] / area

    def total(f):
        return float(density * mp.quad(lambda s: mp.quad(lambda u: f(s, u) * s, [-alpha, alpha]), [0, R]))

    below = total(lambda s, u: s * mp.cos(u)) / p["m"]
    inertia = total(lambda s, u: (s * mp.sin(u)) ** 2 + (R - s * mp.cos(u)) ** 2) + p["m0"] * R**2

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
