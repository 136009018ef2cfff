"""Modes that move by themselves, many at a time, from one bend of the loads to the next.

An oscillating mode η̈ + c η̇ + ω² η = b f is η = Re c, ċ = λ c + w f; two real λ are two such states. Under a wave
f = Re(F τᵏ e^{sτ}) with a(s) = w F/2

    c = C e^{λτ} + Σ gᵢ τⁱ e^{sτ} + the same of s̄ and F̄,      (s − λ) gᵢ = a [i = k] − (i + 1) gᵢ₊₁

and where s is next to λ the part k! a E[λ, s…s](τ), a divided difference, instead.
"""

from collections.abc import Iterator, Sequence
from math import factorial
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.transient.exponential_differences import differences
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.excitation.forcing import Segment

EPSILON = 2.0**-52
NEAR = 1e-3         # an exponent next to an eigenvalue: (distance/|λ|)ᵏ⁺¹ of a wave τᵏ
ALIKE, AROUND = 3e-5, 3e-4      # |1 − ζ| below which two λ of a mode are not told apart, and how far about ζ they are


class States(NamedTuple):
    """rates λ, inputs w (states, channels), modes: the mode each is of, begin: c before the first segment."""

    rates: np.ndarray
    inputs: np.ndarray
    modes: np.ndarray
    begin: np.ndarray


class Stroke(NamedTuple):
    """A wave on all channels from the start of a segment on: Re(F τᵏ e^{sτ})."""

    exponent: complex
    power: int
    force: np.ndarray


class FreeStretch(NamedTuple):
    """A segment of the loads: what drives, and C of each state; rigid: (η, η̇) of the modes that nothing holds; sizes:
    of all that each C is summed of; lost: what rounding leaves of `rigid`."""

    start: float
    strokes: list[Stroke]
    free: np.ndarray
    rigid: np.ndarray
    sizes: np.ndarray
    lost: np.ndarray


def states_of(squares: np.ndarray, damping: np.ndarray, inputs: np.ndarray, eta: np.ndarray,
              rate: np.ndarray) -> States:
    """Those of modes η̈ + c η̇ + ω² η = b f, not both c and ω² being 0, with ω² = squares, c = damping, b = inputs,
    which start with η and η̇."""
    number, half, weight = _told_apart(squares, damping)
    square = squares[number] - half**2
    turning, root = (half.imag == 0) & (square.real > 0), np.sqrt(-square)
    with np.errstate(divide="ignore", invalid="ignore"):
        first = np.where(turning, -half + 1j * np.abs(root), squares[number] / (-half - root))
    second = np.where(turning, first.conj(), -half - root)
    found = []
    for own, other, chosen in ((first, second, np.full(len(number), True)), (second, first, ~turning)):
        at = np.flatnonzero(chosen)
        share, mode = np.where(turning, 2.0, weight)[at] / (own - other)[at], number[at]
        found.append((own[at], share[:, None] * inputs[mode], mode, share * (rate[mode] - other[at] * eta[mode])))
    return States(*(np.concatenate(part) for part in zip(*found, strict=True)))


