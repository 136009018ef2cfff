"""The shape in which a piece of a member rests, and fields counted from it."""

from itertools import islice, pairwise
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.mechanics.rest_curves import ShapeAtRest

CHECKED, SAME = 0.2, 1e-9       # where on a piece a polynomial is checked, relative to its length, and how closely
NEAR, MOST = 1e-12, 16      # of a length: no place of its own; panels that are not few any more
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
    found: np.ndarray | None = np.where(small, 0.0, powers) / length ** np.arange(degree + 1)
    return found


def less_rest(field: Forcing, configuration: "Configuration", piece: "PlacedPiece", degree: int) -> Forcing | None:
    """A field over a piece less u of this in equilibrium: a polynomial of a degree, or one on each of few panels; None
    where it is neither."""
    from vibcli.analyses.transient.time_shift import difference
    from vibcli.mechanics.rest_curves import shape_at_rest

    start, length = float(piece.start), float(piece.piece.length)
    stem = configuration.scene.resting.members[piece.owner].signal_stem
    shape = shape_at_rest(configuration, f"{stem}({start + length / 2!r} m)")
    uneven = len(shape.forms) > 1 and shape.piece.order == piece.piece.order
    powers = None if uneven else polynomial_at_rest(configuration, piece, degree)
    if powers is not None:
        return with_polynomials(field, 0, [-powers], length)
    resting = _on_panels(shape) if shape.bent and shape.piece.order == piece.piece.order else None
    return Forcing(field.channels, difference(field.segments(length), resting, length)) if resting else None


def _on_panels(shape: "ShapeAtRest") -> list[Segment] | None:
    """u of a ShapeAtRest, Segments of polynomials to rounding; None where there are not few."""
    from vibcli.analyses.continuous.smooth_fields import integrated
    from vibcli.mechanics.smooth_forms import powers_between
    from vibcli.symbolic.smooth_panels import NotSmooth, panels

    length, found = float(shape.piece.length), []
    edges = sorted({x for form in shape.forms for one in form.stretches for x in (one.start, one.end)})
    edges = [0.0, *(x for x in edges if NEAR < x / length < 1 - NEAR), length]
    cuts = ((a + (b - a) * float(panel.a), a + (b - a) * float(panel.b)) for a, b in pairwise(edges)
            for panel in panels(lambda x: [shape.highest(x)], (a, b), broken=False))
    try:
        chosen = [] if len(edges) > MOST else list(islice(cuts, MOST))
    except NotSmooth:
        chosen = []
    if not 0 < len(chosen) < MOST:
        return None
    for low, high in chosen:
        given = [float(shape.bent(np.array([(low + high) / 2]), order)[0]) for order in range(shape.piece.order)]
        powers = integrated(given, powers_between(shape.highest, low, high), high - low)
        found.append(Segment(low, tuple(Wave(0, c, k, 0j) for k, c in enumerate(powers) if c)))
    return sorted(found, key=lambda one: one.start)


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
