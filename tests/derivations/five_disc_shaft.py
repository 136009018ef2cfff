"""Holzer's method: sweep the shaft with a trial frequency until the torque at its free end is zero.

Starting from a twist of 1 at the first disc, the inertia torques J omega^2 phi add up along the shaft and
each piece twists by torque over stiffness. The torque left after the flywheel, divided by omega^2, is a
polynomial in omega^2, whose roots are found by polynomial arithmetic; the twist of the flywheel is read
off the sweep.
"""
from math import sqrt

import numpy as np
from numpy.polynomial import Polynomial


def answers(p):
    lam = Polynomial([0.0, 1.0]) * (p["kt"] / p["J"])
    twist, angular = Polynomial([1.0]), Polynomial([0.0])
    discs = [p["J"]] * 4 + [p["Jf"]]
    shafts = [p["kt"]] * 3 + [p["kf"]]
    for n, J in enumerate(discs):
        angular = angular + J * twist
        if n < 4:
            last = twist = twist - lam * angular / shafts[n]
    roots = np.sort(angular.roots().real)
    out = {"omega[1]": 0.0}
    for n, value in enumerate(roots, 2):
        out[f"omega[{n}]"] = sqrt(value * p["kt"] / p["J"])
    out["mode[2][phi5]"] = float(last(roots[0]))
    return out
