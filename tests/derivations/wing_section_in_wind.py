"""Newton for the mass centre and Euler about it; the holder pushes the section at the axis, sideways as guides need.

Lift and springs are a force at the axis and a moment. The matrices are the first order of these; frequencies without
air damping and damping ratios are roots of det(M s^2 + C s + K) = 0, a quartic, in 30 digits.
"""
from math import cos, sin

from mpmath import im, mp, mpf, polyroots, re

NAMES = ("h", "alpha")
REST = dict.fromkeys(NAMES, 0.0)


def answers(p):
    m, J, kh, ka, d, e = (p[n] for n in ("m", "J", "kh", "ka", "d", "e"))

    def residuals(U, q, v, a):
        s, c = sin(q["alpha"]), cos(q["alpha"])
        lift = p["rho"] * U**2 / 2 * p["S"] * p["a"] * (q["alpha"] - v["h"] / U)
        # The axis lies at d (cos, sin) from the mass centre, which accelerates with (ax, ay).
        ax = d * (s * a["alpha"] + c * v["alpha"] ** 2)
        ay = a["h"] - d * (c * a["alpha"] - s * v["alpha"] ** 2)
        plunge = m * ay + kh * q["h"] - lift
        pitch = J * a["alpha"] + ka * q["alpha"] - e * lift - d * (c * m * ay - s * m * ax)
        return plunge, pitch

    def kinetic(q, v):
        vx, vy = d * sin(q["alpha"]) * v["alpha"], v["h"] - d * cos(q["alpha"]) * v["alpha"]
        return (m * (vx**2 + vy**2) + J * v["alpha"] ** 2) / 2

    def column(U, which, name):
        """What a unit of a coordinate, its rate or its acceleration adds to both equations at rest."""
        state = [REST, REST, REST]
        state[which] = REST | {name: 1e-7 if which == 0 else 1.0}
        return [x / state[which][name] for x in residuals(U, *state)]

    def pairs(U, damped):
        """The roots with positive imaginary part, slower first."""
        K, C, M = ([[mpf(x) for x in column(U, which, n)] for n in NAMES] for which in (0, 1, 2))
        entry = [[[K[j][i], C[j][i] * damped, M[j][i]] for j in (0, 1)] for i in (0, 1)]

        def product(x, y):
            return [sum(x[i] * y[n - i] for i in range(3) if 0 <= n - i < 3) for n in range(5)]

        ahead, across = product(entry[0][0], entry[1][1]), product(entry[0][1], entry[1][0])
        quartic = [x - y for x, y in zip(ahead, across, strict=True)][::-1]
        return sorted((s for s in polyroots(quartic, maxsteps=500, extraprec=90) if im(s) > 0), key=abs)

    U, faster = p["U"], 18.0
    with mp.workdps(30):
        free, slow, fast = pairs(U, 0), pairs(U, 1), pairs(faster, 1)
        zeta = [[float(-re(s) / abs(s)) for s in roots] for roots in (slow, fast)]
        omega = [float(abs(s)) for s in free]
    return {
        "T": kinetic,
        "motion[h]": lambda q, v, a: residuals(U, q, v, a)[0],
        "motion[alpha]": lambda q, v, a: residuals(U, q, v, a)[1],
        "M[h,alpha]": column(U, 2, "alpha")[0],
        "K[h,alpha]": column(U, 0, "alpha")[0],
        "K[alpha,h]": column(U, 0, "h")[1],
        "K[alpha,alpha]": column(U, 0, "alpha")[1],
        "C[h,h]": column(U, 1, "h")[0],
        "stable": min(zeta[0]) > 0,
        "omega[1]": omega[0],
        "omega[2]": omega[1],
        "zeta[1]": zeta[0][0],
        "zeta[2]": zeta[0][1],
        "in a faster wind: zeta[1]": zeta[1][0],
        "in a faster wind: zeta[2]": zeta[1][1],
        "in a faster wind: stable": min(zeta[1]) > 0,
    }
