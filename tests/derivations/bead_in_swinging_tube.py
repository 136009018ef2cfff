"""Newton-Euler: accelerations of compound motion (relative, Coriolis, transport), reactions eliminated.

Whole system along the track; tube and bead in moments about the hinge, which moves with the cart; the
bead along the tube, the spring pulling with m3 g + k2 s. Small motions: the slide is alone on k2; for the
cart and the turn the frequencies come from the 2 x 2 matrices written from unit accelerations of these
equations.
"""
from math import cos, sin, sqrt

import numpy as np


def balances(p, q, v, a):
    m1, m2, m3, L, b, k1, k2, g = (p[n] for n in ("m1", "m2", "m3", "L", "b", "k1", "k2", "g"))
    s, c = sin(q["phi"]), cos(q["phi"])
    down, across = np.array([s, -c]), np.array([c, s])
    cart = np.array([a["x"], 0.0])
    weight = np.array([0.0, g])
    rho, w = b + q["s"], v["phi"]
    tube = m2 * (cart + L / 2 * (a["phi"] * across - w**2 * down) + weight)
    relative = a["s"] * down + 2 * v["s"] * w * across
    bead = m3 * (cart + rho * (a["phi"] * across - w**2 * down) + relative + weight)
    spring = m3 * g + k2 * q["s"]
    track = m1 * a["x"] + tube[0] + bead[0] + k1 * q["x"]
    hinge = m2 * L**2 / 12 * a["phi"] + L / 2 * across @ tube + rho * across @ bead
    return {"x": float(track), "phi": float(hinge), "s": float(down @ bead + spring)}


def answers(p):
    m2, m3, L, b, k1, k2, g = (p[n] for n in ("m2", "m3", "L", "b", "k1", "k2", "g"))
    none = dict.fromkeys(("x", "phi", "s"), 0.0)
    rows = [balances(p, none, none, {**none, name: 1.0}) for name in ("x", "phi")]
    M = np.array([[row["x"], row["phi"]] for row in rows])
    K = np.diag([k1, (m2 * L / 2 + m3 * b) * g])
    lam = np.linalg.eigvals(np.linalg.solve(M, K)).real
    omega = sorted([sqrt(value) for value in lam] + [sqrt(k2 / m3)])
    out = {f"omega[{n}]": value for n, value in enumerate(omega, 1)}
    for name in none:
        out[f"motion[{name}]"] = lambda q, v, a, name=name: balances(p, q, v, a)[name]
    out["equilibrium[s]"] = 0.0
    return out
