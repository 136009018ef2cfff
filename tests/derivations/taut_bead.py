"""Newton for the bead: at the displacement y each spring pulls along its own inclined line with the
tension N + k·elongation. The potential energy is the work of that force, by quadrature from 0 to y, and
the stiffness minus its derivative at 0.
"""


def answers(p):
    import mpmath as mp

    springs = ((p["k1"], p["a"]), (p["k2"], p["b"]))

    def force(y):
        total = mp.mpf(0)
        for k, length in springs:
            now = mp.hypot(length, y)
            total -= (p["N"] + k * (now - length)) * y / now
        return total

    stiffness = float(-mp.diff(force, 0))
    return {
        "V": lambda q: float(-mp.quad(force, [0, q["y"]])),
        "equation[y]": lambda q, v, a: p["m"] * a["y"] + stiffness * q["y"],
        "K[y,y]": stiffness,
        "omega[1]": (stiffness / p["m"]) ** 0.5,
    }
