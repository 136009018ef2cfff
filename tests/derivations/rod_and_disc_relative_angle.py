"""Newton and Euler with the absolute angles: the hinge force on the disc follows from the acceleration
of the disc's centre, its moment about that centre is the residual of psi; the moment about O of the rod
with the reversed hinge force, added to it, is that of phi. Matrices are differences of these residuals
about the hanging position.
"""


def answers(p):
    from math import cos, sin

    m1, m2, L, r, g = (p[name] for name in ("m1", "m2", "L", "r", "g"))

    def moments(q, v, a):
        f, w, e = q["phi"], v["phi"], a["phi"]
        F, W, E = f + q["psi"], w + v["psi"], e + a["psi"]
        ax = L * (e * cos(f) - w**2 * sin(f)) + r * (E * cos(F) - W**2 * sin(F))
        ay = L * (e * sin(f) + w**2 * cos(f)) + r * (E * sin(F) + W**2 * cos(F))
        hinge_x, hinge_y = m2 * ax, m2 * ay + m2 * g
        disc = m2 * r**2 / 2 * E - (-r * sin(F) * hinge_y - r * cos(F) * hinge_x)
        on_rod = L * sin(f) * -hinge_y + L * cos(f) * -hinge_x
        rod = m1 * L**2 / 3 * e + m1 * g * L / 2 * sin(f) - on_rod
        return rod, disc

    def psi(q, v, a):
        return moments(q, v, a)[1]

    def phi(q, v, a):
        return sum(moments(q, v, a))

    def kinetic(q, v):
        f, w, F, W = q["phi"], v["phi"], q["phi"] + q["psi"], v["phi"] + v["psi"]
        vx, vy = L * w * cos(f) + r * W * cos(F), L * w * sin(f) + r * W * sin(F)
        return m1 * L**2 / 6 * w**2 + m2 * (vx**2 + vy**2) / 2 + m2 * r**2 / 4 * W**2

    def potential(q):
        drop = L * cos(q["phi"]) + r * cos(q["phi"] + q["psi"])
        return -m1 * g * L / 2 * cos(q["phi"]) - m2 * g * drop

    zero = {"phi": 0.0, "psi": 0.0}
    step = 1e-5

    def slope(row, name):
        return (row(zero | {name: step}, zero, zero) - row(zero | {name: -step}, zero, zero)) / (2 * step)

    def share(row, name):
        return row(zero, zero, zero | {name: 1.0})

    def small(q, v, a):
        return sum(slope(phi, name) * q[name] + share(phi, name) * a[name] for name in ("phi", "psi"))

    return {
        "T": kinetic,
        "V": potential,
        "motion[psi]": psi,
        "equation[phi]": small,
        "M[phi,phi]": share(phi, "phi"),
        "M[phi,psi]": share(psi, "phi"),
        "M[psi,psi]": share(psi, "psi"),
        "K[phi,phi]": slope(phi, "phi"),
        "K[phi,psi]": slope(psi, "phi"),
        "K[psi,psi]": slope(psi, "psi"),
    }
