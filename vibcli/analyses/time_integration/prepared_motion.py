"""What all solutions of one motion share: the equations compiled, what drives them, where they start."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.time_integration.driven_places import driven_places
from vibcli.analyses.time_integration.forcing_breaks import breaks
from vibcli.analyses.time_integration.initial_state import start, vectors
from vibcli.analyses.time_integration.refined_windows import RefinedWindows, refinable
from vibcli.analyses.time_integration.series_windows import SeriesWindows
from vibcli.base.errors import PhysicsError
from vibcli.mechanics.numeric_equations import NumericEquations
from vibcli.mechanics.switching import Switching
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.trajectory import Trajectory
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.float_equations import FloatEquations
    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.scene.scene import Scene

LONGEST = 1e12


class PreparedMotion:
    """The motion of a system up to t = `until` [s]; initial: {x: m or rad, x': m/s or rad/s}. system: its equations;
    stops: the Breaks of what drives it; start: (q, q̇)."""

    def __init__(self, configuration: "Configuration", until: float,
                 initial: Mapping[str, float] | None = None) -> None:
        if not 0 < until < LONGEST:
            raise PhysicsError(f"a motion cannot end at t = {until:.6g} s", "ask for an instant after its start, t = 0")
        places, speeds = start(configuration, initial)
        numeric, drawn = configuration.numeric, configuration.scene
        scene = equations_of(numeric)
        self.configuration, self.until, self.initial = configuration, until, initial
        self.system = NumericEquations(scene, numeric.floats, drawn.freedom.redundant)
        owners, bounds = drawn.law_switches()
        self.driven = driven_places(scene)
        self.stops = breaks(scene, [*self.system.parts.nodes(), *self.driven], numeric.floats, until, numeric.work)
        self.start = vectors(scene, places, speeds)
        self.switching = Switching(self.system, bounds, owners)

    def other_windows(self, rtol: float, first: "Trajectory | None") -> "Sequence[RefinedWindows | SeriesWindows]":
        """Windows that are found by themselves, those before others where they pay: of compiled series; many at once,
        of errors of `rtol`. None where collocation from one to the next is better. first: the solution beside which
        a second one is found."""
        if self._in_floats is None:
            return ()
        return (SeriesWindows(self.system, self._in_floats.work, first is not None),
                RefinedWindows(self._in_floats, self.system.n, rtol, first))

    @cached_property
    def _in_floats(self) -> "FloatEquations | None":
        return refinable(self.system, self.switching, self.driven)

    @cached_property
    def units(self) -> np.ndarray:
        """The size of the figure along each coordinate."""
        return np.array(list(map(self.configuration.numeric.size_along, self.system.scene.coordinates)))


def equations_of(numeric: "NumericSystem") -> "Scene":
    """The scene whose equations are integrated: that with all its coordinates where loops are closed."""
    return numeric.scene if numeric.scene.loops is None else loose(numeric)


def loose(numeric: "NumericSystem") -> "Scene":
    """The scene with all its coordinates, its static preloads in numbers."""
    free = numeric.scene.with_multipliers() if numeric.scene.loops is None else numeric.system.scene_with_multipliers
    if not free.static_preloads:
        return free
    number, floats, preloads = free.table.number, numeric.floats, numeric.system.preloads
    return free.with_preloads({node: number(Fraction(evaluate([preloads[record.name]], Floats, floats)[0]))
                                for node, record in free.static_preloads})
