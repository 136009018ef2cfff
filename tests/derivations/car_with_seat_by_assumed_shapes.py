"""Energies of the two motions in which the driver moves with the floor, written out; exact ones by the determinant.

Bounce Y and pitch P with the driver at the floor: y = Y, phi = P, z = Y + s P, so that the seat is not strained:
2T = (m + m3) Y'^2 + 2 m3 s Y'P' + (J + m3 s^2) P'^2 and 2V = k1 (Y - a P)^2 + k2 (Y + b P)^2, a quadratic for omega^2.
With the driver free det(K - omega^2 M) is a cubic.
"""
from mpmath import mp, mpf, polyroots, sqrt


def answers(p):
    with mp.workdps(40):
        m, J, m3, k1, k2, k3, a, b, s = (mpf(repr(p[name])) for name in "m J m3 k1 k2 k3 a b s".split())
        yy, yp, pp = k1 + k2, k2 * b - k1 * a, k1 * a**2 + k2 * b**2
        tied = roots(((m + m3) * (J + m3 * s**2) - (m3 * s) ** 2,
                      2 * m3 * s * yp - (m + m3) * pp - (J + m3 * s**2) * yy, yy * pp - yp**2))
        # rows y, phi, z of K - x M; expanded along z, in powers of x
        Y, P, Z, c = (-m, yy + k3), (-J, pp + k3 * s**2), (-m3, k3), yp + k3 * s
        free = add(product(product(Y, P), Z), scaled(Z, -(c**2)), scaled(Y, -((k3 * s) ** 2)), scaled(P, -(k3**2)),
                   (2 * c * k3 * s * k3,))
        exact = roots(free)
        return {f"{name}[{i + 1}]": float(found[i]) for name, found in (("ritz", tied), ("omega", exact))
                for i in range(2)}


def roots(coefficients):
    """The frequencies, in ascending order."""
    return sorted(sqrt(root.real) for root in polyroots(coefficients, maxsteps=200, extraprec=200))


def product(one, two):
    found = [mpf(0)] * (len(one) + len(two) - 1)
    for i, x in enumerate(one):
        for j, y in enumerate(two):
            found[i + j] += x * y
    return found


def scaled(one, factor):
    return [factor * x for x in one]


def add(*polynomials):
    longest = max(map(len, polynomials))
    return [sum(column) for column in zip(*([mpf(0)] * (longest - len(one)) + list(one) for one in polynomials),
                                          strict=True)]
