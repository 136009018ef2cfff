"""det(K - w^2 M) = 0 of the deflections x^2 and x^3, their integrals by quadrature in mpmath."""
from mpmath import mpf, quad, sqrt


def answers(p):
    L, EI, mu = (mpf(p[n]) for n in ("L", "EI", "mu"))

    def entries(f, scale):
        return [[scale * quad(lambda x, i=i, j=j: f[i](x) * f[j](x), [0, L]) for j in (0, 1)] for i in (0, 1)]

    K = entries([lambda x: 2, lambda x: 6 * x], EI)
    M = entries([lambda x: x**2, lambda x: x**3], mu)
    a = M[0][0] * M[1][1] - M[0][1] ** 2
    b = K[0][0] * M[1][1] + K[1][1] * M[0][0] - 2 * K[0][1] * M[0][1]
    c = K[0][0] * K[1][1] - K[0][1] ** 2
    return {f"ritz[{i}]": sqrt((b + sign * sqrt(b**2 - 4 * a * c)) / (2 * a)) for i, sign in ((1, -1), (2, 1))}
