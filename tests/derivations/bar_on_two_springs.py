"""Plane statics of the freed bar: two force balances and the moment about its centre, with each spring
force along its own line, are solved by Newton's method in mpmath from the undeformed position. The
Jacobian of the same loads at the root is minus the stiffness matrix; with M = diag(m, m, m L²/12) it
gives the three frequencies.
"""


def answers(p):
    import mpmath as mp
    from scipy.linalg import eigh

    anchors = ((mp.matrix([0, p["h1"]]), -p["L"] / 2, p["k1"], mp.mpf(p["h1"])),
               (mp.matrix([p["L"] + p["d"], p["h2"]]), p["L"] / 2, p["k2"], mp.hypot(p["d"], p["h2"])))

    def loads(x, y, phi):
        fx, fy, moment = mp.mpf(0), mp.mpf(-p["m"] * p["g"]), mp.mpf(0)
        for anchor, arm, k, free in anchors:
            rx, ry = arm * mp.cos(phi), arm * mp.sin(phi)
            dx, dy = anchor[0] - (p["L"] / 2 + x + rx), anchor[1] - (y + ry)
            length = mp.hypot(dx, dy)
            tension = k * (length - free)
            sx, sy = tension * dx / length, tension * dy / length
            fx, fy, moment = fx + sx, fy + sy, moment + rx * sy - ry * sx
        return fx, fy, moment

    rest = list(mp.findroot(loads, (0, -0.05, 0)))
    K = [[0.0] * 3 for _ in range(3)]
    for j in range(3):
        step = mp.mpf("1e-5")
        ahead, behind = ([c + s * (i == j) for i, c in enumerate(rest)] for s in (step, -step))
        for i, (up, down) in enumerate(zip(loads(*ahead), loads(*behind), strict=True)):
            K[i][j] = float(-(up - down) / (2 * step))
    J = p["m"] * p["L"] ** 2 / 12
    squares = eigh(K, [[p["m"], 0, 0], [0, p["m"], 0], [0, 0, J]], eigvals_only=True)
    found = {f"equilibrium[{name}]": float(rest[i]) for i, name in enumerate(("x", "y", "phi"))}
    found["stable"] = bool(squares[0] > 0)
    return found | {f"omega[{i + 1}]": float(square) ** 0.5 for i, square in enumerate(squares)}
