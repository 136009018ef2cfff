"""Strips of the half-disc (width 2√(r² - z²) at the depth z below its flat side) give mass centre and
inertia. The rolling turn is found from equal arcs on track and disc, and the stiffness from a second
difference of the mass centre's height along that motion; the inertia is the one about the lowest point
of the track, where the contact is.
"""


def answers(p):
    import mpmath as mp

    m, r, R, g = p["m"], p["r"], p["R"], p["g"]

    def total(f):
        # z = r sin(u) makes the strips smooth at the rim; f is summed across each strip's half width.
        def strip(u):
            z, half = r * mp.sin(u), r * mp.cos(u)
            return 2 * f(z, half) * r * mp.cos(u)
        return mp.quad(strip, [0, mp.pi / 2])

    density = m / total(lambda z, half: half)
    depth = density * total(lambda z, half: z * half) / m
    J = density * total(lambda z, half: (z - depth) ** 2 * half + half**3 / 3)

    def height(phi):
        # psi is the swing of the line of centres: the arcs R psi and r (psi - phi) are equal.
        psi = -r * phi / (R - r)
        return -(R - r) * mp.cos(psi) - depth * mp.cos(phi)

    stiffness = m * g * mp.diff(height, 0, 2)
    inertia = J + m * (r - depth) ** 2
    return {
        "J[half]": float(J),
        "K[phi,phi]": float(stiffness),
        "M[phi,phi]": float(inertia),
        "period[1]": float(2 * mp.pi * mp.sqrt(inertia / stiffness)),
    }
