"""Everything referred to the motor's shaft; the free-free train of three discs solved by its quadratic.

With n = r1/r2 the wheel adds n^2 Jg to the pinion and the load counts as n^2 J2 behind n^2 kt2. For three
discs on two shafts the non-zero squared frequencies obey lam^2 - (k1(1/J1 + 1/J) + k2(1/J + 1/J2)) lam +
k1 k2 (J1 + J + J2)/(J1 J J2) = 0. The contact speeds are equal: the wheel turns backwards, and at zero
frequency so does the load.
"""
from math import sqrt


def answers(p):
    n = p["r1"] / p["r2"]
    J1, J, J2 = p["J1"], p["Jp"] + n * n * p["Jg"], n * n * p["J2"]
    k1, k2 = p["kt1"], n * n * p["kt2"]
    half = (k1 * (1 / J1 + 1 / J) + k2 * (1 / J + 1 / J2)) / 2
    root = sqrt(half**2 - k1 * k2 * (J1 + J + J2) / (J1 * J * J2))
    fast = half + root
    return {
        "M[phi2,phi2]": J,
        "K[phi2,phi2]": k1 + k2,
        "K[phi2,phi3]": p["kt2"] * n,
        "omega[1]": 0.0,
        "omega[2]": sqrt((half**2 - root**2) / fast),
        "omega[3]": sqrt(fast),
        "mode[1][phi2]": 1.0,
        "mode[1][phi3]": -n,
    }
