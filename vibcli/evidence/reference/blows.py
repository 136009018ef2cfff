"""Impulses that strike a small motion: q̇ jumps by M⁻¹ J at each of their instants.

    Q(t) = Q₀(t) + Σ c(t) δ(a t − b):  at t₀ = b/a,  J = c(t₀)/|a|

Rates of records hold such ones, too (records.py).
"""

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.analyses.time_integration.motion_series import fixed_point
from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.records import DrivingRecord, driving_records, strikes
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

Blows = list[tuple[int, list[int]]]         # (instant, jumps of q̇) in fixed point
Struck = list[tuple[int, "Node | DrivingRecord", "Node"]]


def without_impulses(scene: "Scene", drive: "Mapping[int, Node]") -> "tuple[dict[int, Node], Struck]":
    """(loads without their impulses, [(coordinate, an impulse or a record with such, its factor)])."""
    smooth, found, nothing = {}, [], scene.table.zero
    for i, node in drive.items():
        impulses = {part: part for part in reachable([node]) if part.name == "impulse"}
        records = driving_records(scene, [node])
        struck: dict[Any, Any] = impulses | {record.node: record for record in records if strikes(record)}
        smooth[i], = substitute([node], dict.fromkeys(impulses, nothing))
        still = dict.fromkeys(struck, nothing)
        for part, what in struck.items():
            one, none = (substitute([node], {**still, part: scene.table.number(x)})[0] for x in (1, 0))
            found.append((i, what, one - none))
    return smooth, found


def blows(scene: "Scene", struck: Struck, values: Callable[[int], Mapping[str, Any]],
          inertia: Callable[[Mapping[str, Any]], Any]) -> Callable[[int], Blows]:
    """bits ↦ the blows; values(bits): of all parameters; inertia(of these): M as a matrix of mpmath."""
    time = scene.time.name
    strokes = [what.blows if isinstance(what, DrivingRecord) else _stroke(scene, what) for _, what, _ in struck]

    def found(bits: int) -> Blows:
        with mpmath.workprec(2 * bits):
            known, result = values(bits), []
            for (i, _, factor), stroke in zip(struck, strokes, strict=True):
                for instant, size in stroke(time, known):
                    scaled, = evaluate([factor], multiprecision(), {**known, time: instant})
                    push = mpmath.zeros(len(scene.q), 1)
                    push[i] = scaled * size
                    if instant >= 0 and push[i]:
                        result.append((fixed_point(instant, bits), [fixed_point(x, bits) for x in mpmath.lu_solve(
                            inertia(known), push)]))
            return sorted(result)

    return found


def _stroke(scene: "Scene", impulse: "Node") -> Callable[[str, Mapping[str, Any]], Iterator[tuple[Any, Any]]]:
    """Gives the instant and the size of an impulse."""
    argument = impulse.args[0]
    slope = gradient(argument).get(scene.time)
    if slope is None or slope.mask:
        raise PhysicsError("no reference is found of impulses whose instants are no linear functions of the time")

    def stroke(time: str, known: Mapping[str, Any]) -> Iterator[tuple[Any, Any]]:
        offset, rate = evaluate([argument, slope], multiprecision(), {**known, time: mpmath.mpf(0)})
        yield -offset / rate, 1 / abs(rate)

    return stroke
