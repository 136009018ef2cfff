"""Moments about the hinge in the frame that moves along, the boom as particles m1/6, 2 m1/3, m1/6; complex
amplitudes.
"""
from cmath import phase
from math import sin


def answers(p):
    m1, m2, L, k, c, a, b, Y, Omega = (p[n] for n in ("m1", "m2", "L", "k", "c", "a", "b", "Y", "Omega"))
    particles = [(2 * m1 / 3, L / 2), (m1 / 6 + m2, L)]
    J = sum(m * x * x for m, x in particles)
    S = sum(m * x for m, x in particles)

    def moments(q, v, acc):
        frame = -Y * Omega**2 * sin(Omega * q["t"])
        return J * acc["phi"] + S * frame + c * b**2 * v["phi"] + k * a**2 * q["phi"]

    X = S * Y * Omega**2 / complex(k * a * a - J * Omega**2, c * b * b * Omega)
    return {
        "equation[phi]": moments,
        "amplitude(phi)": abs(X),
        "phase(phi)": -phase(X),
        "amplitude(weight.y - frame.y)": L * abs(X),
        "amplitude(s.force)": k * a * abs(X),
    }
