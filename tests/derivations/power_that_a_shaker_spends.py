"""The steady motion x = A sin + B cos from the two balances of the sine and cosine parts; every mean by quadrature over
one period of the forces and velocities themselves."""
from math import cos, pi, sin, sqrt

import numpy as np
from scipy.integrate import quad


def means(m, k, c, F, W):
    """Gives the mean of a function of (t, x, v, a)."""
    A, B = np.linalg.solve([[k - m * W**2, -c * W], [c * W, k - m * W**2]], [F, 0.0])
    size = sqrt(A * A + B * B)

    def mean(function):
        def value(turn):
            s, o = sin(turn), cos(turn)
            return function(turn, A * s + B * o, W * (A * o - B * s), -W * W * (A * s + B * o))
        return quad(value, 0, 2 * pi, epsabs=0, epsrel=1e-12, limit=200, points=[pi])[0] / (2 * pi)
    return mean, size


def answers(p):
    m, k, c, F, W = (p[n] for n in ("m", "k", "c", "F", "Omega"))
    mean, _ = means(m, k, c, F, W)
    spent = mean(lambda t, x, v, a: m * a * v + c * v * v + k * x * v)
    tuned, _ = means(m, k, c, F, sqrt(k / m))
    return {
        "mean(shaker.power)": spent,
        "mean(dashpot.power)": mean(lambda t, x, v, a: c * v * v),
        "mean(shaker.force*x')": spent,
        "rms(x)": sqrt(mean(lambda t, x, v, a: x * x)),
        "rms(x')": sqrt(mean(lambda t, x, v, a: v * v)),
        "mean(x''^2)": mean(lambda t, x, v, a: a * a),
        "mean(T)": mean(lambda t, x, v, a: m * v * v / 2),
        "mean(spring.energy)": mean(lambda t, x, v, a: k * x * x / 2),
        "mean(x^4)": mean(lambda t, x, v, a: x**4),
        "mean(spring.force*x')": 0.0,
        "rms(steady(shaker.power) - c*Omega^2*X^2/2)": sqrt(mean(lambda t, x, v, a: (F * sin(t) * v - spent) ** 2)),
        "at the natural frequency: mean(shaker.power)": tuned(lambda t, x, v, a: c * v * v),
        "at the natural frequency: mean(T) - mean(spring.energy)": 0.0,
    }
