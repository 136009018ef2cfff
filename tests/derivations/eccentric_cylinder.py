"""The place of the axis, of the particle and of the spring's end are written as functions of the turn;
rolling moves the axis by -R·phi. Speeds are derivatives of these places, taken numerically, and V is the
particle's weight and the spring energy in full, differentiated twice at 30 digits.
"""


def answers(p):
    import mpmath as mp

    m, m0, R, e = p["m"], p["m0"], p["R"], p["e"]

    def attached(phi, below):
        """A point of the cylinder that was `below` its axis."""
        return -R * phi + below * mp.sin(phi), R - below * mp.cos(phi)

    def inertia(phi):
        vx, vy = (mp.diff(lambda f, i=i: attached(f, e)[i], phi) for i in (0, 1))
        return m * R**2 + m * R**2 / 2 + m0 * (vx**2 + vy**2)

    def potential(phi):
        x, y = attached(phi, -R)
        stretch = mp.hypot(x + p["b"], y - 2 * R) - p["b"]
        return m0 * p["g"] * attached(phi, e)[1] + p["k"] * stretch**2 / 2

    with mp.workdps(30):
        stiffness = mp.diff(potential, 0, 2)
    return {
        "T": lambda q, v: float(inertia(q["phi"]) * v["phi"] ** 2 / 2),
        "M[phi,phi]": float(inertia(0)),
        "K[phi,phi]": float(stiffness),
        "omega[1]": float(mp.sqrt(stiffness / inertia(0))),
    }
