"""The equations of motion expanded to the third order in the deviations ξ = q − qₑ from equilibrium.

V, T and Φ to the fourth order, so that the energy of a conservative scene is kept as it is by the full equations; loads
that have a potential count with V, the generalised forces of others are expanded to the third order (Kovacić &
Radomirović 2018, 9.5). The coordinates still count from the drawn position; the time is left as it is.
"""

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.energies import dissipation, generalised_force, kinetic, potential
from vibcli.mechanics.expansion import (
    cleared,
    expanded_about,
    expression_in_numbers,
    require_expandable,
    side_in_numbers,
    up_to,
)
from vibcli.mechanics.lagrange import full_equations
from vibcli.scene.energy_terms import AppliedLoad
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import expanded, is_zero
from vibcli.symbolic.rationals import HALF, ONE
from vibcli.symbolic.running_errors import number_in

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

ENERGY, FORCE = 4, 3        # orders
LARGEST = 6                 # coordinates
SHORT = 40                  # nodes of a coefficient that is multiplied out


class PlaceOfRest(NamedTuple):
    """An equilibrium, {coordinate: node}; `numbers`: the Configuration by which what is not found in letters is found,
    None of a scene in letters; `outright`: is all of it in numbers, as the equilibrium is known in numbers alone?"""

    values: "Mapping[str, Node]"
    numbers: "Configuration | None" = None
    outright: bool = False


def place_of_rest(symbolic: "SymbolicSystem") -> PlaceOfRest:
    """The equilibrium in letters where parameters have no values; else as it is reached."""
    if symbolic.numeric.has_free_symbols:
        return PlaceOfRest(symbolic.equilibrium_position)
    configuration, scene = symbolic.configuration, symbolic.scene
    found = configuration.equilibrium
    if found.drawn:
        return PlaceOfRest(scene.drawn_coordinates, configuration)
    values = {q.name: scene.table.number(Fraction(repr(found.values[q.name]))) for q in scene.q}
    return PlaceOfRest(values, configuration, True)


def expanded_scene(scene: "Scene", place: PlaceOfRest, from_rest: bool = False) -> "Scene":
    """The scene whose energies and loads are expanded about the place, its coordinates counted as drawn or `from_rest`;
    PhysicsError where they have no such expansion."""
    require_expandable(scene)
    if len(scene.q) > LARGEST:
        raise PhysicsError(f"equations are expanded of up to {LARGEST} coordinates, and this scene has {len(scene.q)}",
                           "ask for its motion in full, motion: full")
    constant = [term for term in scene.forces if not term.weight.mask]
    others = scene.with_parts(contents=scene.contents._replace(
        forces=[term for term in scene.forces if term.weight.mask]))
    V = potential(scene) - scene.table.total(term.weight * term.s for term in constant)

    def truncated(node: "Node", order: int, rates: bool, which: str = "V") -> "Node":
        return _truncated(scene, node, place, order, rates, which, from_rest)
    found = {"T": truncated(kinetic(scene), ENERGY, True, "T"), "V": truncated(V, ENERGY, False),
             "Phi": truncated(dissipation(scene), ENERGY, True, "Φ")}
    loads = []
    for i, q in enumerate(scene.q if others.forces else ()):
        force = truncated(generalised_force(others, i), FORCE, True, "Q")
        if not force.is_zero:
            loads.append(AppliedLoad(force, q, owner=others.forces[0].owner))
    return scene.with_parts(still=None, contents=scene.contents._replace(
        energies=found, forces=loads, matrices=_skew(scene), inertias=[], springs=[], weights=[], dampers=[], laws=[],
        shaken={}))


def expanded_equations(symbolic: "SymbolicSystem") -> "tuple[list[Node], list[Node]]":
    """The left side of each equation of motion: the coordinates counted as drawn, and counted from the equilibrium."""
    place = place_of_rest(symbolic)
    scene = expanded_scene(symbolic.scene, place, from_rest=True)
    found = full_equations(scene)
    return substitute(found, {q: q - place.values[q.name] for q in scene.q}), found


