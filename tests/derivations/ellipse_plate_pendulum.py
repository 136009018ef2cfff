"""The plate is summed in stretched polar coordinates (x = a s cos u, y = b s sin u, area a b s ds du)
about the hanging vertex: Gauss points in s, equally spaced in u. Frequency of the compound pendulum from
those sums.
"""


def answers(p):
    from math import pi, sqrt

    import numpy as np

    nodes, weights = np.polynomial.legendre.leggauss(5)
    s, u = np.meshgrid((nodes + 1) / 2, np.arange(16) * 2 * pi / 16, indexing="ij")
    w = np.outer(weights / 2, np.full(16, 2 * pi / 16)) * s
    w *= p["m"] / w.sum()

    def hung(down, across):
        """Inertia about the upper vertex and frequency with the semi-axis `down` vertical."""
        x, y = across * s * np.cos(u), -down + down * s * np.sin(u)
        J = float((w * (x**2 + y**2)).sum())
        return J, sqrt(-p["g"] * float((w * y).sum()) / J)

    (long_J, long_omega), (short_J, short_omega) = hung(p["a"], p["b"]), hung(p["b"], p["a"])
    return {
        "long_axis: J[plate, O]": long_J,
        "long_axis: omega[1]": long_omega,
        "short_axis: J[plate, O]": short_J,
        "short_axis: omega[1]": short_omega,
    }
