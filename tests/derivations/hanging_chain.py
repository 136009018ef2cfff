"""u = J0(2 w sqrt(y/g)), y from the free end; J0(2 w sqrt(L/g)) = 0; the node of mode 2 is at 2 w sqrt(y/g) = j1."""
from mpmath import besseljzero, mp, mpf, sqrt


def answers(p):
    with mp.workdps(30):
        L, g = mpf(p["L"]), mpf(p["g"])
        j = [besseljzero(0, n) for n in (1, 2, 3)]
        return {**{f"omega[{n}]": z / 2 * sqrt(g / L) for n, z in enumerate(j, 1)},
                "node[2][chain, 1]": L - L * (j[0] / j[1]) ** 2}
