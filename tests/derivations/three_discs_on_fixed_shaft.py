"""Holzer's method in 40 digits: twists and moments carried from the wall to the free end, where no moment is left.

The residual moment is a cubic in omega^2; its roots are bracketed by trial, their derivatives are differences.
Rayleigh's shape is the twist piece by piece under the moments outside it, Dunkerley's sum that of the discs one at a
time.
"""
from mpmath import diff, findroot, mp, mpf, sqrt


def answers(p):
    with mp.workdps(40):
        exact = {name: mpf(repr(value)) for name, value in p.items()}
        J, k = [exact[f"J{i}"] for i in (1, 2, 3)], [exact[f"k{i}"] for i in (1, 2, 3)]
        twist, total = [], 0
        for i in range(3):
            total += sum(J[i:]) / k[i]
            twist.append(total)
        out = {
            "omega[1]": omega(exact, 1),
            "rayleigh": sqrt(sum(J[i] * twist[i] for i in range(3)) / sum(J[i] * twist[i] ** 2 for i in range(3))),
            "dunkerley": 1 / sqrt(sum(J[i] * sum(1 / stiffness for stiffness in k[:i + 1]) for i in range(3))),
        }
        for i, name in ((1, "J3"), (1, "k1"), (1, "k2"), (1, "k3"), (2, "k1"), (2, "k3")):
            out[f"sensitivity[{i},{name}]"] = diff(
                lambda value, i=i, name=name: omega(exact | {name: value}, i), exact[name], h=exact[name] / 10**13)
        return {key: float(value) for key, value in out.items()}


def left_over(p, square):
    """The moment left at the free end, for a unit twist of the first disc."""
    twist, moment = mpf(1), p["k1"]
    for i in (1, 2):
        moment -= square * p[f"J{i}"] * twist
        twist += moment / p[f"k{i + 1}"]
    return moment - square * p["J3"] * twist


def omega(p, i):
    """The i-th root, between the trial values where the residual changes its sign."""
    step = mpf(500)
    trials = [n * step for n in range(400)]
    signs = [n for n in range(399) if left_over(p, trials[n]) * left_over(p, trials[n + 1]) < 0]
    low, high = trials[signs[i - 1]], trials[signs[i - 1] + 1]
    return sqrt(findroot(lambda square: left_over(p, square), (low, high), solver="anderson", tol=1e-60))
