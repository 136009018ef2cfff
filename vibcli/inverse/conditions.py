"""The conditions of a scene as functions of its chosen parameters, measured on the scene with numbers.

Every condition is brought into the form L = R with L, R of one kind; its misfit (L − R)/(|L| + |R|) is bounded,
vanishes where it holds, and changes its sign there or at a pole. In equilibrium L and R are the forces of each sign
along a coordinate; at the limit of stability those that restore and those that drive away along the slowest mode, or
the margin to flutter and divergence (margin.py).
"""

from collections.abc import Sequence
from fractions import Fraction
from math import isfinite
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.inverse.admissible_ranges import admissible
from vibcli.inverse.alike_drawings import AlikeDrawings
from vibcli.inverse.slowest_mode import slowest
from vibcli.inverse.stability_margin import ZERO, free_roots, margin
from vibcli.quantities.expression import value_of
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.rationals import ONE
from vibcli.symbolic.syntax import Number

if TYPE_CHECKING:
    from vibcli.inverse.folds import Limit
    from vibcli.reader.sections.choose import Condition
    from vibcli.results.problem import Problem
    from vibcli.results.shared_friction import SharedFriction
    from vibcli.symbolic.node import Node

HOLDS = 1e-8
NEAR = 1e-6         # a misfit from which on a look is enough, at numbers whose bounds are not found


