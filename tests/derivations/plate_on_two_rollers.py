"""Free bodies: the forces of contact from Newton's law of the plate and of each roller, linear equations all.

Unknown: the acceleration A of the plate, and of each roller the friction T and pressure N of the plate on it, F and P
of the floor; its centre is accelerated by A/2 and spins by A/(2 r) clockwise. At the start the rollers lie x0/2 behind
their places below the plate, which leads.
"""
import numpy as np


def answers(p):
    M, m, r, h, a, b, k, x0, g = (p[n] for n in ("M", "m", "r", "h", "a", "b", "k", "x0", "g"))
    start, rows, right = k * x0, [], []

    def law(value, **factors):
        rows.append([factors.get(n, 0.0) for n in ("A", "T1", "N1", "F1", "P1", "T2", "N2", "F2", "P2")])
        right.append(value)

    arms = {"1": -a - x0 / 2, "2": b - x0 / 2}      # from the middle of the plate
    law(-start, A=M, T1=1, T2=1)                    # M A = -k x0 - T1 - T2, T along +x on the roller
    law(M * g, N1=1, N2=1)
    law(0.0, N1=arms["1"], N2=arms["2"], T1=-h / 2, T2=-h / 2)     # -T at h/2 below the middle turns by -T h/2
    for i in "12":
        law(0.0, A=m / 2, **{"T" + i: -1.0, "F" + i: -1.0})
        law(0.0, A=m * r / 4, **{"T" + i: -r, "F" + i: r})         # clockwise: T at the top, F at the foot
        law(m * g, **{"P" + i: 1.0, "N" + i: -1.0})
    A, _, N1, _, _, T2, N2, F2, P2 = np.linalg.solve(rows, right)
    inertia = -start / A
    return {
        "M[x,x]": inertia,
        "omega[1]": (k / inertia) ** 0.5,
        "front.normal.underside(0s)": N2,
        "front.friction.underside(0s)": -T2,        # the tangent there points back
        "front.normal.floor(0s)": P2,
        "front.friction.floor(0s)": F2,
        "rear.normal.underside(0s)": N1,
    }
