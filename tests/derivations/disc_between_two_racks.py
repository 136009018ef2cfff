"""Velocities at the two ends of a diameter: the disc's centre goes with their mean, its rim with half their difference.

Energies are those of three bodies one by one; entries of the matrices by polarisation, E(a + b) - E(a) - E(b).
"""


def answers(p):
    m, M, r, k, k1 = (p[n] for n in ("m", "M", "r", "k", "k1"))

    def kinetic(u, w):
        centre, spin = (u + w) / 2, (u - w) / (2 * r)
        return M * u**2 / 2 + M * w**2 / 2 + m * centre**2 / 2 + (m * r**2 / 2) * spin**2 / 2

    def potential(u, w):
        return k * ((u + w) / 2) ** 2 / 2 + k1 * w**2 / 2

    def mixed(of):
        return of(1, 1) - of(1, 0) - of(0, 1)

    return {
        "T": lambda q, v: kinetic(v["x1"], v["x2"]),
        "V": lambda q: potential(q["x1"], q["x2"]),
        "M[x1,x1]": 2 * kinetic(1, 0), "M[x1,x2]": mixed(kinetic),
        "K[x1,x2]": mixed(potential), "K[x2,x2]": 2 * potential(0, 1),
    }
