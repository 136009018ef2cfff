"""Newton: the bowl pushes the bead with the force P across its slope u/p and is pushed back by it.

P follows from the upward motion of the bead. Small motions: a pendulum of the length p on a cart, whose frequencies
solve (k - (M + m) w) (g/p - w) = m w^2 for w = omega^2.
"""
from math import sqrt


def answers(p):
    M, m, k, radius, g = (p[n] for n in ("M", "m", "k", "p", "g"))

    def upward(q, v, a):
        """m y'' + m g for y = u^2/(2p): the upright part of P; the level one is -u/p of it."""
        return m * (v["u"] ** 2 + q["u"] * a["u"]) / radius + m * g

    def cart(q, v, a):
        return M * a["x"] + k * q["x"] - upward(q, v, a) * q["u"] / radius

    def bead(q, v, a):
        return m * (a["x"] + a["u"]) + upward(q, v, a) * q["u"] / radius

    def kinetic(q, v):
        return M * v["x"] ** 2 / 2 + m * ((v["x"] + v["u"]) ** 2 + (q["u"] / radius * v["u"]) ** 2) / 2

    rest, step = {"x": 0.0, "u": 0.0}, 1e-6
    ends = [bead({"x": 0.0, "u": e}, rest, rest) for e in (step, -step)]
    swing = g / radius
    b = k + (M + m) * swing
    root = sqrt(b * b - 4 * M * k * swing)
    return {
        "T": kinetic,
        "V": lambda q: k * q["x"] ** 2 / 2 + m * g * q["u"] ** 2 / (2 * radius),
        "motion[x]": lambda q, v, a: cart(q, v, a) + bead(q, v, a),
        "motion[u]": bead,
        "M[x,u]": cart(rest, rest, {"x": 0.0, "u": 1.0}) + bead(rest, rest, {"x": 0.0, "u": 1.0}),
        "K[u,u]": (ends[0] - ends[1]) / (2 * step),
        "omega[1]": sqrt(2 * k * swing / (b + root)),
        "omega[2]": sqrt((b + root) / (2 * M)),
    }
