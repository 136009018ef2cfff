"""The disc is freed: friction F acts at the contact, its turn is -s/r. Newton for the disc along the
floor gives F, Euler about its centre is the residual of s; the platform's equation, with F and the inner
spring reversed, is that of x after adding the disc's (the pair then moves as one). Frequencies and modes
from the accelerations solved of the freed bodies, without any mass matrix.
"""


def answers(p):
    from math import sqrt

    import numpy as np

    m1, m2, r, k1, k2 = (p[name] for name in ("m1", "m2", "r", "k1", "k2"))

    def friction(q, a):
        return m2 * (a["x"] + a["s"]) + k2 * q["s"]

    def disc(q, v, a):
        return m2 * r**2 / 2 * a["s"] / r + r * friction(q, a)

    def platform(q, v, a):
        return m1 * a["x"] + k1 * q["x"] - k2 * q["s"] + friction(q, a)

    def kinetic(q, v):
        turning = m2 * r**2 / 4 * (v["s"] / r) ** 2
        return m1 * v["x"] ** 2 / 2 + m2 * (v["x"] + v["s"]) ** 2 / 2 + turning

    zero = {"x": 0.0, "s": 0.0}
    one = {"x": zero | {"x": 1.0}, "s": zero | {"s": 1.0}}
    names = ("x", "s")

    def generalised(i, q, a):
        """Virtual work on the freed bodies for a unit of coordinate i."""
        return platform(q, zero, a) if i == "x" else disc(q, zero, a) / r

    mass = {(i, j): generalised(i, zero, one[j]) for i in names for j in names}
    stiffness = {(i, j): generalised(i, one[j], zero) for i in names for j in names}
    M, K = (np.array([[table[i, j] for j in names] for i in names]) for table in (mass, stiffness))
    squares, shapes = np.linalg.eig(np.linalg.solve(M, K))
    order = np.argsort(squares)
    found = {f"omega[{i + 1}]": sqrt(squares[j]) for i, j in enumerate(order)}
    found |= {f"mode[{i + 1}][s]": shapes[1, j] / shapes[0, j] for i, j in enumerate(order)}
    found |= {"M[x,x]": mass["x", "x"], "M[x,s]": mass["s", "x"], "M[s,s]": mass["s", "s"]}
    found |= {"K[x,x]": stiffness["x", "x"], "K[x,s]": stiffness["x", "s"], "K[s,s]": stiffness["s", "s"]}
    return found | {"T": kinetic, "motion[x]": platform, "equation[s]": disc}
