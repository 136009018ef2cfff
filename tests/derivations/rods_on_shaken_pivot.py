"""Newton–Euler from below: the lower rod freed at the joint, then the upper one with the joint's reaction.

The pivot moves with its known acceleration. Frequencies from the quadratic of the determinant of small motions.
"""
from math import cos, sin, sqrt


def answers(p):
    m1, L1, m2, L2, ct, g = (p[n] for n in ("m1", "L1", "m2", "L2", "ct", "g"))

    def swing(length, angle, rate, change):
        """Acceleration of the place at a distance below a hinge, relative to it."""
        return (length * (cos(angle) * change - sin(angle) * rate**2),
                length * (sin(angle) * change + cos(angle) * rate**2))

    def residuals(q, v, acc, drive=True):
        a, b = q["alpha"], q["beta"]
        pivot = -p["X"] * p["Omega"] ** 2 * sin(p["Omega"] * q["t"]) if drive else 0.0
        half, whole = (swing(s, a, v["alpha"], acc["alpha"]) for s in (L1 / 2, L1))
        low = swing(L2 / 2, b, v["beta"], acc["beta"])
        joint = m2 * (pivot + whole[0] + low[0]), m2 * (whole[1] + low[1] + g)  # force on the lower rod
        pin = joint[0] + m1 * (pivot + half[0]), joint[1] + m1 * (half[1] + g)  # force on the upper rod
        damping = ct * (v["beta"] - v["alpha"])
        # A hinge lies at L/2 (-sin, cos) from the mass centre below it.
        lower = m2 * L2**2 / 12 * acc["beta"] + damping + L2 / 2 * (sin(b) * joint[1] + cos(b) * joint[0])
        upper = m1 * L1**2 / 12 * acc["alpha"] - damping + L1 / 2 * (
            sin(a) * (pin[1] + joint[1]) + cos(a) * (pin[0] + joint[0]))
        return upper, lower

    def small(q, v, acc):
        """The lower rod to first order, its forces across the upright alone."""
        pivot = -p["X"] * p["Omega"] ** 2 * sin(p["Omega"] * q["t"])
        joint = m2 * (pivot + L1 * acc["alpha"] + L2 / 2 * acc["beta"])
        return (m2 * L2**2 / 12 * acc["beta"] + ct * (v["beta"] - v["alpha"])
                + L2 / 2 * (m2 * g * q["beta"] + joint))

    zero = {"alpha": 0.0, "beta": 0.0, "t": 0.0}
    unit = {"alpha": {"alpha": 1.0, "beta": 0.0}, "beta": {"alpha": 0.0, "beta": 1.0}}
    M = [residuals(zero, zero, unit[n], False) for n in ("alpha", "beta")]
    step = 1e-6
    K = [tuple((x - y) / (2 * step) for x, y in zip(*(residuals({**zero, n: e}, zero, zero, False)
                                                      for e in (step, -step)), strict=True)) for n in ("alpha", "beta")]
    top, low = (m1 / 2 + m2) * g * L1, m2 * g * L2 / 2
    A = M[0][0] * M[1][1] - M[0][1] * M[1][0]
    B = M[0][0] * low + M[1][1] * top
    root = sqrt(B * B - 4 * A * top * low)
    return {
        "motion[alpha]": lambda q, v, a: residuals(q, v, a)[0],
        "motion[beta]": lambda q, v, a: residuals(q, v, a)[1],
        "equation[beta]": small,
        "M[alpha,beta]": M[1][0],
        "C[alpha,beta]": residuals(zero, unit["beta"], zero, False)[0]
                         - residuals(zero, zero, zero, False)[0],
        "K[alpha,alpha]": K[0][0],
        "omega[1]": sqrt((B - root) / (2 * A)),
        "omega[2]": sqrt((B + root) / (2 * A)),
    }