def _told_apart(squares: np.ndarray, damping: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(mode, c/2, weight) of each motion that is followed: of a mode whose two λ are one, or nearly so, those of four
    complex ζ about its own, whose mean it is but for the fourth power of their distance; conjugate ones once."""
    omega = np.sqrt(np.maximum(squares, 0.0))
    near = np.flatnonzero((squares > 0) & (np.abs(damping / 2 - omega) < ALIKE * omega))
    apart = np.setdiff1d(np.arange(len(squares)), near)
    about = (damping[near] / 2)[:, None] + omega[near][:, None] * AROUND * np.exp(1j * np.pi * np.array([0.25, 0.75]))
    number = np.concatenate([apart, near, near])
    half = np.concatenate([damping[apart] / 2 + 0j, about[:, 0], about[:, 1]])
    order = np.argsort(number, kind="stable")
    return number[order], half[order], np.where(half.imag, 0.5, 1.0)[order]


def strokes(segment: "Segment", channels: int) -> list[Stroke]:
    """The waves of a segment on the first channels, of one form together."""
    found: dict[tuple[complex, int], np.ndarray] = {}
    for wave in segment.waves:
        if wave.channel < channels and wave.coefficient:
            force = found.setdefault((complex(wave.exponent), wave.power), np.zeros(channels, complex))
            force[wave.channel] += wave.coefficient
    return [Stroke(s, k, force) for (s, k), force in found.items()]


def halves(stroke: Stroke) -> tuple[tuple[complex, np.ndarray], tuple[complex, np.ndarray]]:
    """(s, F/2) and the conjugate."""
    return (stroke.exponent, stroke.force / 2), (stroke.exponent.conjugate(), stroke.force.conj() / 2)


def parts(states: States, stroke: Stroke) -> Iterator[tuple[complex, np.ndarray, np.ndarray, np.ndarray]]:
    """(s, g (k + 1, states), numbers of states next to s, their a) of both halves of a stroke."""
    for s, force in halves(stroke):
        a, gap = states.inputs @ force, s - states.rates
        close = np.abs(gap) <= NEAR ** (1 / (stroke.power + 1)) * np.maximum(abs(s), np.abs(states.rates))
        gap = np.where(close, 1.0, gap)
        g = np.zeros((stroke.power + 1, len(a)), complex)
        g[stroke.power] = np.where(close, 0.0, a / gap)
        for i in reversed(range(stroke.power)):
            g[i] = -(i + 1) * g[i + 1] / gap
        at = np.flatnonzero(close & (a != 0))
        yield s, g, at, a[at]


def next_to(rate: complex, s: complex, power: int, tau: Any) -> Any:
    """k! E[λ, s…s](τ)."""
    return factorial(power) * differences((rate, *(s,) * (power + 1)), np.atleast_1d(tau))


def followed(states: States, rigid: np.ndarray, begin: np.ndarray, segments: "Sequence[Segment]",
             channels: int) -> list[FreeStretch]:
    """The FreeStretches of segments. rigid: b of the modes that nothing holds, begin: their (η, η̇), (2, modes)."""
    found: list[FreeStretch] = []
    c, at_rest, sizes, lost = states.begin.copy(), begin.copy(), np.abs(states.begin), 0 * begin
    for segment, after in zip(segments, [*segments[1:], None], strict=True):
        for channel, size in segment.impulses:
            if channel < channels:
                struck, moving = states.inputs[:, channel] * size, rigid[:, channel] * size
                c, sizes = c + struck, sizes + np.abs(struck)
                at_rest, lost = at_rest + np.array([0 * moving, moving]), lost + EPSILON * np.abs(moving)
        given = strokes(segment, channels)
        driven = [g[0] for stroke in given for _, g, _, _ in parts(states, stroke)]
        free = c - sum(driven, 0 * c)
        found.append(FreeStretch(segment.start, given, free, at_rest, sum(map(np.abs, driven), sizes), lost))
        if after is not None:
            tau = after.start - segment.start
            c, sizes = _later(states, given, free, tau)
            end = found[-1], np.array([tau])
            at_rest, lost = (np.array([of(rigid, *end, order)[0] for order in range(2)]) for of in (moved, lost_by))
    return found


def _later(states: States, given: Sequence[Stroke], free: np.ndarray, tau: float) -> tuple[np.ndarray, np.ndarray]:
    """c after a time, and the size of all that it is summed of."""
    c = free * np.exp(states.rates * tau)
    sizes = np.abs(c)
    for stroke in given:
        for s, g, at, a in parts(states, stroke):
            for i, part in enumerate(g):
                driven = np.exp(s * tau) * tau**i * part
                c, sizes = c + driven, sizes + np.abs(driven)
            for j, x in zip(at, a, strict=True):
                driven = x * next_to(states.rates[j], s, stroke.power, tau)[0]
                c[j] += driven
                sizes[j] += abs(driven)
    return c, sizes


def moved(rigid: np.ndarray, stretch: FreeStretch, tau: np.ndarray, order: int) -> np.ndarray:
    """η or η̇ of what nothing holds, (len(tau), modes)."""
    eta, rate = stretch.rigid
    found = eta + np.outer(tau, rate) if order == 0 else np.broadcast_to(rate, (len(tau), len(rate)))
    for stroke in stretch.strokes:
        nodes = (0j,) * (2 - order) + (stroke.exponent,) * (stroke.power + 1)
        curve = factorial(stroke.power) * differences(nodes, tau)
        found = found + np.real(np.outer(curve, rigid @ stroke.force))
    return found


def lost_by(rigid: np.ndarray, stretch: FreeStretch, tau: np.ndarray, order: int) -> np.ndarray:
    """What rounding leaves of the same: of each term, and of the phases of what drives."""
    (eta, rate), (eta_off, rate_off) = np.abs(stretch.rigid), stretch.lost
    sizes, off = (first + np.outer(tau, then) if order == 0 else np.outer(np.ones(len(tau)), then)
                  for first, then in ((eta, rate), (eta_off, rate_off)))
    for stroke in stretch.strokes:
        k, s = stroke.power, stroke.exponent
        curve, turned = np.abs(differences((0j,) * (2 - order) + (s,) * (k + 1), tau)), np.abs(s) * tau
        phase = np.minimum(turned, np.maximum(turned, 1.0) ** (order - 1)) * np.maximum(1.0, np.exp(s.real * tau))
        sizes = sizes + np.outer(factorial(k) * curve + tau ** (k + 2 - order) * phase, np.abs(rigid @ stroke.force))
    return off + 4 * EPSILON * sizes
