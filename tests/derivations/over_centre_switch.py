"""Moments about O: the tension of the spring, N + k (l − l₁) by Pythagoras, times its arm a L sin φ/l, against the
spiral. Away from the upright the balance k_t φ = T(φ) a L sin φ/l is searched by bisection on a fine table; the
stiffness is the slope of the moment by differences.
"""


def answers(p):
    import math

    import mpmath as mp

    L, a, k, N = (mp.mpf(p[name]) for name in ("L", "a", "k", "N"))

    def moment(phi, kt):
        """Of the springs, against the turn."""
        length = mp.sqrt((L * mp.sin(phi)) ** 2 + (a + L * mp.cos(phi)) ** 2)
        return kt * phi - (N + k * (length - a - L)) * a * L * mp.sin(phi) / length

    def positions(kt):
        limit = mp.mpf(100) * mp.pi / 180
        table = [limit * (2 * i + 1) / 4001 for i in range(2001)]
        moments = [moment(x, kt) for x in table]
        changes = [i for i in range(2000) if moments[i] * moments[i + 1] < 0]
        positive = [mp.findroot(lambda x: moment(x, kt), (table[i], table[i + 1]), solver="bisect", tol=1e-28)
                    for i in changes]
        return [-x for x in reversed(positive)] + [mp.mpf(0)] + positive

    def stiffness(phi, kt):
        return float(mp.diff(lambda x: moment(x, kt), phi))

    kt, stronger = mp.mpf(p["kt"]), mp.mpf("0.3")
    places = positions(kt)
    assert len(places) == 3 and math.isclose(places[0], -places[2])
    return {
        "stable": stiffness(0, kt) > 0,
        "equilibria": len(places),
        **{f"stable[{i}]": stiffness(phi, kt) > 0 for i, phi in enumerate(places, 1)},
        "equilibrium[phi][3]": float(places[2]),
        "K[phi,phi][2]": stiffness(0, kt),
        "K[phi,phi][3]": stiffness(places[2], kt),
        "a stronger spiral: equilibria": len(positions(stronger)),
        "a stronger spiral: stable[1]": stiffness(0, stronger) > 0,
        "a stronger spiral: K[phi,phi][1]": stiffness(0, stronger),
    }
