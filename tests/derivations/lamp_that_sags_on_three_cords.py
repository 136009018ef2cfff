"""Forces balanced by mpmath's Newton from the exact lengths, then differenced at that place."""
from mpmath import atan2, diff, findroot, hypot, mp, mpf


def answers(p):
    with mp.workdps(40):
        cords = [(mpf(p["k1"]), mpf("-0.5"), mpf("0.4")), (mpf(p["k2"]), mpf("0.6"), mpf("0.3")),
                 (mpf(p["k3"]), mpf("0.1"), mpf("0.7"))]

        def force(axis, x, y):
            total = -mpf(p["m"]) * mpf(p["g"]) * axis
            for k, X, Y in cords:
                length = hypot(X - x, Y - y)
                total += k * (length - hypot(X, Y)) * (X - x, Y - y)[axis] / length
            return total

        rest = findroot(lambda x, y: [force(0, x, y), force(1, x, y)], (0, mpf("-0.03")))
        x, y = rest
        xx, xy = (-diff(lambda u, v: force(0, u, v), (x, y), n) for n in ((1, 0), (0, 1)))
        yy = -diff(lambda u, v: force(1, u, v), (x, y), (0, 1))
        middle, half = (xx + yy) / 2, hypot((xx - yy) / 2, xy)
        found = {"equilibrium[x]": x, "equilibrium[y]": y, "stiffness[lamp].max": middle + half,
                 "stiffness[lamp].min": middle - half, "stiffness[lamp].angle": atan2(2 * xy, xx - yy) / 2}
        return {name: float(value) for name, value in found.items()}
