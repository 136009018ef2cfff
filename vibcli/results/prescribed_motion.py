"""Motions of which nothing is free: all places are functions of the time, given outright or by closing loops."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NoReturn

from vibcli.base.errors import PhysicsError
from vibcli.results.full_response import StatesInTime
from vibcli.results.full_signals import PrescribedSignal

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath
    import numpy as np

    from vibcli.analyses.time_integration.trajectory import Trajectory
    from vibcli.results.problem import Problem
    from vibcli.results.shared_friction import SharedFriction
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import NameRef, Power, Sum

GUARDS = (20, 80, 320)      # digits


class PrescribedResponse(StatesInTime):
    """The kinematics of a scene without coordinates of its own."""

    KIND, WORDS = "prescribed", "prescribed by what drives it"

    def __init__(self, problem: "Problem") -> None:
        super().__init__(problem)
        self._closed = self._start()

    @property
    def start(self) -> tuple[dict[str, float], dict[str, float]]:
        return {}, {}

    @property
    def drive(self) -> "dict[int, Node]":
        return {}

    def lasting(self) -> NoReturn:
        raise PhysicsError("it is not known how long this motion is to be looked at",
                           f"say until when: find: [{{response: {{until: {self.problem.spec.example('10 s')}}}}}]")

    def period(self, tree: "NameRef | Power | Sum") -> NoReturn:
        raise PhysicsError("the period of what is prescribed is that of what drives it",
                           "ask for zero[1](x), zero[2](x), argmax(x)")

    def _start(self) -> dict[str, float]:
        """{name: float} of all symbols at t = 0."""
        problem = self.problem
        values = {**problem.numeric.floats, problem.scene.time.name: 0.0, **problem.numeric.drawn_floats}
        if problem.scene.loops is None:
            return values
        found = problem.scene.loops.followed(values, values)
        if found is None:
            raise _not_closed(0.0)
        return found

    def value_to(self, node: "Node", time: "Fraction", digits: int) -> "mpmath.mpf":
        """A function of the time at an instant, to so many correct digits."""
        import mpmath

        from vibcli.symbolic.evaluation import evaluate, multiprecision

        problem = self.problem
        if problem.scene.loops is not None:
            raise PhysicsError("more digits of closed loops that are driven are not found", "leave --digits out")

        def found(working: int) -> "mpmath.mpf":
            with mpmath.workdps(working):
                arithmetic = multiprecision()
                instant = mpmath.mpf(time.numerator) / time.denominator
                values = {**problem.numeric.values(arithmetic), problem.scene.time.name: instant}
                return evaluate([node], arithmetic, values)[0]

        for guard in GUARDS:
            coarse, fine = found(digits + guard), found(digits + 2 * guard)
            if abs(coarse - fine) < abs(fine) * mpmath.mpf(10) ** -digits or coarse == fine:
                return fine
        raise PhysicsError(f"{digits} digits of this are not found at t = {float(time):.6g} s: it is 0, or nothing but "
                           "rounding", "leave --digits out")

    @property
    def known(self) -> float:
        return self.until

    def reaching(self, t: float) -> None:
        """It needs no solution."""

    def places(self, times: "np.ndarray", trajectory: "Trajectory") -> "dict[str, float | np.ndarray]":
        """{name: array} of the time and of what closes the loops."""
        import numpy as np

        times, problem = np.asarray(times, dtype=float), self.problem
        loops, time = problem.scene.loops, problem.scene.time.name
        found: dict[str, float | np.ndarray] = {**problem.numeric.floats, time: times}
        if loops is None:
            return found
        order, values = np.argsort(times, kind="stable"), np.empty((len(loops.names), len(times)))
        reached = loops.through(self._closed, {time: times[order]})
        if reached.shape[1] < len(times):
            raise _not_closed(float(times[order[reached.shape[1]]]))
        values[:, order] = reached
        return {**found, **dict(zip(loops.names, values, strict=True))}

    def signal_of(self, node: "Node", forces: Mapping[Any, Any],
                  shared: "SharedFriction | None" = None) -> PrescribedSignal:
        return PrescribedSignal(self, node, forces, shared)


def _not_closed(time: float) -> PhysicsError:
    return PhysicsError(f"the loops of this scene cannot close at t = {time:.6g} s",
                        "mind the lengths of its links, and dead centres")
