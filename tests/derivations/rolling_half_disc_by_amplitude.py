"""Centroid 4R/3π above the flat side's middle; the contact is the centre of turning: T = ½ (I_c + m d²) φ'², d from
contact to centroid. kappa from the period by quadrature at two small amplitudes, extrapolated (Richardson)."""

import mpmath
from mpmath import mp


def answers(p):
    m, R, g = (mp.mpf(p[name]) for name in ("m", "R", "g"))
    with mp.workdps(40):
        e = 4 * R / (3 * mp.pi)
        centroidal = m * R**2 / 2 - m * e**2

        def inertia(a):
            return centroidal + m * (R**2 + e**2 - 2 * R * e * mp.cos(a))

        natural = mp.sqrt(m * g * e / inertia(mp.mpf(0)))

        def change(A):
            def pace(u):
                with mp.workdps(120):
                    a = A * mp.sin(u)
                    drop = 2 * m * g * e * mp.sin((A + a) / 2) * mp.sin((A - a) / 2)
                    return A * mp.cos(u) * mp.sqrt(inertia(a) / (2 * drop))

            return (mp.pi / (2 * mpmath.quad(pace, [0, mp.pi / 2])) / natural - 1) / A**2

        near, far = change(mp.mpf("1e-4")), change(mp.mpf("2e-4"))
        return {"omega[1]": natural, "backbone[1, phi^2]": (4 * near - far) / 3}
