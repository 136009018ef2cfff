"""omega^2 = k/mu + (b/L)^4 EI/mu with cos b cosh b = 1, and b = 0 twice for the rigid motions."""
from mpmath import cos, cosh, findroot, mp, mpf, pi, sqrt


def answers(p):
    with mp.workdps(30):
        L, EI, mu, k = (mpf(p[n]) for n in ("L", "EI", "mu", "k"))
        b = [mpf(0), mpf(0), *(findroot(lambda x: cos(x) - 1 / cosh(x), (n + mpf("0.5")) * pi) for n in (1, 2))]
        bare = [(x / L) ** 4 * EI / mu for x in b]
        return {**{f"omega[{i}]": sqrt(k / mu + w) for i, w in enumerate(bare, 1)}, "omega[3]^2 - k/mu": bare[2]}
