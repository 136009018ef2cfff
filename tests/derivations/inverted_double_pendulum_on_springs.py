"""Moments about the joint and about the foot. The upper link alone gives the lower angle, φ₁ = φ₂ − (m g L/k) sin φ₂;
that put into the moments about the foot leaves one equation for φ₂, all of whose roots a fine table brackets. The
inertia of the two point masses follows from the angle between the links, the stiffness from differences of the energy.
"""


def answers(p):
    found = {}
    for prefix, k in (("", p["kt"]), ("weaker: ", 1.6)):
        places = positions(p["m"] * p["g"] * p["L"] / k)
        found[prefix + "equilibria"] = len(places)
        for i, (one, two) in enumerate(places, 1):
            square, stiff = squares(p, k, one, two)
            for pair, value in zip(("phi1,phi1", "phi1,phi2", "phi2,phi2"), stiff, strict=True):
                found[f"{prefix}K[{pair}][{i}]"] = value
            found[f"{prefix}equilibrium[phi1][{i}]"] = one
            found[f"{prefix}equilibrium[phi2][{i}]"] = two
            found[f"{prefix}stable[{i}]"] = min(square) > 0
            for j, value in enumerate(sorted(square), 1):
                found[f"{prefix}{'omega' if value > 0 else 'growth_rate'}[{j}][{i}]"] = abs(value) ** 0.5
    wanted = ("equilibria", "equilibrium[phi1][3]", "equilibrium[phi2][3]", "stable[2]", "stable[3]",
              "growth_rate[1][2]", "omega[2][2]", "omega[1][3]", "omega[2][3]",
              *(f"K[{pair}][3]" for pair in ("phi1,phi1", "phi2,phi2", "phi1,phi2")), "weaker: equilibria",
              *(f"weaker: equilibrium[phi{n}][{i}]" for i in (4, 5) for n in (1, 2)),
              *(f"weaker: stable[{i}]" for i in (3, 4, 5)), "weaker: growth_rate[1][3]", "weaker: growth_rate[2][3]",
              "weaker: growth_rate[1][4]", "weaker: omega[2][4]", "weaker: omega[1][5]", "weaker: omega[2][5]")
    return {key: found[key] for key in wanted}


def positions(load):
    """All (φ₁, φ₂) within half a turn, ascending; `load`: m g L/k."""
    import math

    import numpy as np
    from scipy.optimize import brentq

    def lower(two):
        return two - load * math.sin(two)

    def foot(two):
        one = lower(two)
        return one - (two - one) - 2 * load * math.sin(one)

    table = np.linspace(-math.pi, math.pi, 40001) + 1e-7
    moments = np.array([foot(two) for two in table])
    roots = [brentq(foot, table[i], table[i + 1], xtol=1e-15) for i in np.flatnonzero(moments[:-1] * moments[1:] < 0)]
    return sorted((lower(two), two) for two in roots if abs(lower(two)) <= math.pi)


def squares(p, k, one, two):
    """The two ω² of M q̈ + K q = 0, and the entries of K, by central differences of the energy."""
    import mpmath as mp

    m, length, g = (mp.mpf(p[name]) for name in ("m", "L", "g"))

    def energy(a, b):
        return k * a**2 / 2 + k * (b - a) ** 2 / 2 + m * g * length * (2 * mp.cos(a) + mp.cos(b))

    with mp.workdps(40):
        stiff = [[mp.diff(energy, (one, two), order) for order in row] for row in (((2, 0), (1, 1)), ((1, 1), (0, 2)))]
        cosine = mp.cos(mp.mpf(one) - two)
        inertia = mp.matrix([[2, cosine], [cosine, 1]]) * m * length**2
        values = mp.eig(mp.inverse(inertia) * mp.matrix(stiff), left=False, right=False)
    return [float(mp.re(value)) for value in values], [float(stiff[i][j]) for i, j in ((0, 0), (0, 1), (1, 1))]
