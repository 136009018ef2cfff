"""The motion from rest by Duhamel's integral in quadrature; the arrows are read off it: that of a part u of one
frequency and decay is u - i (u' + decay u)/frequency, the part that the rotor keeps up being an ansatz put into the
equation of motion and the free one the rest."""
from cmath import exp as turn
from math import exp, pi, sin, sqrt

from scipy.integrate import quad
from scipy.optimize import minimize_scalar


def arrows(p, c):
    """(arrow kept up, free arrow) at a time."""
    m, k, U, W = (p[n] for n in ("m", "k", "U", "Omega"))
    decay = c / (2 * m)
    w = sqrt(k / m - decay**2)

    def motion(t):
        def part(s):
            return U * W**2 * sin(W * s) * exp(-decay * (t - s)) / (m * w)
        x = quad(lambda s: part(s) * sin(w * (t - s)), 0, t, epsabs=1e-14, epsrel=1e-12, limit=400)[0]
        v = quad(lambda s: part(s) * (w * sin(w * (t - s) + pi / 2) - decay * sin(w * (t - s))), 0, t, epsabs=1e-14,
                 epsrel=1e-12, limit=400)[0]
        return x, v

    def pair(t):
        kept = U * W**2 / (k - m * W**2 + 1j * W * c) * turn(1j * (W * t - pi / 2))
        x, v = motion(t)
        x, v = x - kept.real, v - (1j * W * kept).real
        return kept, x - 1j * (v + decay * x) / w, 1j * W, 1j * w - decay
    return pair


def answers(p):
    still, damped = arrows(p, 0.0), arrows(p, 480.0)

    def envelope(pair, t, order=0):
        one, two, a, b = pair(t)
        return abs(one * a**order + two * b**order)

    def largest(pair, start, end, sense=1):
        found = minimize_scalar(lambda t: -sense * envelope(pair, t), bounds=(start, end), method="bounded",
                                options={"xatol": 1e-10})
        return found.x, -sense * found.fun

    w, W = sqrt(p["k"] / p["m"]), p["Omega"]
    beat = 2 * pi / (w - W)
    return {
        "beat_period(x)": beat,
        "amplitude(x)": abs(still(0.3)[0]),
        "max(envelope(x))": largest(still, 0.3 * beat, 0.7 * beat)[1],
        "min(envelope(x))": envelope(still, 0.0),
        "argmax(envelope(x))": beat / 2,
        "envelope(x)(0.2 s)": envelope(still, 0.2),
        "min(envelope(x'))": 0.0,
        "zero[2](envelope(x'))": beat,
        "envelope(x')(0.2 s)": envelope(still, 0.2, 1),
        "with a damper: final(envelope(x))": abs(damped(0.3)[0]),
        "with a damper: max(envelope(x))": largest(damped, 0.3 * beat, 0.7 * beat)[1],
        "with a damper: envelope(x)(1 s)": envelope(damped, 1.0),
    }
