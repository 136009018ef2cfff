"""Newton in polar coordinates for the bead, with a_r = r'' - r phi'² and a_phi = r phi'' + 2 r' phi';
the smooth rod pushes it only across, with a force that returns on the rod in its moment equation about
O. At rest the spring carries the weight along the rod; the small motions there are uncoupled, a
spring-mass and a compound pendulum, each by its own Euler or Newton equation.
"""


def answers(p):
    from math import cos, sin, sqrt

    M, L, m, k, g = p["M"], p["L"], p["m"], p["k"], p["g"]

    def along(q, v, a):
        radius = p["a"] + q["s"]
        pull = k * (radius - p["a"])
        return m * (a["s"] - radius * v["phi"] ** 2) - (m * g * cos(q["phi"]) - pull)

    def turning(q, v, a):
        radius = p["a"] + q["s"]
        push = m * (radius * a["phi"] + 2 * v["s"] * v["phi"]) + m * g * sin(q["phi"])
        weight = -M * g * L / 2 * sin(q["phi"])
        return M * L**2 / 3 * a["phi"] - weight + push * radius

    def kinetic(q, v):
        radius = p["a"] + q["s"]
        vx = v["s"] * sin(q["phi"]) + radius * cos(q["phi"]) * v["phi"]
        vy = -v["s"] * cos(q["phi"]) + radius * sin(q["phi"]) * v["phi"]
        centre = L / 2 * v["phi"]
        return M * centre**2 / 2 + M * L**2 / 24 * v["phi"] ** 2 + m * (vx**2 + vy**2) / 2

    rest = {"s": 0.0, "phi": 0.0}
    sag = -along(rest, rest, rest) / k
    hung = {"s": sag, "phi": 0.0}
    inertia = turning(hung, rest, {"s": 0.0, "phi": 1.0})
    step = 1e-6
    ahead = turning(hung | {"phi": step}, rest, rest)
    squares = sorted((k / m, ahead / step / inertia))
    return {
        "T": kinetic,
        "motion[s]": along,
        "motion[phi]": turning,
        "equilibrium[s]": sag,
        "equilibrium[phi]": 0.0,
        "equation[s]": lambda q, v, a: m * a["s"] + k * q["s"],
        "omega[1]": sqrt(squares[0]),
        "omega[2]": sqrt(squares[1]),
    }
