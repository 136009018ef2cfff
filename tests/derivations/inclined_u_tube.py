"""The tube's centre line is followed from one surface to the other: an arm at alpha, a level piece, an
arm at beta. The weight of the displaced column is integrated along it, and the second difference of that
energy is the stiffness. All liquid moves with x', so the inertia is its whole mass.
"""


def answers(p):
    import mpmath as mp

    arm = p["L"] / 3
    ends = (mp.sin(p["alpha"]), mp.sin(p["beta"]))

    def height(s):
        if s < arm:
            return (arm - s) * ends[0]
        return (s - 2 * arm) * ends[1] if s > 2 * arm else mp.mpf(0)

    def energy(x):
        column = mp.quad(height, [x, arm, 2 * arm, 3 * arm + x])
        return p["rho"] * p["A"] * p["g"] * column

    inertia = p["rho"] * p["A"] * p["L"]
    step = mp.mpf("0.01")
    stiffness = (energy(step) - 2 * energy(0) + energy(-step)) / step**2
    omega = mp.sqrt(stiffness / inertia)
    return {
        "M[x,x]": inertia,
        "equation[x]": lambda q, v, a: inertia * a["x"] + float(stiffness) * q["x"],
        "omega[1]": float(omega),
        "frequency[1]": float(omega / (2 * mp.pi)),
    }
