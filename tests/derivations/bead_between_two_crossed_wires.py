"""Forces on the displaced bead, differenced with 40 digits."""
from mpmath import diff, hypot, mp, mpf


def answers(p):
    with mp.workdps(40):
        k1, k2, L, N1, N2 = (mpf(p[n]) for n in ("k1", "k2", "L", "N1", "N2"))
        wires = [(k1, N1, -L, 0), (k1, N1, L, 0), (k2, N2, 0, -L), (k2, N2, 0, L)]

        def resisting(axis, x, y):
            total = mpf(0)
            for k, N, X, Y in wires:
                length, arm = hypot(X - x, Y - y), (X - x, Y - y)
                total -= (N + k * (length - L)) * arm[axis] / length
            return total

        xx, xy = (float(diff(lambda x, y: resisting(0, x, y), (0, 0), n)) for n in ((1, 0), (0, 1)))
        yy = float(diff(lambda x, y: resisting(1, x, y), (0, 0), (0, 1)))
        assert abs(xy) < 1e-12 * (xx + yy)
        found = {"xx": xx, "xy": 0.0, "yy": yy, "max": max(xx, yy), "min": min(xx, yy)}
        return {f"stiffness[bead].{part}": value for part, value in found.items()}
