"""Fields with which members start, functions of the place along a piece."""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.mechanics.initial_fields import MemberFields
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


def given_along(scene: "Scene", piece: "PlacedPiece", given: "MemberFields | None") -> "dict[int, Node]":
    """{0: u, 1: u̇} of those that are given, nodes; the time of the scene stands for the place along a piece."""
    from vibcli.symbolic.derivatives import substitute

    parts = () if given is None else (given.displacement, given.rate)
    place = {scene.time: scene.time + scene.table.number(fraction_of(float(piece.start)))}
    return {rate: substitute([part], place)[0] for rate, part in enumerate(parts) if part is not None}


def over_place(problem: "Problem", piece: "PlacedPiece", nodes: "dict[int, Node]",
               orders: "Sequence[int]") -> "Forcing":
    """{channel: node} of functions of the place on a piece as Forcing; as polynomials to rounding where they are no
    sums of powers, exponentials and sines, of derivatives of these orders."""
    from vibcli.analyses.continuous.smooth_fields import smooth_field
    from vibcli.analyses.excitation.decompose import forcing_of
    from vibcli.notation.plain import plain
    from vibcli.symbolic.smooth_panels import NotSmooth

    table, time, floats = problem.scene.table, problem.scene.time, problem.numeric.floats
    try:
        return forcing_of(nodes, time, floats, len(orders), write=plain, work=problem.work)
    except PhysicsError:
        pass
    try:
        return smooth_field(nodes, time, table.number(fraction_of(float(piece.piece.length))), floats, orders)
    except NotSmooth as error:
        raise PhysicsError(f"the field with which '{piece.owner}' starts, or what bends it, {error.message} of its "
                           "piece", error.hint) from None
