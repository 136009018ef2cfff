"""Balance of the vertical forces at the height u of the apex, 2 k u (1 − l₀/√(b² + u²)) + m g = 0, squared to a
polynomial of fourth degree in u, whose real roots of the right sign are kept. The stiffness is the numerical derivative
of that force at each of them.
"""


def answers(p):
    import mpmath as mp

    k, b, h, g = (mp.mpf(p[name]) for name in ("k", "b", "h", "g"))
    rest = mp.hypot(b, h)

    def force(u, m):
        return 2 * k * u * (1 - rest / mp.sqrt(b**2 + u**2)) + m * g

    def positions(m):
        w = m * g / (2 * k)
        squared = [1, 2 * w, w**2 + b**2 - rest**2, 2 * w * b**2, w**2 * b**2]
        roots = mp.polyroots(squared, maxsteps=200, extraprec=200)
        real = [root.real for root in roots if abs(root.imag) < mp.mpf(10) ** -12]
        return sorted(u for u in real if abs(force(u, m)) < mp.mpf(10) ** -9 * m * g)

    def rate(u, m):
        """ω², negative where it falls away."""
        return mp.diff(lambda x: force(x, m), u) / m

    def omega(u, m):
        return float(mp.sqrt(rate(u, m)))

    light, heavy = mp.mpf(p["m"]), mp.mpf(2)
    low, middle, high = positions(light)
    only, = positions(heavy)
    return {
        "equilibria": len(positions(light)),
        **{f"equilibrium[y][{i}]": float(u - h) for i, u in enumerate((low, middle, high), 1)},
        **{f"stable[{i}]": bool(rate(u, light) > 0) for i, u in enumerate((low, middle, high), 1)},
        **{f"K[y,y][{i}]": float(light * rate(u, light)) for i, u in enumerate((low, middle, high), 1)},
        "omega[1][1]": omega(low, light),
        "growth_rate[1][2]": float(mp.sqrt(-rate(middle, light))),
        "omega[1][3]": omega(high, light),
        "twice as heavy: equilibria": len(positions(heavy)),
        "twice as heavy: stable[1]": bool(rate(only, heavy) > 0),
        "twice as heavy: equilibrium[y]": float(only - h),
        "twice as heavy: omega[1]": omega(only, heavy),
    }
