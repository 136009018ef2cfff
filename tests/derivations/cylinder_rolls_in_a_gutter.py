"""Energy 3/4 m v² with v = (R − r) ψ', Newton's law along the line of centres and along the gutter: both forces as
functions of the angle, looked at on a fine grid between the extreme angles."""
from math import cos, sin


def answers(p):
    m, g, alpha, way = p["m"], p["g"], p["alpha"], p["R"] - p["r"]

    def forces(psi):
        square = 4 * g * (cos(psi) - cos(alpha)) / (3 * way)         # psi'^2
        along = -2 * g * sin(psi) / (3 * way)                        # psi''
        normal = m * g * cos(psi) + m * way * square
        return normal, m * way * along + m * g * sin(psi)

    found = [forces(alpha * i / 20000) for i in range(20001)]
    return {"cylinder.normal(0 s)": found[-1][0], "max(cylinder.normal)": max(n for n, _ in found),
            "min(cylinder.normal)": min(n for n, _ in found), "max(abs(cylinder.friction))": max(
                abs(f) for _, f in found), "max(abs(cylinder.friction)/cylinder.normal)": max(
                abs(f) / n for n, f in found)}
