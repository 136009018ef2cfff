"""Matrices and generalised forces at an instant of a motion (mechanics/state_functions.py)."""

from collections.abc import Sequence
from math import isfinite
from typing import TYPE_CHECKING

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.language.spec import RELEASED
from vibcli.quantities.matrices import coordinate_number
from vibcli.quantities.matrices import dimension as entry_dimension
from vibcli.quantities.quantity import ERROR, ROUNDING, Declaration
from vibcli.quantities.response import at_instant
from vibcli.quantities.signal_dimensions import generalised_dimension
from vibcli.symbolic.syntax import Number

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef


def _node(problem: "Problem", tree: "QuantityRef") -> "Node":
    from vibcli.mechanics.state_functions import entry, force

    numbers = [coordinate_number(problem, index) for index in tree.indices]
    return force(problem.scene, *numbers) if tree.head == "Q" else entry(problem.scene, tree.head, *numbers)


def _value(problem: "Problem", tree: "QuantityRef", args: Sequence[float]) -> tuple[float, float]:
    found, error = _at(problem, _node(problem, tree), args[0])
    return float(found), min(1.0, max(ERROR if args[0] else ROUNDING, error / (abs(found) or 1e-300)))


def _at(problem: "Problem", node: "Node", time: float) -> tuple[float, float]:
    """(value, absolute error bound) of a function of the state at an instant; no motion is followed to its start."""
    from vibcli.symbolic.evaluation import Floats, evaluate
    from vibcli.symbolic.expression_graph import reachable

    if not time and not any(part.name == "sign" for part in reachable([node])):
        found, = evaluate([node], Floats, _start(problem))
        if isinstance(found, complex) or not isfinite(found):
            raise PhysicsError("this has no finite real value at t = 0", "ask for a later instant, or start elsewhere")
        return found, 0.0
    signal = problem.response.state_signal(node)
    return at_instant(signal, time), signal.error(time)


def _start(problem: "Problem") -> dict[str, float]:
    """{symbol: float} of the state at t = 0."""
    numeric, (places, speeds) = problem.numeric, problem.response.start
    drawn = numeric.drawn_floats
    closed = numeric.closed_at_start(drawn, {**drawn, **places})
    rates = {name + "'": speed for name, speed in speeds.items()}
    return {**numeric.floats, problem.scene.time.name: 0.0, **closed, **rates}


def _in_letters(problem: "Problem", tree: "QuantityRef") -> "Node":
    """At t = 0, where the motion starts in letters: as `initial` says, else from the equilibrium."""
    from vibcli.symbolic.derivatives import substitute
    from vibcli.symbolic.normal_form import textbook

    scene, record = problem.scene, problem.spec.get("initial") or {}
    instant = tree.args[0]
    if not isinstance(instant, Number) or instant.value or RELEASED in record or not _all_have_inertia(scene):
        raise NotInLetters(f"'{tree.text}' is found in numbers", "give the letters values: with_values(…), or --set")
    rest = {} if all(name in record for name in scene.coordinates) else problem.symbolic.equilibrium_position
    start = {scene.time: scene.table.zero}
    for name, q, v in zip(scene.coordinates, scene.q, scene.v, strict=True):
        start[q] = scene.lower(record[name]) if name in record else rest[name]
        start[v] = scene.lower(record[name + "'"]) if name + "'" in record else scene.table.zero
    found, = substitute([_node(problem, tree)], start)
    return textbook(found)


def _all_have_inertia(scene: "Scene") -> bool:
    """Does something of inertia move with each coordinate, and does none follow from loops: may all starts be given?"""
    from vibcli.mechanics.energies import kinetic
    from vibcli.symbolic.derivatives import gradient

    slopes = gradient(kinetic(scene))
    return scene.loops is None and all(v in slopes for v in scene.v)


def _size(problem: "Problem", tree: "QuantityRef") -> float:
    """The sum of the magnitudes of its terms."""
    from vibcli.quantities.expression import number_of
    from vibcli.symbolic.rationals import ONE

    node, time = _node(problem, tree), number_of(problem, tree.args[0])
    parts = node.args if node.op == "sum" else ((node, ONE),)
    return sum(abs(float(c) * _at(problem, part, time)[0]) for part, c in parts)


def _entry(about: str) -> Declaration:
    return Declaration(about, None, _value, ("coordinate", "coordinate"), ("time",), dimension=entry_dimension,
                       size=_size, symbolic=_in_letters)


QUANTITIES = {
    "M()": _entry("entry of the mass matrix at an instant of the motion"),
    "C()": _entry("entry of the damping matrix at an instant, of dampers and loads"),
    "K()": _entry("tangent stiffness −∂Q/∂r at an instant, Q being Q[q](2 s)"),
    "Q()": Declaration(
        "generalised force −∂V/∂q + Σ F ∂s/∂q of springs, weights and loads as they act at an instant, dampers left "
        "out, with what the inertia of driven motions exerts at relative rest", None, _value, ("coordinate",),
        ("time",), size=_size, symbolic=_in_letters,
        dimension=lambda spec, tree: generalised_dimension(spec, spec.coordinate_name(tree.indices[0]))),
}
