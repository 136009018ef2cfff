"""Free bodies: the rope's tensions on both sides of each pulley are eliminated one after the other by hand, which
leaves two equations for the rise of the movable pulley and of the load.
"""
from math import sqrt


def answers(p):
    # weight down 2y, its spring adds 2 k2 y to what the rope lacks; fixed pulley turns 2y/R: J = Mf R²/2
    inertia = 4 * p["m2"] + 4 * p["Mf"] / 2 + 1.5 * p["mp"]
    stiff, k1, m1 = p["k1"] + 4 * p["k2"], p["k1"], p["m1"]
    # (stiff − λ inertia)(k1 − λ m1) = k1²
    middle = (stiff * m1 + k1 * inertia) / (2 * inertia * m1)
    root = sqrt(middle**2 - (stiff - k1) * k1 / (inertia * m1))
    squares = middle - root, middle + root
    rope = (p["m1"] + p["mp"]) * p["g"] / 2
    return {
        "equilibrium[s1.force]": m1 * p["g"],
        "equilibrium[rope.force.1]": rope,
        "equilibrium[rope.force.3]": rope,
        "equilibrium[s2.force]": rope - p["m2"] * p["g"],
        "equilibrium[top.reaction.y]": 2 * rope + p["Mf"] * p["g"],
        "omega[1]": sqrt(squares[0]),
        "omega[2]": sqrt(squares[1]),
        "mode[1][z]": k1 / (k1 - squares[0] * m1),
        "mode[2][z]": k1 / (k1 - squares[1] * m1),
        "mode[1][w]": -2.0,
    }
