"""Momentum of the blow; the lowest place by the energy of weight and spring, k u²/2 − m₂ g u = (m₁ + m₂) v²/2, and the
time to it by the integral of du/v."""


def answers(p):
    import mpmath as mp

    m1, m2, k, h, g = (p[name] for name in ("m1", "m2", "k", "h", "g"))
    with mp.workdps(25):
        m, v = m1 + m2, m2 * mp.sqrt(2 * g * h) / (m1 + m2)
        omega = mp.sqrt(mp.mpf(k) / m)
        low = (m2 * g + mp.sqrt((m2 * g) ** 2 + k * m * v**2)) / k
        other = m2 * g * 2 / mp.mpf(k) - low
        # du/v between the turning places: u = middle + half·sin s takes the root out
        middle, half = (low + other) / 2, (low - other) / 2
        time = (mp.pi / 2 - mp.asin(-middle / half)) / omega
        place = mp.odefun(lambda t, y: [y[1], (m2 * g - k * y[0]) / m], 0, [mp.mpf(0), v])(mp.mpf("0.1"))[0]
    return {
        "equilibrium[u]": m2 * g / k,
        "omega[1]": float(omega),
        "u'(0 s)": float(v),
        "max(u)": float(low),
        "argmax(u)": float(time),
        "u(0.1 s)": float(place),
    }
