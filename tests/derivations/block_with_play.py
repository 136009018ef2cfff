"""Half a wave at each end about the edges of the gap, and the gap twice each way at the speed there."""

import mpmath


def answers(p):
    omega = mpmath.sqrt(p["k"] / p["m"])

    def period(speed):
        return 2 * mpmath.pi / omega + 4 * p["gap"] / speed

    return {"backbone[1](x)(A)": 2 * mpmath.pi / period((p["A"] - p["gap"]) * omega), "period(x)": period(p["v"])}
