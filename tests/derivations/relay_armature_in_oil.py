"""Balance k x (d − x)² = B, a cubic whose roots within the range are taken by the formula of polynomials; c x' is the
rest of the forces, so that the rate is the slope of these over c, and the small motion one exponential.
"""


def answers(p):
    import mpmath as mp

    k, c, d, B, x0 = (mp.mpf(p[name]) for name in ("k", "c", "d", "B", "x0"))

    def force(x):
        return B / (d - x) ** 2 - k * x

    def stiffness(x):
        return float(-mp.diff(force, x))

    with mp.workdps(30):
        # in units of the gap: u (1 - u)² = B/(k d³)
        roots = mp.polyroots([1, -2, 1, -B / (k * d**3)], maxsteps=200, extraprec=100)
        near, far = sorted(root.real * d for root in roots if abs(root.imag) < 1e-20 and 0 < root.real < mp.mpf("0.9"))
        late = near + (x0 - near) * mp.exp(-stiffness(near) / c * mp.mpf("0.0015"))
    return {
        "equilibria": 2,
        "equilibrium[x][1]": float(near),
        "equilibrium[x][2]": float(far),
        "stable": stiffness(near) > 0,
        "stable[1]": stiffness(near) > 0,
        "stable[2]": stiffness(far) > 0,
        "K[x,x][1]": stiffness(near),
        "K[x,x][2]": stiffness(far),
        "eigenvalue[1][1]": -stiffness(near) / float(c),
        "eigenvalue[1][2]": -stiffness(far) / float(c),
        "Q[x](0 s)": float(force(x0)),
        "K[x,x](0 s)": stiffness(x0),
        "x(1.5 ms)": float(late),
    }
