"""Newton and Euler with the hinge forces eliminated, integrated by an eighth-order Runge-Kutta and an Adams-BDF
method at tight tolerances, which must agree and keep the energy; extremes by events.
"""
import numpy as np
from scipy.integrate import odeint, solve_ivp


def answers(p):
    M, m, L, k, phi0, g = (p[n] for n in ("M", "m", "L", "k", "phi0", "g"))

    def rates(t, z):
        x, phi, v, w = z
        s, c = np.sin(phi), np.cos(phi)
        # momentum along the rails; moments of the rod about the accelerated hinge
        matrix = [[M + m, m * L / 2 * c], [m * L / 2 * c, m * L**2 / 3]]
        return [v, w, *np.linalg.solve(matrix, [m * L / 2 * w**2 * s - k * x, -m * g * L / 2 * s])]

    def energy(z):
        x, phi, v, w = z
        speed = (v + L / 2 * w * np.cos(phi)) ** 2 + (L / 2 * w * np.sin(phi)) ** 2
        return (M * v**2 + m * speed + m * L**2 / 12 * w**2 + k * x**2) / 2 - m * g * L / 2 * np.cos(phi)

    events = [lambda t, z: z[2], lambda t, z: rates(t, z)[3]]
    run = solve_ivp(rates, (0, 2), [0, phi0, 0, 0], method="DOP853", rtol=1e-13, atol=1e-14, dense_output=True,
                    events=events)
    other = odeint(lambda z, t: rates(t, z), [0, phi0, 0, 0], [0, 0.5, 1.5, 2], rtol=1e-11, atol=1e-12, mxstep=10000)
    assert np.allclose(other[1:], run.sol([0.5, 1.5, 2]).T, rtol=1e-7, atol=1e-8)
    assert abs(energy(run.y[:, -1]) - energy(run.y[:, 0])) < 1e-10

    def motion_x(q, v, a):
        swing = a["phi"] * np.cos(q["phi"]) - v["phi"] ** 2 * np.sin(q["phi"])
        return (M + m) * a["x"] + m * L / 2 * swing + k * q["x"]

    def motion_phi(q, v, a):
        return m * L**2 / 3 * a["phi"] + m * L / 2 * (np.cos(q["phi"]) * a["x"] + g * np.sin(q["phi"]))

    def moment(phi):
        """Of the weight about the hinge, by its arm."""
        return -m * g * (L / 2 * np.sin(phi))

    def coupling(phi):
        """Of the momentum along the rails with the rod's turning: the speed of its centre along them."""
        return m * (L / 2 * np.cos(phi))

    def steepness(phi, h=1e-5):
        return -(moment(phi + h) - moment(phi - h)) / (2 * h)

    half, late = run.sol(0.5), run.sol(1.5)
    places = [0, *(z[0] for z in run.y_events[0]), run.y[0, -1]]
    return {
        "motion[x]": motion_x,
        "motion[phi]": motion_phi,
        "M[x,phi](0 s)": coupling(phi0),
        "Q[phi](0 s)": moment(phi0),
        "K[phi,phi](0 s)": steepness(phi0),
        "M[x,phi](0.5 s)": coupling(half[1]),
        "Q[x](0.5 s)": -k * half[0],
        "Q[phi](0.5 s)": moment(half[1]),
        "K[phi,phi](0.5 s)": steepness(half[1]),
        "x(0.5 s)": half[0],
        "phi(0.5 s)": half[1],
        "x(1.5 s)": late[0],
        "phi(1.5 s)": late[1],
        "s.energy(1.5 s)": k * late[0] ** 2 / 2,
        "max(x)": max(places),
        "min(x)": min(places),
        "min(phi')": min([0, *(z[3] for z in run.y_events[1]), run.y[3, -1]]),
    }
