"""The platform stays level and runs on a circle of the rods' length, so one place and one speed say all.

The spring's force at rest comes from the balance of moments of one oblique rod with its share of the load. V is
heights and the spring's length as functions of phi; K is its second derivative, twice T sums mv² and Jω² of the
parts.
"""


def answers(p):
    import mpmath as mp

    X, H, g = p["X"], p["H"], p["g"]
    carried, rods = p["M"] + p["m1"], 3 * p["m"]
    length = mp.hypot(X, H)

    def place(phi):
        """Of the platform's ends, from their drawn place."""
        angle = mp.atan2(X, H) + phi
        return length * mp.sin(angle) - X, H - length * mp.cos(angle)

    # Weights pull back with the arm X (rods at half of it), the level force has the arm H.
    tension = g * (carried * X + rods * X / 2) / H

    def potential(phi):
        x, y = place(phi)
        longer = mp.hypot(p["w"] - x, y) - p["w"]
        return g * (carried + rods / 2) * y + tension * longer + p["k"] * longer**2 / 2

    def kinetic(q, v):
        speed = float(length) * v["phi"]
        spin = rods * float(length) ** 2 / 12 * v["phi"] ** 2
        return carried * speed**2 / 2 + rods * (speed / 2) ** 2 / 2 + spin / 2

    with mp.workdps(30):
        slope, stiffness = mp.diff(potential, 0), mp.diff(potential, 0, 2)
    inertia = 2 * kinetic({}, {"phi": 1.0})
    return {
        "equilibrium[phi]": 0.0 if abs(slope) < 1e-12 * stiffness else float("nan"),
        "T": kinetic,
        "K[phi,phi]": float(stiffness),
        "omega[1]": float(mp.sqrt(stiffness / inertia)),
    }
