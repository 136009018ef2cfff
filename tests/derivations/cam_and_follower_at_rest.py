"""The rise of the roller as a function of the cam's turn, from the triangle O, C, roller; its derivatives carry the
follower's forces over to the cam.

Moments about O: J φ'' = −kt φ − mc g e cos φ − y'(m(y'' …) + c ẏ + k y + N + m g). Rest is the root of what is left
without motion; about it inertia J + m y'², damping c y'² and the slope of the static moment make one damped
oscillator.
"""


def answers(p):
    import mpmath as mp

    e, h, rho, g = (mp.mpf(p[n]) for n in ("e", "h", "rho", "g"))

    def rise(phi):
        return e * mp.sin(phi) + mp.sqrt(rho**2 - (e * mp.cos(phi)) ** 2) - h

    def lever(phi):
        return e * mp.cos(phi) + e**2 * mp.sin(phi) * mp.cos(phi) / mp.sqrt(rho**2 - (e * mp.cos(phi)) ** 2)

    def static_moment(phi):
        follower = p["k"] * rise(phi) + p["N"] + p["m"] * g
        return p["kt"] * phi + p["mc"] * g * e * mp.cos(phi) + lever(phi) * follower

    with mp.workdps(30):
        rest = mp.findroot(static_moment, mp.mpf("-0.1"))
        inertia = p["J"] + p["m"] * lever(rest) ** 2
        omega = mp.sqrt(mp.diff(static_moment, rest) / inertia)
        zeta = p["c"] * lever(rest) ** 2 / (2 * inertia * omega)
        found = {"equilibrium[phi]": rest, "equilibrium[y]": rise(rest), "omega[1]": omega, "zeta[1]": zeta,
                 "omega_d[1]": omega * mp.sqrt(1 - zeta**2)}
    return {key: float(value) for key, value in found.items()}
