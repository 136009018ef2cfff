"""Moments with complex numbers: on the upper bar about the middle hinge, where the jet has none, and the forces at that
hinge on the lower bar about the ground. Small motions are the first order of these, by differences at 30 digits.

The roots w = omega^2 of det(K - w M), M and K so found, by the quadratic formula; the column is stable where both
are real and positive.
"""
import mpmath as mp

NAMES = ("alpha", "beta")


def answers(p):
    m, L, k = (p[n] for n in ("m", "L", "k"))

    def residuals(P, q, v, a):
        up = [1j * mp.exp(1j * q[n]) for n in NAMES]
        change = [L * (1j * a[n] - v[n] ** 2) * u for n, u in zip(NAMES, up, strict=True)]
        tip = m * (change[0] + change[1])
        jet = -P * up[1]
        elbow = k * (q["beta"] - q["alpha"])
        upper = mp.im(mp.conj(L * up[1]) * (tip - jet)) + elbow
        lower = mp.im(mp.conj(L * up[0]) * (2 * m * change[0] + tip - jet)) + k * q["alpha"] - elbow
        return lower, upper

    rest = dict.fromkeys(NAMES, 0)

    def matrices(P):
        with mp.workdps(30):
            M, K = mp.matrix(2), mp.matrix(2)
            for j, n in enumerate(NAMES):
                for i in (0, 1):
                    M[i, j] = residuals(P, rest, rest, rest | {n: 1})[i]
                    K[i, j] = mp.diff(lambda x, i=i, n=n: residuals(P, rest | {n: x}, rest, rest)[i], 0)
        return M, K

    def squares(P):
        M, K = matrices(P)
        with mp.workdps(30):
            A, C = mp.det(M), mp.det(K)
            B = M[0, 0] * K[1, 1] + M[1, 1] * K[0, 0] - M[0, 1] * K[1, 0] - M[1, 0] * K[0, 1]
            root = mp.sqrt(B * B - 4 * A * C)
            return (B - root) / (2 * A), (B + root) / (2 * A)

    def stable(P):
        return all(mp.im(w) == 0 and mp.re(w) > 0 for w in squares(P))

    P = 3 * k / (2 * L)
    M, K = matrices(P)
    out = {
        "motion[alpha]": lambda q, v, a: float(residuals(P, q, v, a)[0]),
        "motion[beta]": lambda q, v, a: float(residuals(P, q, v, a)[1]),
        "M[alpha,alpha]": float(M[0, 0]),
        "M[alpha,beta]": float(M[0, 1]),
        "K[alpha,alpha]": float(K[0, 0]),
        "K[alpha,beta]": float(K[0, 1]),
        "K[beta,alpha]": float(K[1, 0]),
        "stable": stable(P),
        "twice the force: K[alpha,alpha]": float(matrices(2 * P)[1][0, 0]),
        "twice the force: stable": stable(2 * P),
    }
    for prefix, force in (("", P), ("a weaker jet: ", k / L)):
        for i, w in enumerate(squares(force), 1):
            out[f"{prefix}omega[{i}]"] = float(mp.sqrt(w))
    return out
