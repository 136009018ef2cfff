"""The same system as two masses 9 and 1 with springs 24 (to the wall) and 3 (between them).

Seen from the flexibility: a unit force on the first mass moves both by 1/24, one on the second moves it
by 1/24 + 1/3. The eigenvalues of flexibility times mass are 1/omega^2; modes are its eigenvectors.
"""
from math import pi, sqrt

import numpy as np


def answers(p):
    flexibility = np.array([[1 / 24, 1 / 24], [1 / 24, 1 / 24 + 1 / 3]])
    lam, vec = np.linalg.eig(flexibility @ np.diag([9.0, 1.0]))
    first, second = np.argsort(-lam)
    return {
        "omega[1]": 1 / sqrt(lam[first]),
        "omega[2]": 1 / sqrt(lam[second]),
        "frequency[2]": 1 / sqrt(lam[second]) / (2 * pi),
        "mode[1][x2]": vec[1, first] / vec[0, first],
        "mode[2][x2]": vec[1, second] / vec[0, second],
    }
