"""The power that a unit velocity in each direction loses, P(f) = Σ c cos²(f − fᵢ): a circle in the double angle, found
from three of its points.
"""
from math import atan2, cos, hypot, pi


def answers(p):
    dashpots = [(p["c1"], pi), (p["c2"], p["a"]), (p["c3"], p["b"])]

    def power(f):
        return sum(c * cos(f - g) ** 2 for c, g in dashpots)

    middle = (power(0) + power(pi / 2)) / 2
    east, north = power(0) - middle, power(pi / 4) - middle
    found = {"max": middle + hypot(east, north), "min": middle - hypot(east, north), "angle": atan2(north, east) / 2,
             "xx": power(0), "yy": power(pi / 2), "xy": north}
    return {f"damping[float].{part}": value for part, value in found.items()}
