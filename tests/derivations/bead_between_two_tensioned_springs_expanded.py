"""Energy of the two springs as a series in x by differences in 40 digits."""
from mpmath import mp, mpf, sqrt, taylor


def answers(p):
    with mp.workdps(40):
        length, k, N = (mpf(p[name]) for name in "lkN")

        def V(x):
            stretch = sqrt(length**2 + x**2) - length
            return 2 * (N * stretch + k * stretch**2 / 2)

        factors = [float(c) for c in taylor(V, 0, 6)]
        assert abs(factors[3]) < 1e-12 * factors[2] / p["l"]
        return {"2*V[x^2]": 2 * factors[2], "4*V[x^4]": 4 * factors[4], "V[x^3]": 0.0, "V[x^6]": factors[6]}
