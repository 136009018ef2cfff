"""Limit points of a Problem: values of one of its parameters at which two of its equilibria meet."""

from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import with_unit

if TYPE_CHECKING:
    from vibcli.analyses.limit_points.limit_points import FollowedPath, LimitPoint
    from vibcli.results.problem import Problem

DIGITS, GUARD = 17, 25       # of numbers that are floats in the end; beyond those asked


class LimitLoads:
    """Those of a parameter, on the path of equilibria through the one that is reached at the given values."""

    def __init__(self, problem: "Problem", name: str) -> None:
        self.problem, self.name = problem, name

    @cached_property
    def path(self) -> "FollowedPath":
        from vibcli.analyses.limit_points.equations import ParametricEquilibrium
        from vibcli.analyses.limit_points.limit_points import followed_path
        from vibcli.mechanics.equilibrium.scaled_forces import idle
        from vibcli.mechanics.nonsmooth import require_unheld

        problem, configuration = self.problem, self.problem.configuration
        if problem.spec.members:
            raise PhysicsError("equilibria of members are not followed: what they carry is found at one value of the "
                               "parameters", "ask with lumped bodies and springs, or for omega[1] at two values")
        require_unheld(problem.system)
        rest = configuration.equilibrium
        if configuration.scene.held or not configuration.scene.q:
            raise PhysicsError("nothing moves freely in this scene: it has one equilibrium")
        equations = ParametricEquilibrium(configuration.numeric, self.name, rest.values, idle(configuration.numeric))
        if not equations.names:
            raise PhysicsError("no force acts on what moves in this scene: no two equilibria meet")
        return followed_path(equations, problem.digits or DIGITS)

    @property
    def both(self) -> bool:
        """Are limit points of both signs counted?"""
        found: bool = self.problem.spec.parameters[self.name].get("sign") == "any"
        return found

    def limit_point(self, number: int) -> "LimitPoint":
        """That of a number, counted from 1; PhysicsError where there is none, or one before it may have been missed."""
        counted = self.path.counted(self.both)
        if number > len(counted):
            raise PhysicsError(self._missing(number, len(counted)), self._hint())
        found = counted[number - 1]
        self._require_complete(found)
        if self.problem.digits is not None and found.error > 10.0**-self.problem.digits * 2:
            raise PhysicsError(f"forces bend at {self.told(found.value)}, where '{self.name}' turns back: no more "
                               "digits of it are found", "leave --digits out")
        return found

    def at_limit_point(self, number: int, tree: Any) -> tuple[Any, float]:
        """(value, relative error) of a signal at rest there."""
        import mpmath

        from vibcli.results.motion_signals import node_of
        from vibcli.symbolic.evaluation import evaluate, multiprecision
        from vibcli.symbolic.running_errors import Rounded, RunningErrors, error_in, number_in

        found, scene = self.limit_point(number), self.problem.scene.resting
        node = node_of(self.problem, tree)
        with mpmath.workdps((self.problem.digits or DIGITS) + GUARD):
            arithmetic = RunningErrors(multiprecision(), mpmath.mp.eps)
            still = {v.name: mpmath.mpf(0) for v in scene.v}
            values = {name: Rounded(mpmath.mpf(x), found.error * abs(x) + found.blur * scene.unit_of(name) * (
                name in found.position)) for name, x in found.values.items()}
            value, = evaluate([node], arithmetic, {**values, **still})
            number, error = number_in(value), error_in(value)
            if abs(number) <= error:
                return mpmath.mpf(0), 0.0
            return +number, float(error / abs(number))

    def told(self, value: Any) -> str:
        return with_unit(float(value), self.problem.spec.dimensions.of(self.name))

    def _missing(self, number: int, count: int) -> str:
        low, high = self.path.reached
        found = f"only {count} {'is' if count == 1 else 'are'}" if count else "none is"
        return (f"there is no fold {number} of '{self.name}': {found} met by the equilibria that are followed from "
                f"{self.told(low)} to {self.told(high)}")

    def _hint(self) -> str:
        """What was met in place of a fold, or where the path ends."""
        path, other = self.path, [one for one in self.path.limits if one not in self.path.counted(self.both)]
        if path.branchings:
            return (f"at {self.told(path.branchings[0])} other equilibria branch off, which is no fold: the followed "
                    "ones go on there")
        if other:
            return (f"at {self.told(other[0].value)} there is one of the other sign: give {self.name} with `sign: any` "
                    "to count both")
        if path.unresolved:
            return f"at {self.told(path.unresolved[0])} '{self.name}' turns back, but that is no regular fold"
        broken = next((end for end in path.ends if end.broken), path.ends[0])
        return f"followed to {self.told(broken.value)}: {broken.why}"

    def _require_complete(self, found: "LimitPoint") -> None:
        """PhysicsError where the path was left before as large a value, so that another may come before."""
        path = self.path
        for value, why in [(end.value, end.why) for end in path.ends if end.broken] + [
                (value, f"'{self.name}' turns back there, which is no regular fold") for value in path.unresolved]:
            if (self.both or (value < 0) == (path.start < 0)) and abs(value) < abs(found.value):
                raise PhysicsError(f"it is not known which fold of '{self.name}' comes first: the equilibria are not "
                                   f"followed beyond {self.told(value)}", why)
