"""Balance of moments about the hinge, solved by fixed-point iteration; linearised by hand.

At rest kt phi = -(m g L/2) cos(phi): iterated as phi <- -(m g L/2/kt) cos(phi), a contraction here. A
small turn changes the weight's moment by (m g L/2) sin(phi), so the stiffness is kt - (m g L/2) sin(phi),
more than kt because the boom hangs. Inertia: m L^2/12 + m(L/2)^2.
"""
from math import cos, sin, sqrt


def answers(p):
    m, L, kt, ct, g = (p[n] for n in ("m", "L", "kt", "ct", "g"))
    J = m * L**2 / 12 + m * (L / 2) ** 2
    moment = m * g * L / 2
    phi = 0.0
    for _ in range(200):
        phi = -moment / kt * cos(phi)
    K = kt - moment * sin(phi)
    wn, decay = sqrt(K / J), ct / (2 * J)
    return {
        "motion[phi]": lambda q, v, a: (
            J * a["phi"] + ct * v["phi"] + kt * q["phi"] + moment * cos(q["phi"])
        ),
        "equilibrium[phi]": phi,
        "zeta[1]": decay / wn,
        "omega_d[1]": sqrt(wn**2 - decay**2),
    }
