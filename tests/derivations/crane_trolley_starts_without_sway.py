"""Moments about the accelerated pin, the fictitious force -m a; Duhamel's integral of the constant acceleration."""
from math import cos, pi, sin, sqrt

from scipy.integrate import quad


def answers(p):
    m1, m2, L, J, a, g = (p[n] for n in ("m1", "m2", "L", "J", "a", "g"))
    inertia = m1 * L**2 / 12 + m1 * L**2 / 4 + m2 * L**2 + J
    weight = m1 * g * L / 2 + m2 * g * L
    w = sqrt(weight / inertia)

    def phi(u, length, function=sin):
        """At the time u/w, of an acceleration that lasts length/w; with cos: the rate divided by w."""
        value = -a / g * quad(lambda s: function(u - s), 0, min(u, length), epsabs=1e-13)[0]
        return 0.0 if abs(value) < 1e-12 * a / g else value

    whole, half = 2 * pi, pi
    grid = [i * pi / 200 for i in range(801)]
    return {
        "omega[1]": w,
        "min(phi)": min(phi(u, whole) for u in grid),
        "phi(t1/2)": phi(pi, whole),
        "phi(t1)": phi(2 * pi, whole),
        "phi(5*t1/4)": phi(5 * pi / 2, whole),
        "load.x(t1)": a * (whole / w) ** 2 / 2 + L * phi(whole, whole),
        "phi'(t1/4)": w * phi(pi / 2, whole, cos),
        "half:phi(t1)": phi(pi, half),
        "half:max(phi)": max(phi(u, half) for u in grid),
        "half:phi(3*t1/2)": phi(3 * pi / 2, half),
        "half:load.x(t1)": a * (half / w) ** 2 / 2 + L * phi(half, half),
    }
