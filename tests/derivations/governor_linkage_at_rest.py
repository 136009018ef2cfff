"""By symmetry one angle beta of arms and links to the spindle lays out everything: places are multiples of its sine
and cosine. V is heights and the spring, whose compression makes V' vanish as drawn; K is V'', and M twice the energy
of the parts at beta' = 1, from derivatives of their places, with 30 digits.
"""


def answers(p):
    import mpmath as mp

    a, k, g, alpha = p["a"], p["k"], p["g"], mp.mpf(p["alpha"])

    # Mass, place beside the spindle, height: one side, and the sleeve.
    sides = [
        (p["m1"], lambda u: a * mp.sin(u) / 2, lambda u: -a * mp.cos(u) / 2),
        (p["m2"], lambda u: a * mp.sin(u), lambda u: -a * mp.cos(u)),
        (p["m3"], lambda u: a * mp.sin(u) / 2, lambda u: -3 * a * mp.cos(u) / 2),
    ]

    def sleeve(u):
        return -2 * a * mp.cos(u)

    def weights(u):
        return g * (2 * sum(m * high(u) for m, _, high in sides) + p["m4"] * sleeve(u))

    with mp.workdps(30):
        force = -mp.diff(weights, alpha) / mp.diff(sleeve, alpha)

        def potential(u):
            longer = sleeve(u) - sleeve(alpha)
            return weights(u) + force * longer + k * longer**2 / 2

        slope, stiffness = mp.diff(potential, alpha), mp.diff(potential, alpha, 2)
        inertia = p["m4"] * mp.diff(sleeve, alpha) ** 2 + 2 * (p["m1"] + p["m3"]) * a**2 / 12
        inertia += 2 * sum(m * (mp.diff(x, alpha) ** 2 + mp.diff(y, alpha) ** 2) for m, x, y in sides)
    return {
        "equilibrium[phi]": 0.0 if abs(slope) < 1e-15 else float("nan"),
        "M[phi,phi]": float(inertia),
        "K[phi,phi]": float(stiffness),
        "omega[1]": float(mp.sqrt(stiffness / inertia)),
    }
