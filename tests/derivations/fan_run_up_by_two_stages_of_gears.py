"""Everything referred to the motor's shaft: torques passed down the train by Newton's second law, x' = A x + b, whose
solution is e^{At} of the enlarged matrix; at the end the motor's moment, times the ratio, is what the fan's brake
takes.
"""
import numpy as np
from scipy.linalg import eigh, expm


def answers(p):
    n = p["r1"] / p["r2"] * p["r3"] / p["r4"]
    lay = p["J2"] * (p["r1"] / p["r2"]) ** 2 + p["J3"] * n**2
    fan, brake, soft = p["J4"] * n**2, p["c"] * n**2, p["k2"] * n**2        # as seen by the pinion

    def rates(x):
        """Rates of (motor, pinion, fan as seen by the pinion, and their speeds, 1)."""
        motor, pinion, last, w1, w2, w3, one = x
        front, back = p["k1"] * (pinion - motor), soft * (last - pinion)
        last_rate = -(back + brake * w3) / fan
        return np.array([w1, w2, w3, (p["M0"] * one + front) / p["J1"], (back - front) / lay, last_rate, 0.0])

    A = np.array([rates(column) for column in np.eye(7)]).T
    at = expm(A * 0.7)[:, 6]
    springs = np.array([[p["k1"], -p["k1"], 0.0], [-p["k1"], p["k1"] + soft, -soft], [0.0, -soft, soft]])
    squares = eigh(springs, np.diag([p["J1"], lay, fan]), eigvals_only=True)
    return {
        "omega[1]": 0.0,
        "omega[2]": np.sqrt(squares[1]),
        "omega[3]": np.sqrt(squares[2]),
        "motor.angle(0.7 s)": at[0],
        "fan.angle(0.7 s)": n * at[2],
        "s2.force(0.7 s)": soft * (at[2] - at[1]) / n,
        "final(fan.angle')": p["M0"] / (p["c"] * n),
        "final(s2.force)": -p["M0"] / n,
    }
