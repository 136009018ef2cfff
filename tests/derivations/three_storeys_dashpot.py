"""Impedance seen from the ground, eliminated from the top floor down; roots in 30 digits.

The top floor on its storey has the dynamic stiffness k3 m3 s^2/(m3 s^2 + k3); the floors below follow as
a continued fraction. Cleared of fractions it is a sextic in s, multiplied out by hand-made polynomial
products; each complex pair gives omega_d = Im s and zeta = -Re s/|s|, in ascending order of |s|. The amplitudes of its
floors follow from the top down: x2/x3 = 1 + m3 s^2/k3, and the balance of the second floor gives x1/x3.
"""
from mpmath import im, mp, mpf, pi, polyroots, re


def product(a, b):
    out = [mpf(0)] * (len(a) + len(b) - 1)
    for i, u in enumerate(a):
        for j, w in enumerate(b):
            out[i + j] += u * w
    return out


def total(a, b):
    n = max(len(a), len(b))
    a, b = ([mpf(0)] * (n - len(c)) + list(c) for c in (a, b))
    return [u + w for u, w in zip(a, b, strict=True)]


def answers(p):
    with mp.workdps(30):
        m1, m2, m3, k1, k2, k3, c = (mpf(p[n]) for n in ("m1", "m2", "m3", "k1", "k2", "k3", "c"))
        # dynamic stiffness num/den of all that stands on a floor, polynomials in s, highest power first
        num, den = [k3 * m3, 0, 0], [m3, 0, k3]
        num, den = total(product([m2, 0, 0], den), num), den
        num, den = product([k2], num), total(product([k2], den), num)
        sextic = total(product([m1, c, k1], den), num)
        pairs = sorted((s for s in polyroots(sextic, maxsteps=500, extraprec=100) if im(s) > 0), key=abs)
        out = {}
        for i, s in enumerate(pairs, 1):
            out[f"zeta[{i}]"] = float(-re(s) / abs(s))
            out[f"omega_d[{i}]"] = float(im(s))
            out[f"period_d[{i}]"] = float(2 * pi / im(s))
        s = pairs[0]
        second = 1 + m3 * s**2 / k3
        first = second + (m2 * s**2 * second + m3 * s**2) / k2
        for name, top in (("x2", second / first), ("x3", 1 / first)):
            out[f"re(mode_d[1,{name}])"], out[f"im(mode_d[1,{name}])"] = float(re(top)), float(im(top))
        return out
