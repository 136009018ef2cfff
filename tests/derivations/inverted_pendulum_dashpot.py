"""Potential energy for finite angles, differenced; then the roots of the characteristic equation.

Heights of the rod's centre and of the ball and the exact length of the spring give V(phi); its second
difference in 30 digits is the stiffness, whose sign decides stability. Roots of J s^2 + C s + K = 0 give
zeta and omega_d.
"""
from mpmath import cos, diff, hypot, im, mp, mpf, re, sin, sqrt


def answers(p):
    with mp.workdps(30):
        m, mb, L, a, b, w, k, c, g = (mpf(p[n]) for n in ("m", "mb", "L", "a", "b", "w", "k", "c", "g"))
        J = m * L**2 / 12 + m * (L / 2) ** 2 + mb * L**2

        def stiffness(k):
            def V(phi):
                d = hypot(-a * sin(phi) - w, a * cos(phi) - a) - w
                return (m * L / 2 + mb * L) * g * cos(phi) + k * d**2 / 2
            return diff(V, 0, 2)

        K = stiffness(k)
        C = c * diff(lambda phi: hypot(w - b * sin(phi), b * cos(phi) - b), 0) ** 2
        s = (-C + sqrt(mp.mpc(C**2 - 4 * J * K))) / (2 * J)
        return {
            "propped: zeta[1]": float(-re(s) / abs(s)),
            "propped: omega_d[1]": float(im(s)),
            "propped: K[1,1]": float(K),
            "propped: stable": bool(K > 0),
            "soft: stable": bool(stiffness(mpf(300)) > 0),
        }
