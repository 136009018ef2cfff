"""Duffing's motion in closed form: x = x0 cn(w t, k^2) with w^2 = (K + K3 x0^2)/M, k^2 = K3 x0^2/(2 (K + K3 x0^2));
the period again by quadrature of dx/x' from the energy (x = x0 sin u takes the singularity away)."""
import mpmath as mp


def answers(p):
    m, R, i, k, k3, x0 = (p[n] for n in ("m", "R", "i", "k", "k3", "x0"))
    M = m * (1 + (i / R) ** 2)

    def closed(x0):
        hard = k + k3 * x0**2
        return mp.sqrt(hard / M), k3 * x0**2 / (2 * hard)

    def period(x0):
        w, modulus = closed(x0)
        found = 4 * mp.ellipk(modulus) / w
        again = 4 * mp.quad(lambda u: mp.sqrt(M / (k + k3 * x0**2 * (1 + mp.sin(u) ** 2) / 2)), [0, mp.pi / 2])
        assert abs(found - again) < 1e-12
        return float(found)

    w, modulus = closed(x0)
    energy = k * x0**2 / 2 + k3 * x0**4 / 4
    place = x0 * mp.ellipfun("cn", w * 0.25, m=modulus)
    return {
        "Q[x](0 s)": float(-k * x0 - k3 * x0**3),
        "K[x,x](0 s)": float(mp.diff(lambda x: k * x + k3 * x**3, x0)),
        "K[x,x](0.25 s)": float(mp.diff(lambda x: k * x + k3 * x**3, place)),
        "motion[x]": lambda q, v, a: M * a["x"] + k * q["x"] + k3 * q["x"] ** 3,
        "omega[1]": (k / M) ** 0.5,
        "period(x)": period(x0),
        "max(x')": (2 * energy / M) ** 0.5,
        "x(0.25 s)": float(place),
        "x(2 s)": float(x0 * mp.ellipfun("cn", w * 2, m=modulus)),
        "wide:period(x)": period(3 * x0),
    }
