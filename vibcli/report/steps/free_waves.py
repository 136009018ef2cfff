"""A free motion by the letters of lines, as the sum of its vibrations

    x = Σ e^{−δₖt} (aₖ cos ωₖt + bₖ sin ωₖt),   e^{−δₖt} (aₖ + bₖt) of one that is critically damped, or that nothing
    brings back;

and signals that follow such coordinates."""

from typing import TYPE_CHECKING, Any, cast

from vibcli.base.errors import NotInLetters
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.symbolic_linear import outputs
from vibcli.quantities.responses_in_letters import at_rest
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.semantics import lower_measured
from vibcli.symbolic.syntax import NameRef, QuantityRef
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.report.steps.step import WorkedSolution
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


class FreeWave(NamedTuple):
    """One of them: a, b, its frequency and δ, each zero where there is none."""

    a: Any
    b: Any
    rate: Any
    delta: Any

    def at(self, t: "Node") -> "Node":
        """Its value at an instant."""
        table, turned = t.table, self.rate * t
        wave = self.a + self.b * t if self.rate.is_zero else (
            self.a * table.call("cos", turned) + self.b * table.call("sin", turned))
        return cast("Node", wave if self.delta.is_zero else table.call("exp", -(self.delta * t)) * wave)

    @property
    def speed(self) -> "FreeWave":
        """Its rate of change."""
        a, b, rate, delta = self
        if rate.is_zero:
            return FreeWave(b - delta * a, -delta * b, rate, delta)
        return FreeWave(b * rate - delta * a, -(a * rate) - delta * b, rate, delta)

    def times(self, factor: "Node") -> "FreeWave":
        """So many times it."""
        return self._replace(a=factor * self.a, b=factor * self.b)

    @property
    def square(self) -> "Node":
        """The square of its amplitude at t = 0."""
        return cast("Node", self.a ** 2 + self.b ** 2)


def from_start(place: "Node", speed: "Node", rate: "Node", delta: "Node") -> FreeWave:
    """The vibration of a place and a speed at t = 0."""
    ahead = speed if delta.is_zero else speed + delta * place
    return FreeWave(place, ahead if rate.is_zero else ahead / rate, rate, delta)


class ToldMotion(NamedTuple):
    """The vibrations of a coordinate, and the number of the line that tells them."""

    waves: "Sequence[FreeWave]"
    line: int


def waves_of(problem: "Problem", sheet: "WorkedSolution", signal: Any) -> "list[FreeWave]":
    """Those of a signal, or of the tree of a sum of signals, each vibration once; NotInLetters where no line tells its
    motion."""
    told = sheet.waves
    if not told or set(told) != set(problem.scene.coordinates):
        raise NotInLetters("no line tells this motion in letters")
    rows, direct = outputs(problem.symbolic, signal.name + "'" * signal.primes if isinstance(signal, NameRef)
                           else signal)
    if not direct.is_zero:
        raise NotInLetters("this signal is driven beside the free motion")
    found: dict[Any, Any] = {}
    for power, row in enumerate(rows):
        for i, factor in row.items():
            weight, = copied([factor], problem.scene.table)
            for wave in told[problem.scene.coordinates[i]].waves:
                for _ in range(power):
                    wave = wave.speed
                part = wave.times(weight)
                before = found.get(wave.rate)
                found[wave.rate] = part if before is None else part._replace(a=before.a + part.a, b=before.b + part.b)
    waves = [one._replace(a=textbook(one.a), b=textbook(one.b)) for one in found.values()]
    return [one for one in waves if not (one.a.is_zero and one.b.is_zero)]


def value_at(problem: "Problem", sheet: "WorkedSolution", tree: Any, t: "Node") -> "Node":
    """The value of a function of signals at an instant, by the lines that tell the motion."""
    table = problem.scene.table

    def signal(name: str, primes: int, part: NameRef) -> "Node":
        if isinstance(part, QuantityRef):
            raise NotInLetters("parts of signals are found in numbers")
        if name in problem.scene.parameters.nodes and not primes:
            return problem.scene.parameters.nodes[name]
        waves = waves_of(problem, sheet, NameRef(0, 0, name, primes))
        return at_rest(problem, name, primes) + table.total([wave.at(t) for wave in waves])

    return lower_measured(tree, table, signal)


def lines_of(sheet: "WorkedSolution") -> "Sequence[int]":
    """The numbers of the lines that tell the motion."""
    return [one.line for one in sheet.waves.values()]
