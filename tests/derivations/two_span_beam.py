"""The three-moment equation of vibration: coth ba - cot ba + coth bb - cot bb = 0, without poles, in 30 digits."""
from mpmath import cos, coth, findroot, mp, mpf, pi, sin, sqrt


def answers(p):
    with mp.workdps(30):
        a, b, EI, mu = (mpf(p[n]) for n in ("a", "b", "EI", "mu"))

        def f(x):
            return (sin(x * a) * sin(x * b) * (coth(x * a) + coth(x * b))
                    - cos(x * a) * sin(x * b) - cos(x * b) * sin(x * a))

        roots, step, x = [], mpf("0.001"), mpf("0.1")
        while len(roots) < 4:
            if f(x) * f(x + step) < 0:
                roots.append(findroot(f, (x, x + step), "anderson"))
            x += step
        return {f"frequency[{i}]": z**2 * sqrt(EI / mu) / (2 * pi) for i, z in enumerate(roots, 1)}
