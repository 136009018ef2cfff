"""1 + cos b cosh b = M/(mu L) b (sin b cosh b - cos b sinh b), divided by cosh b, in 30 digits."""
from mpmath import cos, cosh, findroot, mp, mpf, sin, sqrt, tanh


def answers(p):
    with mp.workdps(30):
        L, EI, mu, M = (mpf(p[n]) for n in ("L", "EI", "mu", "M"))
        ratio = M / (mu * L)
        b = [findroot(lambda x: 1 / cosh(x) + cos(x) - ratio * x * (sin(x) - cos(x) * tanh(x)), start)
             for start in (1.42, 4.11, 7.19)]
        omega = [x**2 / L**2 * sqrt(EI / mu) for x in b]
        lumped = sqrt(3 * EI / L**3 / (M + mpf(33) / 140 * mu * L))
        return {**{f"omega[{i}]": w for i, w in enumerate(omega, 1)},
                "sqrt(3*EI/L^3/(M + 33/140*mu*L))/omega[1] - 1": lumped / omega[0] - 1}
