"""Pull of the spokes on the displaced hub, each unit displacement along an axis at a time; eigenvalues by Jacobi's
rotation.
"""
from math import atan2, cos, pi, sin, sqrt


def answers(p):
    spokes = [(p[f"k{i + 1}"], 2 * pi * i / 5) for i in range(5)]

    def pull(x, y):
        """The force that resists a small displacement: each spoke is stretched by the part along it."""
        stretches = [(k * (x * cos(f) + y * sin(f)), f) for k, f in spokes]
        return sum(F * cos(f) for F, f in stretches), sum(F * sin(f) for F, f in stretches)

    (xx, xy), (_, yy) = pull(1, 0), pull(0, 1)
    turn = atan2(2 * xy, xx - yy) / 2
    largest = sum(a * b for a, b in zip(pull(cos(turn), sin(turn)), (cos(turn), sin(turn)), strict=True))
    least = sum(a * b for a, b in zip(pull(-sin(turn), cos(turn)), (-sin(turn), cos(turn)), strict=True))
    return {"stiffness[hub].xx": xx, "stiffness[hub].xy": xy, "stiffness[hub].yy": yy, "stiffness[hub].max": largest,
            "stiffness[hub].min": least, "stiffness[hub].angle": turn, "omega[1]": sqrt(least / p["m"]),
            "omega[2]": sqrt(largest / p["m"])}
