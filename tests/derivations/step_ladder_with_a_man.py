"""Moments of the whole about the left foot, of the right leg alone about the hinge; forces of the whole."""


def answers(p):
    m1, m2, M, h, b, e, g = (p[n] for n in ("m1", "m2", "M", "h", "b", "e", "g"))
    foot = g * (m1 * b / 2 + M * 3 * b / 4 + m2 * 3 * b / 2) / (2 * b)
    return {
        "equilibrium[foot.force]": foot,
        "equilibrium[tie.force]": (foot * b - m2 * g * b / 2) / (h - e),
        "equilibrium[left.reaction.y]": (m1 + m2 + M) * g - foot,
        "equilibrium[left.reaction.x]": 0,
    }
