"""P L sin u = k L^2 (sin u - sin a) cos u, u = -phi: extreme where sin^3 u = sin a, P = k L (1 - sin^(2/3) a)^(3/2)."""

from mpmath import asin, cbrt, cos, findroot, mpf, pi, sin


def found(p, a):
    k, L, P = p["k"], p["L"], p["P"]
    most = k * L * (1 - cbrt(sin(a)) ** 2) ** mpf("1.5")
    lean = findroot(lambda u: P * sin(u) - k * L * (sin(u) - sin(a)) * cos(u), 1.3 * a)
    return {"equilibrium[phi]": -lean, "fold[1, P]": most, "fold[1, k]": k * P / most,
            "fold[1, P](phi)": -asin(cbrt(sin(a)))}


def answers(p):
    steep = found(p, 10 * pi / 180)
    return found(p, p["phi0"]) | {f"leaning by ten degrees: {key}": value for key, value in steep.items()}
