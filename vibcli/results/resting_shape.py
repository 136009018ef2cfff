"""The shape in which a piece of a member rests, and fields counted from it."""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.excitation.forcing import Forcing, Wave

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.excitation.forcing import Segment
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.factored_system import PlacedPiece

CHECKED, SAME = 0.2, 1e-9       # where on a piece a polynomial is checked, relative to its length, and how closely
ROUNDING = 1e-12                # of what is subtracted: no difference


def polynomial_at_rest(configuration: "Configuration", piece: "PlacedPiece", degree: int) -> np.ndarray | None:
    """u of a piece in the equilibrium of a Configuration as coefficients of powers of the place along it; None where it
    is no polynomial of this degree."""
    from vibcli.mechanics.rest_curves import value_at_rest

    scene, start, length = configuration.scene.resting, float(piece.start), float(piece.piece.length)
    signal, shares = scene.members[piece.owner].signal_stem, np.linspace(0.0, 1.0, degree + 1)
    *values, other = (value_at_rest(configuration, f"{signal}({start + share * length!r} m)")
                      for share in (*shares.tolist(), CHECKED))
    powers = np.linalg.solve(np.vander(shares, increasing=True), values)
    if abs(np.polynomial.polynomial.polyval(CHECKED, powers) - other) > SAME * max(map(abs, values)):
        return None
    small = np.abs(powers) <= ROUNDING * np.abs(powers).max()
    return np.where(small, 0.0, powers) / length ** np.arange(degree + 1)


def with_polynomials(field: Forcing, channel: int, added: "Sequence[np.ndarray]", length: float) -> Forcing:
    """A field over a piece, and polynomials of the place added on a channel; powers are left out in which they cancel
    it, or each other, to rounding. What does not cancel stands side by side, to tell what it is rounded from."""
    segments = field.segments(length)
    ends = [*(one.start for one in segments[1:]), length]
    return Forcing(field.channels, [_added(one, channel, added, end - one.start)
                                    for one, end in zip(segments, ends, strict=True)])


def _added(segment: "Segment", channel: int, added: "Sequence[np.ndarray]", length: float) -> "Segment":
    moved = [np.polynomial.Polynomial(powers)(np.polynomial.Polynomial([segment.start, 1.0])).coef for powers in added]
    waves = [*segment.waves, *(Wave(channel, c, k, 0j) for powers in moved for k, c in enumerate(powers.tolist()) if c)]
    powered = [wave for wave in waves if wave.channel == channel and not wave.exponent]
    size = max((abs(c) * length**k for powers in moved for k, c in enumerate(powers.tolist())), default=0.0)
    gone = {k for k in {wave.power for wave in powered} if abs(sum(
        wave.coefficient for wave in powered if wave.power == k).real) * length**k <= ROUNDING * size}
    return segment._replace(waves=tuple(
        wave for wave in waves if wave.channel != channel or wave.exponent or wave.power not in gone))
