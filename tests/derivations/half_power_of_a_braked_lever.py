"""Complex compliance from moments about the pin (arm of the force 2 a); peak by a search, half power by bisection."""
from cmath import phase
from math import sqrt

from scipy.integrate import quad
from scipy.optimize import brentq, minimize_scalar


def answers(p):
    m, a, k, F0, Omega = (p[n] for n in ("m", "a", "k", "F0", "Omega"))
    J = m / (3 * a) * quad(lambda x: x * x, -2 * a, a)[0]
    K = k * a**2
    w = sqrt(K / J)
    C = sqrt(k * m) / 16 * (2 * a) ** 2

    def compliance(u):
        """Turn by force at the frequency u w."""
        return 2 * a / complex(K - J * (u * w) ** 2, C * u * w)

    unit = abs(compliance(1.0))
    peak = minimize_scalar(lambda u: -abs(compliance(u)) / unit, bounds=(0.8, 1.2), method="bounded",
                           options={"xatol": 1e-9})
    top = brentq(lambda u: (abs(compliance(u + 1e-5)) - abs(compliance(u - 1e-5))) / unit, 0.9, 1.05, xtol=1e-13)
    assert abs(top - peak.x) < 1e-6
    level = abs(compliance(top)) / sqrt(2) / unit
    half = [brentq(lambda u: abs(compliance(u)) / unit - level, *ends, xtol=1e-14) for ends in ((0.1, top), (top, 3))]
    return {
        "omega[1]": w,
        "zeta[1]": C / (2 * J * w),
        "peak[1](frf[phi, drive]).Omega": sqrt(31 / 32) * w if abs(top - sqrt(31 / 32)) < 1e-8 else top * w,
        "peak[1](frf[phi, drive]).value": abs(compliance(top)),
        "half_power[1](frf[phi, drive])": half[0] * w,
        "half_power[2](frf[phi, drive])": half[1] * w,
        "abs(frf[phi, drive](w))": unit,
        "amplitude(low.x)": 2 * a * F0 * abs(compliance(Omega / w)),
        "phase(phi)": -phase(compliance(Omega / w)),
    }
