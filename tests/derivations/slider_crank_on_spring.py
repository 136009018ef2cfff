"""The mechanism laid out by triangles for a given turn of the crank: places of the mass centres and of the slider,
tilt of the rod. V is heights and the spring's length, twice T the squares of their derivatives by the turn; rest is a
root of V', the frequency follows from V''/(2T), with 40 digits. The holding moment is the slope of V at the drawn
position, by itself, and its constant moment adds nothing to V''.
"""


def answers(p):
    import mpmath as mp

    r, rod, g = p["r"], p["l"], p["g"]

    def tilt(phi):
        """How far below the level the rod points, from crank pin to slider."""
        return mp.asin(r * mp.cos(phi) / rod)

    def slider(phi):
        return -r * mp.sin(phi) + rod * mp.cos(tilt(phi))

    def middle(phi):
        return -r * mp.sin(phi) + rod / 2 * mp.cos(tilt(phi)), r * mp.cos(phi) / 2

    def potential(phi):
        weights = g * (p["m1"] * r / 2 * mp.cos(phi) + p["m2"] * middle(phi)[1])
        return weights + p["k"] / 2 * (p["w"] - slider(phi) - p["l0"]) ** 2

    def inertia(phi):
        parts = [(p["m2"], lambda u: middle(u)[0]), (p["m2"], lambda u: middle(u)[1]), (p["m2"] * rod**2 / 12, tilt),
                 (p["m3"], slider)]
        return p["m1"] * r**2 / 3 + sum(w * mp.diff(s, phi) ** 2 for w, s in parts)

    with mp.workdps(40):
        rest = mp.findroot(lambda u: mp.diff(potential, u), -0.4)
        square, square_held = (mp.diff(potential, u, 2) / inertia(u) for u in (rest, mp.mpf(0)))
        needed = mp.diff(potential, mp.mpf(0))
        holds = abs(needed - p["k"] * (p["w"] - slider(mp.mpf(0)) - p["l0"]) * r) < 1e-12
        found = {
            "equilibrium[phi]": rest,
            "equilibrium[psi]": -(tilt(rest) - tilt(mp.mpf(0))),
            "equilibrium[x]": slider(rest) - slider(mp.mpf(0)),
            "frequency[1]": mp.sqrt(square) / (2 * mp.pi),
            "held: equilibrium[phi]": 0 if holds else mp.nan,
            "held: omega[1]": mp.sqrt(square_held),
        }
    return {key: float(value) for key, value in found.items()} | {"stable": square > 0, "held: stable": square_held > 0}
