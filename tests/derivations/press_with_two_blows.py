"""Place of rest by least energy of the mounts in 30 digits; each blow starts a decaying sine (impulse response),
their sum searched on both sides of the second blow for its extremes.
"""
import mpmath as mp


def answers(p):
    with mp.workdps(30):
        m, k, b, c, S1, S2, t1, t2, g = (mp.mpf(repr(p[n])) for n in ("m", "k", "b", "c", "S1", "S2", "t1", "t2", "g"))

        def energy(y):
            length = mp.hypot(4 * b / 5, 3 * b / 5 + y)
            return 2 * k * (length - b) ** 2 / 2 + m * g * y

        rest = mp.findroot(lambda y: mp.diff(energy, y), -m * g / (2 * k * mp.mpf("0.36")))
        stiffness = mp.diff(energy, rest, 2)
        decay = c / (2 * m)
        wd = mp.sqrt(stiffness / m - decay**2)

        def y(t):
            blows = [(S, t - start) for S, start in ((S1, t1), (S2, t2)) if t > start]
            return rest - sum(S / (m * wd) * mp.exp(-decay * s) * mp.sin(wd * s) for S, s in blows)

        def rate(t):
            return mp.diff(y, t, h=mp.mpf("1e-12"))

        grid = [t1 + mp.mpf(i) / 250 + mp.mpf("1e-7") for i in range(100)]
        turning = [mp.findroot(rate, (grid[i], grid[i + 1]), solver="anderson") for i in range(99)
                   if rate(grid[i]) * rate(grid[i + 1]) < 0 and not grid[i] <= t2 <= grid[i + 1]]
        low, high = min([*turning, t2], key=y), max([*turning, t2], key=y)
        out = {"equilibrium[y]": rest, "K[y,y]": stiffness, "zeta[1]": decay / mp.sqrt(stiffness / m),
               "y(0.1 s)": y(mp.mpf("0.1")), "min(y)": y(low), "argmin(y)": low, "max(y)": y(high),
               "y'(0.3 s)": rate(mp.mpf("0.3"))}
        return {key: float(value) for key, value in out.items()}
