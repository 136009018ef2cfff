"""What follows loads that are ramps or other powers of the time, in letters: q = Σ Qₖ tᵏ with

    K Qₖ = Fₖ − (k+1) (C + G) Qₖ₊₁ − (k+2)(k+1) M Qₖ₊₂.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters
from vibcli.mechanics.static_preload import solve_linear
from vibcli.mechanics.symbolic_linear import outputs
from vibcli.symbolic.common_denominator import shorter
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import TooLong, expanded, textbook
from vibcli.symbolic.rationals import ONE
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    import numpy as np

    from vibcli.mechanics.symbolic_linear import Tree
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

    Matrix = dict[tuple[int, int], Node]

MOST_POWERS, SINGULAR, UNDYING = 4, 1e-12, 1e-9


def are_powers(symbolic: "SymbolicSystem") -> bool:
    """Do the loads of a scene grow as powers of the time alone?"""
    try:
        powers = [k for node in symbolic.excitation.values() for k in _powers(symbolic.scene, node)]
    except NotInLetters:
        return False
    return any(powers)


def following(symbolic: "SymbolicSystem", signal: "str | Tree") -> "Node":
    """The part Σ cₖ tᵏ of a coordinate or signal, counted from equilibrium, as a node of the scene."""
    scene = symbolic.scene
    rows, direct = outputs(symbolic, signal)
    waves = [*_coordinates(symbolic), direct]
    for part in rows:
        nodes = copied(list(part.values()), scene.table)
        waves[-1] = waves[-1] + scene.table.sum(*((x * waves[i], ONE) for i, x in zip(part, nodes, strict=True)))
        waves[:-1] = [_slope(scene, node) for node in waves[:-1]]
    found = {k: shorter(textbook(node)) for k, node in _powers(scene, waves[-1]).items()}
    return scene.table.total([node * scene.time**k if k else node for k, node in found.items()])


def require_damped(symbolic: "SymbolicSystem") -> None:
    """NotInLetters where the free motion does not die out."""
    import numpy as np

    n, sample = len(symbolic.scene.q), symbolic.scene.sample
    M, C, K = (_numbers(entries, n, sample) for entries in _matrices(symbolic))
    if np.linalg.matrix_rank(M) == n:
        states = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
        eigenvalues = np.linalg.eigvals(states)
        if (eigenvalues.real < -UNDYING * np.abs(eigenvalues).max()).all():
            return
    raise NotInLetters("limits in letters are found where inertias and dampers let the free motion die out",
                       "give numbers with --set")


def _coordinates(symbolic: Any) -> "list[Node]":
    """q(t) of each coordinate."""
    import numpy as np

    scene, n = symbolic.scene, len(symbolic.scene.q)
    M, C, K = _matrices(symbolic)
    if np.linalg.cond(_numbers(K, n, scene.sample)) * SINGULAR > 1:
        raise NotInLetters("nothing holds this scene where what drives it stays displaced", "give numbers with --set")
    forces = {i: _powers(scene, node) for i, node in symbolic.excitation.items()}
    zero, degree = scene.table.zero, max((k for found in forces.values() for k in found), default=0)
    found = [[zero] * n] * 2                    # Q of the next two powers
    total = [zero] * n
    for k in reversed(range(degree + 1)):
        right = [forces.get(i, {}).get(k, zero) - (k + 1) * _row(C, i, found[0]) - (k + 2) * (k + 1) * _row(
            M, i, found[1]) for i in range(n)]
        Q = [textbook(x) for x in solve_linear([[*(K.get((i, j), zero) for j in range(n)), right[i]]
                                                for i in range(n)], zero)]
        total = [one + x * scene.time**k if k else one + x for one, x in zip(total, Q, strict=True)]
        found = [Q, found[0]]
    return total


def _row(entries: "Mapping[tuple[int, int], Node]", i: int, Q: "Sequence[Node]") -> "Node":
    return Q[0].table.sum(*((node * Q[j], ONE) for (row, j), node in entries.items() if row == i))


def _matrices(symbolic: "SymbolicSystem") -> "tuple[Matrix, Matrix, Matrix]":
    """M, C + G, K as {(i, j): node}."""
    M, C, G, K = symbolic.matrices
    zero = symbolic.scene.table.zero
    return M, {pair: C.get(pair, zero) + G.get(pair, zero) for pair in {*C, *G}}, K


def _numbers(entries: "Mapping[tuple[int, int], Node]", n: int, sample: dict[str, float]) -> "np.ndarray":
    import numpy as np

    found = np.zeros((n, n))
    for pair, value in zip(entries, evaluate(list(entries.values()), Floats, sample), strict=True):
        found[pair] = value
    return found


def _slope(scene: "Scene", node: "Node") -> "Node":
    return gradient(node).get(scene.time, scene.table.zero)


def _powers(scene: "Scene", node: "Node") -> "dict[int, Node]":
    """{k: coefficient} of a polynomial in the time; NotInLetters of another function."""
    try:
        terms = expanded(node)
    except (TooLong, ZeroDivisionError):
        raise NotInLetters("what drives this scene is too long in letters", "give numbers with --set") from None
    found, table = {}, scene.table
    for monomial, value in terms.items():
        power = sum((e for atom, e in monomial if atom is scene.time), 0)
        rest = [pair for pair in monomial if pair[0] is not scene.time]
        if any(atom.mask & scene.time.mask for atom, _ in rest) or power not in range(MOST_POWERS + 1):
            raise NotInLetters("what follows its loads is found in letters of powers of the time",
                               "give the parameters values with --set")
        term = table.product((table.number(value), ONE), *rest)
        found[int(power)] = found.get(int(power), table.zero) + term
    return found
