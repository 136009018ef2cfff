"""The corner alone as a particle: its energy on a circle of small radius, fitted by the mean and second harmonic."""
from mpmath import atan2, cos, hypot, mp, mpf, pi, sin, sqrt


def answers(p):
    with mp.workdps(50):
        k1, k2, b, r = mpf(p["k1"]), mpf(p["k2"]), mpf(p["b"]), mpf(10) ** -20

        def resists(f):
            x, y = r * cos(f), r * sin(f)
            stored = k1 * (hypot(b - x, y) - b) ** 2 + k2 * (hypot(b - x, b - y) - sqrt(2) * b) ** 2
            return stored / r**2

        count = 16
        values = [(2 * pi * i / count, resists(2 * pi * i / count)) for i in range(count)]
        middle = sum(v for _, v in values) / count
        u, w = (2 * sum(v * wave(2 * f) for f, v in values) / count for wave in (cos, sin))
        found = {"max": middle + hypot(u, w), "min": middle - hypot(u, w), "angle": atan2(w, u) / 2}
        return {f"stiffness[C].{part}": float(value) for part, value in found.items()} | {
            "stiffness[D].yy": p["k3"], "stiffness[D].xx": 0.0, "stiffness[D].angle": float(pi / 2)}
