"""Statics of the drawn position gives the tension of each spring; the force on the body at a displaced
place is the vector sum of two central forces and its weight. The stiffness matrix is the negative
Jacobian of that force, differentiated numerically at 30 digits.
"""


def answers(p):
    import mpmath as mp

    m, k, length, alpha, g = (p[name] for name in ("m", "k", "l", "alpha", "g"))
    tension = m * g / (2 * mp.sin(alpha))
    anchors = [(side * length * mp.cos(alpha), length * mp.sin(alpha)) for side in (-1, 1)]

    def force(x, y):
        fx, fy = mp.mpf(0), mp.mpf(-m * g)
        for ax, ay in anchors:
            now = mp.hypot(ax - x, ay - y)
            pull = tension + k * (now - length)
            fx, fy = fx + pull * (ax - x) / now, fy + pull * (ay - y) / now
        return fx, fy

    with mp.workdps(30):
        kxx = -mp.diff(lambda x: force(x, 0)[0], 0)
        kxy = -mp.diff(lambda y: force(0, y)[0], 0)
        kyy = -mp.diff(lambda y: force(0, y)[1], 0)
    middle, spread = (kxx + kyy) / 2, mp.hypot((kxx - kyy) / 2, kxy)
    return {
        "equilibrium[x]": 0.0,
        "equilibrium[y]": 0.0,
        "K[x,x]": float(kxx),
        "K[x,y]": float(kxy),
        "K[y,y]": float(kyy),
        "omega[1]": float(mp.sqrt((middle - spread) / m)),
        "omega[2]": float(mp.sqrt((middle + spread) / m)),
    }
