"""Complex stiffness of the tower from the ground upwards (a continued fraction): each storey in series with what is
below it, each girder's inertia in parallel. Frequencies from the same without dampers; peaks and half power by
root finding.
"""
from cmath import phase
from math import pi, sqrt

import numpy as np
from scipy.optimize import brentq


def answers(p):
    m, mr, k1, k2, k3, c1, c2 = (p[n] for n in ("m", "mr", "k1", "k2", "k3", "c1", "c2"))
    masses = [m] * 5 + [mr]
    stiffness, damping = [k1, k2, k2, k3, k3, k3], [c1] * 3 + [c2] * 3

    def climb(W, loss=1):
        """Dynamic stiffness under the roof's force, and the share of the roof's motion that each girder has."""
        below, passed = None, []
        for mass, k, c in zip(masses, stiffness, damping, strict=True):
            storey = complex(k, c * W * loss)
            support = storey if below is None else storey * below / (storey + below)
            if below is not None:
                passed.append(storey / (storey + below))        # lower girder by upper one
            below = support - mass * W * W
        shares = [1.0]
        for ratio in reversed(passed):
            shares.insert(0, shares[0] * ratio)
        return below, shares

    def roof(W):
        return 1 / climb(W)[0]

    def first(W):
        below, shares = climb(W)
        return shares[0] / below

    K = np.zeros((6, 6))
    for i, k in enumerate(stiffness):
        K[i, i] += k
        if i:
            K[i - 1, i - 1] += k
            K[i - 1, i] -= k
            K[i, i - 1] -= k
    scale = np.array(masses) ** -0.5
    omegas = np.sqrt(np.linalg.eigvalsh(scale[:, None] * K * scale))
    assert all(abs(1 / climb(w * (1 + 1e-9), 0)[0]) > 1e3 * abs(1 / climb(w * 1.01, 0)[0]) for w in omegas)

    def top(w):
        h = 1e-4 * w

        def slope(W):
            return np.dot([1, -8, 8, -1], [abs(roof(W + i * h)) for i in (-2, -1, 1, 2)])
        return brentq(slope, 0.96 * w, 1.04 * w, xtol=1e-13)

    one, two = top(omegas[0]), top(omegas[1])
    level = abs(roof(one)) / sqrt(2)
    half = [brentq(lambda W: abs(roof(W)) - level, *ends, xtol=1e-13) for ends in ((0.8 * one, one), (one, 1.2 * one))]
    W = 4 * pi
    return {
        "omega[1]": omegas[0],
        "omega[2]": omegas[1],
        "omega[6]": omegas[5],
        "abs(frf[x6, shaker](1 Hz))": abs(roof(2 * pi)),
        "phase(frf[x6, shaker](1 Hz))": -phase(roof(2 * pi)),
        "abs(frf[x6, shaker](5 Hz))": abs(roof(10 * pi)),
        "re(frf[x1, shaker](5 Hz))": first(10 * pi).real,
        "im(frf[x1, shaker](5 Hz))": first(10 * pi).imag,
        "peak[1](frf[x6, shaker]).Omega": one,
        "peak[1](frf[x6, shaker]).value": abs(roof(one)),
        "peak[2](frf[x6, shaker]).Omega": two,
        "peak[2](frf[x6, shaker]).value": abs(roof(two)),
        "half_power[1](frf[x6, shaker])": half[0],
        "half_power[2](frf[x6, shaker])": half[1],
        "transmissibility[ground.force, shaker](2 Hz)": abs(complex(k1, c1 * W) * first(W)),
    }
