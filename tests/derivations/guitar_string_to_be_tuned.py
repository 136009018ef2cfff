"""f = sqrt(T/mu)/(2L)."""


def answers(p):
    return {"T": p["mu"] * (2 * p["L"] * 110) ** 2}
