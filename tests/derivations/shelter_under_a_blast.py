"""Energy of weights and brace by second differences in 30 digits. The response to the triangle from the closed
solution x = F/K (1 - cos wt - t/td + sin wt/(w td)) while it lasts, checked by Duhamel's integral in quadrature,
and free after.
"""
import mpmath as mp


def answers(p):
    with mp.workdps(30):
        M, m, L, k, F0, td, g = (mp.mpf(repr(p[n])) for n in ("M", "m", "L", "k", "F0", "td", "g"))
        inertia = M * L**2 + 2 * m * L**2 / 3
        along, up = 3 * L / 4, L

        def energy(phi):
            x, y = L * mp.sin(phi), L * (mp.cos(phi) - 1)
            stretch = mp.hypot(along + x, up + y) - mp.hypot(along, up)
            return k * stretch**2 / 2 + M * g * y + 2 * m * g * y / 2

        stiffness = mp.diff(energy, 0, 2)
        w = mp.sqrt(stiffness / inertia)
        static = F0 * L / stiffness

        def during(t):
            return static * (1 - mp.cos(w * t) - t / td + mp.sin(w * t) / (w * td))

        duhamel = static * w * mp.quad(lambda s: (1 - s / td) * mp.sin(w * (td - s)), mp.linspace(0, td, 9))
        place, rate = during(td), mp.diff(during, td)
        assert abs(duhamel - place) < 1e-20
        residual = mp.hypot(place, rate / w)
        turning = mp.findroot(lambda t: mp.diff(during, t), (mp.pi / 2 / w, mp.pi / w), solver="anderson")
        assert turning < td and during(turning) > residual
        out = {"M[phi,phi]": inertia, "K[phi,phi]": stiffness, "omega[1]": w, "max(phi)": during(turning),
               "argmax(phi)": turning, "min(phi)": -residual, "phi(td)": place, "phi'(td)": rate,
               "max(brace.force)": k * L * mp.mpf(3) / 5 * during(turning)}
        return {key: float(value) for key, value in out.items()}
