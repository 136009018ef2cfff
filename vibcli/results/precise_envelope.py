"""The envelope of one vibration or of two at the working precision: |Σ a e^{λt}|, Re(a e^{λt}) being the vibrations."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from mpmath import mp

from vibcli.base.errors import PhysicsError
from vibcli.results.precise_features import NEAR, eigenvalue, harmonics, residue
from vibcli.results.precise_signals import PreciseLinear

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.transient.textbook_form import Part


class PreciseEnvelope:
    """Of a signal, whose vibrations the floats find as Parts."""

    def __init__(self, signal: PreciseLinear, parts: "Sequence[Part]") -> None:
        self.waves = [_kept_up(signal, part) if part.forced else (residue(signal, part), eigenvalue(signal, part))
                      for part in parts]

    def at(self, time: "mpmath.mpf", before: bool = False) -> "EnvelopeInstant":
        """What is known of it at a time."""
        return EnvelopeInstant(self.waves, time)

    def breaks(self, until: float) -> "list[mpmath.mpf]":
        """None."""
        return []


def _kept_up(signal: PreciseLinear, part: "Part") -> "tuple[mpmath.mpc, mpmath.mpc]":
    """(a, λ) of a vibration that a load keeps up."""
    near = [(X, mp.mpc(0, speed)) for speed, X in harmonics(signal) if abs(speed - part.omega) <= NEAR * part.omega]
    if len(near) != 1:
        raise PhysicsError("more digits of this envelope are not found", "leave --digits out")
    return near[0]


class EnvelopeInstant:
    """A PreciseEnvelope at an instant."""

    def __init__(self, waves: "Sequence[tuple[mpmath.mpc, mpmath.mpc]]", time: "mpmath.mpf") -> None:
        self.waves, self.time = waves, time

    def read(self, highest: int, by: "mpmath.mpf | int" = 0) -> "list[mpmath.mpf]":
        """It and its derivatives, a little later: of r = |w| they are Re(w̄ w′)/r and (|w′|² + Re(w̄ w″) − r′²)/r."""
        terms = [(a * mp.exp(rate * (self.time + by)), rate) for a, rate in self.waves]
        w, first, second = (mp.fsum(term * rate**order for term, rate in terms) for order in range(3))
        size = abs(w)
        if not highest or not size:
            return [size] * (highest + 1) if not size else [size]
        slope = mp.re(mp.conj(w) * first) / size
        bend = (abs(first) ** 2 + mp.re(mp.conj(w) * second) - slope**2) / size
        return [size, slope, bend][:highest + 1]
