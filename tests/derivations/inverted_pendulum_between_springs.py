"""Moment about the pivot of the weights and of both spring forces, each along the line to its own anchor
and with the tension N + k·(change of length), written with cross products at a finite tilt; stiffness is
its central difference at the upright position. The inertia is the sum over rod elements and the disc.
"""


def answers(p):
    import mpmath as mp

    m, M, L, r, g = (p[name] for name in ("m", "M", "L", "r", "g"))
    inertia = mp.quad(lambda s: m / L * s**2, [0, L]) + M * (L + r) ** 2 + M * r**2 / 2

    def stiffness(k, preload):
        def moment(phi):
            x, y = -p["h"] * mp.sin(phi), p["h"] * mp.cos(phi)
            lean = -mp.sin(phi)
            total = -g * lean * (m * L / 2 + M * (L + r))
            for anchor in (-p["b"], p["b"]):
                dx, dy = anchor - x, p["h"] - y
                length = mp.hypot(dx, dy)
                tension = preload + k * (length - p["b"])
                total += tension * (x * dy - y * dx) / length
            return total
        return float(-mp.diff(moment, 0))

    stiff, soft, tightened = stiffness(p["k"], 0), stiffness(60, 0), stiffness(p["k"], 80)
    inertia = float(inertia)
    return {
        "stiff: stable": stiff > 0,
        "stiff: equation[phi]": lambda q, v, a: inertia * a["phi"] + stiff * q["phi"],
        "stiff: omega[1]": (stiff / inertia) ** 0.5,
        "soft: stable": soft > 0,
        "soft: K[phi,phi]": soft,
        "tightened: stable": tightened > 0,
        "tightened: omega[1]": (tightened / inertia) ** 0.5,
    }
