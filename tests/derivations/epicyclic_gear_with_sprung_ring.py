"""Velocities through the instantaneous picture, seen from the arm: there the wheels turn about fixed axes by equal
arcs.

So the planet turns by -(rs/rp)(alpha - theta) against the arm and the ring by (rp/R) of that. Places of the planet
and of the small mass follow as functions of theta and alpha; M comes from their Jacobians by differences of 30
digits, K from the Hessian of the work of weights and torsion springs, frequencies from the roots of the
characteristic polynomial.
"""


def answers(p):
    import mpmath as mp

    rs, rp, R, g = p["rs"], p["rp"], p["R"], p["g"]
    arm = rs + rp

    def planet(theta, alpha):
        return theta - (alpha - theta) * rs / rp

    def ring(theta, alpha):
        return theta + (planet(theta, alpha) - theta) * rp / R

    def bead(theta, alpha):
        psi = planet(theta, alpha)
        return mp.matrix([arm * mp.sin(theta) + rp * mp.sin(psi), -arm * mp.cos(theta) - rp * mp.cos(psi)])

    def potential(theta, alpha):
        heights = g * ((p["ma"] / 2 + p["mp"]) * -arm * mp.cos(theta) + p["mb"] * bead(theta, alpha)[1])
        return heights + p["ks"] * alpha**2 / 2 + p["kr"] * ring(theta, alpha) ** 2 / 2

    # What moves, with its inertia, as functions of theta and alpha.
    moving = [
        (p["ma"] * arm**2 / 3 + p["mp"] * arm**2, lambda th, al: th),
        (p["mp"] * p["ip"] ** 2, planet), (p["Js"], lambda th, al: al), (p["Jr"], ring),
        (p["mb"], lambda th, al: bead(th, al)[0]), (p["mb"], lambda th, al: bead(th, al)[1]),
    ]
    with mp.workdps(30):
        slopes = [(w, mp.diff(s, (0, 0), (1, 0)), mp.diff(s, (0, 0), (0, 1))) for w, s in moving]
        m11, m12, m22 = (sum(w * pair[i] * pair[j] for w, *pair in slopes) for i, j in ((0, 0), (0, 1), (1, 1)))
        k11, k12, k22 = (mp.diff(potential, (0, 0), n) for n in ((2, 0), (1, 1), (0, 2)))
        gradient = [mp.diff(potential, (0, 0), n) for n in ((1, 0), (0, 1))]
        slow, fast = sorted(mp.polyroots([
            m11 * m22 - m12**2, 2 * m12 * k12 - m11 * k22 - m22 * k11, k11 * k22 - k12**2]))
    return {
        "M[theta,theta]": float(m11), "M[theta,alpha]": float(m12), "M[alpha,alpha]": float(m22),
        "K[theta,theta]": float(k11), "K[theta,alpha]": float(k12), "K[alpha,alpha]": float(k22),
        "equilibrium[rho]": 0.0 if max(map(abs, gradient)) < 1e-20 else mp.nan,
        "omega[1]": float(mp.sqrt(slow)), "omega[2]": float(mp.sqrt(fast)),
    }
