"""How modes that are not counted are damped: E = √(η² + η̇²/ω²) of one that nothing drives never grows."""

from math import inf, sqrt

import numpy as np

from vibcli.base.named_tuple import NamedTuple

FADING = 0.9        # ratio up to which E falls by √((1 + ζ)/(1 − ζ)) e^{−ζωt} at least
CREEPING = 1.25     # ratio from which on it creeps
SLOWER = 2.0        # times e^{−rt/2} it falls at least, whatever ζ, r being the slower rate


class Damping(NamedTuple):
    """Of modes that are not counted: 2ζ, no ω smaller than `highest`, E ≤ `grown` e^{−`fading` t} of its start;
    `creeping`: ζ grows with ω, and 2ζ/ω is at most that instead, inf where it has no bound; `even`: ζ, where all
    have the same."""

    double: float
    highest: float
    grown: float
    fading: float
    creeping: float | None = None
    even: float = 0.0

    def terms(self, count: int) -> np.ndarray:
        """Of |Δf⁽ᵐ⁾|/ωᵐ, or where they creep of |Δf⁽ᵐ⁾|/`unit`ᵐ, in E ω²/|b|."""
        if self.creeping == inf:
            return np.ones(count)
        share = self.unit / self.highest
        step = self._double_at_most * share
        u = [1.0, step]
        while len(u) < count:
            u.append(step * u[-1] + share**2 * u[-2])
        return np.array([u[m] + (share * u[m - 1] if m else 0.0) for m in range(count)])

    @property
    def unit(self) -> float:
        """Of the derivatives of loads: `highest`, or where they creep the rate at which they do."""
        creeps = self.creeping is not None and self.creeping < inf
        return self.highest / max(self._double_at_most, 1.0) if creeps else self.highest

    @property
    def _double_at_most(self) -> float:
        return self.double if self.creeping is None else self.creeping * self.highest

    def reach(self, s: float) -> float:
        """x (2ζ + x)."""
        x = s / self.highest
        return x * (x + self._double_at_most)


def damping_of(squares: np.ndarray, rates: np.ndarray) -> Damping:
    """Beyond modes with ω² = squares and 2ζω = rates."""
    omega = np.sqrt(np.abs(squares))
    highest, half = float(omega[-1]), len(omega) // 2
    double = rates[half:] / omega[half:]
    last = float(double[-1])
    slowest = float(rates[half:].min()) / 2
    if last > (1 + 1e-9) * float(double.min()):
        creeping, zeta = last / highest, last / 2
        if zeta > CREEPING:     # E coth θ/2, cosh θ = ζ, of a slower rate ω² over 2ζω at least
            return Damping(0.0, highest, sqrt((zeta + 1) / (zeta - 1)), 1 / creeping, creeping)
        return Damping(0.0, highest, SLOWER, min(slowest, 1 / creeping) / 2, creeping)
    zeta = float(double.max()) / 2
    if zeta < FADING:
        even = zeta if 2 * zeta <= (1 + 1e-9) * float(double.min()) else 0.0
        return Damping(2 * zeta, highest, sqrt((1 + zeta) / (1 - zeta)), slowest, even=even * (1 - 1e-9))
    return Damping(2 * zeta, highest, SLOWER, min(slowest, highest / (2 * zeta)) / 2)
