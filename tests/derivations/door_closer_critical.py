"""Characteristic roots of the door's moment equation.

The inertia about the hinge is summed over the strips of the door (integral of r^2 dm). The roots of
J s^2 + ct s + kt = 0 give zeta = -(s1 + s2)/(2 sqrt(s1 s2)) and omega_d = (s1 - s2)/(2i).
"""
from mpmath import mpf, quad, sqrt

CASES = {"": None, "thin: ": 16.0, "thick: ": 40.0}


def answers(p):
    J = quad(lambda r: mpf(p["m"]) / p["w"] * r**2, [0, p["w"]])
    out = {}
    for case, ct in CASES.items():
        ct = p["ct"] if ct is None else ct
        root = sqrt(ct**2 - 4 * J * p["kt"])
        s1, s2 = (-ct + root) / (2 * J), (-ct - root) / (2 * J)
        out[case + "zeta[1]"] = float((-(s1 + s2) / (2 * sqrt(s1 * s2))).real)
        if case == "thin: ":
            out[case + "omega_d[1]"] = float(((s1 - s2) / 2j).real)
    out["equation[phi]"] = lambda q, v, a: float(J) * a["phi"] + p["ct"] * v["phi"] + p["kt"] * q["phi"]
    return out
