"""Work and energy from one turning point to the next: weight, spring and friction over the way between them; it rests
where the friction can hold it.
"""
from math import cos, pi, sin, sqrt


def answers(p):
    m, k, g = p["m"], p["k"], p["g"]
    weight, most = m * g * sin(p["alpha"]), p["mu"] * m * g * cos(p["alpha"])
    places, times, half = [0.0], 0, pi * sqrt(m / k)
    while True:
        here = places[-1]
        pull = weight - k * here
        if abs(pull) <= most:
            break
        # ½ k (there² − here²) = (weight ∓ friction)(there − here)
        places.append(2 * (weight - most * (1 if pull > 0 else -1)) / k - here)
        times += 1
    return {
        "max(u)": max(places),
        "argmax(u)": half,
        "u(2 s)": places[-1],
        "zero[2](u')": half,
        "k*u(2 s)": k * places[-1],
    }
