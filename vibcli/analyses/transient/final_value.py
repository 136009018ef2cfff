"""What a motion comes to rest at."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.analyses.excitation.forcing import oscillates
from vibcli.analyses.transient.textbook_form import expanded
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.linear_response import LinearMotion

NOTHING = 1e-13


def final(motion: "LinearMotion", output: "LinearOutput") -> float:
    """The limit of the output as t → ∞; PhysicsError where it keeps vibrating, drifts or grows.

    E[nodes] = Σ over its different nodes λ of (polynomial in t) e^{λt}. Parts of the same λ are added up over all terms
    before they are judged, since a drift that two places share cancels in their difference.
    """
    if motion.forcing.period is not None:
        raise PhysicsError("the load is periodic: the motion comes to no rest",
                           hint="ask for max(x), min(x) or a value at a time")
    parts = motion.pieces(math.inf).on(output, -1, split=False)
    scale = sum(abs(factor * _size(nodes)) for nodes, factor in parts)
    drift, vibration = {}, {}
    for nodes, factor in parts:
        if abs(factor * _size(nodes)) > NOTHING * scale:
            if any(node.real > 0 for node in nodes):
                raise PhysicsError("the motion grows without end: it comes to no rest", "ask for a value at a time")
            _add(drift, factor, nodes, 0j)
            for node in {node for node in nodes if node and not node.real}:
                _add(vibration.setdefault(abs(node.imag), {}), factor, nodes, node)
    if any(_stays(*sums) for found in vibration.values() for power, sums in found.items() if power):
        raise PhysicsError("the motion grows without end: it comes to no rest", "ask for a value at a time")
    if any(_stays(*sums) for power, sums in drift.items() if power):
        raise PhysicsError("the motion drifts without end: it comes to no rest", hint="ask for a value at a time")
    if any(_stays(*sums) for found in vibration.values() for sums in found.values()):
        if oscillates(motion.forcing):
            raise PhysicsError("the loads oscillate without end: the motion comes to no rest",
                               hint="ask for max(x), min(x) or a value at a time")
        raise PhysicsError("the motion keeps vibrating: it comes to no rest",
                           hint="ask for max(x), min(x) or a value at a time, or add a damper")
    return float(drift.get(0, (0.0,))[0].real)


def _stays(total: complex, size: float) -> bool:
    """Is a sum more than the rounding of its parts?"""
    return abs(total) > NOTHING * size


def _add(found: dict[int, tuple[complex, float]], factor: complex, nodes: tuple[complex, ...], node: complex) -> None:
    """Adds the coefficients of tᵏ e^{node t} in factor · E[nodes] to {k: (sum, sum of magnitudes)}; of conjugate nodes
    that of the upper one, and of real ones the real part."""
    for power, c in coefficients(nodes, node).items():
        whole = factor * c
        part = whole.real if not node else whole if node.imag > 0 else whole.conjugate()
        total, size = found.get(power, (0.0, 0.0))
        found[power] = total + part, size + abs(whole)


def coefficients(nodes: Sequence[complex], node: complex) -> dict[int, complex]:
    """{k: c}: E[nodes](t) holds Σ c tᵏ e^{node t}; the Taylor series of 1/Π(p − λ) over the other nodes."""
    others = [other for other in nodes if other != node]
    return dict(enumerate(expanded(node, len(nodes) - len(others), others))) if node in nodes else {}


def _size(nodes: tuple[complex, ...]) -> float:
    """A measure of E[nodes], for telling what is only rounding: the product of the times of all nodes but one."""
    rates = sorted(abs(node) for node in nodes if node)
    return 1.0 / math.prod(rates[:len(nodes) - 1]) if rates else 1.0
