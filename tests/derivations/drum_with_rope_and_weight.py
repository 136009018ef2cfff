"""Each body is freed. The unknowns are x'', the friction F at the contact and the rope tensions S1 (drum
to pulley) and S2 (pulley to weight); Newton for drum and weight, Euler for drum and pulley make a linear
system. Its solution at two values of x gives the rest position, the frequency and, with a unit force at
the centre, the inertia 1/x''.
"""


def answers(p):
    from math import sqrt

    import numpy as np

    m1, m2, m3, R, r = p["m1"], p["m2"], p["m3"], p["R"], p["r"]
    ratio = (R + r) / R

    def acceleration(x, push, weight):
        """x'' at the displacement x under a horizontal force `push` at the drum's centre."""
        drum = [m1, -1, -1, 0]                          # m1 x'' = F + S1 + push - k x
        turning = [m1 * p["i"] ** 2 / R, R, -r, 0]      # clockwise: J x''/R = S1 r - F R
        pulley = [m2 * p["b"] ** 2 / 2 * ratio / p["b"], 0, p["b"], -p["b"]]
        load = [m3 * ratio, 0, 0, 1]                    # m3 ratio x'' = weight - S2
        right = [push - p["k"] * x, 0, 0, weight]
        return np.linalg.solve([drum, turning, pulley, load], right)[0]

    weight = m3 * p["g"]
    at_drawn, further = acceleration(0, 0, weight), acceleration(1, 0, weight)
    square = at_drawn - further

    def kinetic(q, v):
        omega = v["x"] / R
        drum = m1 * v["x"] ** 2 / 2 + m1 * p["i"] ** 2 * omega**2 / 2
        rope = omega * (R + r)
        return drum + m2 * rope**2 / 4 + m3 * rope**2 / 2

    return {
        "T": kinetic,
        "M[x,x]": 1 / acceleration(0, 1, 0),
        "equilibrium[x]": at_drawn / square,
        "omega[1]": sqrt(square),
    }
