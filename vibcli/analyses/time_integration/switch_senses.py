"""The senses σ of what bends or jumps, along a motion: those of its windows, so that where one changes it is that just
after; while it sticks, what keeps the argument at zero, between −σ₀ and σ₀. The sign of an argument that is held is
that of rounding and says nothing.
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.trajectory import Trajectory
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

    OfStates = Callable[[np.ndarray, np.ndarray, np.ndarray], Sequence[float | np.ndarray]]

SAMPLES, NEAR, SAME = 4, 0.01, 1e-9     # states at which two arguments are compared, how far from the motion


def senses(trajectory: "Trajectory", scene: "Scene", arguments: "Sequence[Node]", values: Any, times: np.ndarray,
           of_states: "OfStates | None" = None) -> list[np.ndarray]:
    """σ of `arguments`, nodes of a scene with the same laws as the one that is integrated, at times; values: of the
    arguments there; of_states(t, q, q̇): those at other states of the one that is integrated, by which arguments are
    recognised that stand in no law."""
    found = [np.sign(np.broadcast_to(value, times.shape)) for value in values]
    if not trajectory.switching.count:
        return found
    known = _along(trajectory, times)
    twins = [_twin(trajectory, scene, argument) for argument in arguments]
    if of_states is not None and None in twins:
        twins = _recognised(trajectory, twins, of_states)
    for i, twin in enumerate(twins):
        if twin is not None:
            number, sign = twin
            found[i] = sign * known[number]
    return found


def _along(trajectory: "Trajectory", times: np.ndarray) -> np.ndarray:
    """σ of every switch at times, of shape (switches, times)."""
    number = np.clip(np.searchsorted(trajectory.starts, times, side="right") - 1, 0, len(trajectory.windows) - 1)
    known = np.array([trajectory.windows[i].g for i in number], dtype=float).T
    for k, sigma in trajectory.held(times).items():
        known[k] = np.where(np.isnan(sigma), known[k], sigma)
    return known


def _twin(trajectory: "Trajectory", scene: "Scene", argument: "Node") -> tuple[int, float] | None:
    """(number of the switch of the same law in the scene that is integrated, 1); None of what stands in no law."""
    own, switches = trajectory.system.scene, trajectory.system.switches[:trajectory.switching.count]
    if scene is not own:
        mine, theirs = list(own.law_switches()[0]), list(scene.law_switches()[0])
        if argument not in theirs or len(mine) != len(theirs):
            return None
        argument = mine[theirs.index(argument)]
    return (switches.index(argument), 1.0) if argument in switches else None


def _recognised(trajectory: "Trajectory", twins: "Sequence[tuple[int, float] | None]",
                of_states: "OfStates") -> list[tuple[int, float] | None]:
    """The same, with those that are, but for their sign, a switch at random states near the motion."""
    draw, count = np.random.default_rng(1), trajectory.switching.count
    windows = [trajectory.windows[i] for i in draw.integers(len(trajectory.windows), size=SAMPLES)]
    size = np.array([abs(np.array([getattr(window, name) for window in trajectory.windows])).max(initial=0.0) or 1.0
                     for name in "qv"])
    q, v = (np.array([getattr(window, name) for window in windows]).T + NEAR * reach * draw.uniform(-1, 1, (
        len(trajectory.names), SAMPLES)) for name, reach in zip("qv", size, strict=True))
    t = np.array([window.start for window in windows])
    switches = trajectory.switching.values(t, q, v, np.ones((count, SAMPLES)))
    theirs = [np.broadcast_to(value, t.shape) for value in of_states(t, q, v)]
    return [twin or next(((k, sign) for k in range(count) for sign in (1.0, -1.0)
                          if (abs(values - sign * switches[k]) <= SAME * abs(switches[k])).all()), None)
            for twin, values in zip(twins, theirs, strict=True)]
