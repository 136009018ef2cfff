"""Beam by beam from the right: moments about the hinge H give the roller, sums of forces the hinge; then moments about
G of the second beam give the pier; what is left hangs on the clamped beam."""
from math import cos, sin


def answers(p):
    a, b, c, d, s, u, g = (p[n] for n in ("a", "b", "c", "d", "s", "u", "g"))
    weights = [p["mu"] * g * length for length in (a, c - a, d - c)]
    pull = p["F"] * cos(p["beta"]), p["F"] * sin(p["beta"])
    roller = (weights[2] * (d - c) / 2 - pull[1] * (u - c)) / (cos(p["alpha"]) * (d - c))
    Hx = -pull[0] + roller * sin(p["alpha"])            # what the second beam exerts on the third
    Hy = weights[2] - pull[1] - roller * cos(p["alpha"])
    crane = p["M"] * g
    pier = (weights[1] * (c - a) / 2 + crane * (s - a) + Hy * (c - a)) / (b - a)
    Gx, Gy = Hx, weights[1] + crane + Hy - pier
    moment = weights[0] * a / 2 + Gy * a
    return {"equilibrium[roller.force]": roller, "equilibrium[third.reaction.x]": Hx,
            "equilibrium[third.reaction.y]": Hy, "equilibrium[pier.force]": pier, "equilibrium[G.reaction.x]": Gx,
            "equilibrium[G.reaction.y]": Gy, "equilibrium[A.reaction.x]": Gx,
            "equilibrium[A.reaction.y]": Gy + weights[0], "equilibrium[A.reaction.moment]": moment}
