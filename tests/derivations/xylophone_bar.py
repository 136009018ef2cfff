"""cos b cosh b = 1 between free ends; the first shape: cos z + cos(b/2)/cosh(b/2) cosh z, z = b (x/L - 1/2)."""
from mpmath import cos, cosh, findroot, mp, mpf, pi, sqrt


def answers(p):
    with mp.workdps(30):
        L, h, E, rho = (mpf(p[n]) for n in ("L", "h", "E", "rho"))
        b = [findroot(lambda x: cos(x) - 1 / cosh(x), (n + mpf("0.5")) * pi) for n in (1, 2, 3)]
        r = cos(b[0] / 2) / cosh(b[0] / 2)
        place = findroot(lambda z: cos(z) + r * cosh(z), mpf("1.3")) / b[0]
        tone = b[0] ** 2 / L**2 * sqrt(E * h**2 / 12 / rho) / (2 * pi)
        return {"frequency[3]": tone, "node[3][bar, 1]/L": mpf("0.5") - place, "node[3][bar, 2]/L": mpf("0.5") + place,
                "omega[4]/omega[3]": (b[1] / b[0]) ** 2, "omega[5]/omega[3]": (b[2] / b[0]) ** 2}
