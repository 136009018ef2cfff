"""Forces along the path differenced; the period by quadrature between the turning points of the energy so cut off."""
from mpmath import cos, findroot, mp, mpf, pi, quad, sin, sqrt, taylor


def answers(p):
    with mp.workdps(40):
        m, k1, g1, k, length, a, A = (mpf(p[name]) for name in ("m", "k1", "g1", "k", "l", "a", "A"))

        def oblique(x):
            X, Y = length * cos(a) + x, length * sin(a)
            r = sqrt(X**2 + Y**2)
            return k * (r - length) * X / r

        _, c1, c2, c3 = taylor(oblique, 0, 3)
        linear, quadratic, cubic = k1 + 2 * c1, 2 * c2, g1 + 2 * c3

        def V(x):
            return linear * x**2 / 2 + quadratic * x**3 / 3 + cubic * x**4 / 4

        low = findroot(lambda x: (V(x) - V(A)) / (x - A), -A)
        mid, half = (A + low) / 2, (A - low) / 2

        def speed(u):
            """√(2 (V(A) − V(x))/m) over √((A − x)(x − low)), x = mid + half sin u."""
            x = mid + half * sin(u)
            b3 = cubic / 4
            b2 = quadratic / 3 + b3 * (A + low)
            b1 = linear / 2 + b2 * (A + low) - b3 * A * low
            return sqrt(2 * (b3 * x**2 + b2 * x + b1) / m)

        period = 2 * quad(lambda u: 1 / speed(u), [-pi / 2, 0, pi / 2])
        straight = k * cos(a)**2
        return {"stiffness_correction[above, x]": float(c1 - straight), "stiffness_correction[above, x^2]": float(c2),
                "stiffness_correction[above, x^3]": float(c3), "stiffness_correction[along, x^3]": 0.0,
                "V[x^2]": float(linear / 2), "period(x)": float(period)}
