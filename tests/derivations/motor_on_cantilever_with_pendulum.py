"""The small swing of the bob moves the motor to second order alone; up and down both masses go together."""
from mpmath import mp, mpf, sqrt
from support.transfer_matrices import beam, condition, first_roots, mass


def answers(p):
    with mp.workdps(30):
        L, EI, mu, M, m, length, g = (mpf(p[n]) for n in ("L", "EI", "mu", "M", "m", "l", "g"))
        roots = first_roots(condition([beam(L, EI, mu), mass(4, M + m)], "clamped", "free"), 2, mpf(4))
        return {"omega[1]": sqrt(g / length), "omega[2]": roots[0], "omega[3]": roots[1]}
