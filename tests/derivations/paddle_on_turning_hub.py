"""The paddle as particles (Gauss points of the rod, the weight) whose accelerations in the fixed plane are written with
complex numbers; the moment of their inertia forces about the hinge balances the torsion spring.

Rest is where that moment vanishes without motion, found by bisection; the stiffness is its slope there.
"""
import mpmath as mp
import numpy as np


def answers(p):
    R, M, L, m, kt, alpha = (p[n] for n in ("R", "M", "L", "m", "kt", "alpha"))
    nodes, weights = np.polynomial.legendre.leggauss(3)
    particles = [(M * w / 2, L * (x + 1) / 2) for x, w in zip(nodes.tolist(), weights.tolist(), strict=True)] + [(m, L)]

    def moment(Omega, q, v, a):
        phi, rate = q["phi"], Omega + v["phi"]
        total = kt * (phi - alpha)
        for mass, x in particles:
            # Acceleration along the normal of the paddle, of R exp(i Omega t) + x exp(i (Omega t + phi)).
            hinge = -R * Omega**2 * mp.exp(-1j * phi)
            own = x * (1j * a["phi"] - rate**2)
            total += mass * x * mp.im(hinge + own)
        return total

    rest = {"phi": 0.0}
    J = sum(mass * x**2 for mass, x in particles)

    def settled(Omega):
        def f(phi):
            return moment(Omega, {"phi": phi}, rest, rest)

        with mp.workdps(30):
            phi = mp.findroot(f, (0, mp.mpf(alpha)), solver="anderson", tol=1e-40)
            return float(phi), float(mp.sqrt(mp.diff(f, phi) / J))

    fast, slow = settled(p["Omega"]), settled(6.0)
    return {
        "J[paddle,A]": sum(mass * x**2 for mass, x in particles[:-1]),
        "M[phi,phi]": J,
        "motion[phi]": lambda q, v, a: moment(p["Omega"], q, v, a),
        "equilibrium[phi]": fast[0],
        "omega[1]": fast[1],
        "slow: equilibrium[phi]": slow[0],
        "slow: omega[1]": slow[1],
    }
