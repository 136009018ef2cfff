"""Motions of the full equations to any number of digits, from the exact data of a scene."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.analyses.time_integration.motion_series import fixed_point
from vibcli.analyses.time_integration.motionless import starts_at_rest
from vibcli.analyses.time_integration.prepared_motion import equations_of
from vibcli.analyses.time_integration.proven_digits import ProvenMotion
from vibcli.analyses.time_integration.smooth_pieces import WITHOUT, SmoothPieces
from vibcli.base.errors import PhysicsError
from vibcli.mechanics.equations_of_motion import dynamics
from vibcli.mechanics.high_precision import in_its_place
from vibcli.mechanics.numeric_equations import massless
from vibcli.mechanics.precise_configuration import PreciseConfiguration
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath

    from vibcli.analyses.time_integration.taylor_march import TaylorMarch
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

POLISHED = 60


class MotionInSeries:
    """The motion of a Problem; it is followed as far as is asked for. taut: is looked after elsewhere that its ropes
    are?"""

    def __init__(self, problem: "Problem", taut: bool = False) -> None:
        self.problem, self._values, self._until = problem, {}, 0.0
        self._motion: ProvenMotion | None = None
        scene = problem.numeric.scene
        for tie in scene.constraints:
            if tie.form == "rope" and not taut:
                raise PhysicsError(f"the rope '{tie.name}' may go slack: more digits of such a motion are not found",
                                   WITHOUT)
        if scene.loops is not None and problem.system.preloads:
            raise PhysicsError("the static preloads in the closed loops of this scene are known in floats alone: more "
                               "digits of its motion are not found", "leave --digits out")
        self.scene = equations_of(problem.numeric)
        self.parts = dynamics(self.scene, problem.scene.freedom.redundant)
        for i, name in enumerate(self.scene.coordinates):
            if (i, i) not in self.parts.M:
                raise massless(name)

    def value(self, node: "Node", time: "Fraction", digits: int) -> "mpmath.mpf":
        """An expression of coordinates, their rates and the time at an instant, to so many correct digits."""
        def question(march: "TaylorMarch") -> "mpmath.mpf":
            import mpmath

            with mpmath.workprec(march.bits):
                found, = evaluate([node], multiprecision(), self.states(march, time))
                return +mpmath.mpf(found)

        return self.until(time).found(question, digits, time)

    def states(self, march: "TaylorMarch", time: "Fraction") -> "Mapping[str, mpmath.mpf]":
        """{name: number} of all that expressions are made of, at an instant, at the working precision."""
        import mpmath

        instant = mpmath.mpf(time.numerator) / time.denominator
        values = {**self.values(march.bits), self.problem.scene.time.name: instant}
        for primes, row in zip(("", "'", "''"), march.at(time), strict=True):
            values |= {name + primes: mpmath.ldexp(x, -march.bits)
                       for name, x in zip(self.scene.coordinates, row, strict=True)}
        return values

    def until(self, time: "Fraction") -> ProvenMotion:
        """The ProvenMotion up to an instant at least."""
        if self._motion is None or (self._until < time and not self._motion.pieces.endless):
            problem, self._until = self.problem, max(2 * self._until, float(time) * (1 + 1e-12), 1e-9)
            pieces = SmoothPieces(self.scene, self.parts, self.values, problem.numeric.floats, self._until,
                                  problem.work, self._rests)
            sizes = [problem.numeric.size_along(name) for name in self.scene.coordinates]
            self._motion = ProvenMotion(pieces, self.start, sizes, problem.work)
        return self._motion

    @property
    def _rests(self) -> bool:
        """Does it start at rest in the equilibrium, where nothing acts on it in time?"""
        timed = any(node.mask & self.scene.time.mask for node in self.parts.nodes())
        configuration = self.problem.configuration
        pushed = timed or configuration.preloaded is not None or configuration.falls
        return not pushed and starts_at_rest(self.problem.initial.given)

    def values(self, bits: int) -> "Mapping[str, mpmath.mpf]":
        """{parameter: number} to so many bits."""
        import mpmath

        if bits not in self._values:
            with mpmath.workprec(2 * bits):
                self._values[bits] = self.problem.numeric.values(multiprecision())
        found: Mapping[str, mpmath.mpf] = self._values[bits]
        return found

    def start(self, bits: int) -> list[int]:
        """[q, q̇] at t = 0 in fixed point."""
        import mpmath

        from vibcli.results.high_precision_response import given_start

        with mpmath.workprec(2 * bits):
            values = self.values(bits)
            q, v = given_start(self.problem, values, self._rest(values))
            q, v = self._closed(values, q, v) if self.parts.gaps else (q, v)
            return [fixed_point(row[name], bits) for row in (q, v) for name in self.scene.coordinates]

    def _rest(self, values: "Mapping[str, mpmath.mpf]") -> "dict[str, int | mpmath.mpf]":
        """Where the scene rests, of what `initial` leaves open; as drawn, or where `equilibrium:` says, what falls."""
        problem, record = self.problem, self.problem.spec.get("initial")
        configuration, names = problem.configuration, problem.scene.coordinates
        if all(record is not None and name in record for name in names):
            return dict.fromkeys(names, 0)
        if configuration.falls:
            drawn = {q.name: node for q, node in problem.scene.drawn.items()} | problem.system.named_start
            return in_its_place({q: drawn[q.name] for q in problem.scene.q}, values, multiprecision())
        rest = PreciseConfiguration(configuration.preloaded or configuration).equilibrium
        found: dict[str, int | mpmath.mpf] = rest.values
        return found

    def _closed(self, values: Mapping[str, Any], q: "Mapping[str, mpmath.mpf]",
                v: "Mapping[str, mpmath.mpf]") -> "tuple[dict[str, mpmath.mpf], dict[str, mpmath.mpf]]":
        """The start with the coordinates that close loops, and their velocities."""
        import mpmath

        from vibcli.analyses.time_integration.initial_state import start

        parts, names, zero = self.parts, self.scene.coordinates, self.scene.table.zero
        open_ones = [i for i, name in enumerate(names) if name not in q]
        slopes = [parts.slopes.get((k, i), zero) for k in range(len(parts.gaps)) for i in open_ones]
        near = start(self.problem.configuration, self.problem.initial.given)[0]
        known = {**values, self.scene.time.name: mpmath.mpf(0)}
        q = {**{names[i]: mpmath.mpf(near[names[i]]) for i in open_ones}, **q}
        v = {**{names[i]: mpmath.mpf(0) for i in open_ones}, **v}

        def step(nodes: "Sequence[Node]") -> "dict[str, mpmath.mpf]":
            state = {**known, **q, **{name + "'": speed for name, speed in v.items()}}
            flat = evaluate([*nodes, *slopes], multiprecision(), state)
            n = len(open_ones)
            matrix = mpmath.matrix([flat[n + k * n:n + (k + 1) * n] for k in range(n)])
            return {names[i]: change for i, change in zip(open_ones, mpmath.lu_solve(matrix, mpmath.matrix(
                [-gap for gap in flat[:n]])), strict=True)}

        for _ in range(POLISHED):
            changes = step(parts.gaps)
            q |= {name: q[name] + change for name, change in changes.items()}
            if max(map(abs, changes.values())) <= mpmath.eps * 2**20 * (1 + max(map(abs, q.values()))):
                return q, v | step(parts.rates)
        raise PhysicsError("the loops of this scene do not close to more digits", "ask for fewer digits")
