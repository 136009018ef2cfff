"""Scenes with values for what is chosen, which share their expressions where they would be drawn alike.

While a scene is drawn and linearised, numbers are read off it: lengths, which side, what coincides. What was derived of
a scene is derived once more with numbers that remember what was decided by them; where all of that comes out the same
at other values, these have the same expressions.
"""

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.mechanics.linearisation import nodes_of
from vibcli.mechanics.system import MechanicalSystem
from vibcli.symbolic.evaluation import Floats
from vibcli.symbolic.expression_graph import fingerprint
from vibcli.symbolic.watched_numbers import Decisions

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.results.problem import Problem

FEW, MOST = 4, 3        # scenes drawn anew before one is shared; drawings that are tried


class AlikeDrawings:
    """The Problems of one with values for its symbols, drawn anew or by the expressions of another."""

    def __init__(self, problem: "Problem") -> None:
        self.problem = problem
        self._drawn, self._known = 0, []
        self._newest: Problem | None = None

    def at(self, given: "Mapping[str, Fraction]") -> "Problem":
        """The Problem of these values."""
        if self._newest is not None and self._drawn >= FEW and len(self._known) < MOST:
            drawing = _Drawing(self._newest)
            self._known += [drawing] if drawing.is_alike else []
            self._newest = None
        drawing = next((drawing for drawing in self._known if drawing.serves(given)), None)
        if drawing is not None:
            shared: Problem = drawing.problem.sharing(given)
            return shared
        self._drawn, self._newest = self._drawn + 1, self.problem.with_values(given)
        return self._newest

    def misled(self, given: "Mapping[str, Fraction]", problem: "Problem") -> bool:
        """Was something derived for a Problem that was found here, which its own values decide otherwise?"""
        drawing = next((drawing for drawing in self._known if drawing.problem.system is problem.system), None)
        return drawing is not None and drawing.has_grown and not drawing.serves(given)


class _Drawing:
    """A Problem that was looked at, and what the numbers of its scene decided: at which others would it be the same?"""

    def __init__(self, problem: "Problem") -> None:
        self.problem, self._decisions, self._parts = problem, Decisions(), set()
        self._watched = MechanicalSystem(problem.spec, problem.system.given, watched=self._decisions.watched)
        self.is_alike = "linearisation" in self._derived and _closed_form(problem.system) and self._is_derived_alike()

    @property
    def _derived(self) -> set[str]:
        """The parts that were derived of the system until now."""
        system = self.problem.system
        return {part for part in vars(system) if isinstance(getattr(type(system), part, None), cached_property)}

    @property
    def has_grown(self) -> bool:
        """Was more derived since that was watched?"""
        return self._derived != self._parts

    def _is_derived_alike(self) -> bool:
        """Does the same follow from numbers that are watched?"""
        self._parts = self._derived
        try:
            for part in self._parts:
                getattr(self._watched, part)
        except (SpecError, PhysicsError, ArithmeticError, TypeError, ValueError):
            return False
        return _fingerprint(self._watched) == _fingerprint(self.problem.system)

    def serves(self, given: "Mapping[str, Fraction]") -> bool:
        if self.has_grown:
            self.is_alike = self.is_alike and self._is_derived_alike()
        if not self.is_alike:
            return False
        scene = self.problem.scene
        try:
            sample = scene.parameters.values(Floats, {**self.problem.numeric.floats, **_floats(given)})
        except SpecError:
            return False
        return self._decisions.hold(scene.sample, sample)


def _closed_form(system: MechanicalSystem) -> bool:
    """Is a scene nothing but expressions of its parameters?"""
    table = system.scene.table
    return system.settled is None and not (table.functions or table.records or table.definitions)


def _fingerprint(system: MechanicalSystem) -> tuple[tuple[Any, ...], ...]:
    scene = system.scene
    return fingerprint([*scene.contents.nodes, *scene.drawn.values(), *nodes_of(system.linearisation)])


def _floats(given: "Mapping[str, Fraction]") -> dict[str, float]:
    return {name: float(value) for name, value in given.items()}
