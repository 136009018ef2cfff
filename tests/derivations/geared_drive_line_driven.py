"""Holzer's method: the twist passed from disc to disc, with the wheel and the propeller referred to the pinion's
speed (the turn of the propeller reversed). Residual torque zero gives the frequencies; ratios to it the forced
amplitudes.
"""
from math import pi

from scipy.optimize import brentq


def answers(p):
    J1, Jp, Jg, J3, n, k1, k2, M0, Omega = (p[x] for x in ("J1", "Jp", "Jg", "J3", "n", "k1", "k2", "M0", "Omega"))
    middle, last, soft = Jp + Jg / n**2, J3 / n**2, k2 / n**2       # propeller's turn -theta3 n

    def holzer(W):
        """From a unit turn of the propeller (referred): turns 3, 2, 1, torques of shafts 2, 1, torque needed at 1."""
        t3 = 1.0
        shaft2 = -W**2 * last * t3
        t2 = t3 + shaft2 / soft
        shaft1 = shaft2 - W**2 * middle * t2
        t1 = t2 + shaft1 / k1
        return t3, t2, t1, shaft2, shaft1, shaft1 - W**2 * J1 * t1

    def roots(function, top=400.0, steps=4000):
        grid = [top * (i + 0.5) / steps for i in range(steps)]
        values = [function(W) for W in grid]
        return [brentq(function, grid[i], grid[i + 1], xtol=1e-13) for i in range(steps - 1)
                if values[i] * values[i + 1] < 0]

    second, third = roots(lambda W: holzer(W)[5])
    t3, t2, t1, shaft2, shaft1, needed = (value for value in holzer(Omega))
    still = roots(lambda W: holzer(W)[2])
    pinion, = roots(lambda W: holzer(W)[1])
    slow = holzer(40 * pi)
    return {
        "M[theta2,theta2]": middle,
        "K[theta2,theta3]": k2 / n,
        "omega[1]": 0.0,
        "omega[2]": second,
        "omega[3]": third,
        "amplitude(theta1)": M0 * abs(t1 / needed),
        "amplitude(theta2)": M0 * abs(t2 / needed),
        "amplitude(theta3)": M0 * abs(t3 / needed) / n,
        "phase(theta1)": 0.0 if t1 / needed > 0 else pi,
        "amplitude(s1.force)": M0 * abs(shaft1 / needed),
        "amplitude(s2.force)": M0 * abs(shaft2 / needed) * n,
        "abs(frf[theta3, torque](20 Hz))": abs(slow[0] / slow[5]) / n,
        "antiresonance[1](frf[theta1, torque])": still[0],
        "antiresonance[2](frf[theta1, torque])": still[1],
        "antiresonance[1](frf[theta2, torque])": pinion,
    }
