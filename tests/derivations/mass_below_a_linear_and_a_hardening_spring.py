"""The force m g in both gives each deflection; stiffnesses in series; F = Σ a D^n by orders: with
F = a D + b D^3 + c D^5 put into F/k1 + d(F) = D."""

import mpmath


def answers(p):
    m, g, k1, k2, gamma = (p[name] for name in ("m", "g", "k1", "k2", "gamma"))

    def second(force):
        return mpmath.findroot(lambda d: k2 * d + gamma * d**3 - force, force / k2 / 2)

    with mpmath.workdps(30):
        d = second(m * g)
        stiffness = 1 / (1 / mpmath.mpf(k1) + 1 / (k2 + 3 * gamma * d**2))
        force = mpmath.findroot(lambda force: force / k1 + second(force) - mpmath.mpf("0.05"), 14)
        # d = F/k2 − gamma F^3/k2^4 + 3 gamma^2 F^5/k2^7 and D = F/k + …, 1/k = 1/k1 + 1/k2
        k, u, w = k1 * k2 / (k1 + k2), gamma / k2**4, 3 * gamma**2 / k2**7
        return {"equilibrium[x]": m * g / k1 + d, "equilibrium[s.stretch.2]": d, "equilibrium[s.force]": m * g,
                "omega[1]": mpmath.sqrt(stiffness / m), "law[s, d]": k, "law[s, d^3]": k**4 * u,
                "law[s, d^5]": k**6 * (3 * k * u**2 - w), "law[s](5 cm)": force}
