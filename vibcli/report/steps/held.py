"""Matrices of small oscillations as they are added up line by line, held against those of the engine."""

from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.autonomous import excitation
from vibcli.mechanics.given_damping_in_letters import proportional
from vibcli.mechanics.symbolic_matrices import matrices_in_letters
from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

ALIKE = 1e-9        # relative: of what is added up element by element, and of the engine's
UNTOLD = "what moves, stores energy or acts in this scene is not told apart step by step"
HINT = "leave --steps out for the equations and their solution"


class Untold(PhysicsError):
    """What the lines would add up to is not what the engine has."""


class SmallEquations(NamedTuple):
    """M, C, G, K as {(i, j): node}, {i: Q(t)}, and the numbers of the lines that tell the equations."""

    M: Any
    C: Any
    G: Any
    K: Any
    drive: Any
    lines: list[int]


def held(about: AboutRest, sheet: WorkedSolution, M: Any, C: Any, K: Any,
         G: Any) -> "tuple[dict[tuple[int, int], Node], ...]":
    """M, C, G, K of the engine, without damping by modes; Untold where what was told, these ones, is not all."""
    symbolic, spec = about.problem.symbolic, about.problem.spec
    if symbolic.linearisable and not proportional(spec):
        if not all(map(partial(_same, about), (M, C, G, K), matrices_in_letters(symbolic.linearisation))):
            raise Untold(UNTOLD, HINT)
        return M, C, G, K
    if symbolic.linearisable:
        found = symbolic.matrices
        mine = (M, C if spec.get("damping") is None else _damped_as_a_whole(about, sheet, found[1]), G, K)
        if not all(_same(about, own, engine) for own, engine in zip(mine, found, strict=True)):
            raise Untold(UNTOLD, HINT)
        return mine if about.abbreviates else found
    numbers = about.problem.configuration.linear_system.matrices()
    if not all(_alike(about, *pair) for pair in zip((M, C, G, K), numbers, strict=True)):
        raise Untold(UNTOLD, HINT)
    return M, C, G, K


def _damped_as_a_whole(about: AboutRest, sheet: WorkedSolution,
                       C: "dict[tuple[int, int], Node]") -> "dict[tuple[int, int], Node]":
    """What `damping:` adds to C, which is told."""
    alpha, beta = (about.scene.lower(one) for one in about.problem.spec.get("damping")["proportional"])
    parts = [part for node, name in ((alpha, "M"), (beta, "K")) if not node.is_zero
             for part in (" + ", Factor(node), "·", Name(sheet.matrix(name)))][1:]
    sheet.write(Words("`damping:` adds  "), *parts, Words("  to the damping matrix"), settles="damping")
    return C


def _same(about: AboutRest, own: "Mapping[tuple[int, int], Node]", found: "Mapping[tuple[int, int], Node]") -> bool:
    zero = about.table.zero
    return all(about.same(own.get(pair, zero), found.get(pair, zero)) for pair in {*own, *found})


def _alike(about: AboutRest, own: "Mapping[tuple[int, int], Node]", found: Mapping[tuple[int, int], float]) -> bool:
    """Are the expressions of a matrix its numbers, but for rounding beside those on its diagonal?"""
    values = {pair: about.value(node) for pair, node in own.items()}
    for i, j in {*values, *found}:
        size = abs(found.get((i, i), 0.0) * found.get((j, j), 0.0))**0.5 + abs(found.get((i, j), 0.0))
        if not abs(values.get((i, j), 0.0) - found.get((i, j), 0.0)) <= ALIKE * size:
            return False
    return True


def drive_of(problem: "Problem") -> "dict[int, Node]":
    """{i: Q(t)} of the right sides, without what damping by modes drives."""
    symbolic, scene = problem.symbolic, problem.scene
    if not scene.timed or proportional(problem.spec):
        return symbolic.excitation
    if scene.vibrating is not scene:
        raise Untold(UNTOLD, HINT)
    return excitation(scene, problem.system.time_dependent_linearisation, symbolic.excitation_place)


def row(scene: "Scene", matrix: "Mapping[tuple[int, int], Node]", i: int, symbols: "Sequence[Node]") -> "Node":
    """Row i of a matrix times a column."""
    return scene.table.sum(*((node * symbols[j], 1) for (k, j), node in matrix.items() if k == i))


def left(scene: "Scene", matrices: tuple[Any, ...], i: int) -> "Node":
    """The left side of equation i of M q̈ + (C + G) q̇ + K q = Q."""
    M, C, G, K = matrices
    return row(scene, M, i, scene.a) + row(scene, C, i, scene.v) + row(scene, G, i, scene.v) + row(
        scene, K, i, scene.q)
