"""Outputs of a motion under loads that are straight lines, its blocks having one eigenvalue each: all blocks at once.

    c(τ) = e^{λτ} c + E[λ, 0](τ) W f + E[λ, 0, 0](τ) W ḟ,   E[λ, 0] = τ φ₁(λτ),   E[λ, 0, 0] = τ² φ₂(λτ)

with φ₁(z) = (eᶻ − 1)/z = 1 + z φ₂(z) and φ₂(z) = Σ zᵏ/(k + 2)!, a series where z is small.
"""

import math
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.transient.markov_parameters import direct, markov
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.pieces import Pieces

EPSILON, NEAR, TERMS, LOST = 2.0**-52, 2.0, 40, 1e-18


def is_straight(pieces: "Pieces") -> bool:
    """Are the loads straight lines, and has each block one eigenvalue?"""
    return not any(waves.exponent or waves.power > 1 for waves in pieces.timeline.waves) and all(
        len(block.B) == 1 for block in pieces.motion.blocks)


class StraightSum:
    """The order-th derivative of an output on segments: what ExponentialSum is of others."""

    def __init__(self, pieces: "Pieces", output: "LinearOutput", order: int) -> None:
        motion, count = pieces.motion, len(pieces.timeline.starts)
        rows = [block.rows(output, order)[0] for block in motion.blocks]
        held = [(block, c, row) for block, c, row in zip(motion.blocks, pieces.states, rows, strict=True) if row]
        self.exponents = np.array([block.B[0, 0] for block, _, _ in held], complex)
        W = np.array([row * block.W[0] for block, _, row in held], complex).reshape(len(held), len(motion.M))
        self.parts = np.zeros((3, len(held), count), complex)
        self.parts[0] = np.array([row * c[:, 0] for _, c, row in held]).reshape(len(held), count)
        self.lines = np.zeros((2, count))
        if output.constant and motion.constants and not order:
            self.lines[0] += output.constant
        driven = output.a or output.channels or (order and output.v) or order > 1 or motion.system is not None
        rates = direct(output, order, markov(motion, order + 2), motion.forcing.channels) if driven else {}
        for waves in pieces.timeline.waves:
            self.parts[1 + waves.power] += waves.through(W).T
            for i, row in rates.items():
                for power, factor in waves.derivative(i).items():
                    self.lines[power] += factor * waves.onto(row)

    def nodes(self) -> list[tuple[complex, ...]]:
        """The nodes of each exponential in the sum."""
        return [(node, *(0j,) * k) for node in self.exponents.tolist() for k in range(3)]

    def at(self, segment: np.ndarray, tau: np.ndarray) -> np.ndarray:
        """The values at the times `tau` after the starts of the segments."""
        with np.errstate(all="ignore"):
            y: np.ndarray = np.einsum("kit,kit->t", self.parts[:, :, segment], shapes(self.exponents, tau)).real
            y += self.lines[0, segment] + self.lines[1, segment] * tau
        if not np.isfinite(y).all():
            raise PhysicsError("the motion grows beyond the range of floating-point numbers",
                               hint="ask for an earlier time: the system is unstable")
        return y

    def bound(self, segment: np.ndarray, early: np.ndarray, late: np.ndarray) -> np.ndarray:
        """Upper bounds of the magnitude on the intervals early <= τ <= late of the segments."""
        rate, size = self.exponents.real[:, None], np.abs(self.exponents)[:, None]
        with np.errstate(all="ignore"):
            free, top = np.exp(np.maximum(rate * early, rate * late)), np.exp(np.maximum(rate * late, 0.0))
            first = np.fmin(top * late, (top + 1) / size)
            second = np.fmin(top * late**2 / 2, (first + late) / size)
            found = np.einsum("kit,kit->t", np.abs(self.parts[:, :, segment]), np.stack([free, first, second]))
            found += np.abs(self.lines[0, segment]) + np.abs(self.lines[1, segment]) * late
            own, lines, lost = (part[:, segment] for part in self._settled)
            other = np.einsum("it,it->t", own, free) + lines[0] + lines[1] * late + lost[0] + lost[1] * late
        result: np.ndarray = np.fmin(found, other)
        return result

    @cached_property
    def _settled(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(sizes of what is free beside what follows the loads, which is a line; that line; what it loses by
        rounding)."""
        node = self.exponents[:, None]
        own, force, rate = self.parts
        follows = np.stack([force / node + rate / node**2, rate / node])
        lines = np.abs(self.lines - follows.sum(axis=1).real)
        lost = len(node) * EPSILON * (np.abs(self.lines) + np.abs(follows).sum(axis=1))
        return np.abs(own + follows[0]), lines, lost


def shapes(exponents: np.ndarray, tau: np.ndarray) -> np.ndarray:
    """E[λ], E[λ, 0], E[λ, 0, 0] at times: (3, exponents, times)."""
    z = np.multiply.outer(exponents, tau)
    size = np.abs(z)
    far, reach = size > NEAR, min(NEAR, float(size.max(initial=0.0)))
    grown, second = np.exp(z), np.zeros_like(z)
    for k in reversed(range(next(k for k in range(1, TERMS) if reach**k < LOST * math.factorial(k)))):
        second *= z
        second += 1 / math.factorial(k + 2)
    first, second = tau * (1 + z * second), tau**2 * second
    if far.any():
        node, time = (np.broadcast_to(part, z.shape)[far] for part in (exponents[:, None], tau))
        first[far] = (grown[far] - 1) / node
        second[far] = (first[far] - time) / node
    return np.stack([grown, first, second])
