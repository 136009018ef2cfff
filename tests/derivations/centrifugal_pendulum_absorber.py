"""Newton for the bob at z = R exp(i psi) + r exp(i (psi + phi)), psi = Omega t + theta: its arm is light, so no force
acts across it. The moments on disc and bob together about the axis make the second equation. Small motions: the first
order of these at 30 digits.

The shape of the second mode keeps the moment of momentum about the axis at zero; its frequency is that for which the
greatest kinetic energy equals the greatest energy in the field m Omega^2 |z|^2/2 of the centrifugal force.
"""
import mpmath as mp


def answers(p):
    J, m, R, n, Omega, M0 = (p[x] for x in ("J", "m", "R", "n", "Omega", "M0"))
    r = R / n**2

    def acceleration(q, v, a):
        """z'' seen along the radius through the hinge."""
        disc, arm = Omega + v["theta"], Omega + v["theta"] + v["phi"]
        across = a["theta"] + a["phi"]
        return R * (1j * a["theta"] - disc**2) + r * mp.exp(1j * q["phi"]) * (1j * across - arm**2)

    def bob(q, v, a):
        return m * r * mp.im(acceleration(q, v, a) * mp.exp(-1j * q["phi"]))

    def both(q, v, a):
        place = R + r * mp.exp(1j * q["phi"])
        load = M0 * mp.sin(n * Omega * q["t"])
        return J * a["theta"] + m * mp.im(mp.conj(place) * acceleration(q, v, a)) - load

    def first_order(residual):
        def linear(q, v, a):
            def scaled(by):
                small = [{key: by * x for key, x in part.items() if key != "t"} for part in (q, v, a)]
                return residual({**small[0], "t": q["t"]}, small[1], small[2])

            with mp.workdps(30):
                return float(scaled(mp.mpf(0)) + mp.diff(scaled, 0))
        return linear

    def kinetic(q, v):
        disc, arm = Omega + v["theta"], Omega + v["theta"] + v["phi"]
        speed = abs(R * disc + r * mp.exp(1j * q["phi"]) * arm)
        return float(J * disc**2 / 2 + m * speed**2 / 2)

    rest = {"theta": 0.0, "phi": 0.0}
    phi = -(J + m * (R + r) ** 2) / (m * (R + r) * r)
    energy = J / 2 + m * (R + r + r * phi) ** 2 / 2
    with mp.workdps(30):
        field = -mp.diff(lambda x: m * Omega**2 * abs(R + r * mp.exp(1j * x)) ** 2 / 2, 0, 2)
    return {
        "T": kinetic,
        "motion[phi]": lambda q, v, a: float(bob(q, v, a)),
        "equation[theta]": first_order(both),
        "equation[phi]": first_order(bob),
        "M[theta,phi]": float(bob(rest, rest, {"theta": 1.0, "phi": 0.0})
                              - bob(rest, rest, rest)),
        "K[phi,phi]": float(field),
        "omega[1]": 0.0,
        "omega[2]": float(mp.sqrt(field * phi**2 / 2 / energy)),
        "mode[2][phi]": phi,
    }
