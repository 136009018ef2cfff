"""The spring's length is the distance between its ends in coordinates; the moment about the pivot is
written from the force's components (r × S), the weight and the torsion spring, and its root is bracketed
and bisected. The frequency is from the central difference of that moment.
"""


def answers(p):
    from math import cos, hypot, sin, sqrt

    from scipy.optimize import brentq

    def ends(phi):
        return p["a"] * cos(phi), p["a"] * sin(phi)

    def moment(phi):
        x, y = ends(phi)
        dx, dy = -x, p["h"] - y
        tension = p["k"] * (hypot(dx, dy) - p["l0"])
        pull = tension * (x * dy - y * dx) / hypot(dx, dy)
        return pull - p["m"] * p["g"] * p["L"] / 2 * cos(phi) - p["kt"] * phi

    def potential(phi):
        x, y = ends(phi)
        stretch = hypot(x, y - p["h"]) - p["l0"]
        lifted = p["m"] * p["g"] * p["L"] / 2 * sin(phi)
        return lifted + p["kt"] * phi**2 / 2 + p["k"] * stretch**2 / 2

    rest = brentq(moment, -0.5, 0.5, xtol=1e-15)
    step = 1e-5
    stiffness = (moment(rest - step) - moment(rest + step)) / (2 * step)
    return {
        "V": lambda q: potential(q["phi"]),
        "equilibrium[phi]": rest,
        "stable": stiffness > 0,
        "omega[1]": sqrt(stiffness / (p["m"] * p["L"] ** 2 / 3)),
    }
