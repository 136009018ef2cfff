"""The rope carries M g on both sides of the pulley, whose forces the axle B hands to the jib. Moments of the jib about
A give the tie, sums of forces the hinge; the mast carries hinge, tie and winch. The rope leaves the pulley towards P
along the tangent that touches both the rim and P, by its angle."""
from math import asin, atan2, cos, hypot, sin

import numpy as np


def answers(p):
    h, a, b, H, r, m, M, g = (p[n] for n in ("h", "a", "b", "H", "r", "m", "M", "g"))
    A, B, T, P = (np.array(place) for place in ((0, h), (a, h + b), (0, H), (r, p["p"])))
    way = P - B
    angle = atan2(way[1], way[0]) + asin(r / hypot(*way))       # of the tangent over the top
    rope = M * g
    direction = np.array([cos(angle), sin(angle)])
    axle = rope * direction + np.array([0, -rope])              # on the jib
    tie = (T - B) / hypot(*(T - B))

    def moment(at, force, about):
        x, y = np.array(at) - about
        return x * force[1] - y * force[0]

    middle, weight = (A + B) / 2, np.array([0, -m * g])
    tension = -(moment(B, axle, A) + moment(middle, weight, A)) / moment(B, tie, A)
    hinge = -(tension * tie + axle + weight)
    foot = hinge + tension * tie + rope * direction             # against what acts on the mast
    origin = np.zeros(2)
    clamp = moment(A, hinge, origin) + moment(T, tension * tie, origin) + moment(P, rope * direction, origin)
    touched = B + r * np.array([sin(angle), -cos(angle)])
    assert abs(moment(touched, direction, P)) < 1e-9 and touched[1] > B[1]
    return {"equilibrium[tie.force]": tension, "equilibrium[rope.force.1]": rope, "equilibrium[A.reaction.x]": hinge[0],
            "equilibrium[A.reaction.y]": hinge[1], "equilibrium[pulley.reaction.x]": -axle[0],
            "equilibrium[pulley.reaction.y]": -axle[1], "equilibrium[O.reaction.x]": foot[0],
            "equilibrium[O.reaction.y]": foot[1], "equilibrium[O.reaction.moment]": clamp}
