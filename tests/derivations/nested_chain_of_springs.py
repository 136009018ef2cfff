"""From inside out: with the deflection e of the innermost hardening spring all others follow, e -> D; one unknown."""

import mpmath


def answers(p):
    k, c, P = (mpmath.mpf(p[name]) for name in ("k", "c", "P"))

    def outwards(e):
        """(force of the chain, deflection of the pair, deflection of all)"""
        inner = k * e + c * e**3
        pair = e + inner / k
        force = inner + c * pair**3
        return force, pair, pair + force / k

    with mpmath.workdps(40):
        at = mpmath.findroot(lambda e: outwards(e)[2] - mpmath.mpf("0.04"), 0.01)
        under = mpmath.findroot(lambda e: outwards(e)[0] - P, 0.01)
        force, pair, whole = outwards(under)
        # to the third order: D = a e + b e^3, F = f e + h e^3
        a, b = 3, 2 * c / k + 8 * c / k     # pair 2 e + (c/k) e^3, force k e + c e^3 + 8 c e^3, over k
        f, h = k, 9 * c
        return {"law[s](4 cm)": outwards(at)[0], "law[s, d]": f / a, "law[s, d^3]": h / a**3 - f * b / a**4,
                "equilibrium[x]": whole, "equilibrium[s.stretch.1]": force / k, "equilibrium[s.stretch.2]": pair,
                "equilibrium[s.stretch.2.2.2]": under}
