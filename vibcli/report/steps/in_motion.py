"""The functions s(q, t) of a scene as they are, unexpanded: what `AboutRest` gives about rest, in any motion."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.report.steps.agreement import agree_in_motion, samples_of, tidy
from vibcli.report.steps.small import value_of
from vibcli.symbolic.common_denominator import shorter
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import TooLong, textbook

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


UNKNOWN = 0.7       # of a tension that closed loops leave to the balance at rest


def short_form(node: "Node") -> "Node":
    """The shorter one of two forms, as one fraction or not."""
    found = textbook(node)
    try:
        return min((found, shorter(found)), key=letters)
    except TooLong:
        return found


class Unexpanded(NamedTuple):
    """A function s of coordinates and time, and {coordinate: ∂s/∂q}; drive: s itself where it moves in time."""

    s: Any
    slopes: "Mapping[Node, Node]"
    drive: Any


class InMotion:
    """A problem in any motion, its closed loops open."""

    order_of_speeds = ""

    def __init__(self, problem: "Problem") -> None:
        self.problem, self.scene = problem, problem.system.scene_with_multipliers
        self.table, self.samples = self.scene.table, samples_of(problem, {symbol.name: UNKNOWN for symbol, _ in
                                                                         self.scene.static_preloads})

    def small(self, s: "Node") -> Unexpanded:
        """A function of the coordinates."""
        slopes = gradient(s)
        return Unexpanded(s, {q: slopes[q] for q in self.scene.q if q in slopes},
                     s if self.scene.time in slopes else self.table.zero)

    def shifted(self, node: "Node") -> "Node":
        """A function of the coordinates, as they are."""
        return textbook(node)

    def rate(self, s: Unexpanded) -> "Node":
        """ṡ."""
        return short_form(self.scene.rate(s.s))

    def square(self, speeds: "Sequence[Node]") -> "Node":
        """Σ vᵢ²."""
        return short_form(self.table.total([v ** 2 for v in speeds]))

    def half_squares(self, parts: "Sequence[tuple[Node, Unexpanded]]", rates: bool) -> "Node":
        """½ Σ w ṡ², or of s itself."""
        of = self.rate if rates else lambda s: s.s
        return short_form(self.table.total([weight * of(s) ** 2 / 2 for weight, s in parts]))

    def tidy(self, node: "Node") -> "Node":
        """The simplest form of an expression without coordinates."""
        return tidy(node, self.samples)

    def letter(self, name: str) -> "Node":
        """The symbol of a new letter."""
        return self.table.parameter(name)

    def value(self, node: "Node") -> float | None:
        """The number of an expression of parameters; None where they have none."""
        return value_of(self.problem, node, {})

    def agree(self, one: "Sequence[Node]", other: "Sequence[Node]", more: "Sequence[Node]" = ()) -> bool:
        """Have two lists of terms the same sum at states of motion, `more` being further symbols in them?"""
        return agree_in_motion(self.scene, self.samples, one, other, more)
