"""Signals of motions whose places, velocities and accelerations are known at any instant: integrated or prescribed."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NoReturn

from vibcli.base.errors import PhysicsError
from vibcli.results.signal import Signal, require_finite
from vibcli.results.signals import ComposedSignal
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath
    import numpy as np

    from vibcli.analyses.time_integration.signal_error import SignalError
    from vibcli.analyses.time_integration.trajectory import Trajectory
    from vibcli.analyses.transient.composition import Composition
    from vibcli.base.work import Work
    from vibcli.results.shared_friction import SharedFriction
    from vibcli.symbolic.node import Node


BENT = ("abs", "min", "max", "ramp")
ALIKE = 4e-15           # of the range of a signal


class FullSignal(Signal):
    """A function of the coordinates, velocities and accelerations of a motion that was integrated, and of `forces`
    {symbol: name} of constraints, supports and drives; shared: its SharedFriction, None if it has none."""

    KIND = "a motion that is integrated"

    def __init__(self, motion: Any, node: "Node", forces: Mapping[Any, Any] | None = None,
                 shared: "SharedFriction | None" = None) -> None:
        self.motion, self.node, self.forces, self.shared = motion, node, forces or {}, shared
        self._errors: dict[Any, SignalError] = {}

    def values(self, times: "np.ndarray | Sequence[float]", order: int = 0) -> "np.ndarray":
        if order:
            raise PhysicsError("rates of composed signals are not found", "ask for x' or x''")
        import numpy as np

        times = np.asarray(times, dtype=float)
        return self._along(self.motion.reaching(times.max(initial=0.0)), times)

    def precise(self, t: "Fraction | int", digits: int) -> "mpmath.mpf":
        """The value at an instant, correct to so many digits."""
        if self.forces:
            raise PhysicsError("more digits of forces of constraints, supports and drives are not found along a motion",
                               "ask for coordinates, or for forces of springs and dampers")
        return self.motion.value_to(self.node, t, digits)

    def error(self, t: float) -> float:
        trajectory = self.motion.reaching(t)
        found = float(max(one.at(t) for one in self._about(trajectory, t)))
        return found if trajectory.fast is None or t < trajectory.fast.since else found + self._of_fast(trajectory, t)

    def _of_fast(self, trajectory: "Trajectory", t: float) -> float:
        """What an oscillation that was stepped over may make of the signal: Σ |∂s/∂q| of its amplitudes."""
        import numpy as np

        from vibcli.symbolic.derivatives import gradient

        if self.forces:
            raise PhysicsError(f"from t = {trajectory.fast.since:.3g} s on a fast oscillation of this motion is "
                               "stepped over: forces of constraints, supports and drives are not known",
                               "ask for earlier instants, or with more --patience")
        fast, slopes = trajectory.fast, gradient(self.node)
        rows = zip(("", "'", "''"), (fast.q, fast.v, fast.a), strict=True)
        amplitudes = {name + primes: size for primes, sizes in rows
                      for name, size in zip(trajectory.names, sizes, strict=True)}
        found: float = sum(amplitudes[symbol.name] * abs(float(FullSignal(self.motion, slope).values(np.array([t]))[0]))
                           for symbol, slope in slopes.items() if symbol.name in amplitudes)
        return found

    def error_of_time(self, t: float) -> float:
        from math import isfinite

        from vibcli.analyses.time_integration.error_scales import EPSILON

        trajectory = self.motion.reaching(t)
        if t <= trajectory.rests:       # at rest since the start, or where it begins to move
            return EPSILON * t
        found = [one.of_time(t) for one in self._about(trajectory, t)]
        return float(next(filter(isfinite, found), t))      # before it sticks: what rests has an extreme at any instant

    def _about(self, trajectory: "Trajectory", t: float) -> "list[SignalError]":
        """The SignalError of each window in which an instant lies."""
        from vibcli.analyses.time_integration.signal_error import SignalError

        numbers = trajectory.about(t)
        for k in numbers:
            if (id(trajectory), k) not in self._errors:
                self._errors[id(trajectory), k] = SignalError(trajectory, self._along, k)
        return [self._errors[id(trajectory), k] for k in numbers]

    def _along(self, trajectory: "Trajectory", times: "np.ndarray") -> "np.ndarray":
        """The values along one solution."""
        import numpy as np

        from vibcli.symbolic.array_arithmetic import Arrays

        values = self.motion.places(times, trajectory)
        if self.forces:
            values |= self.motion.forces(self.forces, values, trajectory)

        def value(node: "Node", values: "dict[str, float | np.ndarray]") -> "float | np.ndarray":
            with np.errstate(all="ignore"):
                found: float | np.ndarray = evaluate([self._with_senses(node, trajectory, times, values)], Arrays,
                                                     values)[0]
                return found

        found = value(self.node, values)
        self._require_fixed(trajectory, times, values, value)
        return require_finite(np.broadcast_to(found, times.shape), times)

    def _require_fixed(self, trajectory: "Trajectory", times: "np.ndarray", values: "dict[str, float | np.ndarray]",
                       value: "Callable[[Node, dict[str, float | np.ndarray]], float | np.ndarray]") -> None:
        """PhysicsError where the signal is a force that elements share in any proportion."""
        if self.shared is not None:
            self.shared.require_fixed(trajectory, times, values, value)

    def _with_senses(self, node: "Node", trajectory: "Trajectory", times: "np.ndarray",
                     values: "dict[str, float | np.ndarray]") -> "Node":
        """The node with a symbol for each sign in it that may be held, whose value is added to `values`."""
        from vibcli.symbolic.array_arithmetic import Arrays
        from vibcli.symbolic.derivatives import substitute
        from vibcli.symbolic.expression_graph import reachable

        signs = [part for part in reachable([node]) if part.name == "sign" and part.mask]
        if not signs:
            return node
        from vibcli.analyses.time_integration.switch_senses import senses

        scene, arguments = self.motion.problem.scene, [part.args[0] for part in signs]

        def of_states(t: "np.ndarray", q: "np.ndarray", v: "np.ndarray") -> Any:
            return evaluate(arguments, Arrays, self.motion.named(trajectory.names, t, q, v))

        found = senses(trajectory, scene, arguments, evaluate(arguments, Arrays, values), times, of_states)
        symbols = {part: scene.table.variable(f"sense {i}") for i, part in enumerate(signs)}
        values |= {symbol.name: sense for symbol, sense in zip(symbols.values(), found, strict=True)}
        return substitute([node], symbols)[0]

    def zeros(self, start: float, end: float, level: float = 0.0) -> list[float]:
        """Instants at which the signal passes a level."""
        from vibcli.analyses.time_integration.level_crossings import passages

        return passages(self.motion.reaching(end), self.values, start, end, level)

    def extreme(self, start: Any, end: float, sense: int) -> tuple[float, float]:
        """(instant, value) of the largest (sense 1) or smallest (−1) value."""
        from vibcli.analyses.time_integration.level_crossings import extreme

        trajectory = self.motion.reaching(end)
        bends = self._bends(trajectory, start, end)
        if not len(bends):
            found = extreme(trajectory, self.values, start, end, sense)
            error = self.error(found[0]) if trajectory.shared.asked else 0.0    # more known, peaks alike are alike
            return extreme(trajectory, self.values, start, end, sense, 2 * error) if error else found
        from vibcli.analyses.transient.sampled_extremes import SampledSearch

        search = SampledSearch(self.values, start, min(end, trajectory.end), self.motion.problem.work)
        found = [search.extreme(sense), *zip(bends.tolist(), self.values(bends).tolist(), strict=True)]
        top = max(sense * value for _, value in found)
        return min((t, value) for t, value in found if sense * value >= top - ALIKE * search.range)

    def _bends(self, trajectory: "Trajectory", start: float, end: float) -> "np.ndarray":
        """The instants at which the signal bends by itself: where the motion switches, windows end anyhow."""
        import numpy as np

        from vibcli.symbolic.expression_graph import reachable

        found = []
        for part in reachable([self.node]):
            if part.op == "call" and part.name in BENT and part.mask:
                argument = part.args[0] - part.args[1] if len(part.args) > 1 else part.args[0]
                if argument not in trajectory.system.switches:
                    found += FullSignal(self.motion, argument, self.forces).zeros(start, end)
        return np.array(found)

    def final(self) -> NoReturn:
        raise PhysicsError("a motion that is integrated has no known limit", "ask for its value at a late instant")


class PrescribedSignal(FullSignal):
    """The same of a motion that is prescribed."""

    KIND = "a motion that is prescribed"

    extreme, zeros, period = ComposedSignal.extreme, ComposedSignal.zeros, None  # type: ignore[assignment]
    _sampled = ComposedSignal._sampled
    error, error_of_time = Signal.error, Signal.error_of_time

    def along(self, end: float) -> "Composition":
        """The Composition of the time alone; KeyError where places follow from loops, or forces from the equations."""
        from vibcli.analyses.transient.composition import Composition

        problem = self.motion.problem
        if self.forces or problem.scene.loops is not None:
            raise KeyError("loops")
        return Composition(self.node, {}, problem.numeric.floats, problem.scene.time.name, require_finite, end)

    @property
    def work(self) -> "Work":
        found: Work = self.motion.problem.work
        return found

    def _require_fixed(self, trajectory: "Trajectory | None", times: "np.ndarray", values: Mapping[str, Any],
                       value: float) -> None:
        """Speeds that are prescribed are held by the drives."""

    def _with_senses(self, node: "Node", trajectory: "Trajectory | None", times: "np.ndarray",
                     values: Mapping[str, Any]) -> "Node":
        return node

    def final(self) -> NoReturn:
        raise PhysicsError("a motion that is prescribed has no known limit", "ask for its value at a late instant")
