"""Free fall from h, then a part of a harmonic motion about -m g/k that starts and ends with the speed sqrt(2 g h)."""

import mpmath


def answers(p):
    omega, v = mpmath.sqrt(p["k"] / p["m"]), mpmath.sqrt(2 * p["g"] * p["h"])
    rest = p["m"] * p["g"] / p["k"]
    depth = rest + mpmath.sqrt(rest**2 + (v / omega) ** 2)
    period = 2 * v / p["g"] + 2 / omega * (mpmath.pi - mpmath.atan(v * omega / p["g"]))
    return {"equilibrium[y]": -rest, "period(y)": period, "min(y)": -depth}
