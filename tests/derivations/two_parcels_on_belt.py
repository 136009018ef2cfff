"""Newton for each parcel; at rest the coupling spring carries the drag on the second parcel, the tie that on both.

Decay: with exp(s t) the impedances Z1 = m1 s^2 + c1 s + k1 + k2 and Z2 = m2 s^2 + c2 s + k2 give Z1 Z2 = k2^2, a
quartic, solved in 30 digits; the speed of the belt is not in it.
"""
from mpmath import im, mp, mpf, polyroots, re


def answers(p):
    m1, m2, k1, k2, c1, c2, v0 = (p[n] for n in ("m1", "m2", "k1", "k2", "c1", "c2", "v0"))

    def first(q, v, a):
        drag, tie, coupling = c1 * (v0 - v["x1"]), k1 * q["x1"], k2 * (q["x2"] - q["x1"])
        return m1 * a["x1"] - (drag - tie + coupling)

    def second(q, v, a):
        return m2 * a["x2"] - (c2 * (v0 - v["x2"]) - k2 * (q["x2"] - q["x1"]))

    drag1, drag2 = c1 * v0, c2 * v0
    rest, moving = {"x1": 0.0, "x2": 0.0}, {"x1": 1.0, "x2": 0.0}
    still = first(rest, rest, rest)
    with mp.workdps(30):
        M1, M2, C1, C2, K1, K2 = (mpf(x) for x in (m1, m2, c1, c2, k1 + k2, k2))
        quartic = [M1 * M2, M1 * C2 + M2 * C1, M1 * K2 + M2 * K1 + C1 * C2, C1 * K2 + C2 * K1, K1 * K2 - K2**2]
        pairs = sorted((s for s in polyroots(quartic, maxsteps=200, extraprec=60) if im(s) > 0), key=abs)
        zeta, omega_d = [float(-re(s) / abs(s)) for s in pairs], [float(im(s)) for s in pairs]
    return {
        "motion[x1]": first,
        "motion[x2]": second,
        "equilibrium[x1]": (drag1 + drag2) / k1,
        "equilibrium[x2]": (drag1 + drag2) / k1 + drag2 / k2,
        "C[x1,x1]": first(rest, moving, rest) - still,
        "C[x1,x2]": first(rest, {"x1": 0.0, "x2": 1.0}, rest) - still,
        "zeta[1]": zeta[0],
        "zeta[2]": zeta[1],
        "omega_d[1]": omega_d[0],
        "omega_d[2]": omega_d[1],
        "belt at rest: equilibrium[x2]": 0.0,
        "belt at rest: zeta[1]": zeta[0],
    }
