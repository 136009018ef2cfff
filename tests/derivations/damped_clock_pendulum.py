"""One rigid body: total mass, mass centre, inertia about it, then J_O = J_C + M OC^2.

Energies follow from the mass centre. The dashpot coefficient is the square of the rate of its exact
length, by a central difference of 30 digits; stiffness by twice differencing the height of the mass
centre.
"""
from mpmath import cos, diff, hypot, mp, mpf, sin


def answers(p):
    with mp.workdps(30):
        m1, m2, L, r, b, w, ct, c, g = (mpf(p[n]) for n in ("m1", "m2", "L", "r", "b", "w", "ct", "c", "g"))
        mass = m1 + m2
        depth = (m1 * L / 2 + m2 * (L + r)) / mass
        JC = m1 * (L**2 / 12 + (depth - L / 2) ** 2) + m2 * (r**2 / 2 + (L + r - depth) ** 2)
        JO = JC + mass * depth**2
        rate = diff(lambda phi: hypot(b * sin(phi) + w, b * cos(phi) - b), 0)
        K = diff(lambda phi: -mass * g * depth * cos(phi), 0, 2)
        weight = float(mass * g * depth)
        return {
            "T": lambda q, v: float(JO) * v["phi"] ** 2 / 2,
            "V": lambda q: -weight * float(cos(q["phi"])),
            "M[phi,phi]": float(JO),
            "C[phi,phi]": float(ct + c * rate**2),
            "K[phi,phi]": float(K),
        }
