"""Complex amplitudes of the two equations by Cramer's rule at the frequencies where the amplitudes for no damper and
for a rigid one are equal and opposite, which are roots of a quadratic in the squared frequency.
"""
from math import sqrt


def answers(p):
    m1, k1, mu, c, F0 = (p[n] for n in ("m1", "k1", "mu", "c", "F0"))
    m2, k2 = mu * m1, mu * k1 / (1 + mu) ** 2

    def amplitude(W, c):
        link = complex(k2, c * W)
        a, d = k1 + link - m1 * W**2, link - m2 * W**2
        return abs(d / (a * d - link**2))

    # (k2 - m2 s)(k1 - (m1 + m2) s) + (k1 + k2 - m1 s)(k2 - m2 s) - k2^2 = 0, s the squared frequency
    a2 = m2 * (m1 + m2) + m1 * m2
    a1 = -(k2 * (m1 + m2) + m2 * k1) - (m2 * (k1 + k2) + m1 * k2)
    a0 = k1 * k2 + (k1 + k2) * k2 - k2**2
    root = sqrt(a1 * a1 - 4 * a2 * a0)
    low, high = (sqrt((-a1 + sign * root) / (2 * a2)) for sign in (-1, 1))
    return {
        "omega[1]*omega[2]": sqrt(k1 * k2 / (m1 * m2)),
        "abs(frf[x1, drive](wP))": amplitude(low, c),
        "abs(frf[x1, drive](wQ))": amplitude(high, c),
        "amplitude(x1)": F0 * amplitude(low, c),
        "stronger:amplitude(x1)": F0 * amplitude(high, 7 * c),
        "weaker:amplitude(x1)": F0 * amplitude(low, c / 9),
    }
