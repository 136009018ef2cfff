"""Tensions of ropes along a motion, and when one of them would have to push: there it goes slack.

A scene whose ropes are taut is integrated with the coordinates that they leave; λ of M q̈ + h + Σ λ ∂G/∂q = 0 over all
its coordinates is the tension.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.time_integration.level_crossings import passages
from vibcli.analyses.time_integration.switch_senses import senses
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.compiled_arrays import Compiled
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.trajectory import Trajectory
    from vibcli.mechanics.numeric_equations import NumericEquations
    from vibcli.mechanics.numeric_system import NumericSystem

NOTHING = 1e-10         # of the largest tension: no push


def slack(numeric: "NumericSystem", loose: "NumericEquations", trajectory: "Trajectory") -> tuple[float, str] | None:
    """(instant, name of the rope) at which a rope first goes slack; None where none does. `loose`: the System with all
    coordinates of the scene."""
    ropes = [k for k, tie in enumerate(loose.scene.constraints) if tie.form == "rope" and tie.name in loose.parts.names]
    found = []
    for k in ropes:
        name = loose.scene.constraints[k].whole
        number = loose.parts.names.index(loose.scene.constraints[k].name)

        def tension(times: np.ndarray, number: int = number) -> np.ndarray:
            found: np.ndarray = tensions(numeric, loose, trajectory, times)[number]
            return found

        largest = float(np.abs(tension(trajectory.starts)).max())
        for instant in [0.0, *passages(trajectory, tension, 0.0, trajectory.until)]:
            later = instant + 1e-6 * (trajectory.until - instant)
            if tension(np.array([later]))[0] < -NOTHING * largest:
                found.append((instant, name))
                break
    return min(found, default=None)


def tensions(numeric: "NumericSystem", loose: "NumericEquations", trajectory: "Trajectory",
             times: np.ndarray) -> np.ndarray:
    """The multipliers of all constraints at the times, of shape (constraints, times)."""
    arguments = list(loose.switches)
    compiled = Compiled(loose.scene, loose.floats, None, arguments)

    def of_states(t: np.ndarray, q: np.ndarray, v: np.ndarray) -> "tuple[float | np.ndarray, ...]":
        return compiled(t, *_all_coordinates(numeric, loose, trajectory, t, q, v))

    q, v = _all_coordinates(numeric, loose, trajectory, times, *trajectory.at(times)[:2])
    values = compiled(times, q, v) if arguments else ()
    return loose.solved(times, q, v, senses(trajectory, loose.scene, arguments, values, times, of_states))[1]


def _all_coordinates(numeric: "NumericSystem", loose: "NumericEquations", trajectory: "Trajectory", times: np.ndarray,
                     q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(q, q̇) of the scene with all its coordinates, from those that were integrated."""
    if trajectory.system is loose:
        return q, v
    scene = numeric.scene
    values = {**numeric.floats, scene.time.name: times}
    for primes, rows in (("", q), ("'", v)):
        values |= {name + primes: row for name, row in zip(trajectory.names, rows, strict=True)}
    nodes = [scene.symbol(name, primes) for primes in (0, 1) for name in loose.scene.coordinates]
    found = [np.broadcast_to(value, times.shape) for value in evaluate(nodes, Arrays, values)]
    return np.array(found[:loose.n]), np.array(found[loose.n:])
