"""The force of the spring inverted by squaring, its slope by a central difference of 40 digits."""
from mpmath import diff, mp, mpf, pi, sqrt


def answers(p):
    with mp.workdps(40):
        a, m, F = (mpf(p[n]) for n in ("a", "m", "F"))
        x = (F / a) ** 2
        omega = sqrt(diff(lambda d: a * sqrt(d), x) / m)
        return {"equilibrium[x]": float(x), "equilibrium[s.force]": float(a * sqrt(x)), "omega[1]": float(omega),
                "period[1]": float(2 * pi / omega)}
