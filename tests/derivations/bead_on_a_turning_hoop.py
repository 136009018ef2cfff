"""With u = cos theta, theta'^2 = W^2 (u0 - u)(u - u1), u1 = 2 g/(R W^2) - u0: T = 2 int du/(sqrt(1 - u^2) |theta'|) is
a complete elliptic integral of four real roots (Byrd and Friedman 1971, 255 and 257)."""

import mpmath


def between(a, b, c, d):
    """int from c to b of du/sqrt((a - u)(b - u)(u - c)(u - d)), a > b > c > d."""
    modulus = (b - c) * (a - d) / ((a - c) * (b - d))
    return 2 / mpmath.sqrt((a - c) * (b - d)) * mpmath.ellipk(modulus)


def answers(p):
    W, ratio, degree = p["W"], p["g"] / (p["R"] * p["W"] ** 2), mpmath.pi / 180
    near = mpmath.cos(20 * degree)
    far = mpmath.cos(120 * degree)
    return {"equilibrium[theta]": mpmath.acos(ratio), "omega[1]": W * mpmath.sin(mpmath.acos(ratio)),
            "period(theta)": 2 * between(1, near, 2 * ratio - near, -1) / W,
            "max(theta)": mpmath.acos(2 * ratio - near),
            "through the bottom: period(theta)": 4 * between(2 * ratio - far, 1, far, -1) / W,
            "through the bottom: min(theta)": -2 * mpmath.pi / 3}
