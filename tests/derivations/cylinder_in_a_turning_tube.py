"""The turn of the cylinder from the equal velocities at the contact, r phi' = R theta' - (R - r) chi', by the swing chi
of the line of centres in space; then chi = theta + psi."""
from math import sqrt


def answers(p):
    m, r, R, J, kt, g = (p[n] for n in ("m", "r", "R", "J", "kt", "g"))
    c = R - r
    J1, J12, J2 = J + m * R * R / 2, -m * R * c / 2, 3 * m * c * c / 2
    a, b, d = J1 + 2 * J12 + J2, J12 + J2, J2
    s = m * g * c
    det = a * d - b * b
    mean, product = (a * s + d * (kt + s) - 2 * b * s) / det, kt * s / det
    root = sqrt(mean * mean / 4 - product)
    return {"M[theta,theta]": a, "M[theta,psi]": b, "M[psi,psi]": d, "K[psi,psi]": s,
            "omega[1]": sqrt(mean / 2 - root), "omega[2]": sqrt(mean / 2 + root)}
