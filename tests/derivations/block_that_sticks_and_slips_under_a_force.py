"""From rest to rest: where it sticks until |F sin - k x| = R, and where it slips the exact motion under F sin and a
constant R, the ends of both by bisection."""
from math import copysign, cos, sin, sqrt

import numpy as np
from scipy.optimize import brentq

END, GRID = 4.0, 40001


def answers(p):
    m, k, R, F, Omega = (p[n] for n in ("m", "k", "R", "F", "Omega"))
    w, B = sqrt(k / m), F / (k - m * Omega**2)
    t, x, v = 0.0, 0.0, 0.0
    while t < END:
        start = first(lambda s, x=x: abs(F * sin(Omega * s) - k * x) - R, t, END)
        if start is None:
            break
        side = copysign(1, F * sin(Omega * start) - k * x)
        place = -side * R / k
        C, D = x - place - B * sin(Omega * start), -B * Omega * cos(Omega * start) / w

        def moved(s, place=place, C=C, D=D, start=start):
            return place + B * sin(Omega * s) + C * cos(w * (s - start)) + D * sin(w * (s - start))

        def rate(s, C=C, D=D, start=start):
            return B * Omega * cos(Omega * s) + w * (D * cos(w * (s - start)) - C * sin(w * (s - start)))

        stop = first(lambda s, side=side, rate=rate: -side * rate(s), start + 1e-3, END)
        t = END if stop is None else stop
        x, v = moved(t), rate(t) if stop is None else 0.0
    return {"x(4 s)": x, "x'(4 s)": v}


def first(rising, start, end):
    """Where a function of the time first passes zero upwards, at its start where it is positive there."""
    if rising(start) > 1e-9:
        return start
    grid = np.linspace(start, end, GRID)
    at = next((i for i in range(1, GRID) if rising(grid[i]) > 0), None)
    return None if at is None else brentq(rising, grid[at - 1], grid[at], xtol=1e-14)
