"""Places by triangles; velocities and accelerations by numerical derivatives with 40 digits. The moment of the motor by
power, M Omega = d(T + V)/dt + F x'; the guide by the moments of rod and piston about the crank pin; the axle by the
momentum of all that moves.
"""


def answers(p):
    import mpmath as mp

    r, rod, m2, m3, W, g = p["r"], p["l"], p["m2"], p["m3"], p["Omega"], p["g"]

    def tilt(t):
        return -mp.asin(r * mp.sin(W * t) / rod)

    def middle(t):
        return r * mp.cos(W * t) + rod / 2 * mp.cos(tilt(t)), r * mp.sin(W * t) / 2

    def piston(t):
        return r * mp.cos(W * t) + rod * mp.cos(tilt(t))

    def kinetic(t):
        squares = [(m2, lambda u: middle(u)[0]), (m2, lambda u: middle(u)[1]), (m2 * rod**2 / 12, tilt), (m3, piston)]
        return p["J"] * W**2 / 2 + sum(w * mp.diff(s, t) ** 2 for w, s in squares) / 2

    def potential(t):
        return m2 * g * middle(t)[1]

    def motor(t, F):
        return (mp.diff(lambda u: kinetic(u) + potential(u), t) + F * mp.diff(piston, t)) / W

    with mp.workdps(40):
        t, F = mp.mpf(p["t1"]), p["F"]
        ax, ay = (mp.diff(lambda u, i=i: middle(u)[i], t, 2) for i in (0, 1))
        a, spin = mp.diff(piston, t, 2), mp.diff(tilt, t, 2)
        along, across = rod * mp.cos(tilt(t)), rod * mp.sin(tilt(t))
        # moments about the crank pin of rod and piston: J θ″ + m (c × a_C) + m₃ (l × a) = l × forces
        left = m2 * rod**2 / 12 * spin + m2 * (along / 2 * ay - across / 2 * ax) - m3 * across * a
        guide = (left + m2 * g * along / 2 + m3 * g * along - across * F) / along
        found = {
            "x(t1)": piston(t) - piston(mp.mpf(0)), "x'(t1)": mp.diff(piston, t), "x''(t1)": a, "T(t1)": kinetic(t),
            "crank.drive(t1)": motor(t, F), "piston.reaction.y(t1)": guide,
            "crank.reaction.x(t1)": m2 * ax + m3 * a + F,
            "crank.reaction.y(t1)": m2 * ay + (m2 + m3) * g - guide,
            "without pressure: crank.drive(t1)": motor(t, 0),
        }
    return {key: float(value) for key, value in found.items()}
