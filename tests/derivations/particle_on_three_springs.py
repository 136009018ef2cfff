"""Force on the displaced particle, differenced.

The pull of each spring is k(length - l0) along its line from the exact places; the derivative of the
resultant by central differences of 30 digits is the stiffness matrix. Frequencies from its two
eigenvalues.
"""
from mpmath import diff, hypot, mp, mpf, pi, sqrt


def answers(p):
    with mp.workdps(30):
        m, k, l0, e = (mpf(p[n]) for n in ("m", "k", "l0", "e"))
        ends = [((l0 + e) * mp.cos(n * 2 * pi / 3), (l0 + e) * mp.sin(n * 2 * pi / 3)) for n in range(3)]

        def force(x, y, axis):
            total = mpf(0)
            for end in ends:
                arm = (end[0] - x, end[1] - y)
                length = hypot(*arm)
                total += k * (length - l0) * arm[axis] / length
            return total

        kxx, kxy = (-diff(lambda x, y: force(x, y, 0), (0, 0), n) for n in ((1, 0), (0, 1)))
        kyy = -diff(lambda x, y: force(x, y, 1), (0, 0), (0, 1))
        mean, half = (kxx + kyy) / 2, hypot((kxx - kyy) / 2, kxy)
        return {
            "K[x,x]": float(kxx),
            "K[x,y]": float(kxy),
            "K[y,y]": float(kyy),
            "omega[1]": float(sqrt((mean - half) / m)),
            "omega[2]": float(sqrt((mean + half) / m)),
            "equation[y]": lambda q, v, a: float(m) * a["y"] + float(kxy) * q["x"] + float(kyy) * q["y"],
        }
