"""The lag u = shaft - pointer by its balance J u'' + c u' + k u = c w (or c q t + J q), from rest to two instants at
which the free motion is gone, by the exponential of the matrix that also holds the constant and the time; the pointer
at the time tau is that of the line through them."""
from math import sqrt

import numpy as np
from scipy.linalg import expm


def late(p, still, growing):
    """[(t, u)] at two late instants of J u'' + c u' + k u = still + growing·t, integrated in units of 1/sqrt(k/J)."""
    J, k, c = (p[n] for n in ("J", "k", "c"))
    w0 = sqrt(k / J)
    zeta = c / (2 * J * w0)
    slowest = zeta if zeta < 1 else zeta - sqrt(zeta**2 - 1)
    A = np.array([[0, 1, 0, 0], [-1, -2 * zeta, still / k, growing / (k * w0)], [0, 0, 0, 0], [0, 0, 1, 0]])
    return [(s / w0, (expm(A * s) @ [0, 0, 1, 0])[0]) for s in (40 / slowest, 44 / slowest)]


def answers(p):
    J, k, c, w, q, tau, delta = (p[n] for n in ("J", "k", "c", "w", "q", "tau", "delta"))
    (_, lag), _ = late(p, c * w, 0.0)
    (one, first), (two, second) = late(p, J * q, c * q)
    rate = (second - first) / (two - one)
    return {
        "final(shaft.angle - phi)": lag,
        "final(hair.force)": -k * lag,
        "final(phi')": w,
        "steady(phi)(tau)": w * tau - lag,
        "steady(phi)(0)": -lag,
        "speeding up: steady(shaft.angle - phi)(tau)": first + rate * (tau - one),
        "speeding up: final(shaft.angle' - phi')": rate,
        "speeding up: final(hair.force')": -k * rate,
        "largest damping: c": c * delta / lag,
    }
