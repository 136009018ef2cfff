"""The motion of the equations expanded to the third order, integrated; what is read off it are functions of its places
and velocities."""

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any, NoReturn

from vibcli.base.errors import PhysicsError
from vibcli.results.full_response import FullResponse
from vibcli.symbolic.syntax import parts_of

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.results.full_signals import FullSignal
    from vibcli.results.problem import Problem


THIRD_ORDER = "equations to the third order"


class ExpandedResponse(FullResponse):
    """That of a Problem about its equilibrium."""

    WORDS = "equations to the third order in the deviations from equilibrium, integrated"

    def __init__(self, problem: "Problem") -> None:
        super().__init__(problem)
        if problem.digits is not None:
            raise PhysicsError("motions of expanded equations are found in the digits of floats",
                               "leave --digits out, or ask for motion: full")

    @property
    def title(self) -> str:
        return f"{super().title} ({THIRD_ORDER})".strip()

    @cached_property
    def expanded(self) -> "Configuration":
        """The system whose equations are expanded, at the same equilibrium."""
        from vibcli.mechanics.configuration import Configuration
        from vibcli.mechanics.expanded_scene import expanded_scene, place_of_rest
        from vibcli.mechanics.expanded_system import ExpandedSystem
        from vibcli.mechanics.numeric_system import NumericSystem

        configuration, symbolic = self.problem.configuration, self.problem.symbolic
        system = ExpandedSystem(configuration.system, expanded_scene(symbolic.scene, place_of_rest(symbolic)))
        return Configuration(NumericSystem(system, configuration.numeric.given), configuration.equilibrium)

    @cached_property
    def full(self) -> FullResponse:
        """The motion of the full equations from the same start."""
        return FullResponse(self.problem)

    @property
    def _integrated(self) -> "Configuration":
        return self.expanded

    def signal(self, tree: Any) -> "FullSignal":
        """The signal of a tree: a function of places, velocities and accelerations, and of forces of elements."""
        if any(name in ("T", "V", "Phi") for name, *_ in parts_of(tree).names):
            raise PhysicsError("energies along a motion of the expanded equations are not told",
                               "ask for them with motion: full, or for their factors, as in V[x^2]")
        return super().signal(tree)

    def forces(self, wanted: Mapping[str, str], places: Any, trajectory: Any) -> NoReturn:
        raise PhysicsError("forces of supports and constraints are not those of the expanded equations",
                           "ask for them with motion: full")

    @property
    def precise(self) -> NoReturn:
        raise PhysicsError("motions of expanded equations are found in the digits of floats",
                           "leave --digits out, or ask for motion: full")

    @cached_property
    def _exact_period(self) -> tuple[float, float] | None:
        from vibcli.analyses.nonlinear.period import exact_period

        if len(self.problem.scene.coordinates) != 1:
            return None
        self._require_start()
        places, speeds = self.problem.initial.start
        (q,), (v,) = places.values(), speeds.values()
        return exact_period(self.expanded.scene, self.problem.numeric.floats, q, v)
