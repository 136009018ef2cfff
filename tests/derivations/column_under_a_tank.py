"""k = P/(tan(aL)/a - L) with a = sqrt(P/EI), P = Mg, of a clamped column with a dead load."""
from math import sqrt, tan


def answers(p):
    L, EI, M, g = (p[n] for n in ("L", "EI", "M", "g"))
    P = M * g
    a = sqrt(P / EI)
    return {"omega[1]": sqrt(P / (tan(a * L) / a - L) / M)}