def _truncated(scene: "Scene", node: "Node", place: PlaceOfRest, order: int, rates: bool, which: str,
               from_rest: bool) -> "Node":
    """An expression expanded to an order in the deviations, and the velocities where there are `rates`."""
    table, variables = scene.table, [x for x in (*scene.q, *(scene.v if rates else ())) if node.mask & x.mask]
    if not variables:
        return node
    shifts = variables if from_rest else [x - place.values.get(x.name, table.zero) for x in variables]
    terms = _coefficients(scene, node, place, variables, order, which)
    return table.sum(*((table.product((c, ONE), *((u, n) for u, n in zip(shifts, powers, strict=True) if n)), ONE)
                       for powers, c in terms.items() if not (c.is_zero or (
                           from_rest and sum(powers) == 1 and not c.mask and is_zero(c)))))


def _coefficients(scene: "Scene", node: "Node", place: PlaceOfRest, variables: "list[Node]", order: int,
                  which: str) -> "dict[tuple[int, ...], Node]":
    """{powers: node}; of a place in numbers alone they are numbers, but for what changes with the time."""
    table, numbers, timed = scene.table, place.numbers, node.mask & scene.time.mask
    rest = {q.name: q for q in scene.q} if place.outright else place.values
    if timed or not place.outright:
        try:
            terms = expanded_about(scene, node, rest, variables, up_to(order), order, which,
                                   None if numbers is None else side_in_numbers(numbers))
            return {powers: _beside_time(scene, c, place) for powers, c in terms.items()} if place.outright else terms
        except NotInLetters:
            if numbers is None:
                raise
            if timed:
                raise PhysicsError("which side of a kink the scene is on hangs on the time: there is no expansion",
                                   "ask for motion: full") from None
    found = expression_in_numbers(numbers, node, order, variables, which)
    return {powers: table.number(Fraction(repr(c))) for powers, c in found.items()}


def _beside_time(scene: "Scene", c: "Node", place: PlaceOfRest) -> "Node":
    """A coefficient at rest, with numbers for what the time does not change; multiplied out where it is short."""
    table, time, factors = scene.table, scene.time.mask, {}
    if not c.mask & time:
        return _numbers(table, [c], place)[0]
    nodes = reachable([c])
    if len(nodes) > SHORT:
        fixed = {part for node in nodes if node.mask & time for part in _parts(node)
                 if not part.mask & time and part.op != "number"}
        return substitute([c], dict(zip(fixed, _numbers(table, fixed, place), strict=True)))[0]
    for monomial, value in expanded(c).items():
        moving = table.product(*(pair for pair in monomial if pair[0].mask & time))
        factors.setdefault(moving, []).append(table.product((table.number(value), ONE), *(
            pair for pair in monomial if not pair[0].mask & time)))
    numbers = _numbers(table, [table.total(parts) for parts in factors.values()], place)
    at_rest = {q: place.values[q.name] for q in scene.q}
    return table.total(number * moving for number, moving in zip(numbers, substitute(list(factors), at_rest),
                                                                 strict=True))


def _parts(node: "Node") -> "Sequence[Node]":
    return node.args if node.op == "call" else [part for part, _ in node.args]


def _numbers(table: "Table", nodes: "Iterable[Node]", place: PlaceOfRest) -> "list[Node]":
    """Nodes of their values at rest, zero where only rounding is left."""
    arithmetic, values = place.numbers.bounded_rest
    return [table.number(Fraction(repr(float(number_in(cleared(one, arithmetic))))))
            for one in evaluate(list(nodes), arithmetic, values)]


def _skew(scene: "Scene") -> "dict[str, list[list[Node]]]":
    """The skew part of a C that is given outright, which no dissipation function has."""
    C = scene.matrices.get("C")
    if C is None:
        return {}
    return {"C": [[(C[i][j] - C[j][i]) * HALF for j in range(len(C))] for i in range(len(C))]}
