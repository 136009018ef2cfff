"""Newton–Euler from the tip: the second rod freed at the elbow, then the first with the elbow's reaction.

Rest: the same equations without motion, solved by a root finder; stiffness and inertia at rest by derivatives of the
residuals at 30 digits, freed of the elbow force; frequencies from the quadratic of the determinant.
"""
import mpmath as mp

NAMES = ("alpha", "beta")


def answers(p):
    m1, L1, m2, L2, k1, k2 = (p[n] for n in ("m1", "L1", "m2", "L2", "k1", "k2"))
    F = complex(p["Fx"], p["Fy"])

    def residuals(q, v, a):
        along = [mp.exp(1j * q[n]) for n in NAMES]
        first, second = ((1j * a[n] - v[n] ** 2) * u for n, u in zip(NAMES, along, strict=True))
        elbow = m2 * (L1 * first + L2 / 2 * second) - F  # force of the first rod on the second
        spring = k2 * (q["beta"] - q["alpha"])

        def moment(arm, force):
            return mp.im(mp.conj(arm) * force)

        lower = m2 * L2**2 / 12 * a["beta"] + spring - moment(-L2 / 2 * along[1], elbow) - moment(L2 / 2 * along[1], F)
        upper = m1 * L1**2 / 3 * a["alpha"] + k1 * q["alpha"] - spring - p["M0"] + moment(L1 * along[0], elbow)
        return upper, lower

    zero = dict.fromkeys(NAMES, 0)
    with mp.workdps(30):
        found = mp.findroot(lambda x, y: residuals({"alpha": x, "beta": y}, zero, zero), (0.5, 1))
        rest = dict(zip(NAMES, found, strict=True))

        def slopes(vary):
            return [[mp.diff(lambda x, i=i, n=n: vary(n, x)[i], 0) for n in NAMES] for i in (0, 1)]

        K = slopes(lambda n, x: residuals(rest | {n: rest[n] + x}, zero, zero))
        M = slopes(lambda n, x: residuals(rest, zero, zero | {n: x}))
        A = M[0][0] * M[1][1] - M[0][1] * M[1][0]
        B = M[0][0] * K[1][1] + M[1][1] * K[0][0] - M[0][1] * K[1][0] - M[1][0] * K[0][1]
        C = K[0][0] * K[1][1] - K[0][1] * K[1][0]
        root = mp.sqrt(B * B - 4 * A * C)
        squares = (B - root) / (2 * A), (B + root) / (2 * A)
    return {
        "motion[alpha]": lambda q, v, a: float(residuals(q, v, a)[0]),
        "motion[beta]": lambda q, v, a: float(residuals(q, v, a)[1]),
        "equilibrium[alpha]": float(rest["alpha"]),
        "equilibrium[beta]": float(rest["beta"]),
        "K[alpha,beta]": float(K[0][1]),
        "stable": squares[0] > 0,
        "omega[1]": float(mp.sqrt(squares[0])),
        "omega[2]": float(mp.sqrt(squares[1])),
    }
