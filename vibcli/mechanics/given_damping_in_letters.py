"""What `damping:` adds to C in letters: α M + β K; damping by modes is found in numbers alone."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.mechanics.linearisation import at_position
from vibcli.mechanics.symbolic_matrices import matrices_in_letters
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import fraction_of
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    import mpmath

    from vibcli.language.spec import Spec
    from vibcli.mechanics.inputs_outputs.base_excitation import SystemWithInputs
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def proportional(spec: "Spec") -> bool:
    """Has the damping of a scene as a whole letters?"""
    return spec.get("damping") is None or "proportional" in spec.get("damping")


def in_letters(spec: "Spec", scene: "Scene", M: Any, C: Any, K: Any) -> "dict[tuple[int, int], Node]":
    """C + α M + β K; NotInLetters of damping by modes."""
    if not proportional(spec):
        raise NotInLetters("damping by modes is found in numbers",
                           "give values, or write `proportional: [alpha, beta]`")
    alpha, beta = (scene.lower(expression) for expression in spec.get("damping")["proportional"])
    zero, found = scene.table.zero, {}
    for pair in {**M, **C, **K}:
        node = textbook(C.get(pair, zero) + alpha * M.get(pair, zero) + beta * K.get(pair, zero))
        if not node.is_zero:
            found[pair] = node
    return found


def excitation_by_damping(symbolic: "SymbolicSystem") -> "dict[int, Node]":
    """{i: −C_u u̇} of what drives the scene."""
    opened = symbolic.configuration.with_inputs
    scene = opened.scene
    if scene.driven:
        raise PhysicsError("damping of a whole scene beside what is driven farther and farther is not found",
                           "write the dampers one by one under dampers")
    driven = {j: scene.rate(one.node) for j, one in enumerate(scene.inputs.values(), opened.n) if one.node is not None}
    found: dict[int, Node] = {}
    if driven:
        for (i, j), c in _columns(symbolic, opened, driven).items():
            found[i] = found.get(i, scene.table.zero) - c * driven[j]
    return dict(zip(found, copied(list(found.values()), symbolic.scene.table), strict=True))


def _columns(symbolic: "SymbolicSystem", opened: "SystemWithInputs",
             driven: "Mapping[int, Node]") -> "dict[tuple[int, int], Node]":
    """C_u, {(i, j): node}."""
    from vibcli.mechanics.symbolic_linear import place_in_letters

    scene = opened.scene
    if proportional(symbolic.spec):
        M, _, _, K = matrices_in_letters(at_position(opened.form, place_in_letters(symbolic)))
        M, K = ({(i, j): x for (i, j), x in part.items() if i < opened.n and j in driven} for part in (M, K))
        return in_letters(symbolic.spec, scene, M, {}, K)
    if symbolic.numeric.has_free_symbols:
        return in_letters(symbolic.spec, scene, {}, {}, {})
    return _rounded(scene, opened.damping)


def _rounded(scene: "Scene", columns: "Mapping[tuple[int, int], float | mpmath.mpf]") -> "dict[tuple[int, int], Node]":
    return {pair: scene.table.number(fraction_of(x)) for pair, x in columns.items()}
