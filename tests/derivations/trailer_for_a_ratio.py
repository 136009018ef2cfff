"""Sums and products of the squared frequencies (traces and determinants of the 2 x 2 dynamic matrix).

w1^2 + w2^2 = (k1 + k2)/m1 + k2/m2 and w1^2 w2^2 = k1 k2/(m1 m2). A ratio r of frequencies fixes (sum)^2/product =
(r + 1/r)^2; two frequencies fix both. Each leads to a quadratic.
"""
import numpy as np


def positive_roots(*coefficients):
    real = [float(root.real) for root in np.roots(coefficients) if abs(root.imag) < 1e-9 * abs(root)]
    return sorted(root for root in real if root > 0)


def answers(p):
    m1, k1, k2 = p["m1"], p["k1"], p["k2"]
    total = (k1 + k2) / m1
    squared = (3 + 1 / 3) ** 2
    light, heavy = positive_roots(total**2, 2 * total * k2 - squared * k1 * k2 / m1, k2**2)
    dynamic = np.array([[(k1 + k2) / m1, -k2 / m1], [-k2 / light, k2 / light]])
    values, vectors = np.linalg.eig(dynamic)
    first = vectors[:, np.argmin(values)]
    # 5 rad/s: (k1 + k2 - 25 m1)(k2 - 25 m2) = k2^2, linear in m2
    slow = (k2 - k2**2 / (k1 + k2 - 25 * m1)) / 25
    m2 = 300.0
    # with u = k2/m2, k1 = P m1 m2/k2: P m2/k2 + k2/m1 + k2/m2 = S, quadratic in k2
    S, P = 4.0**2 + 12.0**2, (4.0 * 12.0) ** 2
    links = positive_roots(1 / m1 + 1 / m2, -S, P * m2)
    walls = {P * m1 * m2 / link: link for link in links}
    one, two = sorted(walls)
    return {"m2": light, "m2[2]": heavy, "m2*m2[2]": light * heavy, "mode[1,y]": float(first[1] / first[0]),
            "slow: m2": slow, "springs: k1": one, "springs: k1[2]": two, "springs: k2": walls[one]}
