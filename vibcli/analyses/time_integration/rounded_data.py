"""The data of a motion as floats: each constant differs from the decimal that was written by up to its last digit.

What that does to a motion is found from equations whose constants are all changed at once, each by STEP times a number
of its own, the same wherever the same constant stands: a direction in the space of the data. The effects of DIRECTIONS
independent ones give the size of the effect of any.
"""

from collections.abc import Mapping, Sequence
from math import frexp, isfinite, sqrt
from typing import TYPE_CHECKING, Any

from vibcli.mechanics.numeric_equations import NumericEquations
from vibcli.mechanics.switching import Switching

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.time_integration.trajectory import Trajectory

STEP = 1e-7             # by which constants are changed, relative
DIRECTIONS = 8
SHORT = 2.0**32         # constants of so few binary digits are exact: 2, 0.5, 9e5


class ChangeOfData:
    """A change of all constants: called with one it gives it changed."""

    def __init__(self, seed: int) -> None:
        import numpy as np

        self._random, self._parts = np.random.default_rng(seed), {}

    def __call__(self, value: float) -> float:
        return value * (1 + STEP * self.part(value))

    def part(self, value: float) -> float:
        """By how many STEPs a constant is changed: 0 of those that are exact; of variance 1."""
        size = abs(value)
        if size not in self._parts:
            exact = not isfinite(size) or (frexp(size)[0] * SHORT).is_integer()
            self._parts[size] = 0.0 if exact else float(self._random.uniform(-sqrt(3), sqrt(3)))
        found: float = self._parts[size]
        return found


class Varied:
    """The equations of a trajectory, first as they are, then with their data changed: systems, their switchings."""

    def __init__(self, trajectory: "Trajectory") -> None:
        scene, floats = trajectory.system.scene, trajectory.system.floats
        owners, bounds = scene.law_switches()
        self.systems, self.switchings = [trajectory.system], [trajectory.switching]
        self.directions = [ChangeOfData(seed) for seed in range(DIRECTIONS)]
        for direction in self.directions:
            system = NumericEquations(scene, changed(floats, direction), trajectory.system.redundant, direction,
                                      trajectory.system)
            self.systems.append(system)
            self.switchings.append(Switching(system, bounds, owners))

    def accelerations(self, which: int, t: Any, q: Any, v: Any, g: Sequence[Any],
                      slides: Sequence[int]) -> "np.ndarray":
        """q̈ of the equations `which` while the switches stay as they are."""
        if slides:
            return self.switchings[which].sliding(slides, t, q, v, g)[0]
        return self.systems[which].accelerations(t, q, v, g)


def changed(floats: Mapping[str, float], direction: ChangeOfData) -> dict[str, float]:
    """The values of parameters, changed."""
    return {name: direction(value) if isinstance(value, float) else value for name, value in floats.items()}
