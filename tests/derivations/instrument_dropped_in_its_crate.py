"""Stiffness of the sprung crate by second differences of the springs' energy, the sag by least energy in high
precision; the motion about the place of rest from the two initial values, its extremes by roots of its
derivatives.
"""
import mpmath as mp


def answers(p):
    with mp.workdps(30):
        m, k, b, c, h, g = (mp.mpf(repr(p[n])) for n in ("m", "k", "b", "c", "h", "g"))

        def energy(y):
            lengths = [mp.hypot(3 * b / 5, side * 4 * b / 5 - y) for side in (1, -1)]
            return sum(2 * k * (length - b) ** 2 / 2 for length in lengths) + m * g * y

        rest = mp.findroot(lambda y: mp.diff(energy, y), -m * g / (4 * k * mp.mpf("0.64")))
        stiffness = mp.diff(energy, rest, 2)
        w = mp.sqrt(stiffness / m)
        decay = c / (2 * m)
        wd = mp.sqrt(w * w - decay**2)
        v0 = -mp.sqrt(2 * g * h)

        def y(t):
            return rest + mp.exp(-decay * t) * (-rest * mp.cos(wd * t) + (v0 - decay * rest) / wd * mp.sin(wd * t))

        def acceleration(t):
            return -(c * mp.diff(y, t) + stiffness * (y(t) - rest)) / m

        quarter = mp.pi / 2 / wd
        lowest = mp.findroot(lambda t: mp.diff(y, t), (quarter / 2, 3 * quarter / 2), solver="anderson")
        hardest = mp.findroot(lambda t: mp.diff(acceleration, t), (quarter / 9, quarter), solver="anderson")
        out = {"zeta[1]": decay / w, "equilibrium[y]": rest, "omega[1]": w, "min(y)": y(lowest), "argmin(y)": lowest,
               "max(y'')": acceleration(hardest), "argmax(y'')": hardest}
        return {key: float(value) for key, value in out.items()}
