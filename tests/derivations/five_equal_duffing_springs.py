"""Each is stretched by D/5: F = k D/5 + gamma (D/5)^3; V is its integral, which has x^4 with a quarter of the cubic
factor."""

import math


def answers(p):
    N, k, gamma, D = 5, p["k"], p["gamma"], p["D"]
    return {"law[s](D)": k * (D / N) + gamma * (D / N) ** 3, "law[s, d]": k / N, "law[s, d^3]": gamma / N**3,
            "law[s, d^5]": 0.0, "V[x^4]": gamma / N**3 / 4, "omega[1]": math.sqrt(k / N / p["m"])}
