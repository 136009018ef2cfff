"""Force coefficients of a wire by differences; the period of a Duffing oscillator by an elliptic integral."""
from mpmath import ellipk, mp, mpf, sqrt, taylor


def answers(p):
    with mp.workdps(40):
        m, k1, g1, k, N, length, A = (mpf(p[name]) for name in ("m", "k1", "g1", "k", "N", "l", "A"))

        def across(x):
            r = sqrt(length**2 + x**2)
            return (N + k * (r - length)) * x / r

        _, one, _, three = taylor(across, 0, 3)
        linear, cubic = k1 + 2 * one, g1 + 2 * three
        omega = sqrt((linear + cubic * A**2) / m)
        period = 4 * ellipk(cubic * A**2 / (2 * (linear + cubic * A**2))) / omega
        return {"stiffness_correction[above, x]": float(one), "stiffness_correction[above, x^3]": float(three),
                "stiffness_correction[along, x^3]": 0.0, "V[x^4]": float(cubic / 4), "period(x)": float(period)}
