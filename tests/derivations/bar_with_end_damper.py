"""u = sinh(sx/c0) e^(st), EA u' = -c u_t at the end:
tanh z = -1/r, z = sL/c0 = -ln((1+r)/(1-r))/2 + i pi (n - 1/2)."""
from math import hypot, log, pi, sqrt


def answers(p):
    L, speed, r = p["L"], sqrt(p["EA"] / p["mu"]), p["r"]
    decay, turns = log((1 + r) / (1 - r)) / 2 * speed / L, pi / 2 * speed / L
    return {"omega_d[1]": turns, "omega_d[2]": 3 * turns, "decay[1]": decay, "decay[2]": decay,
            "zeta[1]": decay / hypot(decay, turns)}
