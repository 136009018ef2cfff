"""What modes left out bring to a motion by modes under loads F τᵏ e^{sτ}: H(s) without its first modes, R(s), has no
pole nearby, so that its derivatives are means over a circle (Cauchy).
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


class TooSlow(PhysicsError):
    """More modes are needed."""


class ModesLeftOut:
    """Beyond RealModes, ComplexModes or TiedModes, of what a transfer knows exactly."""

    def __init__(self, modes: "RealModes | ComplexModes | TiedModes",
                 transfer: "ExactTransfer | DampedTransfer | CoupledTransfer"):
        self.modes, self.transfer, self.states = modes, transfer, modes.states
        self._taylor: dict[Any, np.ndarray] = {}

    def of_powers(self, read: "Read", stroke: "Stroke") -> tuple[np.ndarray, np.ndarray]:
        """What they bring to each power of the time under a stroke, and what it is rounded from, (power + 1,)."""
        k = stroke.power
        taylor, sizes = self._remaining(read, stroke.exponent, k)
        found, size = (np.array([comb(k, i) * factorial(k - i) * part[k - i] for i in range(k + 1)])
                       for part in (taylor @ stroke.force, sizes @ np.abs(stroke.force)))
        return found, np.abs(size)

    def _remaining(self, read, s, power):
        """(2, power + 1, channels): the coefficients of Taylor's series of R about s, and what these are rounded
        from."""
        key = (key_of(read.output), read.order, s)
        if key not in self._taylor or self._taylor[key].shape[1] <= power:
            highest, slowest = self.modes.left_out
            radius = (highest - abs(s)) / INSIDE
            if not radius > highest / (4 * INSIDE):
                raise TooSlow(f"a load turns with {abs(s):.4g} rad/s, as fast as the modes that are counted")
            radius = min(radius, abs(s + slowest if s.real > -slowest else s.imag) / INSIDE)
            if not radius:
                return self._among_creeping(read, s, power)
            turn = np.exp(2j * np.pi * (np.arange(POINTS) + 0.5) / POINTS)
            left = self._left(read, s + radius * turn)
            size = np.abs(left) + self._inside(read, s + radius * turn)
            self._taylor[key] = np.array([[(part * wave**-m).mean(axis=1) / radius**m for m in range(power + 5)]
                                          for part, wave in ((left, turn), (size, 1.0))])
        return self._taylor[key][:, :power + 1]

    def _among_creeping(self, read, s, power):
        """The same where no circle about s is free of eigenvalues: of a steady load alone."""
        if s or power or read.rigid.size or not self.states.rates.all():
            raise left_to_creep()
        left = self._left(read, np.zeros(1, complex)).T
        return np.array([left, np.abs(left)])

    def _left(self, read, s):
        """R at points, (channels, points)."""
        exact = self.transfer.at(read.output, s) * s**read.order
        for sign in (1, -1):
            weight, rates, inputs = (part if sign > 0 else part.conj()
                                     for part in (read.states, self.states.rates, self.states.inputs))
            exact = exact - ((weight / (s[:, None] - rates)) @ inputs).T / 2
        for order in range(2 if read.rigid.size else 0):
            exact = exact - np.outer(read.rigid[order] @ self.modes.rigid_inputs, s ** (order - 2.0))
        return exact

    def _inside(self, read, s):
        """What is read at both ends of short pieces of beams, beside which it may be small inside: its size there."""
        pieces, basis, found = self.transfer.pieces, self.modes.basis, 0.0
        for place, factor in read.output.places.items():
            if any(part.bends is not None for part in basis.parts[place.piece]):
                for x in (0.0, float(pieces[place.piece].piece.length)):
                    one = LinearOutput(0.0, {}, {}, {}, {}, {place._replace(x=x): factor})
                    found = found + np.abs(self.transfer.at(one, s) * s**read.order)
        return found
