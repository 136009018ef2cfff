"""The rod turns about the instantaneous centre, where the normals of the guides meet: level, at the end in the level
guide, so that J = m L²/3 and half the weight rests on the spring."""


def answers(p):
    m, L, k, g = (p[name] for name in ("m", "L", "k", "g"))
    J = m * L**2 / 12 + m * (L / 2) ** 2
    return {
        "equilibrium[s.force]": -m * g * (L / 2) / L,
        "equation[theta]": lambda q, v, a: J * a["theta"] + k * L * q["theta"] * L,
        "omega[1]": (k * L**2 / J) ** 0.5,
    }
