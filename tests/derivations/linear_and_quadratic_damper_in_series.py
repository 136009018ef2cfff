"""w = F/c + sqrt(F/b), a quadratic equation of sqrt(F); c (w − v) = c v + a v^3 by orders,
v = w/2 + v3 w^3 + v5 w^5."""

import mpmath


def answers(p):
    c, b, a, w = (mpmath.mpf(p[name]) for name in ("c", "b", "a", "w"))
    root = mpmath.polyroots([1 / c, 1 / mpmath.sqrt(b), -w])
    r = a / c       # 2 v + r v^3 = w: 2 v3 + r/8 = 0, 2 v5 + 3 r v3/4 = 0
    v3 = -r / 16
    v5 = -3 * r * v3 / 8
    v = mpmath.findroot(lambda v: 2 * v + r * v**3 - w, w / 2)
    return {"law[d](w)": max(root) ** 2, "law[e](w)": c * (w - v), "law[e, v]": c / 2, "law[e, v^3]": -c * v3,
            "law[e, v^5]": -c * v5}
