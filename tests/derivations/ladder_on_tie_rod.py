"""The ladder laid out for a given place of its foot: Q is the intersection, nearest the drawn one, of the circles
about the foot (radius AQ) and about P (radius of the tie rod). V is heights and the spring; M the energy at u' = 1
from derivatives of the places; rest the root of V', omega² = V''/M, with 30 digits. The tension that balances the
drawn position comes from moments about A and the level balance: the tie rod's line has the arm AQ there.
"""


def answers(p):
    import mpmath as mp

    L, q, s, m, M, g = (mp.mpf(p[n]) for n in ("L", "q", "s", "m", "M", "g"))
    top, rod = 5 * q / 4, 3 * q / 4

    def angle(u):
        """Of the ladder to the floor."""
        far, direction = mp.hypot(u, top), mp.atan2(top, -u)
        return direction - mp.acos((q**2 + far**2 - rod**2) / (2 * q * far))

    def place(along):
        return lambda u: u + along * mp.cos(angle(u)), lambda u: along * mp.sin(angle(u))

    middle, man = place(L / 2), place(s)

    def at_rest(tension):
        """(u, M, omega²) where the spring is drawn with this tension."""
        def potential(u):
            return g * (m * middle[1](u) + M * man[1](u)) - tension * u + p["k"] * u**2 / 2

        u = mp.findroot(lambda x: mp.diff(potential, x), mp.mpf("0.001"))
        parts = [(m, middle[0]), (m, middle[1]), (m * L**2 / 12, angle), (M, man[0]), (M, man[1])]
        inertia = sum(w * mp.diff(place, u) ** 2 for w, place in parts)
        return u, inertia, mp.diff(potential, u, 2) / inertia

    with mp.workdps(30):
        slope = mp.mpf(3) / 5
        balancing = mp.mpf(4) / 5 * slope * g * (m * L / 2 + M * s) / q
        u, inertia, square = at_rest(p["N"])
        u_balanced, _, square_balanced = at_rest(balancing)
        found = {
            "equilibrium[u]": u,
            "equilibrium[phi]": angle(u) - angle(mp.mpf(0)),
            "M[u,u]": inertia,
            "omega[1]": mp.sqrt(square),
            "balanced: equilibrium[u]": mp.chop(u_balanced, 1e-15),
            "balanced: omega[1]": mp.sqrt(square_balanced),
        }
    return {key: float(value) for key, value in found.items()} | {
        "stable": square > 0, "balanced: stable": square_balanced > 0}
