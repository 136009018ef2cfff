"""The force along the path by the tension of a spring and its slope, its Taylor coefficients by differences."""
from mpmath import mp, mpf, sqrt, taylor


def answers(p):
    with mp.workdps(60):
        k1, k2, N, length = (mpf(p[name]) for name in ("k1", "k2", "N", "l"))

        def across(x):
            r = sqrt(length**2 + x**2)
            return (N + k2 * (r - length)) * x / r

        _, one, two, three = taylor(across, 0, 3)

    def motion(q, v, a):
        x = q["x"]
        return p["m"] * a["x"] + float(k1 + 2 * one) * x + 2 * float(three) * x**3

    return {"stiffness_correction[above, x]": float(one), "stiffness_correction[above, x^2]": float(two),
            "stiffness_correction[above, x^3]": float(three), "stiffness_correction[along, x]": 0.0,
            "stiffness_correction[along, x^3]": 0.0, "motion[x]": motion}
