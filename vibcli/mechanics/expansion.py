"""V and T expanded by the deviations ξ = q − qₑ from equilibrium:

    V = Σ V_{i…j} ξ₁ⁱ … ξₙʲ        T = Σ T_{i…j k…l} ξ₁ⁱ … ξₙʲ ξ̇₁ᵏ … ξ̇ₙˡ

(Kovacić & Radomirović 2018, 9.4 and 9.5). Loads are left out of V: its linear terms balance them.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import Kinked, PhysicsError
from vibcli.mechanics.energies import effective_potential, kinetic, potential
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.running_errors import Rounded, RunningErrors, error_in, number_in
from vibcli.symbolic.truncated_polynomials import NodeArithmetic, NoDerivative, Polynomials, sign

if TYPE_CHECKING:
    from vibcli.base.errors import Where
    from vibcli.language.spec import Spec
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.scene.energy_terms import Spring, Weight
    from vibcli.scene.laws import Law
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.truncated_polynomials import Polynomial

ENERGIES = {"V": potential, "T": kinetic, "V with loads": effective_potential}
Powers = tuple[int, ...]


def up_to(order: int) -> Callable[[Powers], bool]:
    """Which powers are of this order at most, all variables together."""
    return lambda powers: sum(powers) <= order


def within(powers: Powers) -> Callable[[Powers], bool]:
    """Which powers divide these."""
    return lambda each: all(map(int.__le__, each, powers))


def require_expandable(scene: "Scene") -> None:
    """PhysicsError of a scene whose energies are no functions of its coordinates and their rates alone."""
    if scene.pieces or scene.spec.members:
        raise PhysicsError("members take part in small motions alone: their energies are not expanded further",
                           "ask for K[x, x] and omega[1]")
    if scene.loops is not None:
        ties = ", ".join(f"'{tie.name}'" for tie in scene.constraints)
        raise PhysicsError(f"a closed loop ties coordinates to each other ({ties}): energies are expanded by "
                           "coordinates that are independent", "give the motion of the loop as an expression of one")
    if not scene.q:
        raise PhysicsError("nothing moves in this scene: it has no coordinates to expand by", "let a body move")


def in_numbers(configuration: "Configuration", which: str, variables: "Sequence[Node]", keep: Callable[[Powers], bool],
               order: int, digits: int | None = None, unit: float = 2.0**-52) -> "dict[Powers, Rounded]":
    """{powers of the variables: coefficient with its bound} of V or T, all else at rest."""
    scene = configuration.scene.resting
    if digits is None:
        arithmetic, values = configuration.bounded_rest
    else:
        inner, values = configuration.precise_rest(digits)
        arithmetic = RunningErrors(inner, unit)
    found, = expanded_by(scene, which, [ENERGIES[which](scene)], arithmetic, values, variables, keep, order, sign)
    return {powers: cleared(c, arithmetic) for powers, c in found.items()}


def expression_in_numbers(configuration: "Configuration", node: "Node", order: int,
                          variables: "Sequence[Node] | None" = None, which: str = "V") -> dict[Powers, float]:
    """{powers of the coordinates, or of other variables: factor} of an expression up to an order, all else at rest;
    what is only rounding by the bound of its error is left out."""
    scene = configuration.scene.resting
    arithmetic, values = configuration.bounded_rest
    found, = expanded_by(scene, which, [node], arithmetic, values, variables or scene.q, up_to(order), order, sign)
    numbers = {powers: float(number_in(cleared(c, arithmetic))) for powers, c in found.items()}
    return {powers: c for powers, c in numbers.items() if c}


def cleared(c: Any, arithmetic: RunningErrors) -> Rounded:
    """The coefficient; zero where only rounding is left of it."""
    c = c if c.__class__ is Rounded else Rounded(c, 0.0, arithmetic.unit)
    if not arithmetic.inner.isfinite(c.value):
        raise PhysicsError("a coefficient of this expansion is not a finite real number",
                           "mind the signs under roots, and what may vanish")
    return c if sign(c) else Rounded(arithmetic.inner.number(0), error_in(c), arithmetic.unit)


def in_letters(symbolic: "SymbolicSystem", which: str, variables: "Sequence[Node]", keep: Callable[[Powers], bool],
               order: int) -> "dict[Powers, Node]":
    """The same in letters, about an equilibrium that is known in letters; else PhysicsError."""
    scene = symbolic.scene.resting
    found = about(scene, which, symbolic.equilibrium_position, variables, keep, order)
    return {powers: textbook(node) for powers, node in found.items()}


def about(scene: "Scene", which: str, place: "Mapping[str, Node]", variables: "Sequence[Node]",
          keep: Callable[[Powers], bool], order: int) -> "dict[Powers, Node]":
    """{powers: node} of V or T about a place, {coordinate: node}, at t = 0."""
    return expanded_about(scene, ENERGIES[which](scene), {**place, scene.time.name: scene.table.zero}, variables, keep,
                          order, which)


def expanded_about(scene: "Scene", node: "Node", place: "Mapping[str, Node]", variables: "Sequence[Node]",
                   keep: Callable[[Powers], bool], order: int, which: str = "V",
                   side: "Callable[[Node], int | None] | None" = None) -> "dict[Powers, Node]":
    """{powers: node} of an expression about a place, all else at rest there; `which`: of what a refusal tells, `side`:
    the sign of an expression, that in letters unless one is given."""
    arithmetic = NodeArithmetic(scene.table, list(Floats.functions))
    values = {**symbols_of([node]), **dict.fromkeys((v.name for v in scene.v), scene.table.zero), **place}
    return expanded_by(scene, which, [node], arithmetic, values, variables, keep, order, side or side_in_letters)[0]


def symbols_of(nodes: "Sequence[Node]") -> "dict[str, Node]":
    """{name: itself} of the symbols in expressions."""
    from vibcli.symbolic.expression_graph import evaluable

    return {node.name: node for node in evaluable(nodes) if node.op == "symbol"}


def side_in_letters(u: "Node") -> int | None:
    """The sign of an expression of the parameters, 0 where it vanishes; None where nothing tells it."""
    if is_zero(u):
        return 0
    simple = textbook(u)
    return next((side for side, node in ((1, simple), (-1, -simple)) if u.table.is_positive(node)), None)


def side_in_numbers(configuration: "Configuration") -> "Callable[[Node], int | None]":
    """The sign of an expression in equilibrium, 0 where it vanishes or only rounding is left of it; None where the time
    may change it."""
    arithmetic, values = configuration.bounded_rest

    def side(u: "Node") -> "int | None":
        if u.mask & configuration.scene.time.mask:
            return 0 if u.is_zero else None
        return sign(evaluate([u], arithmetic, values)[0])
    return side


def sizes(configuration: "Configuration", which: str, variables: "Sequence[Node]", keep: Callable[[Powers], bool],
          order: int) -> dict[Powers, float]:
    """{powers: the sum of the magnitudes of what the elements contribute}."""
    scene, found = configuration.scene.resting, {}
    arithmetic, values = configuration.bounded_rest
    terms: tuple[Spring | Weight | Law, ...] = (
        *scene.springs, *scene.weights, *(law for law in scene.laws if not law.damper))
    nodes = [ENERGIES[which](scene), *([term.potential(scene) for term in terms] if which == "V" else ())]
    for part in expanded_by(scene, which, nodes, arithmetic, values, variables, keep, order, sign):
        for powers, c in part.items():
            found[powers] = found.get(powers, 0.0) + abs(number_in(c))
    return found


def expanded_by(scene: "Scene", which: str, nodes: "Sequence[Node]", arithmetic: Any, values: Mapping[str, Any],
                variables: "Sequence[Node]", keep: Callable[[Powers], bool], order: int,
                side: Callable[[Any], int | None]) -> list[dict[Powers, Any]]:
    """[{powers: coefficient}] of expressions about {name: value}, in the numbers of an arithmetic."""
    ring = Polynomials(arithmetic, len(variables), keep, order, side)
    polynomials = {name: ring.still(value) for name, value in values.items()}
    polynomials |= {x.name: ring.variable(i, values[x.name]) for i, x in enumerate(variables)}
    try:
        return [found.terms for found in evaluate(nodes, ring, polynomials)]
    except NoDerivative as cause:
        raise _kinked(scene, which, ring, polynomials, cause) from None
    except KeyError as unknown:
        raise PhysicsError(f"{unknown.args[0]} has no expansion here", "ask for K[x, x] and for motions in full"
                           ) from None
    except ZeroDivisionError:
        raise PhysicsError("something divides by zero in the equilibrium: there is no expansion about it",
                           "let the equilibrium lie elsewhere") from None


def _kinked(scene: "Scene", which: str, ring: Polynomials, polynomials: "dict[str, Polynomial]",
            cause: NoDerivative) -> Kinked:
    """The refusal, with the element that has the kink."""
    owner = next((term.owner for term in _terms_of(scene, which) if _is_kinked(
        term.potential(scene), ring, polynomials)), None)
    known = cause.name in Floats.functions
    what = "an infinite derivative" if cause.name == "power" else f"a kink of {cause.name}" if known else "a kink"
    name = f"'{owner}' has" if owner else f"{which} has"
    places = [(x.name, polynomials[x.name].constant) for x in scene.q]
    at = ", ".join(f"{name} = {number_in(c):.6g}" for name, c in places if not hasattr(c, "op"))
    hint = "ask for motion: full" if which in ("Φ", "Q") else "move the equilibrium off it"
    return Kinked(f"{name} {what} in the equilibrium{at and ' at ' + at}: {which} has no expansion about it", hint,
                  _place(scene.spec, owner))


def _terms_of(scene: "Scene", which: str) -> list[Any]:
    """Those of V, or of Φ."""
    if which in ("V", "V with loads"):
        return [*scene.springs, *scene.weights, *(law for law in scene.laws if not law.damper)]
    return [*scene.dampers, *(law for law in scene.laws if law.damper)] if which == "Φ" else []


def _place(spec: "Spec", owner: str) -> "Where | None":
    """Where an element stands in the file."""
    found: Where | None = next((section[owner].where for section in spec.sections.values()
                                if isinstance(section, dict) and owner in section), None)
    return found


def _is_kinked(node: "Node", ring: Polynomials, polynomials: "dict[str, Polynomial]") -> bool:
    try:
        evaluate([node], ring, polynomials)
    except NoDerivative:
        return True
    return False
