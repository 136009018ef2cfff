"""x = y and x = -y move alone: each a single mass m on k, on 3 k, with its share of alpha and beta."""
from math import sqrt


def answers(p):
    m, k, alpha, beta = (p[x] for x in ("m", "k", "alpha", "beta"))
    found = {"omega[1]": sqrt(k / m), "omega[2]": sqrt(3 * k / m), "C[x,x]": alpha * m + 2 * beta * k,
             "C[x,y]": -beta * k,
             "equation[x]": lambda q, v, a: (m * a["x"] + (alpha * m + 2 * beta * k) * v["x"] - beta * k * v["y"]
                                             + 2 * k * q["x"] - k * q["y"])}
    for i, stiffness in ((1, k), (2, 3 * k)):
        found[f"zeta[{i}]"] = (alpha * m + beta * stiffness) / (2 * sqrt(stiffness * m))
    w1, w2 = sqrt(1200 / 3), sqrt(3600 / 3)
    ratios = [(0.253590 / w + 0.000366025 * w) / 2 for w in (w1, w2)]
    return found | {"measured: zeta[1]": ratios[0], "measured: zeta[2]": ratios[1],
                    "measured: decay[1]": ratios[0] * w1}
