"""tan(beta a) tan(beta b) = A1/A2, written without poles; roots by a scan in steps far below their distance."""
from mpmath import cos, findroot, mp, mpf, sin, sqrt


def answers(p):
    with mp.workdps(30):
        a, b, D, d, E, rho = (mpf(p[n]) for n in ("a", "b", "D", "d", "E", "rho"))

        def f(beta):
            return D**2 * cos(beta * a) * cos(beta * b) - d**2 * sin(beta * a) * sin(beta * b)

        roots, step, x = [], mpf("0.01"), mpf("0.001")
        while len(roots) < 4:
            if f(x) * f(x + step) < 0:
                roots.append(findroot(f, (x, x + step), "anderson"))
            x += step
        return {f"omega[{i}]": beta * sqrt(E / rho) for i, beta in enumerate(roots, 1)}
