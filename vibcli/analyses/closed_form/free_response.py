"""The free motion of one degree of freedom in letters, m q̈ + c q̇ + k q = 0 from q₀ and q̇₀:

    c = 0          q₀ cos ωt + q̇₀/ω sin ωt                                    ω² = k/m
    c² < 4 k m     e^{−δt} (q₀ cos ω_d t + (q̇₀ + δ q₀)/ω_d sin ω_d t)          δ = c/(2m), ω_d² = k/m − δ²
    c² = 4 k m     e^{−δt} (q₀ + (q̇₀ + δ q₀) t)
    c² > 4 k m     e^{−δt} (q₀ cosh βt + (q̇₀ + δ q₀)/β sinh βt)                β² = δ² − k/m
    m = 0          q₀ e^{−(k/c) t}
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters
from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.common_denominator import shorter
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.radicals import root

if TYPE_CHECKING:

    from vibcli.symbolic.node import Node

UNDAMPED, UNDER, CRITICAL, OVER = "undamped", "under-damped", "critically damped", "over-damped"
RELAXATION = "relaxation"


class FreeMotion(NamedTuple):
    """decay: e^{−δt}, or None; wave: the terms of what it multiplies; rate: the symbol of ω, ω_d or β, or None; value:
    what that is."""

    regime: str
    decay: Any
    wave: Any
    rate: Any
    value: Any


def free_motions(m: "Node", c: "Node", k: "Node", start: "Sequence[Node]", rates: "Mapping[str, Node]", t: "Node",
                 samples: Sequence[dict[str, float]]) -> list[FreeMotion]:
    """The FreeMotions of each regime that there may be; start: (q₀, q̇₀); rates: {regime: symbol of its frequency}."""
    if k.is_zero:
        raise NotInLetters("nothing brings this motion back: it is found in numbers", "give numbers with --set")
    x, v = start
    if m.is_zero:
        return [FreeMotion(RELAXATION, m.table.call("exp", -(shorter(textbook(k / c)) * t)), (x,), None, None)]
    table, delta = m.table, shorter(textbook(c / (2 * m)))
    if c.is_zero:
        omega = rates[UNDAMPED]
        wave = x * table.call("cos", omega * t), v / omega * table.call("sin", omega * t)
        return [FreeMotion(UNDAMPED, None, wave, omega, root(shorter(textbook(k / m)), samples))]
    decay, slope, found = table.call("exp", -(delta * t)), v + delta * x, []
    for regime, even, odd, sign in ((UNDER, "cos", "sin", 1), (CRITICAL, None, None, 0), (OVER, "cosh", "sinh", -1)):
        if not sign:
            found.append(FreeMotion(regime, decay, (x, slope * t), None, None))
            continue
        beta = rates[regime]
        wave = x * table.call(even, beta * t), slope / beta * table.call(odd, beta * t)
        square = sign * (shorter(textbook(k / m)) - delta * delta)
        found.append(FreeMotion(regime, decay, wave, beta, table.sqrt(square)))
    return found


def critical(m: "Node", c: "Node", k: "Node") -> bool:
    """Is c² = 4 k m whatever values the letters have?"""
    return is_zero(c * c - 4 * k * m)


def regime_at(m: float, c: float, k: float) -> str:
    """The regime for numbers m, c, k."""
    if not m:
        return RELAXATION
    if not c:
        return UNDAMPED
    return CRITICAL if c * c == 4 * k * m else UNDER if c * c < 4 * k * m else OVER
