"""Signals whose amplitude tells one free motion of a family from another."""

from typing import TYPE_CHECKING, Any

from vibcli.analyses.nonlinear.period import has_potential
from vibcli.base.errors import PhysicsError
from vibcli.language.signals import signal_dimension
from vibcli.notation.numbers import with_unit
from vibcli.results.signal_nodes import node_of_signal
from vibcli.symbolic.syntax import NameRef, QuantityRef

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


def require_families(problem: "Problem") -> None:
    """PhysicsError where a scene has no families of free motions."""
    if problem.spec.members:
        raise PhysicsError("members take part in small motions alone: their frequencies hang on no amplitude",
                           "ask for omega[1]")
    scene = problem.scene.resting
    if scene.timed:
        raise PhysicsError("loads or displacements in time drive this scene: it has no family of free motions",
                           "leave them out, or ask for its motion in time")
    if not has_potential(scene):
        raise PhysicsError("families of free motions are found of open chains whose forces have a potential",
                           "this scene has closed loops" if scene.loops is not None else
                           "a load of this scene follows its motion")


def require_positive(amplitude: float) -> None:
    if not amplitude > 0:
        raise PhysicsError("an amplitude is positive", "as the amplitude tends to 0, ask for omega[1]")


def node_of(problem: "Problem", tree: Any) -> "Node":
    """The expression of a signal, by the coordinates of the scene at rest."""
    from vibcli.mechanics.signals import moving

    scene, system = problem.scene.resting, problem.system

    def symbol(name: str, primes: int, part: NameRef) -> "Node":
        if isinstance(part, QuantityRef):
            raise PhysicsError(f"'{part.text}' has no amplitude in a family of motions",
                               "ask for the amplitude of a coordinate, of a place or of a spring's force")
        found = scene.parameters.nodes.get(name) if not primes else None
        return found if found is not None else moving(system, name, primes)

    return node_of_signal(tree, scene.table, symbol)


def require_changing(node: "Node") -> None:
    """PhysicsError where a signal is the same in all motions."""
    if not node.mask:
        raise PhysicsError("this signal does not change: it has no amplitude", "ask for that of what moves")


def amplitude_told(problem: "Problem", tree: Any, amplitude: float) -> str:
    """An amplitude of a signal with its unit."""
    spec = problem.spec
    known = isinstance(tree, NameRef) and not tree.primes
    dimension = known and (spec.dimensions.of(tree.name) if tree.name in spec.coordinates else
                           signal_dimension(spec, tree.name))
    return with_unit(amplitude, dimension) if dimension else f"{amplitude:.6g} in SI units"
