"""Signals of small motions that are no coordinates: forces, stretches, places as linear functions of the deviations,

    y = y₀ + Σ qᵢ ∂y/∂qᵢ + Σ q̇ᵢ ∂y/∂q̇ᵢ + Σ q̈ᵢ ∂y/∂q̈ᵢ,

whose coefficients have as many digits as the element data.
"""

from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.analyses.excitation.signal_outputs import linear_output
from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.motion import Motion
from vibcli.mechanics.precise_configuration import PreciseConfiguration

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


def _numbers(output: Any) -> dict[tuple[str, int], Any]:
    """{(kind, coordinate): coefficient}, the constant being that of kind 0."""
    return {("0", 0): output.constant} | {(kind, i): x for kind, part in (("q", output.q), ("v", output.v), (
        "a", output.a)) for i, x in part.items()}
