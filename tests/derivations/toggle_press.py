"""Both bars rise at one angle beta, so K is at (cos, sin) and S at twice the cosine, times the bars' length.

The work of the constant loads and weights is a function U of beta. U' = 0 at the drawn angle says balance; K is −U'',
M twice the energy of the parts at beta' = 1, all by derivatives of 30 digits.
"""


def answers(p):
    import mpmath as mp

    m, M, b, h, F, g = (mp.mpf(p[n]) for n in ("m", "M", "b", "h", "F", "g"))
    length, drawn = mp.hypot(b, h), mp.atan2(h, b)

    def ram(beta):
        return 2 * length * mp.cos(beta)

    def work(beta):
        knee = length * mp.sin(beta)
        force = ((F + m * g) * b - p["M0"]) / (2 * h)
        return -F * knee - 2 * m * g * knee / 2 + p["M0"] * beta - force * ram(beta)

    with mp.workdps(30):
        slope, stiffness = mp.diff(work, drawn), -mp.diff(work, drawn, 2)
        places = [(m, lambda u: length * mp.cos(u) / 2), (m, lambda u: length * mp.sin(u) / 2),
                  (m, lambda u: 3 * length * mp.cos(u) / 2), (m, lambda u: length * mp.sin(u) / 2), (M, ram)]
        inertia = sum(w * mp.diff(s, drawn) ** 2 for w, s in places) + 2 * m * length**2 / 12
    balanced = 0.0 if abs(slope) < 1e-12 else float("nan")
    return {"equilibrium[phi]": balanced, "equilibrium[x]": balanced, "K[phi,phi]": float(stiffness),
            "M[phi,phi]": float(inertia)}
