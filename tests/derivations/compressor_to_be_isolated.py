"""Amplitude and force ratio written in squares give quadratics for the whole stiffness S; their positive roots, the
lower one of the two for the amplitude (below resonance frequency of the drive).
"""
from math import hypot, sqrt


def answers(p):
    m, c, F0, W = (p[n] for n in ("m", "c", "F0", "Omega"))
    loss = 4 * c * W
    inertial = m * W**2

    # (S^2 + loss^2) 100 = (S - inertial)^2 + loss^2
    S = (-2 * inertial + sqrt(4 * inertial**2 + 4 * 99 * (inertial**2 - 99 * loss**2))) / (2 * 99)

    def passed(S, W):
        return hypot(S, 4 * c * W) / hypot(S - m * W**2, 4 * c * W)

    assert abs(passed(S, W) - 0.1) < 1e-12
    # (S - inertial)^2 + loss^2 = (F0/1 mm)^2
    soft = inertial - sqrt((F0 / 1e-3) ** 2 - loss**2)
    return {
        "k": S / 4,
        "omega[1]": sqrt(S / m),
        "zeta[1]": 4 * c / (2 * sqrt(S * m)),
        "amplitude(y)": F0 / hypot(S - inertial, loss),
        "amplitude(ground.force)": F0 * passed(S, W),
        "transmissibility[ground.force, drive](2*Omega)": passed(S, 2 * W),
        "soft:k": soft / 4,
        "soft:transmissibility[ground.force, drive](Omega)": passed(soft, W),
    }
