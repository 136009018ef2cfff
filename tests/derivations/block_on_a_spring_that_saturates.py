"""Beyond y it falls with the acceleration ω² y, within it goes as a wave; ω² = k/m."""

import mpmath


def answers(p):
    omega, y = mpmath.sqrt(p["k"] / p["m"]), p["y"]

    def speed_at_y(X):
        return omega * mpmath.sqrt(2 * y * (X - y))

    def period(X):
        v = speed_at_y(X)
        return 4 * (v / (omega**2 * y) + mpmath.atan(omega * y / v) / omega)

    return {"period(x)": period(p["A"]), "max(x')": mpmath.sqrt(speed_at_y(p["A"]) ** 2 + (omega * y) ** 2),
            "s.energy(0 s)": p["k"] * y * (p["A"] - y / 2), "backbone[1](x)(A/2)": 2 * mpmath.pi / period(p["A"] / 2)}
