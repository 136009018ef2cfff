"""Quantities of scenes in letters: modes of several degrees by their closed forms, others as conditions take them."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.quantities.energies import equation_number, require_sum
from vibcli.quantities.expression import lowered
from vibcli.quantities.in_letters import quantity_in_letters, response_of, size_of
from vibcli.quantities.quantity import declared
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.syntax import QuantityRef, parts_of

if TYPE_CHECKING:

    from vibcli.analyses.closed_form.closed_forms import ClosedMode
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

OF_MODES = ("omega", "frequency", "period", "growth_rate", "mode", "zeta", "omega_d", "period_d", "decay")
GIVE_VALUES = "give the letters values: with_values(…), or --set"


def expression_in_letters(problem: "Problem", expression: "Expression") -> "Node":
    """An expression of quantities as one of the letters; NotInLetters where it is found in numbers alone."""
    scene, tree = problem.scene, expression.tree
    response = response_of(problem, tree)
    if response is not None:
        return size_of(problem, response)
    found = {part.text: any_quantity(problem, part) for part in parts_of(tree).quantities}
    return lowered(expression, scene.table, lambda name, primes, part: found[part.text]
                   if isinstance(part, QuantityRef) else scene.parameters.nodes[name])


def state_function(problem: "Problem", tree: QuantityRef) -> "Node":
    """T, V, Phi or Q[q], or the left side of an equation of motion, as a function of coordinates and velocities."""
    if tree.head in ("T", "V", "Phi"):
        require_sum(problem, tree.head)
        found: Node = problem.symbolic.energies[tree.head]
        return found
    if tree.head == "Q":
        return declared(tree).symbolic(problem, tree)
    if tree.head == "motion" and problem.spec.expanded:
        return declared(tree).symbolic(problem, tree)
    i = equation_number(problem, tree.indices[0])
    equations, name = problem.symbolic.equations, problem.scene.coordinates[i]
    if tree.head == "motion" and equations.full:
        result: Node = equations.full[equations.names.index(name)]
        return result
    if tree.head == "equation" and equations.refusal is not None:
        raise equations.refusal
    if tree.head == "equation" and equations.in_letters:
        value: Node = equations.linear[i] - equations.drive.get(i, problem.scene.table.zero)
        return value
    raise NotInLetters(f"'{tree.text}' is not found in letters", "matrices of numbers are M[x, x], C[x, x], K[x, x]")


def closed_modes(problem: "Problem") -> list["ClosedMode"]:
    """The modes in letters, all of them; NotInLetters where they are not found."""
    forms = problem.closed_forms
    if forms is None or forms.polynomials:
        raise NotInLetters("the modes are not all found in letters", GIVE_VALUES)
    return sorted(forms.modes, key=lambda mode: mode.index)


def any_quantity(problem: "Problem", tree: Any) -> "Node":
    """A quantity as an expression of the parameters, those of modes by the closed forms; NotInLetters where it is found
    in numbers."""
    if getattr(tree, "head", None) not in OF_MODES or tree.args or len(tree.indices) != 1 + (tree.head == "mode"):
        return quantity_in_letters(problem, tree)
    number, forms = int(tree.indices[0]), problem.closed_forms
    if problem.scene.pieces:
        if forms is None:
            raise NotInLetters(f"'{tree.text}' is found in numbers, as a root of a frequency equation", GIVE_VALUES)
        return _of_mode(problem, tree, forms.numbered(number))
    modes = closed_modes(problem)
    if number > len(modes):
        raise PhysicsError(f"there is no mode {number}: this scene has {len(modes)}", "ask for one that it has")
    return _of_mode(problem, tree, modes[number - 1])


def _amplitude(problem: "Problem", shape: "Sequence[Node]", name: str) -> "Node | None":
    """Of a coordinate, or Σ (∂s/∂qᵢ) φᵢ at rest of one that follows others; None of other signals, and of closed loops
    whose rest is not as drawn."""
    scene = problem.scene
    if name in scene.coordinates:
        return shape[scene.coordinates.index(name)]
    if name not in scene.dependent or scene.pieces:
        return None
    slopes, place = gradient(scene.dependent[name]), scene.drawn_position
    if not problem.symbolic.balanced_as_drawn:
        rest = problem.symbolic.equilibrium_position
        place = {scene.time: scene.table.zero} | {q: rest[q.name] for q in scene.q}
    found = scene.table.total([substitute([slopes[q]], place)[0] * x for q, x in zip(scene.q, shape, strict=True)
                               if q in slopes])
    return None if found.mask else textbook(found)


def _of_mode(problem: "Problem", tree: QuantityRef, mode: "ClosedMode") -> "Node":
    table, head = problem.scene.table, tree.head
    if head == "mode":
        found = None if mode.shape is None else _amplitude(problem, mode.shape, tree.indices[1])
        if found is None:
            raise NotInLetters(f"'{tree.text}' is found in numbers", GIVE_VALUES)
        return found
    if head == "growth_rate" or mode.unstable:
        if head != "growth_rate" or not mode.unstable:
            raise PhysicsError(f"mode {mode.index} is {'un' * mode.unstable}stable: it has no such number",
                               f"ask for {'growth_rate' if mode.unstable else 'omega'}[{mode.index}]")
        result: Node = mode.omega
        return result
    if head in ("zeta", "omega_d", "period_d", "decay") and mode.zeta is None:
        return quantity_in_letters(problem, tree)
    if head == "period" and mode.omega.is_zero:
        raise PhysicsError(f"mode {mode.index} is a rigid-body mode: it has no period", f"ask for omega[{mode.index}]")
    forms = {"omega": lambda: mode.omega, "frequency": lambda: mode.omega / (2 * table.pi),
             "period": lambda: mode.period, "zeta": lambda: mode.zeta, "omega_d": lambda: mode.omega_d,
             "period_d": lambda: 2 * table.pi / mode.omega_d,
             "decay": lambda: mode.zeta * mode.omega}
    value: Node = forms[head]()
    return value
