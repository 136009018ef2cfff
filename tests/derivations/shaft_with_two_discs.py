"""GI b/L (cos b phi_0 ...): tan b (1 - a1 a2 b^2) + (a1 + a2) b = 0 with a = J/(rho I L), in 30 digits."""
from mpmath import atan, cos, findroot, mp, mpf, pi, sin, sqrt


def answers(p):
    with mp.workdps(30):
        d, L, G, rho, J1, J2 = (mpf(p[n]) for n in ("d", "L", "G", "rho", "J1", "J2"))
        polar = pi * d**4 / 32
        one, two = J1 / (rho * polar * L), J2 / (rho * polar * L)

        def f(b):
            return sin(b) * (1 - one * two * b * b) + (one + two) * b * cos(b)

        roots, step, x = [], mpf("0.01"), mpf("0.001")
        while len(roots) < 2:
            if f(x) * f(x + step) < 0:
                roots.append(findroot(f, (x, x + step), "anderson"))
            x += step
        omega = [b / L * sqrt(G / rho) for b in roots]
        # phi = cos(b x/L) - a1 b sin(b x/L), from J1 omega^2 phi(0) = -GI phi'(0)
        node = atan(1 / (one * roots[0])) / roots[0] * L
        rigid = sqrt(G * polar / L * (J1 + J2) / (J1 * J2))
        return {"omega[2]": omega[0], "omega[3]": omega[1], "node[2][shaft, 1]": node,
                "sqrt(G*pi*d^4/32/L*(J1 + J2)/(J1*J2))/omega[2] - 1": rigid / omega[0] - 1}
