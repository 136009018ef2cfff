"""Newton in the fixed plane for z = w exp(i Omega t), turned back into the axes of the shaft; weight along -i.

With w = u + i v and exp(s t) in both, (k1 + m (s^2 - Omega^2)) (k2 + m (s^2 - Omega^2)) + 4 m^2 Omega^2 s^2 = 0: a
quadratic for s^2, whose roots are negative and real where the rotor runs safely.
"""
from cmath import exp, sqrt


def answers(p):
    m, k1, k2, g = (p[n] for n in ("m", "k1", "k2", "g"))

    def newton(Omega, q, v, a, weight=g):
        w, w1, w2 = (complex(part["u"], part["v"]) for part in (q, v, a))
        spring = complex(k1 * q["u"], k2 * q["v"])
        load = -1j * m * weight * exp(-1j * Omega * q["t"])
        return m * (w2 + 2j * Omega * w1 - Omega**2 * w) + spring - load

    def squares(Omega):
        """s^2 of both modes, the slower one first."""
        A, B = k1 - m * Omega**2, k2 - m * Omega**2
        b = m * (A + B) + 4 * m**2 * Omega**2
        root = sqrt(b * b - 4 * m**2 * A * B)
        return sorted(((-b + root) / (2 * m * m), (-b - root) / (2 * m * m)), key=abs)

    def safe(Omega):
        return all(abs(x.imag) < 1e-9 * abs(x) and x.real < 0 for x in squares(Omega))

    Omega = p["Omega"]
    rest, across = {"u": 0.0, "v": 0.0, "t": 0.0}, {"u": 0.0, "v": 1.0}
    out = {
        "equation[u]": lambda q, v, a: newton(Omega, q, v, a).real,
        "equation[v]": lambda q, v, a: newton(Omega, q, v, a).imag,
        "G[u,v]": newton(Omega, rest, across, rest, weight=0.0).real,
        "equilibrium[u]": 0.0,
        "equilibrium[v]": 0.0,
        "stable": safe(Omega),
        "between the critical speeds: K[u,u]": newton(80.0, {"u": 1.0, "v": 0.0, "t": 0.0}, rest, rest, 0.0).real,
        "between the critical speeds: K[v,v]": newton(80.0, {"u": 0.0, "v": 1.0, "t": 0.0}, rest, rest, 0.0).imag,
        "between the critical speeds: stable": safe(80.0),
        "between the critical speeds: growth_rate[1]": max(sqrt(x).real for x in squares(80.0)),
        "above both: stable": safe(120.0),
    }
    for prefix, speed in (("", Omega), ("above both: ", 120.0)):
        for i, x in enumerate(squares(speed), 1):
            out[f"{prefix}omega[{i}]"] = abs(sqrt(x))
    return out
