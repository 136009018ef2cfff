"""Damped modes of members that `damping:` damps: λ² + c λ + ω² = 0 of each mode without dampers, in its shape."""

from typing import TYPE_CHECKING, Any, cast

from vibcli.analyses.modal.damped_modes import DampedMode

if TYPE_CHECKING:
    import mpmath
    import numpy as np

    from vibcli.analyses.continuous.member_damping import MemberDamping
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.analyses.modal.undamped import Mode

ROUNDINGS = 8       # units in which λ, of ω and c, is not sharper
UNIT = 2.0**-53


class RatedModes:
    """What `Modes` asks for the damped modes of a MemberDamping; natural: the modes without it; digits: those that it
    has, as numbers of mpmath. They have the numbers of these, two eigenvalues of one mode its own."""

    def __init__(self, natural: "Modes", damping: "MemberDamping", digits: int | None = None) -> None:
        self._natural, self._damping = natural, damping
        self._unit = UNIT if digits is None else 10.0**-digits

    def numbered(self, first: int, last: int) -> list[DampedMode]:
        """Those of the modes with an index from first to last."""
        return [one for mode in self._natural.numbered(first, last) for one in self._of(mode)]

    def proof(self, first: int, last: int) -> None:
        """None: that none is missing is told of the modes that they are of."""

    def count(self, Omega: float) -> int:
        """How many modes have ω ≤ Omega, the rigid ones among them."""
        return len(self._natural.up_to(Omega))

    def _of(self, mode: "Mode") -> list[DampedMode]:
        """One eigenvalue, with Im λ > 0, or two real ones."""
        c, omega, shape = self._damping.rate(mode), mode.omega, mode.shape + 0j
        if not omega:
            return self._not_held(mode, c, shape)
        zeta, square = c / (2 * omega), omega**2
        inner = (1 - zeta) * (1 + zeta)
        error = self._error(float(mode.error), abs(float(inner))) * self._damping.spread(mode)
        if inner > 0:
            return [DampedMode(mode.index, _complex(-c / 2, omega * inner**0.5), omega, zeta, shape, error)]
        fast = -(c / 2 + omega * (-inner)**0.5)
        return [DampedMode(mode.index, _complex(value, 0 * c), omega, zeta, shape, error, None, c / 2)
                for value in (square / fast, fast)]

    def _not_held(self, mode: "Mode", c: float, shape: "np.ndarray") -> list[DampedMode]:
        """λ = 0 and −c of a rigid motion; λ² + c λ = g² of what grows."""
        g, error = mode.growth_rate, self._error(float(mode.error), 1.0) * self._damping.spread(mode)
        if g is None:
            rigid = DampedMode(mode.index, 0 * c, 0 * c, None, shape, 0.0, "rigid motion: λ = 0")
            return [rigid, *([_alone(mode, -c, shape, error)] if c else [])]
        fast = c / 2 + (c**2 / 4 + g**2)**0.5
        return [_alone(mode, g**2 / fast, shape, error), _alone(mode, -fast, shape, error)]

    def _error(self, known: float, inner: float) -> float:
        """Of |δλ|/|λ|: that of ω, and what rounding of ζ makes of √|1 − ζ²|."""
        rounded = ROUNDINGS * self._unit + 2 * known
        return cast("float", rounded / max(min(1.0, inner), rounded)**0.5)


def _alone(mode: "Mode", value: float, shape: "np.ndarray", error: float) -> DampedMode:
    """A real eigenvalue that is not one of two of an over-damped mode."""
    return DampedMode(mode.index, _complex(value, 0 * value), abs(value), None, shape, error)


def _complex(re: Any, im: Any) -> Any:
    return complex(re, im) if isinstance(re, float) else _precise(re, im)


def _precise(re: "mpmath.mpf", im: "mpmath.mpf") -> "mpmath.mpc":
    import mpmath

    return mpmath.mpc(re, im)
