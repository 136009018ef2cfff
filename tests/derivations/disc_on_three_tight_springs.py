"""Second differences of the springs' energy for finite displacements of the disc, in 30 digits.

The fastenings on the rim are placed by rotation and translation, the lengths taken exactly, the energy of
each spring is N d + k d^2/2. The stiffness matrix is the Hessian; inertias m, m and m R^2/2. Frequencies
from the diagonal, which is all there is.
"""
from mpmath import cos, diff, hypot, mp, mpf, pi, sin, sqrt


def answers(p):
    with mp.workdps(30):
        m, R, length, k, N = (mpf(p[n]) for n in ("m", "R", "l", "k", "N"))

        def V(x, y, phi):
            total = mpf(0)
            for n in range(3):
                t = 2 * pi * n / 3
                dx = (R + length) * cos(t) - x - R * cos(t + phi)
                dy = (R + length) * sin(t) - y - R * sin(t + phi)
                d = hypot(dx, dy) - length
                total += N * d + k * d**2 / 2
            return total

        kxx, kyy, kff = (diff(V, (0, 0, 0), n) for n in ((2, 0, 0), (0, 2, 0), (0, 0, 2)))
        kxf = diff(V, (0, 0, 0), (1, 0, 1))
        omega = sorted([sqrt(kxx / m), sqrt(kyy / m), sqrt(kff / (m * R**2 / 2))])
        out = {f"omega[{n}]": float(value) for n, value in enumerate(omega, 1)}
        out.update({"K[x,x]": float(kxx), "K[x,phi]": float(kxf), "K[phi,phi]": float(kff)})
        return out
