"""Moments about the point of contact, of which the roller turns by x/R: J = 3/2 m R², the spring's arm R, the dashpot's
2 R; then the damped free vibration from its start.
"""
from math import cos, exp, sin, sqrt


def answers(p):
    J, K, C = 1.5 * p["m"] * p["R"] ** 2, p["k"] * p["R"] ** 2, p["c"] * (2 * p["R"]) ** 2
    omega, delta = sqrt(K / J), C / (2 * J)
    rate = sqrt(omega**2 - delta**2)
    x0, v0, t = p["x0"], -p["v0"], 0.5
    weight = p["m"] * p["g"]
    return {
        "omega[1]": omega,
        "zeta[1]": delta / omega,
        "omega_d[1]": rate,
        "equilibrium[s.force]": weight * sin(p["alpha"]),
        "equilibrium[roller.normal]": weight * cos(p["alpha"]),
        "equilibrium[roller.friction]": 0.0,
        "x(0.5 s)": exp(-delta * t) * (x0 * cos(rate * t) + (v0 + delta * x0) / rate * sin(rate * t)),
    }
