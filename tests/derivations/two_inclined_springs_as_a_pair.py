"""The energy of both springs, differenced twice along each direction: the largest is looked for over the directions."""
from mpmath import cos, diff, findroot, hypot, mp, mpf, pi, sin, sqrt


def answers(p):
    with mp.workdps(40):
        m, k1, k2, a, b, L = (mpf(p[n]) for n in ("m", "k1", "k2", "a", "b", "L"))

        def energy(x, y):
            return sum(k * (hypot(L * cos(f) - x, L * sin(f) - y) - L) ** 2 / 2 for k, f in ((k1, a), (k2, b)))

        def along(f):
            return diff(lambda s: energy(s * cos(f), s * sin(f)), 0, 2)

        places = [pi * i / 40 - pi / 2 for i in range(41)]
        start = max(places, key=along)
        best = findroot(lambda f: along(f + pi / 4) - along(f - pi / 4), (start, start + mpf("0.05")), tol=1e-18)
        angle = float(best - pi * round((best - mpf("1e-12")) / pi)) if best else 0.0
        return {
            "stiffness[bead].max": float(along(best)),
            "stiffness[bead].min": float(along(best + pi / 2)),
            "stiffness[bead].angle": angle,
            "omega[1]": float(sqrt(along(best + pi / 2) / m)),
        }
