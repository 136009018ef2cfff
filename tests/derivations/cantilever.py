"""cos b cosh b = -1; the shape cosh - cos - s (sinh - sin), s = (cosh b + cos b)/(sinh b + sin b), in 30 digits."""
from mpmath import cos, cosh, findroot, mp, mpf, pi, sin, sinh, sqrt


def answers(p):
    with mp.workdps(30):
        L, EI, mu = (mpf(p[n]) for n in ("L", "EI", "mu"))
        b = [findroot(lambda x: cos(x) + 1 / cosh(x), (n - mpf("0.5")) * pi) for n in range(1, 7)]
        s = (cosh(b[1]) + cos(b[1])) / (sinh(b[1]) + sin(b[1]))
        node = findroot(lambda x: cosh(x) - cos(x) - s * (sinh(x) - sin(x)), mpf("0.783") * b[1]) / b[1]
        return {**{f"omega[{i}]": x**2 / L**2 * sqrt(EI / mu) for i, x in enumerate(b[:3], 1)},
                "omega[6]/omega[1]": (b[5] / b[0]) ** 2, "node[2][arm, 1]": node * L, "node[2][arm, 1]/L": node}
