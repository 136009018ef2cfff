"""½ m (1 + (dy/dx)²) ẋ² and m g y + ½ k x², differenced with 40 digits."""
from math import factorial

from mpmath import diff, mp, mpf


def answers(p):
    with mp.workdps(40):
        m, a, k, g = (mpf(p[name]) for name in ("m", "a", "k", "g"))

        def height(x):
            return a * x**2

        def half_inertia(x):
            return m / 2 * (1 + diff(height, x)**2)

        def V(x):
            return m * g * height(x) + k * x**2 / 2

        assert abs(diff(half_inertia, mpf(0))) < mpf(10)**-12 and abs(diff(V, mpf(0), 4)) < mpf(10)**-6 * k
        return {"T[x'^2]": float(half_inertia(mpf(0))), "T[x^2*x'^2]": float(diff(half_inertia, mpf(0), 2)) / 2,
                "T[x*x'^2]": 0.0, "V[x^2]": float(diff(V, mpf(0), 2)) / factorial(2), "V[x^4]": 0.0}
