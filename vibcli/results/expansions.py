"""The expansion of a Problem about its equilibrium: deflections of springs, what their material and their geometry
store, energies, and equations of motion."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import Kinked, NotInLetters, PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.energies import potential
from vibcli.mechanics.expansion import (
    expanded_about,
    expression_in_numbers,
    in_letters,
    in_numbers,
    require_expandable,
    up_to,
)
from vibcli.mechanics.spring_shares import SpringShares, shares_in_letters, shares_in_numbers
from vibcli.mechanics.truncated_equations import Powers, truncated_equation
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.rationals import ONE
from vibcli.symbolic.running_errors import number_in

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.scene.energy_terms import Spring
    from vibcli.scene.laws import Law
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

LARGEST = 6         # coordinates
NIL = 2.0**-40      # of what a sum is added from: less is rounding


class Expansion(NamedTuple):
    """{powers of ξ, then ξ̇, then ξ̈: factor} of each; factors are expressions (`letters`) or numbers. equations: None
    where loads follow the motion; symbols: those of ξ, ξ̇ and ξ̈; timed: is
    something driven or loaded in time? springs: what each has of V."""

    letters: bool
    deflections: dict[str, dict[Powers, Any]]
    springs: dict[str, SpringShares]
    energies: dict[str, dict[Powers, Any]]
    equations: list[dict[Powers, Any]] | None
    symbols: "Sequence[Node]"
    timed: bool

    def product(self, powers: Powers) -> "Node":
        """That of so many factors of each symbol."""
        table = self.symbols[0].table
        return table.product(*((x, n) for x, n in zip(self.symbols, powers, strict=False) if n))


def expansions(problem: "Problem", order: int) -> list[Expansion]:
    """In letters, where the equilibrium is known in letters, and in numbers, where all parameters have values;
    PhysicsError where there is neither."""
    scene = problem.scene.resting
    require_expandable(scene)
    if len(scene.q) > LARGEST:
        raise PhysicsError(f"energies are expanded of up to {LARGEST} coordinates, and this scene has {len(scene.q)}",
                           "ask for single factors, as V[x^2]")
    numbers, found = not problem.numeric.has_free_symbols, []
    try:
        found.append(_in_letters(problem, scene, order))
    except (NotInLetters, Kinked):      # a kink may be away from an equilibrium that is known in numbers alone
        if not numbers:
            raise
    try:
        return [*found, _in_numbers(problem, scene, order)] if numbers else found
    except Kinked as kink:      # what is asked for is missing, not only what is found beside it
        raise PhysicsError(kink.message, kink.hint, kink.where) from None


def in_powers(problem: "Problem", node: "Node", order: int, letters: bool) -> dict[Powers, Any]:
    """{powers of the coordinates: factor} of an expression up to an order about the equilibrium, without what is not
    moved; factors are expressions, or numbers."""
    scene = problem.scene.resting
    if letters:
        place = {**problem.symbolic.equilibrium_position, scene.time.name: scene.table.zero}
        found = {powers: textbook(c) for powers, c in expanded_about(
            scene, node, place, scene.q, up_to(order), order).items()}
        found = {powers: c for powers, c in found.items() if not is_zero(c)}
    else:
        found = expression_in_numbers(problem.configuration, node, order)
    return _ascending({powers: c for powers, c in found.items() if any(powers)}, len(scene.q))


def deflection(problem: "Problem", name: str, order: int, letters: bool) -> dict[Powers, Any]:
    """That of a spring, to an order: one more than that of the energies needs, where it is loaded at rest."""
    return in_powers(problem, dict(_stretches(problem))[name], order, letters)


def is_loaded(problem: "Problem", name: str, letters: bool) -> bool:
    """Does a spring bear anything in equilibrium? So that its deflection counts to the order of the energies."""
    force = problem.scene.resting.force_of(name)
    if force is None:
        return True
    if letters:
        return not is_zero(textbook(substitute([force], place_of(problem))[0]))
    return bool(expression_in_numbers(problem.configuration, force, 0))


def place_of(problem: "Problem") -> "dict[Node, Node]":
    """{coordinate: expression} of the equilibrium in letters."""
    scene, place = problem.scene.resting, problem.symbolic.equilibrium_position
    return {q: place[q.name] for q in scene.q} | {scene.time: scene.table.zero}


def of_others(problem: "Problem", order: int, letters: bool) -> dict[Powers, Any]:
    """What of V is of no spring: of weights, or written out."""
    scene = problem.scene.resting
    names = set(problem.spec.get("springs") or ())
    terms: tuple[Spring | Law, ...] = (*scene.springs, *(law for law in scene.laws if not law.damper))
    stored = [term.potential(scene) for term in terms if term.owner in names]
    return in_powers(problem, potential(scene) - scene.table.total(stored), order, letters)


def of_loads(problem: "Problem", order: int, letters: bool) -> dict[Powers, Any]:
    """The work of steady loads."""
    W = _work(problem.scene.resting)
    return {} if W is None or W.is_zero else in_powers(problem, W, order, letters)


def _in_letters(problem: "Problem", scene: "Scene", order: int) -> Expansion:
    place, symbolic = problem.symbolic.equilibrium_position, problem.symbolic
    energies = {"V": in_letters(symbolic, "V", scene.q, up_to(order), order),
                "T": in_letters(symbolic, "T", [*scene.q, *scene.v], up_to(order), order)}

    def total(factors: "Iterable[Node]") -> "Node | None":
        node = textbook(scene.table.sum(*((factor, 1) for factor in factors)))
        return None if is_zero(node) else node

    def written(node: "Node", order: int) -> "dict[Powers, Node]":
        return {powers: textbook(c) for powers, c in expanded_about(
            scene, node, place, scene.q, up_to(order), order).items()}

    deflections, W = {name: written(node, order - 1) for name, node in _stretches(problem)}, _work(scene)
    springs = {name: shares_in_letters(symbolic, name, up_to(order), order) for name in deflections}
    return _together(scene, True, deflections, springs, energies, total, None if W is None else written(W, order))


def _in_numbers(problem: "Problem", scene: "Scene", order: int) -> Expansion:
    configuration = problem.configuration
    energies = {which: {powers: float(number_in(c)) for powers, c in in_numbers(
        configuration, which, variables, up_to(order), order).items()}
        for which, variables in (("V", scene.q), ("T", [*scene.q, *scene.v]))}

    def total(factors: "Sequence[float]") -> "float | None":
        found = sum(factors)
        return found if abs(found) > NIL * sum(map(abs, factors)) else None

    deflections = {name: expression_in_numbers(configuration, node, order - 1)
                   for name, node in _stretches(problem)}
    springs = {name: _plain(shares_in_numbers(configuration, name, up_to(order), order)) for name in deflections}
    W = _work(scene)
    work = None if W is None else expression_in_numbers(configuration, W, order)
    return _together(scene, False, deflections, springs, energies, total, work)


def _plain(shares: SpringShares) -> SpringShares:
    """The same without bounds and what vanishes."""
    parts = [{powers: float(number_in(c)) for powers, c in part.items()} for part in shares]
    return SpringShares(*({powers: c for powers, c in part.items() if c} for part in parts))


def _stretches(problem: "Problem") -> "Iterator[tuple[str, Node]]":
    """(name, expression) of the deflection of each spring."""
    from vibcli.mechanics.signals import moving

    for name in problem.spec.get("springs") or ():
        yield name, moving(problem.system, f"{name}.stretch")


def _together(scene: "Scene", letters: bool, deflections: Mapping[str, Mapping[Powers, Any]],
              springs: Mapping[str, SpringShares], energies: Mapping[str, Mapping[Powers, Any]],
              total: Callable[[Sequence[Any]], Any], work: Mapping[Powers, Any] | None) -> Expansion:
    n, equations = len(scene.q), None
    kept = {which: _ascending({powers: c for powers, c in terms.items() if any(powers) and total([c]) is not None}, n)
            for which, terms in energies.items()}
    if work is not None:
        equations = []
        for i in range(n):
            parts = truncated_equation(kept["T"], [*kept["V"].items(), *((p, -c) for p, c in work.items())], i, n)
            sums = {powers: total(factors) for powers, factors in parts.items()}
            equations.append(_ascending({powers: c for powers, c in sums.items() if c is not None}, n))
    of_springs = {name: _ascending({powers: c for powers, c in terms.items() if any(powers)}, n)
                  for name, terms in deflections.items()}
    shares = {name: SpringShares(*(_ascending(part, n) for part in found)) for name, found in springs.items()}
    timed = scene.timed or any(term.weight.mask & scene.time.mask for term in scene.forces)
    return Expansion(letters, of_springs, shares, kept, equations, [*scene.q, *scene.v, *scene.a], timed)


def _ascending(terms: Mapping[Powers, Any], n: int) -> dict[Powers, Any]:
    """By their order; of equal ones accelerations first, then by the coordinates."""
    return dict(sorted(terms.items(), key=lambda term: (
        sum(term[0]), [-power for power in (*term[0][2 * n:], *term[0][:2 * n])])))


def _work(scene: "Scene") -> "Node | None":
    """The work of steady loads; None where loads follow the motion."""
    if any(term.weight.mask & ~scene.time.mask for term in scene.forces):
        return None
    return scene.table.sum(*((term.weight * term.s, ONE) for term in scene.forces if not term.weight.mask))
