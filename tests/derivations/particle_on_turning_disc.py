"""Newton in the fixed plane, written as complex numbers z = w exp(i Omega t), with the pull of the four springs.

At the centre the springs hold the particle alike in all directions, with the stiffness k0 of one direction, taken from
their forces by a numerical derivative. In the fixed plane it circles at the rate sqrt(k0/m), one way or the other;
seen from the disc, at that rate less or more the turning.
"""
from cmath import exp

import mpmath as mp


def answers(p):
    m, k, a, N, Omega = (p[n] for n in ("m", "k", "a", "N", "Omega"))

    def pull(u):
        """The force of the springs along the first pair on a particle displaced by u along it."""
        total = mp.mpf(0)
        for x, y in ((a, 0), (0, a), (-a, 0), (0, -a)):
            length = mp.hypot(x - u, y)
            total += (N + k * (length - a)) * (x - u) / length
        return total

    with mp.workdps(30):
        k0 = float(-mp.diff(pull, 0))

    def newton(q, v, a):
        """Force that is missing along the turning axes."""
        w, w1, w2 = (complex(part["u"], part["v"]) for part in (q, v, a))
        return m * (w2 + 2j * Omega * w1 - Omega**2 * w) + k0 * w

    def kinetic(q, v, t=0.7):
        rate = (complex(v["u"], v["v"]) + 1j * Omega * complex(q["u"], q["v"])) * exp(1j * Omega * t)
        return m * abs(rate) ** 2 / 2

    rest, along = {"u": 0.0, "v": 0.0}, {"u": 1.0, "v": 0.0}
    own = (k0 / m) ** 0.5
    return {
        "T": kinetic,
        "M[u,v]": newton(rest, rest, {"u": 0.0, "v": 1.0}).real,
        "G[u,v]": newton(rest, {"u": 0.0, "v": 1.0}, rest).real,
        "K[u,u]": newton(along, rest, rest).real,
        "equation[u]": lambda q, v, a: newton(q, v, a).real,
        "equation[v]": lambda q, v, a: newton(q, v, a).imag,
        "omega[1]": abs(own - Omega),
        "omega[2]": own + Omega,
    }
