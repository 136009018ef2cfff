"""Fourier: F/pi, F/2 of the sine, 2F/(pi (1 - n^2)) of the even cosines, none of the other odd ones; each through the
complex stiffness, the squares summed up."""
from math import pi, sqrt


def answers(p):
    m, k, c, F, T = (p[n] for n in ("m", "k", "c", "F", "T"))
    W = 2 * pi / T

    def through(n):
        return 1 / abs(complex(k - m * (n * W) ** 2, c * n * W))

    mean, one = F / pi / k, F / 2 * through(1)
    even = {n: 2 * F / (pi * (n * n - 1)) * through(n) for n in range(2, 4000, 2)}
    return {"mean(x)": mean, "harmonic[1](x)": one, "harmonic[2](x)": even[2], "harmonic[3](x)": 0,
            "rms(x)": sqrt(mean**2 + (one**2 + sum(x * x for x in even.values())) / 2)}
