"""Newton along the plank for the disc, and the moments about the hinge on plank and disc together.

The disc's centre is at z = (s + i r) exp(i theta). It turns by theta - s/r; the friction that turns it also pushes it
along the plank. At rest both equations are linear in small displacements: frequencies by the quadratic equation.
"""
from cmath import exp, sqrt


def answers(p):
    M, L, m, r, kt, k, g = (p[n] for n in ("M", "L", "m", "r", "kt", "k", "g"))
    J, own = M * L**2 / 12, m * r**2 / 2

    def acceleration(q, v, a):
        """Of the centre of the disc, along the plank and across it."""
        w = complex(q["s"], r)
        return a["s"] + 2j * v["theta"] * v["s"] + (1j * a["theta"] - v["theta"] ** 2) * w

    def along(q, v, a):
        friction = own * (a["theta"] - a["s"] / r) / r
        weight = (-1j * m * g * exp(-1j * q["theta"])).real
        return m * acceleration(q, v, a).real - friction - weight + k * q["s"]

    def about_hinge(q, v, a, kt=kt):
        arm = complex(q["s"], r)
        orbital = (arm.conjugate() * m * acceleration(q, v, a)).imag
        weight = -m * g * (arm * exp(1j * q["theta"])).real
        return J * a["theta"] + orbital + own * (a["theta"] - a["s"] / r) + kt * q["theta"] - weight

    def kinetic(q, v):
        speed = abs(v["s"] + 1j * v["theta"] * complex(q["s"], r))
        return (J * v["theta"] ** 2 + m * speed**2 + own * (v["theta"] - v["s"] / r) ** 2) / 2

    def squares(kt):
        # Displaced by theta the disc's weight turns the plank with m g r theta, displaced by s with -m g s.
        a11, a12, a22 = J + m * r**2 + own, -(m * r + own / r), m + own / r**2
        k11, k12, k22 = kt - m * g * r, m * g, k
        A, B, C = a11 * a22 - a12**2, a11 * k22 + a22 * k11 - 2 * a12 * k12, k11 * k22 - k12**2
        root = sqrt(B * B - 4 * A * C)
        return (B - root) / (2 * A), (B + root) / (2 * A)

    rest, step = {"theta": 0.0, "s": 0.0}, 1e-6
    turned = [about_hinge({"theta": e, "s": 0.0}, rest, rest) for e in (step, -step)]
    moved = [about_hinge({"theta": 0.0, "s": e}, rest, rest) for e in (step, -step)]
    firm, soft = squares(kt), squares(6.0)
    return {
        "T": kinetic,
        "motion[theta]": about_hinge,
        "motion[s]": along,
        "M[theta,s]": about_hinge(rest, rest, {"theta": 0.0, "s": 1.0}),
        "K[theta,theta]": (turned[0] - turned[1]) / (2 * step),
        "K[theta,s]": (moved[0] - moved[1]) / (2 * step),
        "omega[1]": sqrt(firm[0]).real,
        "omega[2]": sqrt(firm[1]).real,
        "soft torsion spring: stable": soft[0].real > 0,
        "soft torsion spring: growth_rate[1]": sqrt(-soft[0]).real,
    }
