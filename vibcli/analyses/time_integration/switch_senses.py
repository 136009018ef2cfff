"""The senses σ of what bends or jumps, along a motion: ±1 by the sign of its argument; while it sticks, what keeps the
argument at zero, between −σ₀ and σ₀. The sign of an argument that is held is that of rounding and says nothing.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.trajectory import Trajectory
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def senses(trajectory: "Trajectory", scene: "Scene", arguments: "Sequence[Node]", values: Any,
           times: np.ndarray) -> list[np.ndarray]:
    """σ of `arguments`, nodes of a scene with the same laws as the one that is integrated, at times; values: of the
    arguments there."""
    found = [np.sign(np.broadcast_to(value, times.shape)) for value in values]
    for k, sigma in trajectory.held(times).items():
        argument = _twin(trajectory, scene, trajectory.system.switches[k])
        if argument in arguments:
            i = arguments.index(argument)
            found[i] = np.where(np.isnan(sigma), found[i], sigma)
    return found


def _twin(trajectory, scene, argument):
    """The argument of the same law in another scene; itself in its own."""
    own = trajectory.system.scene
    if scene is own:
        return argument
    mine, theirs = list(own.law_switches()[0]), list(scene.law_switches()[0])
    return theirs[mine.index(argument)] if argument in mine and len(mine) == len(theirs) else None
