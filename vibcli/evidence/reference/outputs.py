"""Signals of motions as expressions. Of small ones forces, stretches, places are linear functions of the deviations,

    y = y₀ + Σ qᵢ ∂y/∂qᵢ + Σ q̇ᵢ ∂y/∂q̇ᵢ + Σ q̈ᵢ ∂y/∂q̈ᵢ + the same of driven displacements + f(t),

whose coefficients have as many digits as the element data.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.forces_along import TrueForces
from vibcli.evidence.reference.motion import Motion
from vibcli.language.signals import is_reaction
from vibcli.mechanics.inputs_outputs.outputs import linear_row
from vibcli.mechanics.precise_configuration import PreciseConfiguration
from vibcli.mechanics.signals import moving
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import QuantityRef
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.mechanics.inputs_outputs.linear_functions import LinearFunction
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import NameRef


class FollowedScene(NamedTuple):
    """A scene with all coordinates that are followed, as a system whose signals are told."""

    spec: Any
    scene: Any


def with_output(problem: "Problem", motion: Motion, text: str) -> "tuple[Motion, Node]":
    """(the Motion with the coefficients of a signal among its parameters, the expression of the signal)."""
    near = linear_row(problem.configuration, text)
    scene, table = motion.scene, motion.scene.table
    letters = {key: table.parameter(f"{text}[{';'.join(map(str, key))}]", positive=False) for key in _numbers(near)}
    carried = _carried(problem, scene, near, letters)
    node = table.total([letter * carried[key] if key in carried else letter for key, letter in letters.items()])
    known: dict[int, dict[str, Any]] = {}

    def values(bits: int) -> dict[str, Any]:
        if bits not in known:
            with mpmath.workprec(2 * bits):
                found = _numbers(linear_row(PreciseConfiguration(problem.configuration), text))
                known[bits] = {letter.name: mpmath.mpmathify(found.get(key, 0)) for key, letter in letters.items()}
        return {**motion.values(bits), **known[bits]}

    floats = {letter.name: float(_numbers(near)[key]) for key, letter in letters.items()}
    return motion._replace(values=values, floats={**motion.floats, **floats}), node


def _carried(problem: "Problem", scene: "Scene", row: "LinearFunction",
             keys: "Mapping[tuple[str, int], Node]") -> "dict[tuple[str, int], Node]":
    """{key: what a coefficient stands before}: coordinates, driven displacements and their rates, functions of time."""
    opened, symbols = problem.configuration.with_inputs, {"q": scene.q, "v": scene.v, "a": scene.a}
    driven, found = list(opened.scene.inputs.values()), {}
    for kind, i in keys:
        if kind == "t":
            found[kind, i], = copied([row.time[i][1]], scene.table)
        elif kind != "0" and i < opened.n:
            found[kind, i] = symbols[kind][i]
        elif kind != "0":
            node = driven[i - opened.n].node
            if node is None:
                raise PhysicsError("no reference is found of signals that loads enter themselves")
            for _ in range("qva".index(kind)):
                node = opened.scene.rate(node)
            found[kind, i], = copied([node], scene.table)
    return found


def signal(problem: "Problem", motion: Motion, tree: Any) -> "tuple[Motion, Node]":
    """(the Motion, the expression of a signal): of coordinates and their rates, of full motions also of places and
    stretches, of small ones of what is linear in the deviations, or in a linear scene."""
    scene = motion.scene

    def symbol(name: str, primes: int, part: "NameRef") -> "Node":
        nonlocal motion
        if name in scene.parameters.nodes and not primes and not isinstance(part, QuantityRef):
            return scene.parameters.nodes[name]
        if name in scene.coordinates:
            return motion.coordinate(name, primes)
        if motion.rested and not isinstance(part, QuantityRef):
            motion, found = _of_small(problem, motion, name, primes)
            return found
        if isinstance(part, QuantityRef):
            raise PhysicsError("of this motion a reference is found of signals alone, and of steady states")
        if is_reaction(problem.spec, name) and not primes:
            return TrueForces(problem, scene)[name]
        followed: Any = FollowedScene(problem.spec, scene)
        try:
            return moving(followed, name, primes)
        except PhysicsError:
            raise PhysicsError("of full motions a reference is found of coordinates, places, energies, and of forces "
                               "alone") from None

    node = lower(tree, scene.table, symbol)
    return motion, node


def _of_small(problem: "Problem", motion: Motion, name: str, primes: int) -> "tuple[Motion, Node]":
    """What is linear in the deviations, or else exact in a linear scene, with its coordinates counted from rest."""
    try:
        return with_output(problem, motion, name + "'" * primes)
    except PhysicsError:
        if not problem.system.is_linear or motion.scene is not problem.scene:
            raise
        from vibcli.symbolic.derivatives import substitute

        places = {q: motion.coordinate(q.name) for q in motion.scene.q}
        return motion, substitute([moving(problem.system, name, primes)], places)[0]


def _numbers(row: "LinearFunction") -> dict[tuple[str, int], Any]:
    """{(kind, number): coefficient}, the constant being that of kind 0, functions of time of kind t."""
    return ({("0", 0): row.constant} | {("t", i): factor for i, (factor, _) in enumerate(row.time)}
            | {(kind, i): x for kind, part in (("q", row.q), ("v", row.v), ("a", row.a)) for i, x in part.items() if x})
