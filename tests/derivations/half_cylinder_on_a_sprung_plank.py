"""The mass centre, 4r/(3 pi) below the centre of the circle, moves by x - r phi + e phi; its height by e phi^2/2."""
from math import pi, sqrt


def answers(p):
    m, r, M, k, g = (p[n] for n in ("m", "r", "M", "k", "g"))
    e = 4 * r / (3 * pi)
    a, b, d = M + m, -m * (r - e), m * (r - e) ** 2 + m * r * r / 2 - m * e * e
    s = m * g * e
    det = a * d - b * b
    mean, product = (a * s + d * k) / det, k * s / det
    root = sqrt(mean * mean / 4 - product)
    return {"M[x,phi]": b, "M[phi,phi]": d, "K[phi,phi]": s, "omega[1]": sqrt(mean / 2 - root),
            "omega[2]": sqrt(mean / 2 + root)}
