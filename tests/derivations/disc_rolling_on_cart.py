"""Momentum of the free pair, and the friction force eliminated by hand.

Disc: m(x'' + s'') = F - k2 s; rolling gives m R^2/2 (s''/R) = -F R, so F = -m s''/2. No force acts from
outside, so mc x' + m(x' + s') = 0 when the common centre rests. What is left is one oscillator with the
inertia m(x'' + s'')/s'' + m/2 on k2.
"""
from math import sqrt


def answers(p):
    mc, m, R, k2 = p["mc"], p["m"], p["R"], p["k2"]
    share = -m / (mc + m)
    inertia = m * (share + 1) + m / 2

    def T(q, v):
        turning = m * R**2 / 2 * (v["s"] / R) ** 2
        return (mc * v["x"] ** 2 + m * (v["x"] + v["s"]) ** 2 + turning) / 2

    return {
        "T": T,
        "omega[1]": 0.0,
        "omega[2]": sqrt(k2 / inertia),
        "mode[1][s]": 0.0,
        "mode[2][s]": 1 / share,
    }
