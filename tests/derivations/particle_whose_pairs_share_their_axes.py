"""By symmetry about the horizontal the springs are equal; each axis then has an oscillator of its own."""
from math import cos, sin, sqrt


def answers(p):
    m, k, a = (p[n] for n in ("m", "k1", "a"))
    along, across = 2 * k * cos(a) ** 2, 2 * k * sin(a) ** 2
    ratios = {across: p["d"] / (2 * sqrt(m * across)), along: p["c"] / (2 * sqrt(m * along))}
    slow, fast = sorted(ratios)
    return {"k2": k, "stiffness[p].max": along, "stiffness[p].min": across, "stiffness[p].angle": 0.0,
            "damping[p].max": p["d"], "damping[p].xy": 0.0, "zeta[1]": ratios[slow], "zeta[2]": ratios[fast]}
