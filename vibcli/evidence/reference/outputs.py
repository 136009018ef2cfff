"""Signals of motions as expressions. Of small ones forces, stretches, places are linear functions of the deviations,

    y = y₀ + Σ qᵢ ∂y/∂qᵢ + Σ q̇ᵢ ∂y/∂q̇ᵢ + Σ q̈ᵢ ∂y/∂q̈ᵢ,

whose coefficients have as many digits as the element data.
"""

from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.analyses.excitation.signal_outputs import linear_output
from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.motion import Motion
from vibcli.mechanics.precise_configuration import PreciseConfiguration
from vibcli.mechanics.signals import moving
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


def with_output(problem: "Problem", motion: Motion, text: str) -> "tuple[Motion, Node]":
    """(the Motion with the coefficients of a signal among its parameters, the expression of the signal)."""
    output, direct = linear_output(problem.configuration, text)
    if direct or output.places:
        raise PhysicsError("no reference is found of signals that loads or driven motions enter themselves")
    scene, table = motion.scene, motion.scene.table
    letters = {key: table.parameter(f"{text}[{';'.join(map(str, key))}]", positive=False) for key in _numbers(output)}
    symbols = {"q": scene.q, "v": scene.v, "a": scene.a}
    node = table.total([letter if kind == "0" else letter * symbols[kind][i] for (kind, i), letter in letters.items()])
    known: dict[int, dict[str, Any]] = {}

    def values(bits: int) -> dict[str, Any]:
        if bits not in known:
            with mpmath.workprec(2 * bits):
                found = _numbers(linear_output(PreciseConfiguration(problem.configuration), text)[0])
                known[bits] = {letter.name: mpmath.mpmathify(found.get(key, 0)) for key, letter in letters.items()}
        return {**motion.values(bits), **known[bits]}

    floats = {letter.name: float(x) for (key, letter) in letters.items() for x in [_numbers(output)[key]]}
    return motion._replace(values=values, floats={**motion.floats, **floats}), node


def signal(problem: "Problem", motion: Motion, tree: Any) -> "tuple[Motion, Node]":
    """(the Motion, the expression of a signal): of coordinates and their rates, of full motions also of places and
    stretches, of small ones of what is linear in the deviations, or in a linear scene."""
    scene = motion.scene

    def symbol(name, primes, part):
        nonlocal motion
        if name in scene.parameters.nodes and not primes and not isinstance(part, QuantityRef):
            return scene.parameters.nodes[name]
        if name in scene.coordinates:
            return motion.coordinate(name, primes)
        if motion.rested and not isinstance(part, QuantityRef):
            motion, found = _of_small(problem, motion, name, primes)
            return found
        if isinstance(part, QuantityRef) or scene is not problem.scene:
            raise PhysicsError("of this motion a reference is found of coordinates and their rates alone")
        try:
            return moving(problem.system, name, primes)
        except PhysicsError:
            raise PhysicsError("of full motions a reference is found of coordinates, places, energies, and of the "
                               "forces of springs and dampers alone") from None

    node = lower(tree, scene.table, symbol)
    return motion, node


def _of_small(problem, motion, name, primes):
    """What is linear in the deviations, or else exact in a linear scene, with its coordinates counted from rest."""
    try:
        return with_output(problem, motion, name + "'" * primes)
    except PhysicsError:
        if not problem.system.is_linear or motion.scene is not problem.scene:
            raise
        from vibcli.symbolic.derivatives import substitute

        places = {q: motion.coordinate(q.name) for q in motion.scene.q}
        return motion, substitute([moving(problem.system, name, primes)], places)[0]


def _numbers(output: Any) -> dict[tuple[str, int], Any]:
    """{(kind, coordinate): coefficient}, the constant being that of kind 0."""
    return {("0", 0): output.constant} | {(kind, i): x for kind, part in (("q", output.q), ("v", output.v), (
        "a", output.a)) for i, x in part.items()}
