"""Two free bodies: moments about the hinge and about the disc's pin.

The disc's weight and inertia as a particle belong to the rod's moment equation; the disc turns about its
own centre under the torsion spring alone. Its mode obeys theta = phi/(1 - (omega/omega_disc)^2), and the
frequencies are found by bisection of the remaining moment between the poles of this ratio.
"""
from math import sqrt


def bisect(f, low, high):
    sign = f(low) > 0
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if (f(middle) > 0) == sign else (low, middle)
    return (low + high) / 2


def answers(p):
    m1, m2, L, r, kt, g = (p[n] for n in ("m1", "m2", "L", "r", "kt", "g"))
    inertia = m1 * L**2 / 12 + m1 * (L / 2) ** 2 + m2 * L**2
    weight = m1 * g * L / 2 + m2 * g * L
    Jd = m2 * r**2 / 2
    pole = kt / Jd

    def rod(q, v, a):
        return inertia * a["phi"] + weight * q["phi"] - kt * (q["theta"] - q["phi"])

    def disc(q, v, a):
        return Jd * a["theta"] + kt * (q["theta"] - q["phi"])

    def moment(lam):
        theta = pole / (pole - lam)
        return weight - inertia * lam - kt * (theta - 1)

    eps = 1e-9
    low = bisect(moment, 0.0, pole * (1 - eps))
    top = pole + weight / inertia + kt / inertia
    high = bisect(moment, pole * (1 + eps), top)
    return {
        "equation[phi]": rod,
        "equation[theta]": disc,
        "omega[1]": sqrt(low),
        "omega[2]": sqrt(high),
        "mode[1][theta]": pole / (pole - low),
    }
