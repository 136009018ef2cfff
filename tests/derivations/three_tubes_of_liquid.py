"""Unsteady pressure balance along the pipes instead of energies.

At the foot of a tube the pressure is rho((g + x'')H + g x), to first order; the liquid in a pipe of
length B is driven by the difference of the feet. Pipe one carries -x1 towards the middle, pipe two the
rise of the third tube. The two balances are solved for the accelerations; the balances are then combined
into work on x1 and x2 for M and K.
"""
import numpy as np


def answers(p):
    rho, A, H, B, g = (p[n] for n in ("rho", "A", "H", "B", "g"))
    rise = np.array([[1.0, 0.0], [0.0, 1.0], [-1.0, -1.0]])
    inertia, weight = rho * H * rise, rho * g * rise
    # first - middle + rho B x1'' = 0 ; middle - third - rho B x3'' = 0
    jump = np.array([[1.0, -1.0, 0.0], [0.0, 1.0, -1.0]])
    pipes = rho * B * np.array([rise[0], -rise[2]])
    left, right = jump @ inertia + pipes, jump @ weight
    lam, vec = np.linalg.eig(np.linalg.solve(left, right))
    slow, fast = np.argsort(lam.real)
    # a rise x1 sends liquid through both pipes, a rise x2 only through the second
    work = A * np.array([[1.0, 1.0], [0.0, 1.0]])
    return {
        "omega[1]": float(np.sqrt(lam[slow].real)),
        "omega[2]": float(np.sqrt(lam[fast].real)),
        "mode[1][x2]": float((vec[1, slow] / vec[0, slow]).real),
        "mode[2][x2]": float((vec[1, fast] / vec[0, fast]).real),
        "M[1,2]": float((work @ left)[0, 1]),
        "K[1,1]": float((work @ right)[0, 0]),
    }
