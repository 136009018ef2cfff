"""Least potential energy and its second differences in 50 digits, and differences of the frequencies by each parameter.

V = k (|r| - l)^2/2 + m g y about the place of rest that Newton's method finds anew for every changed value.
"""
from mpmath import diff, findroot, matrix, mp, mpf, sqrt


def answers(p):
    with mp.workdps(50):
        exact = {name: mpf(repr(value)) for name, value in p.items()}
        out = {"equilibrium[y]": float(rest(exact) + exact["l"])}
        for i in (1, 2):
            out[f"omega[{i}]"] = float(omega(exact, i))
        for i, name in ((1, "k"), (1, "m"), (1, "l"), (1, "g"), (2, "k"), (2, "l")):
            rate = diff(lambda value, i=i, name=name: omega(exact | {name: value}, i), exact[name], h=mpf(10) ** -15)
            out[f"sensitivity[{i},{name}]"] = float(rate) if abs(rate) > 1e-20 else 0.0
        return out


def energy(p, x, y):
    return p["k"] * (sqrt(x * x + y * y) - p["l"]) ** 2 / 2 + p["m"] * p["g"] * y


def rest(p):
    """The height of rest below the hook."""
    return findroot(lambda y: p["k"] * (y + p["l"]) + p["m"] * p["g"], -p["l"])


def omega(p, i):
    y, h = rest(p), mpf(10) ** -12
    across = (energy(p, h, y) - 2 * energy(p, 0, y) + energy(p, -h, y)) / h**2
    along = (energy(p, 0, y + h) - 2 * energy(p, 0, y) + energy(p, 0, y - h)) / h**2
    return sqrt(matrix(sorted([across, along]))[i - 1] / p["m"])
