"""EI u⁗ + μ g ((H − x) u′)′ = μ ω² u − q₀ x/H by its power series about the foot, u = u′ = 0 there, u″ = u‴ = 0 at the
top, where the weight presses no more."""
from mpmath import findroot, lu_solve, matrix, mp, mpf

TERMS = 120


def answers(p):
    with mp.workdps(30):
        H, EI, mu, q0, g = (mpf(p[n]) for n in ("H", "EI", "mu", "q0", "g"))

        def series(a2, a3, load, square):
            a = [mpf(0), mpf(0), mpf(a2), mpf(a3)]
            for k in range(TERMS):
                left = mu * square * a[k] - (load * q0 / H if k == 1 else 0)
                left += mu * g * ((k + 1) ** 2 * a[k + 1] - H * (k + 2) * (k + 1) * a[k + 2])
                a.append(left / (EI * (k + 4) * (k + 3) * (k + 2) * (k + 1)))
            return a

        def at_top(a, order):
            total = mpf(0)
            for k in range(order, len(a)):
                factor = mpf(1)
                for i in range(order):
                    factor *= k - i
                total += factor * a[k] * H ** (k - order)
            return total

        own, first, second = series(0, 0, 1, 0), series(1, 0, 0, 0), series(0, 1, 0, 0)
        ends = matrix([[at_top(a, n) for a in (first, second)] for n in (2, 3)])
        a2, a3 = lu_solve(ends, matrix([-at_top(own, n) for n in (2, 3)]))
        bent = series(a2, a3, 1, 0)

        def determinant(w):
            one, two = series(1, 0, 0, w * w), series(0, 1, 0, w * w)
            return at_top(one, 2) * at_top(two, 3) - at_top(one, 3) * at_top(two, 2)

        w = findroot(determinant, mpf("3.516") * (EI / mu) ** mpf("0.5") / H**2 * mpf("0.92"))
        return {"equilibrium[mast.u(H)]": at_top(bent, 0), "equilibrium[mast.moment(0 m)]": 2 * EI * a2, "omega[1]": w}
