"""Momentum and the law of restitution as two linear equations; the motion by the complex root of m₁ s² + c s + k, its
turning places where the speed vanishes, by a search."""


def answers(p):
    import mpmath as mp

    m1, m2, k, c, v, e = (p[name] for name in ("m1", "m2", "k", "c", "v", "e"))
    with mp.workdps(25):
        after = mp.lu_solve(mp.matrix([[m1, m2], [1, -1]]), mp.matrix([m2 * v, e * v]))
        root = next(s for s in mp.polyroots([m1, c, k]) if mp.im(s) > 0)

        def place(t, n=0):
            return mp.im(after[0] / mp.im(root) * root**n * mp.exp(root * t))

        half = mp.pi / mp.im(root)
        first, second = (mp.findroot(lambda t: place(t, 1), (begin * half, (begin + 1) * half), solver="anderson")
                         for begin in (0, 1))
        return {
            "x'(0 s)": float(after[0]),
            "omega_d[1]": float(mp.im(root)),
            "max(x)": float(place(first)),
            "argmax(x)": float(first),
            "min(x)": float(place(second)),
            "v - m1/m2*x'(0 s)": float(after[1]),
        }
