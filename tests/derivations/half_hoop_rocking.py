"""The half hoop is a set of particles on its arc, summed with Gauss points. Rolling moves the arc's
centre by -r·phi while the particles turn about it. Newton for the mass centre gives the contact force,
Euler about the mass centre is the residual of the motion; the frequency follows from the slope of that
residual.
"""


def answers(p):
    from math import cos, pi, sin, sqrt

    import numpy as np

    m, r, g = p["m"], p["r"], p["g"]
    nodes, weights = np.polynomial.legendre.leggauss(24)
    u, w = nodes * pi / 2, weights / 2 * m
    depth = float(np.sum(w * r * np.cos(u)) / m)
    J = float(np.sum(w * ((r * np.sin(u)) ** 2 + (depth - r * np.cos(u)) ** 2)))

    def residual(q, v, a):
        s, c = sin(q["phi"]), cos(q["phi"])
        ax = -r * a["phi"] + depth * (c * a["phi"] - s * v["phi"] ** 2)
        ay = depth * (s * a["phi"] + c * v["phi"] ** 2)
        friction, normal = m * ax, m * (ay + g)
        # From the mass centre the contact lies at (-depth sin, depth cos - r).
        return J * a["phi"] - (-depth * s * normal - (depth * c - r) * friction)

    def kinetic(q, v):
        turned = u + q["phi"]
        vx = v["phi"] * (-r + r * np.cos(turned))
        vy = v["phi"] * r * np.sin(turned)
        return float(np.sum(w / 2 * (vx**2 + vy**2)))

    rest, step = {"phi": 0.0}, 1e-5
    slope = (residual({"phi": step}, rest, rest) - residual({"phi": -step}, rest, rest)) / (2 * step)
    return {
        "centre[hoop].y": r - depth,
        "J[hoop]": J,
        "T": kinetic,
        "V": lambda q: float(np.sum(w * g * (r - r * np.cos(u + q["phi"])))),
        "motion[phi]": residual,
        "omega[1]": sqrt(slope / residual(rest, rest, {"phi": 1.0})),
    }
