"""Half a wave of each: T = pi (sqrt(m/k1) + sqrt(m/k2)); the spring that stretches to the right is k1."""

import mpmath


def answers(p):
    period = mpmath.pi * (mpmath.sqrt(p["m"] / p["k1"]) + mpmath.sqrt(p["m"] / p["k2"]))
    return {"period(x)": period, "backbone[1](x)(1 cm)": 2 * mpmath.pi / period,
            "backbone[1](x)(1 m)": 2 * mpmath.pi / period, "max(x)": p["v"] * mpmath.sqrt(p["m"] / p["k1"]),
            "min(x)": -p["v"] * mpmath.sqrt(p["m"] / p["k2"])}
