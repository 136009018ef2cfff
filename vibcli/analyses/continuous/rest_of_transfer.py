"""What modes far from a load F τᵏ e^{sτ} bring to a motion under it: H(s) without its near modes, R(s), has no pole
nearby, so that its derivatives are means over a circle (Cauchy). What each of the far ones brings is never asked, nor
therefore how well their shapes are known.
"""

from math import comb, factorial
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.disturbances import left_to_creep
from vibcli.analyses.continuous.modal_reads import key_of
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.continuous.complex_modes import ComplexModes
    from vibcli.analyses.continuous.coupled_modes import TiedModes
    from vibcli.analyses.continuous.coupled_transfer import CoupledTransfer
    from vibcli.analyses.continuous.damped_transfer import DampedTransfer
    from vibcli.analyses.continuous.exact_transfer import ExactTransfer
    from vibcli.analyses.continuous.modal_reads import Read
    from vibcli.analyses.continuous.modal_states import Stroke
    from vibcli.analyses.continuous.real_modes import RealModes

POINTS, INSIDE = 24, 8.0        # of the circle, and how far inside the poles that are left it lies
NEAR, LOW = 0.3, 32     # of |λ|: how near to s a mode is near; the slowest are near in any case
NONE = 8                # of the last powers of the circle, which R has not: they show what rounds
SURE = 4.0              # times what these show
POLES = 1e3             # times what rounds, of poles
EPSILON = 2.0**-52


class TooSlow(PhysicsError):
    """More modes are needed."""


class RestOfTransfer:
    """Of RealModes, ComplexModes or TiedModes and what is beyond them, of what a transfer knows exactly."""

    def __init__(self, modes: "RealModes | ComplexModes | TiedModes",
                 transfer: "ExactTransfer | DampedTransfer | CoupledTransfer") -> None:
        self.modes, self.transfer, self.states = modes, transfer, modes.states
        self._taylor: dict[Any, np.ndarray] = {}
        self._near: dict[complex, np.ndarray] = {}
        self._reach = NEAR * np.abs(self.states.rates)

    def near(self, s: complex) -> np.ndarray:
        """Which states are near e^{st}, (states,)."""
        if s not in self._near:
            self._near[s] = (self._apart(s) <= self._reach) | (self.states.modes < LOW)
        return self._near[s]

    def _apart(self, s: complex) -> np.ndarray:
        """How far the λ of each state, or its conjugate, is from s."""
        rates = self.states.rates
        return np.minimum(np.abs(s - rates), np.abs(s - rates.conj()))

    def of_powers(self, read: "Read", stroke: "Stroke") -> tuple[np.ndarray, np.ndarray]:
        """What they bring to each power of the time under a stroke, and how far rounding puts it off, (power + 1,)."""
        k = stroke.power
        taylor, lost = self._remaining(read, stroke.exponent, k)
        found, off = (np.array([comb(k, i) * factorial(k - i) * part[k - i] for i in range(k + 1)])
                      for part in (taylor @ stroke.force, lost @ np.abs(stroke.force)))
        return found, np.abs(off)

    def _remaining(self, read: "Read", s: complex, power: int) -> np.ndarray:
        """(2, power + 1, channels): the coefficients of Taylor's series of R about s, and what rounding leaves of
        them."""
        key = (key_of(read.output), read.order, s)
        if key not in self._taylor or self._taylor[key].shape[1] <= power:
            wide, close = self._radius(s, self.near(s)), self._radius(s, self._apart(s) <= self._reach)
            if not wide:
                return self._among_creeping(read, s, power)
            found, told = self._on_circle(read, s, power, wide)
            if told and 0 < close < wide:
                other, told = self._on_circle(read, s, power, close)
                found = other if other[1, 0].max() < found[1, 0].max() else found
            self._taylor[key] = found
        return self._taylor[key][:, :power + 1]

    def _on_circle(self, read: "Read", s: complex, power: int, radius: float) -> tuple[np.ndarray, bool]:
        """(the coefficients, does R show poles within? as where near modes that are critically damped stand for double
        poles)."""
        turn = np.exp(2j * np.pi * (np.arange(POINTS) + 0.5) / POINTS)
        left, near = self._left(read, s + radius * turn, self.near(s)), self._inside(read, s + radius * turn)
        powers = [(left * turn**-m).mean(axis=1) for m in range(power + 5)]
        none = [(left * turn**m).mean(axis=1) for m in range(1, NONE + 1)]
        rounds = 16 * EPSILON * (np.abs(left) + near).mean(axis=1)
        shown = SURE * np.sqrt(np.mean(np.abs(none)**2, axis=0))
        found = np.array([[part / radius**m for m, part in enumerate(own)]
                          for own in (powers, [rounds + shown] * len(powers))])
        return found, bool((shown > POLES * rounds).any())

    def _radius(self, s: complex, near: np.ndarray) -> float:
        """That of a circle about s well inside all poles but the near ones; 0 where there is none."""
        highest, slowest = self.modes.left_out
        if not highest - abs(s) > highest / 4:
            raise _too_slow(s)
        far = self._apart(s)[~near]
        beyond = abs(s + slowest if s.real > -slowest else s.imag)
        return min(highest - abs(s), beyond, float(far.min(initial=np.inf))) / INSIDE

    def _among_creeping(self, read: "Read", s: complex, power: int) -> np.ndarray:
        """The same where no circle about s is free of eigenvalues: of a steady load alone."""
        if s or power or read.rigid.size or not self.states.rates.all():
            raise left_to_creep()
        left = self._left(read, np.zeros(1, complex), self.near(s)).T
        return np.array([left, 16 * EPSILON * np.abs(left)])

    def _left(self, read: "Read", s: np.ndarray, near: np.ndarray) -> np.ndarray:
        """R at points, (channels, points)."""
        exact: np.ndarray = self.transfer.at(read.output, s) * s**read.order
        for sign in (1, -1):
            weight, rates, inputs = (part[near] if sign > 0 else part[near].conj()
                                     for part in (read.states, self.states.rates, self.states.inputs))
            exact = exact - ((weight / (s[:, None] - rates)) @ inputs).T / 2
        for order in range(2 if read.rigid.size else 0):
            exact = exact - np.outer(read.rigid[order] @ self.modes.rigid_inputs, s ** (order - 2.0))
        return exact

    def _inside(self, read: "Read", s: np.ndarray) -> float:
        """What is read at both ends of short pieces of beams, beside which it may be small inside: its size there."""
        pieces, basis, found = self.transfer.pieces, self.modes.basis, 0.0
        for place, factor in read.output.places.items():
            if any(part.bends is not None for part in basis.parts[place.piece]):
                for x in (0.0, float(pieces[place.piece].piece.length)):
                    one = LinearOutput(0.0, {}, {}, {}, {}, {place._replace(x=x): factor})
                    found = found + np.abs(self.transfer.at(one, s) * s**read.order)
        return found


def _too_slow(s: complex) -> TooSlow:
    if complex(s).imag:
        return TooSlow(f"a load turns with {abs(s):.4g} rad/s, as fast as the modes that are counted",
                       "ask for steady(…), or let it turn more slowly")
    return TooSlow(f"a load grows or dies out at {abs(s):.4g} 1/s, as fast as the modes that are counted",
                   "let it do so more slowly, or take a step or a blow for it")
