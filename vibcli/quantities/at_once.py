"""Quantities of many scenes at once: those that are read off modes, where arrays know these.

A declaration that says so is asked as of one scene, whose numbers are arrays with an entry for each of many.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.quantities.expression import lowered_in
from vibcli.quantities.quantity import about_which, declared, is_choice
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.syntax import QuantityRef, parts_of

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.results.shared_solutions import SharedSolutions
    from vibcli.results.variants import Place, Variants


class ManyScenes:
    """What quantities that may be asked at once look at in a Problem, of scenes that share the expressions of one."""

    many, digits, choice = True, None, None

    def __init__(self, base: "Problem", solutions: "SharedSolutions") -> None:
        self.spec, self.scene, self.floats, self.modal = base.spec, base.scene, solutions.values, self
        self.known, self.modes = solutions.known, solutions.natural.swinging()
        self.damped = None if solutions.undamped else solutions.damped.swinging()

    def oscillates(self) -> np.ndarray:
        """Where all modes do, those with dampers too: truths."""
        modes = [*self.modes, *(self.damped or ())]
        found: np.ndarray = self.known & np.all([np.isfinite(mode.omega) for mode in modes], axis=0)
        return found

    def value_of(self, expression: "Expression") -> "tuple[np.ndarray, np.ndarray] | PhysicsError | None":
        """(values, relative error bounds), NaN where they are not known, of an expression of parameters and quantities;
        why none of them has one; None where it asks for what is not found at once."""
        trees = [expression.tree] if isinstance(expression.tree, QuantityRef) else parts_of(expression.tree).quantities
        if not all(map(self._at_once, trees)):
            return None
        with np.errstate(all="ignore"):
            try:
                found = [declared(tree).value(self, tree, []) for tree in trees]
            except PhysicsError as error:
                return error
            worst = np.max([np.broadcast_to(error, self.known.shape) for _, error in found], axis=0, initial=0.0)
            if isinstance(expression.tree, QuantityRef):
                return found[0][0], worst
            numbers = {tree.text: value for tree, (value, _) in zip(trees, found, strict=True)}
            value, = evaluate([lowered_in(self.scene, expression)], Arrays, {**self.floats, **numbers})
            return np.broadcast_to(value, self.known.shape), worst

    def _at_once(self, tree: QuantityRef) -> bool:
        if tree.args or is_choice(self.spec, tree) or about_which(tree)[1] is not None:
            return False
        return declared(tree).at_once


class AnswersAtOnce:
    """What arrays tell of expressions at the places of Variants, those apart that were drawn by themselves."""

    def __init__(self, variants: "Variants") -> None:
        groups = [(solutions, ManyScenes(base, solutions)) for base, solutions in variants.groups
                  if solutions is not None]
        self._groups = [({place: i for place, i in solutions.numbers.items() if not variants.is_drawn(place)}, scenes)
                        for solutions, scenes in groups]
        self._found: dict[str, list[Any]] = {}

    def value_of(self, expression: "Expression", place: "Place") -> tuple[float, float] | None:
        """(value, relative error bound) at a place, None where the scene is to be asked; PhysicsError where it has
        none."""
        known = self._found.get(expression.text)
        if known is None:
            known = self._found[expression.text] = [
                (numbers, *_told(scenes, scenes.value_of(expression))) for numbers, scenes in self._groups]
        for numbers, values, errors in known:
            number = numbers.get(place)
            if number is not None:
                error = errors[number]
                if isinstance(error, PhysicsError):
                    raise error.with_traceback(None)
                return None if error is None else (values[number], error)
        return None

    def oscillates(self) -> "dict[Place, tuple[tuple[str, ...], tuple[str, ...]]]":
        """{place: (the kind of each natural mode, of each damped one)} of those at which all of them oscillate."""
        found: dict[Place, Any] = {}
        for numbers, scenes in self._groups:
            swings = scenes.oscillates().tolist()
            kinds = tuple(mode.kind for mode in scenes.modes), tuple(mode.kind for mode in scenes.damped or ())
            found |= {place: kinds for place, i in numbers.items() if swings[i]}
        return found


def _told(scenes: ManyScenes,
          found: PhysicsError | tuple[np.ndarray, np.ndarray] | None) -> tuple[list[Any], list[Any]]:
    """(values, error bounds) of all, the bound being None where they are not known, and why there is no value."""
    known = scenes.known
    if found is None or isinstance(found, PhysicsError):
        return [], np.where(known, found, None).tolist()        # type: ignore[call-overload]
    values, errors = found
    known = known & np.isfinite(values) & np.isfinite(errors)
    return values.tolist(), np.where(known, errors, None).tolist()
