"""The motion of the full equations, integrated, and what it shares with motions that are prescribed."""

from collections.abc import Callable, Mapping, Sequence, ValuesView
from contextlib import suppress
from fractions import Fraction
from functools import cached_property
from math import log
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, Unknown
from vibcli.language.signals import is_reaction
from vibcli.results.duration_beside_loads import duration_beside_loads
from vibcli.results.full_signals import FullSignal
from vibcli.results.response import Response
from vibcli.results.signal_nodes import node_of_signal
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.syntax import NameRef, Power, QuantityRef, Sum

if TYPE_CHECKING:
    import mpmath
    import numpy as np

    from vibcli.analyses.time_integration.agreement import Shared
    from vibcli.analyses.time_integration.trajectory import Trajectory
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.inputs_outputs.forces_along_motion import ForcesAlong
    from vibcli.results.motion_in_series import MotionInSeries
    from vibcli.results.problem import Problem
    from vibcli.results.shared_friction import SharedFriction
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

LOOK = 1.0          # seconds, to tell what rests for ever
FOLLOWED, LOST = 12, 13         # digits that are offered beyond the horizon; those that are lost there
SOON = 1e-3         # seconds, as far as a motion is followed of which the start alone is asked


class StatesInTime(Response):
    """A motion whose places, velocities and accelerations are known at any instant, and with them all forces."""

    signal_of: Callable[..., FullSignal]

    def signal(self, tree: Any) -> FullSignal:
        """The signal of a tree: a function of the coordinates, velocities and accelerations, and of forces."""
        from vibcli.mechanics.signals import moving
        from vibcli.results.shared_friction import SharedFriction

        scene, forces, frictions = self.problem.scene, {}, set()

        def symbol(name: str, primes: int, part: NameRef) -> "Node":
            if isinstance(part, QuantityRef):
                getattr(self.signal_of(scene.table.zero, {}), part.head)      # says why there is none
            if name in scene.parameters.nodes and not primes:
                return scene.parameters.nodes[name]
            if not primes and is_reaction(self.problem.spec, name):
                found = scene.table.variable("force " + name)
                forces[found.name] = name
                return found
            if name.endswith(".force") and not primes:
                frictions.add(name)
            return moving(self.problem.system, name, primes)

        node = node_of_signal(tree, scene.table, symbol)
        return self.signal_of(node, forces, SharedFriction.of(scene, tree, frictions, symbol) if frictions else None)

    def state_signal(self, node: Any) -> FullSignal:
        """The signal of an expression of coordinates, velocities and accelerations."""
        return self.signal_of(node, {})

    @cached_property
    def _forces(self) -> "ForcesAlong":
        from vibcli.mechanics.inputs_outputs.forces_along_motion import ForcesAlong

        return ForcesAlong(self.problem.numeric)

    def forces(self, wanted: Mapping[str, str], places: "Mapping[str, float | np.ndarray]",
               trajectory: "Trajectory | None") -> "dict[str, np.ndarray]":
        """{symbol: array} of the forces {symbol: name} of constraints, supports and drives, from the `places`."""
        states = self.states(places, trajectory)
        found = self._forces.values(list(dict.fromkeys(wanted.values())), states, self.senses(states, trajectory))
        return {symbol: found[name] for symbol, name in wanted.items()}

    def senses(self, states: Any,
               trajectory: "Trajectory | None") -> "Callable[[Scene, list[Node]], list[np.ndarray]] | None":
        """Gives the σ of arguments of a scene at the `states`; None where their signs are those of the arguments."""
        return None

    def states(self, known: Any, trajectory: "Trajectory | None") -> "dict[str, float | np.ndarray]":
        """{name: array} of the time and of all coordinates with their rates, from what is `known` of them."""
        import numpy as np

        from vibcli.symbolic.array_arithmetic import Arrays

        scene, names = self.problem.scene, self.problem.spec.coordinates
        nodes = {name + "'" * primes: scene.symbol(name, primes) for name in names for primes in range(3)
                 if name + "'" * primes not in known}
        values = evaluate(list(nodes.values()), Arrays, known)
        shape = np.shape(known[scene.time.name])
        return {**known, **{name: np.broadcast_to(value, shape) for name, value in zip(nodes, values, strict=True)}}


