"""Free bodies: drum, moving pulley, load and block, with the tensions S1 (drum to pulley), S0 (pulley to ceiling) and
S2 (drum to block) as unknowns.

A turn of the drum hauls the block up by r phi and lets the pulley roll down the standing part of its rope, half as
fast as the rope goes out, clockwise. Newton and Euler are linear in the accelerations and tensions; what they give at
unit displacements and loads makes M⁻¹K and M⁻¹, from which M, K, rest and frequencies follow.
"""
import numpy as np


def answers(p):
    J, R, r, mp, rho, m, mb, k1, k2, g = (p[n] for n in ("J", "R", "r", "mp", "rho", "m", "mb", "k1", "k2", "g"))

    def accelerations(q, load, gravity):
        """(phi'', z'') at q under a moment on the drum and an upward force on the load."""
        phi, z = q
        y, s = -R * phi / 2, r * phi
        hook, tie = k1 * (y - z), k2 * s
        rows = [                                              # phi'', z'', S1, S0, S2
            [J, 0, -R, 0, r],                                 # the pulley's rope drives, the block's holds back
            [-mp * R / 2, 0, -1, -1, 0],                      # mp y''
            [mp * rho**2 / 2 * R / (2 * rho), 0, rho, -rho, 0],    # clockwise: the drum's side sinks
            [0, m, 0, 0, 0],
            [mb * r, 0, 0, 0, -1],
        ]
        right = [load[0], -mp * gravity - hook, 0, load[1] + hook - m * gravity, -tie - mb * gravity * 3 / 5]
        return np.linalg.solve(rows, right)[:2]

    none, units = np.zeros(2), np.eye(2)
    flexible = np.column_stack([accelerations(none, u, 0) for u in units])
    M = np.linalg.inv(flexible)
    K = -M @ np.column_stack([accelerations(u, none, 0) for u in units])
    rest = np.linalg.solve(K, M @ accelerations(none, none, g))
    slow, fast = np.sort(np.roots([
        np.linalg.det(M), -(M[0, 0] * K[1, 1] + M[1, 1] * K[0, 0] - 2 * M[0, 1] * K[0, 1]), np.linalg.det(K)]).real)
    return {
        "M[phi,phi]": M[0, 0], "M[phi,z]": M[0, 1], "M[z,z]": M[1, 1],
        "K[phi,phi]": K[0, 0], "K[phi,z]": K[0, 1], "K[z,z]": K[1, 1],
        "equilibrium[phi]": rest[0], "equilibrium[s]": r * rest[0],
        "omega[1]": slow**0.5, "omega[2]": fast**0.5,
    }
