"""V = 2 (N (s − l) + ½ k (s − l)²), s² = l² + x², in powers of x by the binomial series."""
from sympy import series, sqrt, symbols


def answers(p):
    x, l, k, N = (symbols(name, positive=True) for name in "xlkN")
    s = sqrt(l**2 + x**2)
    V = series(2 * (N * (s - l) + k * (s - l)**2 / 2), x, 0, 7).removeO().expand()
    at = {k: p["k"], l: p["l"], N: p["N"]}
    V2, V3, V4, V6 = (float(V.coeff(x, n).subs(at)) for n in (2, 3, 4, 6))
    return {"2*V[x^2]": 2 * V2, "4*V[x^4]": 4 * V4, "V[x^3]": V3, "V[x^6]": V6}
