"""Impulses that strike a small motion: q̇ jumps by M⁻¹ J at each of their instants.

    Q(t) = Q₀(t) + Σ c(t) δ(a t − b):  at t₀ = b/a,  J = c(t₀)/|a|
"""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.analyses.time_integration.motion_series import fixed_point
from vibcli.base.errors import PhysicsError
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

Blows = list[tuple[int, list[int]]]         # (instant, jumps of q̇) in fixed point


def without_impulses(drive: "Mapping[int, Node]") -> "tuple[dict[int, Node], list[tuple[int, Node, Node]]]":
    """(loads without their impulses, [(coordinate, argument of an impulse, its factor)])."""
    smooth, found = {}, []
    for i, node in drive.items():
        struck = [part for part in reachable([node]) if part.name == "impulse"]
        still = dict.fromkeys(struck, node.table.zero)
        smooth[i], = substitute([node], still)
        for part in struck:
            one, = substitute([node], {**still, part: node.table.number(1)})
            found.append((i, part.args[0], one - smooth[i]))
    return smooth, found


def blows(scene: "Scene", struck: "list[tuple[int, Node, Node]]", values: Callable[[int], Mapping[str, Any]],
          inertia: Callable[[Mapping[str, Any]], Any]) -> Callable[[int], Blows]:
    """bits ↦ the blows; values(bits): of all parameters; inertia(of these): M as a matrix of mpmath."""
    slopes = [gradient(argument).get(scene.time) for _, argument, _ in struck]
    if any(slope is None or slope.mask for slope in slopes):
        raise PhysicsError("no reference is found of impulses whose instants are no linear functions of the time")

    def found(bits: int) -> Blows:
        with mpmath.workprec(2 * bits):
            known, arithmetic, result = values(bits), multiprecision(), []
            for (i, argument, factor), slope in zip(struck, slopes, strict=True):
                offset, rate = evaluate([argument, slope], arithmetic, {**known, scene.time.name: mpmath.mpf(0)})
                instant = -offset / rate
                size, = evaluate([factor], arithmetic, {**known, scene.time.name: instant})
                push = mpmath.zeros(len(scene.q), 1)
                push[i] = size / abs(rate)
                if instant >= 0:
                    result.append((fixed_point(instant, bits), [fixed_point(x, bits) for x in mpmath.lu_solve(
                        inertia(known), push)]))
            return sorted(result)

    return found
