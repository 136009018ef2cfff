"""Newton along the wire for z = w exp(i Omega t), w = e + r exp(i s/r), with the pull of the spring towards O.

The rest beside the farthest point is where the spring alone can carry the bead round, k (rho - l0) = m Omega^2 rho;
it is found on the wire by bisection of the force along it. Stiffnesses are slopes of this force at 30 digits.
"""
import mpmath as mp


def answers(p):
    r, e, m, k, l0 = (p[n] for n in ("r", "e", "m", "k", "l0"))

    def place(s):
        return e + r * mp.exp(1j * s / r)

    def along(Omega, s, s1=0.0, s2=0.0):
        """m times the acceleration along the wire, less the pull along it."""
        w, tangent = place(s), 1j * mp.exp(1j * s / r)
        rate, change = tangent * s1, tangent * s2 - mp.exp(1j * s / r) * s1**2 / r
        acceleration = change + 2j * Omega * rate - Omega**2 * w
        pull = -k * (abs(w) - l0) * w / abs(w)
        return mp.re((m * acceleration - pull) * mp.conj(tangent))

    fast, slow = p["Omega"], 12.0
    with mp.workdps(30):
        aside = mp.findroot(lambda s: along(slow, s), (0.3, 0.6), solver="anderson", tol=1e-40)
        stiffness = mp.diff(lambda s: along(fast, s), 0)
        falling = mp.diff(lambda s: along(slow, s), 0)
        beside = mp.diff(lambda s: along(slow, s), aside)
    return {
        "V": lambda q: float(k * (abs(place(q["s"])) - l0) ** 2 / 2),
        "motion[s]": lambda q, v, a: float(along(fast, q["s"], v["s"], a["s"])),
        "equilibrium[s]": 0.0,
        "K[s,s]": float(stiffness),
        "omega[1]": float(mp.sqrt(stiffness / m)),
        "half the rate, farthest point: stable": falling > 0,
        "half the rate, farthest point: growth_rate[1]": float(mp.sqrt(-falling / m)),
        "half the rate, at rest beside it: equilibrium[s]": float(aside),
        "half the rate, at rest beside it: stable": beside > 0,
        "half the rate, at rest beside it: omega[1]": float(mp.sqrt(beside / m)),
    }