class ConditionSystem:
    """Conditions on the parameters `names` of a problem in which nothing else is without value."""

    refusal: Any
    free: int
    rigid: int | None

    def __init__(self, problem: "Problem", limits: dict[Any, Any] | None = None) -> None:
        self.problem, self.names = problem, list(problem.spec.choices)
        self.conditions = [record["so"] for record in problem.spec.choices.values()]
        self.ranges = [admissible(problem, name) for name in self.names]
        self.shares = not in_geometry(problem, self.names)
        self._drawings = AlikeDrawings(problem)
        self.refusal, self.rigid, self.free = None, None, None
        self._measured: dict[tuple[float | Fraction, ...], list[list[tuple[float, float]]] | None] = {}
        self._substituted: dict[tuple[Fraction, ...], tuple[Problem, list[list[tuple[float, float]]]]] = {}
        self.scales = [0.0] * len(self.conditions)
        self.rest, self.ends = {}, []                               # Configurations; where following them ends
        self.limits: dict[Any, Limit] = {} if limits is None else limits      # those followed to, by value (folds.py)

    def measured(self, values: Sequence[float | Fraction]) -> list[list[tuple[float, float]]]:
        """[[(L, R), …] of each condition] at numbers for the parameters, None where the scene has no such answer."""
        key = tuple(values)
        if key not in self._measured:
            instance = self.instance(values, True)
            found = self._measure(instance)
            if self._drawings.misled(self._given(values), instance):
                instance = self.instance(values)
                found = self._measure(instance)
            self._measured[key] = found
            if "equilibrium" in vars(instance.configuration):
                self.rest[key] = instance.configuration
        return self._measured[key]

    def instance(self, values: Any, shared: "bool | SharedFriction | None" = False) -> "Problem":
        given = self._given(values)
        if not shared:
            found = self.problem.with_values(given)
        else:
            found = self.problem.sharing(given) if self.shares else self._drawings.at(given)
        limit = self.limit(values)
        if limit is None:
            return found
        from vibcli.mechanics.equilibrium.degenerate import at_limit

        return found.about(at_limit(found.configuration, limit.position, limit.felt))

    def _given(self, values: Sequence[float | Fraction]) -> dict[str, Fraction]:
        return {name: Fraction(value) for name, value in zip(self.names, values, strict=True)}

    def know(self, limits: Any, ends: Any) -> None:
        """Keep the Limits to which equilibria were followed, and the ends of those ways."""
        self.ends = ends
        self.limits.update({Fraction(limit.value): limit for limit in limits})

    def limit(self, values: Sequence[float | Fraction]) -> "Limit | None":
        """The Limit that was followed to at these values; None elsewhere."""
        return self.limits.get(Fraction(values[0])) if len(values) == 1 else None

    def _measure(self, instance: "Problem") -> list[list[tuple[float, float]]] | None:
        import numpy as np

        self.problem.work.step()
        try:
            with np.errstate(all="ignore"):
                if not all(condition.is_balance for condition in self.conditions):
                    instance = _roughly(instance)
                found = self.seen(instance.roughly())
                told = all(condition.word for condition in self.conditions)
                if not told and any(abs(one) < NEAR for one in self._misfits_of(found)):
                    found = self.seen(instance)
        except (SpecError, PhysicsError, ArithmeticError, np.linalg.LinAlgError) as error:
            self.refusal = self.refusal or error
            return None
        return found if all(isfinite(x) for pairs in found for pair in pairs for x in pair) else None

    def seen(self, instance: "Problem") -> list[list[tuple[float, float]]]:
        """[[(L, R), …] of each condition] in a Problem of numbers."""
        signed = instance.with_signs()
        return [self._pairs(signed if _vanishing(condition) else instance, condition) for condition in self.conditions]

    def _pairs(self, instance: "Problem", condition: "Condition") -> list[tuple[float, float]]:
        if condition.is_balance:
            return balance(instance)
        if condition.word:
            return [self._slowest(instance)]
        return [(value_of(instance, condition.left)[0], value_of(instance, condition.right)[0])]

    def _slowest(self, instance: "Problem") -> tuple[float, float]:
        """What restores and what drives away, in the unstable mode that grows fastest or else the slowest one; with
        loads or damping that may drive a mode, its margin to flutter and divergence; where coordinates have no inertia,
        of the least stiffness, or the margin of the decay."""
        if instance.configuration.linear_system.massless:
            values, size = instance.modal.margins_without_inertia
            zeros = sum(abs(value) <= ZERO * size for value in values)
            self.rigid = zeros if self.rigid is None else min(zeros, self.rigid)
            held = sorted(values, key=abs)[self.rigid:]
            if not held:
                raise _nothing_held()
            return 0.5 * (size + min(held)), 0.5 * (size - min(held))
        free = free_roots(instance.configuration.linear_system)
        self.free = free if self.free is None else min(free, self.free)
        found = margin(instance.configuration.linear_system, self.free)
        if found is not None:
            value, size = found
            return 0.5 * (size + value), 0.5 * (size - value)
        found = slowest(instance)
        if found is None:
            return 0.0, 1.0
        rigid, value, size = found
        self.rigid = rigid if self.rigid is None else min(rigid, self.rigid)
        if rigid > self.rigid:
            return 1.0, 1.0
        if value is None:
            raise _nothing_held()
        return 0.5 * (size + value), 0.5 * (size - value)

    def misfits(self, values: Sequence[float]) -> list[float]:
        """(L − R)/(|L| + |R|) of each condition, None where the scene has no such answer."""
        found = self.measured(values)
        if found is None:
            return None
        return self._misfits_of(found)

    def _misfits_of(self, found: list[list[tuple[float, float]]]) -> list[float]:
        return [misfit(pair, scale) for pairs, scale in zip(found, self.scales, strict=True) for pair in pairs]

    def settle_scales(self, places: Sequence[list[float]]) -> None:
        """Where one side is zero at each place, this one or that, as of one force that turns round, the misfit is
        relative to the usual size of the other."""
        found = []
        for measured in map(self.measured, places):
            if measured is not None:
                found.append(measured)
            if found and self._is_plain and all(pairs and pairs[0][0] and pairs[0][1] for pairs in found[-1]):
                return
        for i in range(len(self.conditions)):
            pairs = [measured[i][0] for measured in found if measured[i]]
            if pairs and not any(left and right for left, right in pairs):
                sizes = sorted(abs(left) + abs(right) for left, right in pairs)
                self.scales[i] = sizes[len(sizes) // 2]

    @property
    def _is_plain(self) -> bool:
        """Are all conditions equations of quantities where the scene rests as it is drawn, so that nothing else is
        learnt where they are measured?"""
        return not any(one.word for one in self.conditions) and (
            self.problem.system.is_linear or self.problem.symbolic.balanced_as_drawn)

    def substituted(self, values: Sequence[Fraction]) -> "tuple[Problem, list[list[tuple[float, float]]]]":
        """(the scene built anew with these values, its [(L, R), …] of each condition)."""
        key = tuple(values)
        if key not in self._substituted:
            anew = self.instance(values)
            self._substituted[key] = anew, [self._pairs(anew, condition) for condition in self.conditions]
        return self._substituted[key]

    def residual(self, values: Sequence[Fraction]) -> float:
        """The largest misfit in a scene built anew with these values; PhysicsError where it has no such answer."""
        limit = self.limit(values)
        if limit is not None and self.conditions[0].word:
            return limit.residual
        return max(map(abs, self._misfits_of(self.substituted(values)[1])))

    def holds(self, values: Sequence[Fraction]) -> tuple[bool, float]:
        """(whether all conditions hold, residual) by substitution; a limit of stability has to be passed."""
        try:
            residual = self.residual(values)
        except (SpecError, PhysicsError, ArithmeticError):
            return False, None
        limits = [i for i, condition in enumerate(self.conditions) if condition.word and not condition.is_balance]
        followed = self.limit(values) is not None
        return residual <= HOLDS and (followed or all(self._passed(i, values) for i in limits)), residual

    def _passed(self, i: int, values: Sequence[float | Fraction]) -> bool:
        """Does the slowest mode change its stability with its parameter?"""
        signs = []
        for factor in (1 - 1e-4, 1 + 1e-4):
            moved = list(values)
            moved[i] = values[i] * factor if values[i] else (factor - 1) * self.ranges[i].scale
            found = self.measured(moved)
            signs.append(found is not None and misfit(found[i][0], 0.0))
        return signs[0] * signs[1] < 0

    def admits(self, values: Sequence[float | Fraction]) -> bool:
        return all(isfinite(x) and span.holds(x) for x, span in zip(values, self.ranges, strict=True))


def _vanishing(condition: "Condition") -> bool:
    """Is a condition an equation of which one side is written as 0?"""
    return not condition.word and any(
        isinstance(side.tree, Number) and not side.tree.value for side in condition.sides)


def _roughly(instance: "Problem") -> "Problem":
    """The same with element data about an equilibrium that is not drawn, in floats: for a first look, not to the last
    digit."""
    from vibcli.mechanics.numeric_linearisation import in_numbers

    scene, system, configuration = instance.scene, instance.system, instance.configuration
    plain = scene.loops is None and not scene.timed and "atan2" not in scene.table.called
    if not plain or system.is_linear or configuration.equilibrium.drawn:
        return instance
    elements = in_numbers(system.linearisation, Floats, configuration.at_rest).elements
    return instance.about(configuration.about(configuration.equilibrium, elements))


def _nothing_held() -> PhysicsError:
    return PhysicsError("nothing holds this scene: it has no limit of stability", "add a spring")


def misfit(pair: tuple[float, float], scale: float) -> float:
    left, right = pair
    size = abs(left) + abs(right) + scale
    return (left - right) / size if size else 0.0


def balance(instance: Any) -> list[tuple[float, float]]:
    """(forces along, forces against) each coordinate in the drawn position."""
    found = []
    place = {**instance.numeric.floats, instance.scene.time.name: 0.0, **instance.numeric.drawn_floats}
    for terms in instance.system.drawn_residual:
        values = evaluate(terms, Floats, place)
        found.append((sum(x for x in values if not x < 0), -sum(x for x in values if x < 0)))
    return found


def in_geometry(problem: "Problem", names: Sequence[str]) -> bool:
    """Does the place or motion of anything depend on these parameters?"""
    scene, parameters = problem.scene, problem.scene.parameters
    symbols = {parameters.nodes[name] for name in names}
    for name in parameters.order:
        if name in parameters.definitions and symbols & set(reachable([parameters.definitions[name]])):
            symbols.add(parameters.nodes[name])
    terms = (*scene.inertias, *scene.springs, *scene.dampers, *scene.weights, *scene.forces)
    places = [*(term.s for term in terms), *(constraint.node for constraint in scene.constraints)]
    return bool(symbols & set(reachable([*places, *scene.drawn.values(), *scene.dependent.values()])))


def summed(table: Any, terms: "Sequence[Node]") -> "Node":
    total: Node = table.sum(*((term, ONE) for term in terms))
    return total
