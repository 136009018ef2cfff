"""Roots of the boom's moment equation J s^2 + c L^2 s + k (L/2)^2 = 0, the damping found by halving an interval.

J is summed over the strips of the boom; each question is a condition on the two roots s1, s2, followed in c.
"""
from mpmath import findroot, mpf, quad, sqrt


def roots(J, damping, stiffness):
    root = sqrt(damping**2 - 4 * J * stiffness)
    return (-damping + root) / (2 * J), (-damping - root) / (2 * J)


def answers(p):
    m, L, k = mpf(p["m"]), mpf(p["L"]), mpf(p["k"])
    J = quad(lambda r: m / L * r**2, [0, L])

    def of(c, k=k):
        s1, s2 = roots(J, c * L**2, k * (L / 2) ** 2)
        return {"zeta": (-(s1 + s2) / (2 * sqrt(s1 * s2))).real, "slow": -s1.real, "turn": abs((s1 - s2).imag) / 2,
                "omega": sqrt(abs(s1 * s2))}

    def halved(condition, low, high):
        return findroot(condition, (mpf(low), mpf(high)), solver="anderson", tol=1e-25)

    omega = of(0)["omega"]
    critical = 2 * sqrt(J * k * (L / 2) ** 2) / L**2
    c = halved(lambda c: of(c)["zeta"] - mpf("0.7"), 0.1, critical)
    half = halved(lambda c: of(c)["turn"] ** 2 - omega**2 / 4, 0.1, critical * 0.999)
    slow = halved(lambda c: of(c)["slow"] - 5, 0.1, critical * 0.999)
    fast = halved(lambda c: of(c)["slow"] - 5, critical * 1.001, 10 * critical)
    # both: s = -decay +- 12 i with decay/|s| = 0.6; stiffness and damping from s1 s2 and s1 + s2
    decay = 12 * mpf("0.6") / sqrt(1 - mpf("0.6") ** 2)
    stiff = J * (decay**2 + 144) / (L / 2) ** 2
    return {key: float(value) for key, value in {
        "c": c, "omega[1]": omega, "omega_d[1]": of(c)["turn"], "half: c": half, "half: zeta[1]": of(half)["zeta"],
        "fading: c": slow, "fading: c[2]": fast, "both: k": stiff, "both: c": 2 * decay * J / L**2,
        "both: decay[1]": decay}.items()}
