"""The differential equation by one symmetric half: EI u⁗ − μΩ² u = q beside the middle, 0 beyond, joined at L/4."""
from mpmath import cos, cosh, lu_solve, matrix, mp, mpf, sin, sinh


def answers(p):
    with mp.workdps(30):
        L, EI, mu, q, W = (mpf(p[n]) for n in ("L", "EI", "mu", "q", "Omega"))
        b, a = (mu * W**2 / EI) ** mpf("0.25"), L / 4

        def inner(x, k):        # even about the middle: cos and cosh of b (x − L/2)
            z = b * (x - L / 2)
            return [b**k * [cos(z), -sin(z), -cos(z), sin(z)][k], b**k * [cosh(z), sinh(z)][k % 2]]

        def outer(x, k):        # zero with its second derivative at x = 0
            z = b * x
            return [b**k * [sin(z), cos(z), -sin(z), -cos(z)][k], b**k * [sinh(z), cosh(z)][k % 2]]

        rest = -q / (mu * W**2)
        rows = matrix([[*inner(a, k), *(-v for v in outer(a, k))] for k in range(4)])
        A, B, C, D = lu_solve(rows, matrix([-rest, 0, 0, 0]))
        middle = A + B + rest
        moment, shear = EI * b**2 * (B - A), EI * b**3 * (D - C)
        still = (5 * q * L**4 / 384 - 2 * _corner(q, L, EI=1, a=a)) / EI
        return {"amplitude(bridge.u(L/2))": abs(middle), "amplitude(bridge.u''(L/2))": W**2 * abs(middle),
                "amplitude(bridge.moment(L/2))": abs(moment), "amplitude(bridge.shear(0 m))": abs(shear),
                "q*abs(frf[bridge.u(L/2), crowd](0 Hz))": still}


def _corner(q, L, EI, a):
    """The middle's deflection under q from an end to a, by Mohr: ∫ q (3 L² s − 4 s³)/48 ds/EI over s."""
    return q * (3 * L**2 * a**2 / 2 - a**4) / (48 * EI)
