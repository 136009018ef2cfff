"""Newton and Euler for the rod with its particle: the floor pushes N_A upwards at A, the wall N_B to the left at B,
the spring pulls A to the wall. Accelerations of the common centre by the coordinates of A and B; the moment about
that centre is the residual of the motion. T is m v²/2 added up along the rod and for the particle, V the work against
weights and spring, by quadrature.
"""


def answers(p):
    from math import cos, sin

    import numpy as np

    m, M, L, b, g = p["m"], p["M"], p["L"], p["b"], p["g"]
    mass = m + M
    s = (m * L / 2 + M * b) / mass                      # the common centre, from A
    inertia = m * L**2 / 12 + m * (L / 2 - s) ** 2 + M * (b - s) ** 2

    def pull(angle):
        """Of the spring on A, towards the wall, whichever side A is on."""
        place = -L * cos(angle)
        return -p["k"] * (abs(place) - p["l0"]) * np.sign(place)

    def residual(angle, rate, acceleration):
        c, n = cos(angle), sin(angle)
        # Centre at (-(L - s) cos, s sin).
        ax = (L - s) * (n * acceleration + c * rate**2)
        ay = s * (c * acceleration - n * rate**2)
        floor = mass * (ay + g)
        wall = mass * ax - pull(angle)
        # Arms from the centre: A at -s, B at L - s along the rod.
        moment = -s * c * floor + s * n * pull(angle) - (L - s) * n * wall
        return moment - inertia * acceleration

    nodes, weights = np.polynomial.legendre.leggauss(6)
    along = (nodes + 1) / 2 * L

    def kinetic(q, v):
        def square(place):
            vx = (L - place) * sin(q["theta"]) * v["theta"]
            vy = place * cos(q["theta"]) * v["theta"]
            return vx**2 + vy**2
        return float(np.sum(weights / 2 * m / 2 * square(along)) + M / 2 * square(b))

    def potential(q):
        place = -L * cos(q["theta"])
        stretch = abs(place) - p["l0"]
        force = (nodes + 1) / 2 * stretch * p["k"]      # as the spring is drawn out
        weight = np.sum(weights / 2 * m * g * along * sin(q["theta"])) + M * g * b * sin(q["theta"])
        return float(weight + np.sum(weights / 2 * force) * stretch)

    return {
        "T": kinetic,
        "V": potential,
        "motion[theta]": lambda q, v, a: residual(q["theta"], v["theta"], a["theta"]),
    }
