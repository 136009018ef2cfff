"""omega = pi omega_0 / (2 K(sin(a/2))); the bob rises by L (1 - cos a), half of that is the amplitude of y."""

import mpmath


def answers(p):
    natural = mpmath.sqrt(p["g"] / p["L"])

    def omega(a):
        return natural * mpmath.pi / (2 * mpmath.ellipk(mpmath.sin(a / 2) ** 2))

    degree = mpmath.pi / 180
    return {"omega[1]": natural, "backbone[1](phi)(20 deg)": omega(20 * degree),
            "backbone[1](phi)(90 deg)": omega(90 * degree), "backbone[1](phi)(170 deg)": omega(170 * degree),
            "backbone[1](bob.y)(L/4)": omega(mpmath.acos(mpmath.mpf(1) / 2))}
