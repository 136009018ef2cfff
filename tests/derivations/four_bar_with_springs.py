"""The linkage laid out for a given turn of the crank: B is the intersection of the circles about A and C that is
nearest the drawn one, the tilts of coupler and rocker are arctangents. V is heights, the coil and the length of the
inclined spring; twice T the squares of the derivatives of places and tilts. Rest is the root of V', the frequency
√(V''/2T), with 40 digits.
"""


def answers(p):
    import mpmath as mp

    a, c, d, b, mu, g = p["a"], p["c"], p["d"], p["b"], p["mu"], p["g"]

    def pin(phi):
        return -a * mp.sin(phi), a * mp.cos(phi)

    def hinge(phi):
        ax, ay = pin(phi)
        wx, wy = d - ax, -ay
        far = mp.hypot(wx, wy)
        along = (b**2 - c**2 + far**2) / (2 * far)
        across = mp.sqrt(b**2 - along**2)
        # The intersection on the left as seen from A to C: the upper one.
        return ax + (along * wx - across * wy) / far, ay + (along * wy + across * wx) / far

    def tilts(phi):
        (ax, ay), (bx, by) = pin(phi), hinge(phi)
        coupler = mp.atan2(by - ay, bx - ax) - mp.atan2(c - a, d)
        return coupler, mp.atan2(by, bx - d) - mp.pi / 2

    def middle(phi):
        (ax, ay), (bx, by) = pin(phi), hinge(phi)
        return (ax + bx) / 2, (ay + by) / 2

    drawn = mp.hypot(p["f"], c)

    def potential(phi):
        _, by = hinge(phi)
        heights = g * mu * (a * pin(phi)[1] + c * by) / 2 + g * (p["m"] + mu * b) * middle(phi)[1]
        bx, by = hinge(phi)
        longer = mp.hypot(bx - d - p["f"], by) - drawn
        return heights + p["kt"] * phi**2 / 2 + p["N"] * longer + p["k"] * longer**2 / 2

    def inertia(phi):
        parts = [(p["m"] + mu * b, lambda u: middle(u)[0]), (p["m"] + mu * b, lambda u: middle(u)[1]),
                 (mu * b**3 / 12, lambda u: tilts(u)[0]), (mu * c**3 / 3, lambda u: tilts(u)[1])]
        return mu * a**3 / 3 + sum(w * mp.diff(s, phi) ** 2 for w, s in parts)

    with mp.workdps(40):
        a, c, d, b = map(mp.mpf, (a, c, d, b))
        rest = mp.findroot(lambda u: mp.diff(potential, u), -0.1)
        stiffness, mass = mp.diff(potential, rest, 2), inertia(rest)
        coupler, rocker = tilts(rest)
        found = {"equilibrium[phi]": rest, "equilibrium[psi]": coupler, "equilibrium[chi]": rocker,
                 "M[phi,phi]": mass, "K[phi,phi]": stiffness, "omega[1]": mp.sqrt(stiffness / mass)}
    return {key: float(value) for key, value in found.items()}
