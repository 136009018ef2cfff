"""Statics of the resting platform: the pendulum's level pull m g theta balances the force, at its own natural
frequency; checked by the amplitudes of the two equations of motion for this and other lengths.
"""


def answers(p):
    M, m1, m, L, F0, W, g = (p[n] for n in ("M", "m1", "m", "L", "F0", "Omega", "g"))
    inertia, weight = M * L**2 + 2 * m1 * L**2 / 3 + m * L**2, M * g * L + 2 * m1 * g * L / 2 + m * g * L

    def amplitudes(length):
        a, b, d = weight - inertia * W**2, -m * L * length * W**2, m * g * length - m * length**2 * W**2
        det = a * d - b * b
        return F0 * L * d / det, -F0 * L * b / det

    length = g / W**2
    platform, bob = amplitudes(length)
    assert abs(platform) < 1e-9 * abs(bob) < abs(amplitudes(1.1 * length)[0]) * 1e9
    return {
        "l": length,
        "amplitude(theta)": abs(bob),
        "antiresonance[1](frf[phi, drive])": (g / length) ** 0.5,
        "amplitude(bob.x)": length * abs(bob),
        "M[phi,phi]": inertia,
        "M[phi,theta]": m * L * length,
        "K[phi,phi]": weight,
    }
