"""The forces of the mounts as vectors, from the lengths of the displaced springs; the stiffness is their derivative at
30 digits, in which the compression of the mounts counts. Frequencies from the quadratic of the determinant.
"""
import mpmath as mp


def answers(p):
    M, k1, k2, long, beta, c, U, Omega, g = (p[n] for n in ("M", "k1", "k2", "l", "beta", "c", "U", "Omega", "g"))

    def force(x, y):
        """What the displaced motor lacks for its balance, against mounts and weight."""
        compressed = M * g / 2 / mp.cos(beta)
        total = [mp.mpf(0), M * g]
        for k, side in ((k1, -1), (k2, 1)):
            foot = side * long * mp.sin(beta), -long * mp.cos(beta)
            run = x - foot[0], y - foot[1]
            length = mp.hypot(*run)
            tension = -compressed + k * (length - long)
            total = [t + tension * r / length for t, r in zip(total, run, strict=True)]
        return total

    with mp.workdps(30):
        K = [[mp.diff(lambda s, i=i: force(s, mp.mpf(0))[i], 0), mp.diff(lambda s, i=i: force(mp.mpf(0), s)[i], 0)]
             for i in (0, 1)]
        rest = force(mp.mpf(0), mp.mpf(0))
        B, det = K[0][0] + K[1][1], K[0][0] * K[1][1] - K[0][1] * K[1][0]
        root = mp.sqrt(B * B - 4 * det)
        squares = (B - root) / 2 / M, (B + root) / 2 / M
    Kxx, Kxy, Kyy = float(K[0][0]), float(K[0][1]), float(K[1][1])

    def turning(q):
        return U * Omega**2 * mp.cos(Omega * q["t"]), U * Omega**2 * mp.sin(Omega * q["t"])

    return {
        "equilibrium[x]": float(rest[0]),
        "equilibrium[y]": float(rest[1]),
        "K[x,x]": Kxx,
        "K[x,y]": Kxy,
        "K[y,y]": Kyy,
        "C[y,y]": c,
        "equation[x]": lambda q, v, a: float(M * a["x"] + Kxx * q["x"] + Kxy * q["y"] - turning(q)[0]),
        "equation[y]": lambda q, v, a: float(M * a["y"] + c * v["y"] + Kxy * q["x"] + Kyy * q["y"] - turning(q)[1]),
        "omega[1]": float(mp.sqrt(squares[0])),
        "omega[2]": float(mp.sqrt(squares[1])),
    }
