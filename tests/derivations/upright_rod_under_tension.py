"""Moment about the pivot at a finite tilt: the weight, and the spring's pull along the line from the
rod's tip to the fixed point, with the tension N + k·(change of length). Its derivative at the upright
position, taken numerically at 30 digits, is minus the stiffness.
"""


def answers(p):
    import mpmath as mp

    m, L, h, g = (p[name] for name in ("m", "L", "h", "g"))

    def stiffness(preload):
        def moment(phi):
            x, y = -L * mp.sin(phi), L * mp.cos(phi)
            dx, dy = -x, L + h - y
            length = mp.hypot(dx, dy)
            tension = preload + p["k"] * (length - h)
            return tension * (x * dy - y * dx) / length - x / 2 * m * g

        with mp.workdps(30):
            return float(-mp.diff(moment, 0))

    inertia = float(mp.quad(lambda s: m / L * s**2, [0, L]))
    tight, slack = stiffness(p["N"]), stiffness(3)
    return {
        "tight: stable": tight > 0,
        "tight: equation[phi]": lambda q, v, a: inertia * a["phi"] + tight * q["phi"],
        "tight: omega[1]": (tight / inertia) ** 0.5,
        "slack: stable": slack > 0,
        "slack: K[phi,phi]": slack,
    }
