"""Lagrange's equations of the second kind in letters: d/dt ∂T/∂q̇ − ∂T/∂q + ∂Φ/∂q̇ + ∂V/∂q − Q = 0.

The small oscillations are those about the equilibrium, M q̈ + (C + G) q̇ + K q = 0, q being the deviation from it:
in letters where the equilibrium is the drawn position or plays no part, else with numbers for its place.
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.energies import dissipation, generalised_force, kinetic, potential, textbook_kinetic
from vibcli.mechanics.given_damping_in_letters import proportional
from vibcli.symbolic.common_denominator import shorter
from vibcli.symbolic.contents import without_contents
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.normal_form import TooLong, expanded, factors_of, reduced, textbook
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

LETTERS = 16        # most coordinates for which equations are written in letters


class EquationsOfMotion(NamedTuple):
    """full: left sides of the equations of motion, `names` their coordinates; `multipliers` {symbol: the constraint's
    name} and `conditions`, the left sides of the constraints, where loops are closed; M, C, G, K: matrices
    {(i, j): expression or float} of the small oscillations, their entries in letters or in numbers (`in_letters`);
    linear: left sides of their equations, drive: {i: Q(t)} of their right sides, left_out: {i: products
    that their left sides lack}; refusal: the PhysicsError of a scene that has no equilibrium, or None; `unexpanded`:
    that of equations which are to be expanded and are not, so that none are written out, or None; from_rest: the
    expanded ones, the coordinates counted from the equilibrium."""

    names: list[str]
    full: "list[Node]"
    multipliers: "dict[Node, str]"
    conditions: "list[Node]"
    refusal: Any = None
    drive: "Mapping[int, Node]" = MappingProxyType({})
    left_out: "Mapping[int, Node]" = MappingProxyType({})
    in_letters: bool = False
    M: Mapping[tuple[int, int], Any] = MappingProxyType({})
    C: Mapping[tuple[int, int], Any] = MappingProxyType({})
    G: Mapping[tuple[int, int], Any] = MappingProxyType({})
    K: Mapping[tuple[int, int], Any] = MappingProxyType({})
    linear: "Sequence[Node]" = ()
    unexpanded: Any = None
    from_rest: "Sequence[Node]" = ()


def equation_of(scene: "Scene", i: int, T: "Node | None" = None, V: "Node | None" = None,
                Phi: "Node | None" = None) -> "Node":
    """The left side of the equation of motion of coordinate i, as it comes from the energies."""
    T, V, Phi = T or kinetic(scene), V or potential(scene), Phi or dissipation(scene)
    q, v, zero = scene.q[i], scene.v[i], scene.table.zero
    momentum = scene.rate(gradient(T).get(v, zero))
    left = momentum - gradient(T).get(q, zero) + gradient(V).get(q, zero) + gradient(Phi).get(v, zero)
    return left + gyroscopic(scene, i) - generalised_force(scene, i)


def gyroscopic(scene: "Scene", i: int) -> "Node":
    """Σ Gᵢⱼ q̇ⱼ of the skew part of a C that is given outright, which no dissipation function has."""
    if "C" not in scene.matrices:
        return scene.table.zero
    C = scene.matrices["C"]
    return scene.table.sum(*(((C[i][j] - C[j][i]) * v, HALF) for j, v in enumerate(scene.v[:len(C)]) if i < len(C)))


def full_equations(scene: "Scene") -> "list[Node]":
    """The left side of each equation of motion, simplified."""
    T, V, Phi = textbook_kinetic(scene), potential(scene), dissipation(scene)
    return [textbook(equation_of(scene, i, T, V, Phi)) for i in range(len(scene.q))]


def nested_equations(scene: "Scene") -> "list[Node]":
    """The same as they come from the energies, nothing multiplied out: k·(x + a)·(ℓ − b)/ℓ of a spring."""
    T, V, Phi = textbook_kinetic(scene), potential(scene), dissipation(scene)
    return [without_contents(equation_of(scene, i, T, V, Phi)) for i in range(len(scene.q))]


def _with_multipliers(scene: "Scene", full: "Sequence[Node]") -> "tuple[list[Node], dict[Node, str], list[Node]]":
    """Lagrange's equations of the first kind, … + Σ λ ∂G/∂q = 0, of a scene whose equations without constraints are
    `full`, the multipliers {symbol: the constraint's name} and the conditions G = 0."""
    nodes = [textbook(constraint.node) for constraint in scene.constraints]
    conditions = [_primitive(node) for node in nodes]
    symbols = [scene.table.variable("lambda_" + constraint.name.replace(".", "_")) for constraint in scene.constraints]
    names = {symbol: constraint.name for symbol, constraint in zip(symbols, scene.constraints, strict=True)}
    slopes, found = [gradient(node) for node in nodes], []
    for left, q in zip(full, scene.q, strict=True):
        ties = [shorter(textbook(slope[q])) * symbol
                for symbol, slope in zip(symbols, slopes, strict=True) if q in slope]
        found.append(scene.table.total([left, *ties]))
    return found, names, conditions


def _primitive(node: "Node") -> "Node":
    """A condition without its common factor."""
    try:
        return factors_of(node.table, reduced(expanded(node)))[1][0]
    except (TooLong, IndexError):
        return node


def equations(symbolic: "SymbolicSystem") -> EquationsOfMotion:
    """The EquationsOfMotion of a scene; without an equilibrium only the full ones, and the refusal of the others."""
    scene, found = symbolic.scene, (_expanded if symbolic.spec.expanded else _full)(symbolic)
    try:
        _require_slope(symbolic.configuration)
        if scene.timed:
            found = found._replace(drive=symbolic.excitation)
            found = found._replace(left_out=symbolic.left_out)
        return found._replace(**_small(symbolic))
    except PhysicsError as error:
        return found._replace(refusal=error)


def _full(symbolic: "SymbolicSystem") -> EquationsOfMotion:
    scene, loose = symbolic.scene, symbolic.system.scene_with_multipliers
    full, multipliers, conditions = full_equations(loose.written) if len(loose.q) <= LETTERS else [], {}, []
    if loose is not scene and full:
        full, multipliers, conditions = _with_multipliers(loose, full)
    return EquationsOfMotion(list(loose.coordinates), full, multipliers, conditions)


def _expanded(symbolic: "SymbolicSystem") -> EquationsOfMotion:
    """Of motions by the equations to the third order these ones."""
    found = EquationsOfMotion(list(symbolic.scene.coordinates), [], {}, [])
    try:
        full, from_rest = symbolic.expanded_equations
    except PhysicsError as refusal:
        return found._replace(unexpanded=refusal)
    return found._replace(full=full, from_rest=from_rest)


def _small(symbolic: "SymbolicSystem") -> dict[str, Any]:
    """The matrices of the small oscillations, and in letters the left sides of their equations."""
    scene = symbolic.scene
    if len(scene.q) <= LETTERS and symbolic.linearisable and (proportional(symbolic.spec)
                                                              or symbolic.numeric.has_free_symbols):
        matrices = dict(zip("MCGK", symbolic.matrices, strict=True))
        linear = [_left_side(scene, matrices, i) for i in range(len(scene.q))]
        return {**matrices, "in_letters": True, "linear": linear}
    if symbolic.numeric.has_free_symbols:
        return {}
    return dict(zip("MCGK", symbolic.configuration.told_matrices, strict=True))


def _require_slope(configuration: "Configuration") -> None:
    """Kinked where the forces have none at rest."""
    from vibcli.mechanics.nonsmooth import require_smooth, require_unheld

    require_unheld(configuration.system)
    if not configuration.numeric.has_free_symbols:
        require_smooth(configuration)


def _left_side(scene: "Scene", matrices: "Mapping[str, dict[tuple[int, int], Node]]", i: int) -> "Node":
    terms = []
    for kinds, symbols in (("M", scene.a), ("CG", scene.v), ("K", scene.q)):
        for j, symbol in enumerate(symbols):
            terms += [matrices[kind][i, j] * symbol for kind in kinds if (i, j) in matrices[kind]]
    return scene.table.total(terms)
