"""The level platform moves on a circle, as its carrying points do: its speed is L·phi', the rods turn
about fixed points. T from those speeds, V from the heights and from the spring's length between its two
ends; stiffness by a 30-digit second derivative of V, frequency from the balance of both energies.
"""


def answers(p):
    import mpmath as mp

    L, b = p["L"], p["b"]
    carried = p["M"] + p["m0"]

    def kinetic(q, v):
        speed = L * v["phi"]
        about_centre, centre = p["m"] * L**2 / 12 * v["phi"] ** 2, p["m"] * (speed / 2) ** 2
        return carried * speed**2 / 2 + 2 * (about_centre + centre) / 2

    def potential(phi):
        x, y = L * mp.sin(phi), L - L * mp.cos(phi)
        stretch = mp.hypot(x + b, y) - b
        return p["g"] * (carried * y + 2 * p["m"] * y / 2) + p["k"] * stretch**2 / 2

    with mp.workdps(30):
        stiffness = mp.diff(potential, 0, 2)
    inertia = 2 * kinetic({}, {"phi": 1.0})
    return {
        "T": kinetic,
        "V": lambda q: float(potential(q["phi"])),
        "K[phi,phi]": float(stiffness),
        "frequency[1]": float(mp.sqrt(stiffness / inertia) / (2 * mp.pi)),
    }
