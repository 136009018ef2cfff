"""Each piece as a sum of cosh, sinh, cos, sin: twelve conditions at the ends and supports; their determinant is
bisected by mpmath to 25 digits."""
import mpmath


def answers(p):
    a, b, c, EI, mu, M = (p[n] for n in ("a", "b", "c", "EI", "mu", "M"))

    def row(be, x, order):
        """The derivative of that order of (cosh, sinh, cos, sin)(be x)."""
        z, odd = be * x, order % 2
        wide = [mpmath.cosh(z), mpmath.sinh(z)]
        waves = [mpmath.cos(z), -mpmath.sin(z), -mpmath.cos(z), mpmath.sin(z)]
        return [be**order * f for f in (wide[odd], wide[1 - odd], waves[order], waves[order - 1])]

    def condition(w):
        be = mpmath.root(mu * w * w / EI, 4)
        lines = [{0: row(be, 0, 0)}, {0: row(be, 0, 2)},
                 {2: row(be, c, 2)},
                 {2: [EI * f + M * w * w * u for f, u in zip(row(be, c, 3), row(be, c, 0), strict=True)]}]
        for piece, length in ((0, a), (1, b)):
            lines += [{piece: row(be, length, 0)}, {piece + 1: row(be, 0, 0)}]
            lines += [{piece: row(be, length, n), piece + 1: [-f for f in row(be, 0, n)]} for n in (1, 2)]
        whole = [[f for piece in range(3) for f in line.get(piece, [0] * 4)] for line in lines]
        return mpmath.det(mpmath.matrix(whole))

    with mpmath.workdps(25):
        found, w = [], mpmath.mpf(2)
        here = condition(w)
        while len(found) < 3:
            there = condition(w + 5)
            if here * there < 0:
                found.append(mpmath.findroot(condition, (w, w + 5), solver="anderson", verify=False))
            w, here = w + 5, there
    return {f"omega[{i + 1}]": float(found[i]) for i in range(3)}
