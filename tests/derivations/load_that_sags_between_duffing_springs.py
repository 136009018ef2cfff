"""The place of rest by its forces; there the force of a level spring, and that of a deflection that stays proportional
to the sinking, differenced with 60 digits."""
from mpmath import diff, findroot, mp, mpf, sqrt, taylor


def answers(p):
    with mp.workdps(60):
        m, k1, g1, k2, g2, length, g = (mpf(p[name]) for name in ("m", "k1", "g1", "k2", "g2", "l", "g"))

        def deflection(y):
            return sqrt(length**2 + y**2) - length

        def tension(d):
            return k2 * d + g2 * d**3

        def level(y):
            return tension(deflection(y)) * y / sqrt(length**2 + y**2)

        def force(y):
            return k1 * y + g1 * y**3 + 2 * level(y)

        rest = findroot(lambda y: force(y) - m * g, mpf("0.1"))
        slope = diff(deflection, rest)

        def proportional(y):
            return tension(deflection(rest) + slope * (y - rest)) * slope

        added = [float(a - b) for a, b in zip(taylor(level, rest, 3), taylor(proportional, rest, 3), strict=True)]
        stiffness = diff(force, rest)
        return {"equilibrium[y]": float(rest), "2*V[y^2]": float(stiffness), "stiffness_correction[left, y]": added[1],
                "stiffness_correction[left, y^2]": added[2], "stiffness_correction[left, y^3]": added[3],
                "stiffness_correction[above, y^3]": 0.0, "omega[1]": float(sqrt(stiffness / m))}
