"""The wire is taken as particles along its two pieces, summed by quadrature in mpmath: mass, static
moment and moment about O. J_C follows as the sum of the squared distances from the mass centre. The
frequency is from the second derivative of the potential energy of those particles, turned about O.
"""


def answers(p):
    import mpmath as mp

    mu, R, alpha = p["mu"], p["R"], p["alpha"]

    def along(density):
        stem = mp.quad(lambda s: density(mp.mpf(0), -s), [0, R])
        arch = mp.quad(lambda u: R * density(R * mp.sin(u), -R * mp.cos(u)), [-alpha, alpha])
        return mu * (stem + arch)

    mass = along(lambda x, y: 1)
    cx, cy = along(lambda x, y: x) / mass, along(lambda x, y: y) / mass
    about_pivot = along(lambda x, y: x**2 + y**2)
    about_centre = along(lambda x, y: (x - cx) ** 2 + (y - cy) ** 2)
    static_x, static_y = along(lambda x, y: x), along(lambda x, y: y)
    stiffness = mp.diff(lambda f: p["g"] * (static_x * mp.sin(f) + static_y * mp.cos(f)), 0, 2)
    return {
        "mass[anchor]": float(mass),
        "centre[anchor].x": float(cx),
        "centre[anchor].y": float(cy),
        "J[anchor, O]": float(about_pivot),
        "J[anchor]": float(about_centre),
        "omega[1]": float(mp.sqrt(stiffness / about_pivot)),
    }
