"""The tension N in both gives each deflection; stiffnesses in series; factors as without tension, from d = 0."""

import mpmath


def answers(p):
    m, k1, k2, gamma, N = (mpmath.mpf(p[name]) for name in ("m", "k1", "k2", "gamma", "N"))
    d = mpmath.findroot(lambda d: k2 * d + gamma * d**3 - N, 0.05)
    stiffness = 1 / (1 / k1 + 1 / (k2 + 3 * gamma * d**2))
    return {"equilibrium[x]": 0, "equilibrium[chain.force]": N, "equilibrium[chain.deflection]": N / k1 + d,
            "omega[1]": mpmath.sqrt(stiffness / m), "law[chain, d^3]": gamma * (k1 / (k1 + k2)) ** 4}
