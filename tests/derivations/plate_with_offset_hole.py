"""Area, static moments and polar moment are integrated numerically: Gauss points over the rectangle,
Gauss rings with equally spaced angles over the hole. The plate hangs with its mass centre straight below
O; the frequency is that of a compound pendulum, g·OC·m/J_O, from those integrals.
"""


def answers(p):
    from math import atan2, hypot, pi, sqrt

    import numpy as np

    nodes, weights = np.polynomial.legendre.leggauss(6)
    x, y = np.meshgrid(nodes * p["a"] / 2, (nodes - 1) * p["b"] / 2)
    w = np.outer(weights, weights) * p["a"] * p["b"] / 4
    angle = np.arange(12) * 2 * pi / 12
    radius = (nodes + 1) * p["r"] / 2
    ring, turn = np.meshgrid(radius, angle, indexing="ij")
    hole = np.outer(weights * p["r"] / 2 * radius, np.full(12, 2 * pi / 12))
    xs = np.concatenate([x.ravel(), (p["d"] + ring * np.cos(turn)).ravel()])
    ys = np.concatenate([y.ravel(), (-p["c"] + ring * np.sin(turn)).ravel()])
    ms = p["rho"] * np.concatenate([w.ravel(), -hole.ravel()])
    mass = ms.sum()
    cx, cy = (ms * xs).sum() / mass, (ms * ys).sum() / mass
    J = (ms * (xs**2 + ys**2)).sum()
    return {
        "mass[plate]": mass,
        "centre[plate].x": cx,
        "centre[plate].y": cy,
        "J[plate, O]": J,
        "equilibrium[phi]": -pi / 2 - atan2(cy, cx),
        "omega[1]": sqrt(mass * p["g"] * hypot(cx, cy) / J),
    }
