"""The forces along the path of a spring behind and of one ahead, their Taylor coefficients by differences."""
from mpmath import cos, mp, mpf, sin, sqrt, taylor


def answers(p):
    with mp.workdps(60):
        k, N, length, a = (mpf(p[name]) for name in ("k", "N", "l", "a"))

        def pull(X):
            """The force along the path of a spring whose free end is X behind."""
            def force(x):
                r = sqrt((X + x)**2 + (length * sin(a))**2)
                return (N + k * (r - length)) * (X + x) / r
            return taylor(force, 0, 3)

        behind, ahead = pull(length * cos(a)), pull(-length * cos(a))
        linear, cubic = (2 * (behind[n] + ahead[n]) for n in (1, 3))

    def motion(q, v, acceleration):
        return p["m"] * acceleration["x"] + float(linear) * q["x"] + float(cubic) * q["x"]**3

    return {"V[x^2]": float(linear / 2), "V[x^3]": float(behind[2] + ahead[2]) * 2 / 3,
            "stiffness_correction[s1, x]": float(behind[1] - k * cos(a)**2),
            "stiffness_correction[s1, x^3]": float(behind[3]), "motion[x]": motion}
