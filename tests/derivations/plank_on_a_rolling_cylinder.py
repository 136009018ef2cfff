"""Places of cylinder and plank by rotations and arcs; both matrices from them by numerical differences.

The cylinder's centre is at -R phi. Seen from axes that turn with the line of centres, by theta, the plank touches
R + h below its middle after it has rolled over the arc R (theta - phi).
"""
import numpy as np
from mpmath import cos, diff, eye, matrix, mp, mpf, sin
from scipy.linalg import eigh


def answers(p):
    m, M, g, b, h, R, k = (mpf(p[n]) for n in ("m", "M", "g", "b", "h", "R", "k"))
    mp.dps = 30

    def plank(phi, theta):
        turned = matrix([[cos(theta), -sin(theta)], [sin(theta), cos(theta)]])
        return matrix([-R * phi, R]) + turned * matrix([R * (theta - phi), R + h])

    def slopes(part):
        return [diff(lambda *q: plank(*q)[part], (0, 0), order) for order in ((1, 0), (0, 1))]

    J = m * ((2 * b) ** 2 + (2 * h) ** 2) / 12
    inertia = M * R**2 / 2 * matrix([[1, 0], [0, 0]]) + M * R**2 * matrix([[1, 0], [0, 0]]) + J * (
        eye(2) - matrix([[1, 0], [0, 0]]))
    for part in (0, 1):
        row = slopes(part)
        inertia += m * matrix([[x * y for y in row] for x in row])

    def V(phi, theta):
        return k * (R * phi) ** 2 / 2 + m * g * plank(phi, theta)[1]

    stiffness = matrix([[diff(V, (0, 0), order) for order in row] for row in (((2, 0), (1, 1)), ((1, 1), (0, 2)))])
    squares, modes = eigh(np.array(stiffness.tolist(), float), np.array(inertia.tolist(), float))
    names, found = ("phi", "theta"), {}
    for letter, of in (("M", inertia), ("K", stiffness)):
        for i, j in ((0, 0), (0, 1), (1, 1)):
            found[f"{letter}[{names[i]},{names[j]}]"] = float(of[i, j])
    for i in (0, 1):
        found[f"omega[{i + 1}]"] = squares[i] ** 0.5
        found[f"mode[{i + 1}][theta]"] = modes[1, i] / modes[0, i]
    return found
