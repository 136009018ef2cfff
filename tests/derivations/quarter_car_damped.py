"""Characteristic polynomial by hand from the impedances, its roots in 30 digits.

With Z = c s + ks the wheel and the body give (mu s^2 + kt + Z)(ms s^2 + Z) - Z^2 = 0, a quartic; each
complex pair has omega_d = Im s and zeta = -Re s/|s|, in ascending order of |s|. The body on Z follows the wheel as
x2/x1 = Z/(ms s^2 + Z).
"""
from mpmath import arg, im, mp, mpf, pi, polyroots, re


def answers(p):
    with mp.workdps(30):
        mu, ms, kt, ks, c = (mpf(p[n]) for n in ("mu", "ms", "kt", "ks", "c"))
        quartic = [mu * ms, c * (mu + ms), ks * (mu + ms) + kt * ms, c * kt, ks * kt]
        pairs = sorted((s for s in polyroots(quartic, maxsteps=200, extraprec=60) if im(s) > 0), key=abs)
        out = {
            "Phi": lambda q, v: p["c"] * (v["x1"] - v["x2"]) ** 2 / 2,
            "C[1,1]": p["c"],
            "C[1,2]": -p["c"],
        }
        for i, s in enumerate(pairs, 1):
            out[f"zeta[{i}]"] = float(-re(s) / abs(s))
            out[f"omega_d[{i}]"] = float(im(s))
            out[f"period_d[{i}]"] = float(2 * pi / im(s))
            ratio = (c * s + ks) / (ms * s**2 + c * s + ks)
            out[f"abs(mode_d[{i},x2])"], out[f"arg(mode_d[{i},x2])"] = float(abs(ratio)), float(arg(ratio))
        return out
