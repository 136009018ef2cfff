"""Energy: the period by the complete elliptic integral of sin(phi0/2), the angle by Jacobi's functions, as
sin(phi/2) = sin(phi0/2) cd(w t); the period again by quadrature of dphi/phi'."""
import mpmath as mp


def answers(p):
    m1, L, m2, r, phi0, g = (p[n] for n in ("m1", "L", "m2", "r", "phi0", "g"))
    J = m1 * L**2 / 12 + m1 * L**2 / 4 + m2 * r**2 / 2 + m2 * (L + r) ** 2
    S = m1 * L / 2 + m2 * (L + r)
    w, k = mp.sqrt(S * g / J), mp.sin(mp.mpf(phi0) / 2)
    period = 4 * mp.ellipk(k * k) / w
    again = 4 / w * mp.quad(lambda u: 1 / mp.sqrt(1 - (k * mp.sin(u)) ** 2), [0, mp.pi / 2])
    assert abs(period - again) < 1e-12

    def phi(t):
        u = w * t
        return 2 * mp.asin(k * mp.ellipfun("cd", u, k=k))

    return {
        "motion[phi]": lambda q, v, a: J * a["phi"] + S * g * float(mp.sin(q["phi"])),
        "period[1]": float(2 * mp.pi / w),
        "period(phi)": float(period),
        "max(phi')": float(mp.sqrt(2 * S * g * (1 - mp.cos(phi0)) / J)),
        "phi(0.5 s)": float(phi(0.5)),
        "phi(3 s)": float(phi(3)),
    }
