"""Signals that drift, c₁t + c₂t² + … beside what lasts of them, and functions of these in which that cancels."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.results.signal_features import beside_drift, drifting, kept_up
from vibcli.results.signals import ComposedSignal, LinearSignal
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

AT = 0.0, 0.3, 0.7, 1.1         # how far along a drift, in sizes of a signal, it is looked whether it is seen
CANCELLED = 1e-11       # relative: what is left of slopes that cancel


def require_cancelled(signal: ComposedSignal, node: "Node") -> None:
    """Refuses a node of the signals of a ComposedSignal that changes as these drift."""
    slopes = {symbol.name: slope for symbol, slope in gradient(node).items()}
    if any(not _cancels(signal, slopes, along, share) for along in _drifts(signal) for share in AT):
        raise PhysicsError("what moves on without end does not cancel in this signal: it has no mean",
                           "ask for its value at a time, or for a signal that does not see what moves on")


def next_to_zero(signal: ComposedSignal) -> dict[str, float]:
    """{name: c} by which signals are moved along drifts that cancel, so that what is far along them is near 0."""
    found: dict[str, float] = {}
    for along in _drifts(signal):
        means = {name: _mean(signal.signals[name]) + found.get(name, 0.0) for name in along}
        share = sum(c * means[name] for name, c in along.items()) / sum(c * c for c in along.values())
        found |= {name: found.get(name, 0.0) - share * c for name, c in along.items()}
    return found


def _mean(part: LinearSignal) -> float:
    """Of a signal beside its drift."""
    return part.motion.steady.polynomial(part.output)[0] if kept_up(part) else beside_drift(part)[0][1].real


def _drift(part: LinearSignal) -> dict[Any, Any]:
    """{k: cₖ} of a signal, k ≥ 1; none of what is no linear one."""
    if not isinstance(part, LinearSignal):
        return {}
    if not kept_up(part):
        return drifting(part)
    return {k: c for k, c in enumerate(part.motion.steady.polynomial(part.output)) if k and c}


def _drifts(signal: ComposedSignal) -> list[Any]:
    """[{name: c}] of the drifts c tᵏ of its signals, of each power one."""
    found = {name: _drift(part) for name, part in signal.signals.items()}
    powers = sorted({k for one in found.values() for k in one})
    return [{name: one[k] for name, one in found.items() if k in one} for k in powers]


def _cancels(signal: ComposedSignal, slopes: "Mapping[str, Node]", along: Mapping[str, float], share: float) -> bool:
    """Is the slope of a function along a drift 0 but for rounding, so far along it?"""
    import numpy as np

    at = np.array([share])
    here = {name: float((part.motion.steady.values(part.output, at) if isinstance(part, LinearSignal) and kept_up(part)
                         else part.values(at))[0]) for name, part in signal.signals.items()}
    size = max(map(abs, here.values()), default=0.0) / max(map(abs, along.values()))
    here |= {name: here[name] + share * size * c for name, c in along.items()}
    terms = [c * evaluate([slopes[name]], Floats, {**signal.floats, **here})[0] for name, c in along.items()
             if name in slopes]
    found: bool = abs(sum(terms)) <= CANCELLED * sum(map(abs, terms))
    return found