class FullResponse(StatesInTime):
    """The motion of the full equations, integrated."""

    KIND, WORDS = "full", "full equations, integrated"

    def __init__(self, problem: "Problem") -> None:
        super().__init__(problem)
        self._trajectory: Any = None
        self._periods: dict[str, tuple[float, float]] = {}

    @property
    def _integrated(self) -> "Configuration":
        """The system whose equations are integrated."""
        return self.problem.configuration

    @property
    def integrated(self) -> bool:
        return self._trajectory is not None

    def trajectory(self, until: Any = None) -> "Trajectory":
        """The Trajectory up to an instant at least, to the end asked for if none is given."""
        until = self.until if until is None else until
        found = self._trajectory
        if found is None or (found.until < until and not found.reason):
            from vibcli.analyses.time_integration.known_motion import known_motion

            self._trajectory = known_motion(self._integrated, until, self.problem.initial.given,
                                            self.problem.spec.accuracy)
        result: Trajectory = self._trajectory
        return result

    @cached_property
    def precise(self) -> "MotionInSeries":
        """The same motion to any number of digits."""
        from vibcli.results.motion_in_series import MotionInSeries

        return MotionInSeries(self.problem)

    def value_to(self, node: "Node", time: "Fraction", digits: int) -> "mpmath.mpf":
        """An expression of coordinates, their rates and the time at an instant, to so many correct digits."""
        return self.precise.value(node, time, digits)

    def unknown(self, t: float) -> Unknown:
        """The refusal of an instant after the end; where digits run out before, with more that are known there."""
        trajectory = self.trajectory()
        refusal = trajectory.unknown(t)
        known = trajectory.shared
        if known is not None and trajectory.end == known.lost_from and self._is_affordable(known, t):
            return Unknown(refusal.message, f"{refusal.hint}; --digits {FOLLOWED} carries as many as it takes")
        return refusal

    def _is_affordable(self, shared: "Shared", t: float) -> bool:
        """Can a series follow the motion up to an instant?"""
        loss = max(LOST / shared.horizon, 0.0 if shared.folding is None else 1 / (shared.folding * log(10)))
        try:
            return self.precise.until(Fraction(t)).is_affordable(FOLLOWED, Fraction(t), loss)
        except PhysicsError:
            return False

    @property
    def known(self) -> float:
        """Up to when the motion is known, of that which is looked at [s]; where nobody says how long that is, of that
        which was followed."""
        try:
            until = self.until
        except PhysicsError:
            if self._trajectory is None:
                raise
            found: float = self._trajectory.end
            return found
        return min(until, self.trajectory().end)

    def reaching(self, t: float) -> "Trajectory":
        """The Trajectory up to an instant: as far as the motion is looked at, where that is known and can be found."""
        if self._trajectory is None or self._trajectory.until < t:
            try:
                return self.trajectory(max(t, self.until))
            except PhysicsError:
                return self.trajectory(t or SOON)
        found: Trajectory = self._trajectory
        return found

    def _say_until(self) -> str:
        return f"say until when: find: [{{response: {{until: {self.problem.spec.example('10 s')}}}}}]"

    def lasting(self) -> float:
        self.problem.numeric.floats  # noqa: B018 - refused where parameters have none
        try:
            damped = self.problem.modal.damped
            modes = self.problem.modal.modes.shown(), damped and damped.shown()
        except PhysicsError:
            raise PhysicsError("it is not known how long this motion is to be looked at", self._say_until()) from None
        return duration_beside_loads(self.problem, *modes, self._say_until)

    def by_quadrature(self, tree: NameRef | Power | Sum) -> tuple[float, float] | None:
        """(period, relative error) of a coordinate of a conservative scene that has no other; else None."""
        if isinstance(tree, NameRef) and tree.name in self.problem.scene.coordinates and not tree.primes:
            return self._exact_period
        return None

    @cached_property
    def _exact_period(self) -> tuple[float, float] | None:
        import mpmath

        from vibcli.analyses.nonlinear.high_precision_period import DIGITS
        from vibcli.analyses.nonlinear.period import exact_period
        from vibcli.symbolic.evaluation import multiprecision

        problem = self.problem
        if len(problem.scene.coordinates) != 1:
            return None
        self._require_start()
        with mpmath.workdps(DIGITS):
            values = problem.numeric.values(multiprecision())
            (q,), (v,) = self._precise_start(values)
        return exact_period(problem.scene, values, q, v)

    def _require_start(self) -> None:
        """PhysicsError of a period where nothing starts to move."""
        from vibcli.analyses.time_integration.motionless import starts_at_rest

        if self.problem.scene.timed or not starts_at_rest(self.problem.initial.given):
            return
        found = self.reaching(LOOK)
        if found.rests == found.end:
            raise PhysicsError("the scene is at rest: its motion has no period", "give it an `initial` state")

    def _precise_start(self, values: "dict[str, mpmath.mpf]") -> tuple[ValuesView[Any], ValuesView[Any]]:
        """The places and velocities at t = 0, to more digits than floats have where they are given."""
        from vibcli.results.high_precision_response import start

        q, v = self.problem.initial.start
        with suppress(PhysicsError):
            q, v = start(self.problem, values, q)
        return q.values(), v.values()

    def period(self, tree: NameRef | Power | Sum) -> tuple[float, float]:
        """(period, relative error): of one conservative degree of freedom by quadrature; else the time after which a
        signal repeats itself."""
        self._require_start()
        if self.by_quadrature(tree) is not None:
            return self._exact_period
        if str(tree) not in self._periods:
            self._periods[str(tree)] = self._searched_period(tree)
        return self._periods[str(tree)]

    def _searched_period(self, tree: NameRef | Power | Sum) -> tuple[float, float]:
        from vibcli.analyses.time_integration.periodicity import searched_period

        try:
            first = self.until
        except PhysicsError:
            first = None
        found, error = searched_period(self.signal(tree), first)
        return found, error / found

    def senses(self, states: Any,
               trajectory: "Trajectory | None") -> "Callable[[Scene, list[Node]], list[np.ndarray]] | None":
        """By the windows of the motion; PhysicsError where friction that sticks is shared in any proportion."""
        if trajectory is None or not trajectory.switching.count:
            return None
        from vibcli.analyses.time_integration.switch_senses import senses
        from vibcli.results.shared_friction import require_unshared
        from vibcli.symbolic.array_arithmetic import Arrays

        times, names = states[self.problem.scene.time.name], trajectory.names
        require_unshared(trajectory, times, states)

        def of(scene: "Scene", arguments: "list[Node]") -> "list[np.ndarray]":
            def of_states(t: "np.ndarray", q: "np.ndarray", v: "np.ndarray") -> "list[np.ndarray]":
                return evaluate(arguments, Arrays, self.states(self.named(names, t, q, v, 0.0 * v), trajectory))

            return senses(trajectory, scene, arguments, evaluate(arguments, Arrays, states), times, of_states)

        return of

    def places(self, times: "np.ndarray", trajectory: "Trajectory") -> "dict[str, float | np.ndarray]":
        """{name: array} of the time and of the coordinates that were integrated, with their rates."""
        return self.named(trajectory.names, times, *trajectory.at(times))

    def named(self, names: Sequence[str], times: "np.ndarray", *rows: "np.ndarray") -> "dict[str, Any]":
        """{name: array} of the time, of coordinates and as many of their rates as there are `rows`."""
        values = {**self.problem.numeric.floats, self.problem.scene.time.name: times}
        for primes, each in zip(("", "'", "''"), rows, strict=False):
            values |= {name + primes: row for name, row in zip(names, each, strict=True)}
        return values

    def signal_of(self, node: "Node", forces: Mapping[Any, Any], shared: "SharedFriction | None" = None) -> FullSignal:
        return FullSignal(self, node, forces, shared)
