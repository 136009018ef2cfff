"""The rod is freed at the pin: the pin force (H, V) follows from the acceleration of its mass centre.
The moment of that force about the mass centre is the rod's residual, its reaction on the cart the
cart's. T is summed over the rod's elements; small oscillations keep the first order of the residuals,
and the matrix entries are differences of those.
"""


def answers(p):
    from math import cos, sin

    import numpy as np

    M, m, L, g = p["M"], p["m"], p["L"], p["g"]

    def residuals(q, v, a):
        s, c = sin(q["phi"]), cos(q["phi"])
        ax = a["x"] + L / 2 * (c * a["phi"] - s * v["phi"] ** 2)
        ay = L / 2 * (s * a["phi"] + c * v["phi"] ** 2)
        pin_x, pin_y = m * ax, m * ay + m * g
        cart = M * a["x"] + p["k"] * q["x"] + p["c"] * v["x"] + pin_x
        # The pin lies at (-L/2 sin, +L/2 cos) from the mass centre.
        rod = m * L**2 / 12 * a["phi"] - (-L / 2 * s * pin_y - L / 2 * c * pin_x)
        return cart, rod

    def kinetic(q, v):
        nodes, weights = np.polynomial.legendre.leggauss(4)
        s = (nodes + 1) / 2 * L
        vx = v["x"] + s * cos(q["phi"]) * v["phi"]
        vy = s * sin(q["phi"]) * v["phi"]
        return M * v["x"] ** 2 / 2 + float(np.sum(weights / 2 * m / 2 * (vx**2 + vy**2)))

    rest = {"x": 0.0, "phi": 0.0}
    step = 1e-6
    tilted = ({"x": 0.0, "phi": s * step} for s in (1, -1))
    up, down = (residuals(q, rest, rest)[1] for q in tilted)
    return {
        "T": kinetic,
        "V": lambda q: p["k"] * q["x"] ** 2 / 2 + m * g * L / 2 * (1 - cos(q["phi"])),
        "motion[x]": lambda q, v, a: residuals(q, v, a)[0],
        "motion[phi]": lambda q, v, a: residuals(q, v, a)[1],
        "equation[x]": lambda q, v, a: M * a["x"] + p["k"] * q["x"] + p["c"] * v["x"]
                                       + m * (a["x"] + L / 2 * a["phi"]),
        "M[x,phi]": residuals(rest, rest, {"x": 0.0, "phi": 1.0})[0],
        "C[x,x]": residuals(rest, {"x": 1.0, "phi": 0.0}, rest)[0],
        "K[phi,phi]": (up - down) / (2 * step),
    }
