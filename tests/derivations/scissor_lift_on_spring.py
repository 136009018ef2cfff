"""All bars rise at one angle beta to the floor, so every place is a multiple of cos(beta) or sin(beta).

V is heights and the spring between the lower ends; its tension as drawn comes from virtual work there. Twice T: each
bar turns at beta' about its middle, the middles rise on the vertical half-way line, which itself moves. Rest is a
root of V', the frequency √(V''/2T), with 30 digits.
"""


def answers(p):
    import mpmath as mp

    L, m, g, k = p["L"], p["m"], p["g"], p["k"]

    def at_rest(table, guess):
        """(angle, omega²) with a table of this mass."""
        def potential(beta):
            wide, high = L * mp.cos(beta), L * mp.sin(beta)
            longer = wide - wide0
            heights = g * (table * 2 * high + 2 * m * high / 2 + 2 * m * 3 * high / 2)
            return heights + tension * longer + k * longer**2 / 2

        def inertia(beta):
            across, lower, upper = -L * mp.sin(beta) / 2, L * mp.cos(beta) / 2, 3 * L * mp.cos(beta) / 2
            bars = 2 * m * (across**2 + lower**2) + 2 * m * (across**2 + upper**2) + 4 * m * L**2 / 12
            return bars + table * (2 * L * mp.cos(beta)) ** 2

        beta = mp.findroot(lambda u: mp.diff(potential, u), guess)
        return beta, mp.diff(potential, beta, 2) / inertia(beta)

    with mp.workdps(30):
        L = mp.mpf(L)
        drawn = mp.atan(mp.mpf(3) / 4)
        wide0 = L * mp.cos(drawn)
        # As beta grows by d the loads rise by cos(beta) d, the spring shortens by L sin(beta) d.
        tension = g * (2 * p["M"] + 4 * m) * mp.cos(drawn) / mp.sin(drawn)
        rest, square = at_rest(p["M"], drawn)
        loaded, square_loaded = at_rest(p["M"] + p["mc"], drawn - mp.mpf("0.08"))
        found = {
            "equilibrium[theta]": mp.chop(rest - drawn, 1e-15),
            "equilibrium[y]": mp.chop(2 * L * (mp.sin(rest) - mp.sin(drawn)), 1e-15),
            "frequency[1]": mp.sqrt(square) / (2 * mp.pi),
            "loaded: equilibrium[y]": 2 * L * (mp.sin(loaded) - mp.sin(drawn)),
            "loaded: omega[1]": mp.sqrt(square_loaded),
        }
    stable = {"stable": square > 0, "loaded: stable": square_loaded > 0}
    return {key: float(value) for key, value in found.items()} | stable
