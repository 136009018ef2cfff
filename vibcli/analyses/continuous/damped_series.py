"""Many damped modes of members at a time: all λ within a circle, as many as the argument principle counts there.

The first are those of the DampedModes; to all others Newton's steps lead at once from many places.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.argument_count import sizes
from vibcli.analyses.continuous.damped_estimates import where_waves_turn
from vibcli.analyses.continuous.newton_of_members import ALIKE, ShapesOf
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.coincident_roots import CoincidentRoots
    from vibcli.analyses.continuous.damped_parts import DampedPart, StillPart
    from vibcli.analyses.continuous.damped_source import Region
    from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix

SURE = 1e-3             # relative bound of a root that is told
EFFORTS = 1, 2, 4       # times as many estimates, in turn
MANY = 4_096            # roots for which more than the first of these takes too long
SECTIONS = 0.5, 0.31, 0.72      # of a gap between roots
FAR, SWALLOWED = 1e8, 1e-6      # times a frequency; of a wave, what no longer comes back
GAPS = 6                # between roots that are tried in turn for the circle


class DampedSeries(NamedTuple):
    """What moves with all λ ≠ 0 with Im λ ≥ 0 within |λ| < radius, by |λ|: λ or of those that coincide points about
    them, their relative bounds and shapes; of_parts: these λ of each part; resting: how often 0 is one; of_points: no
    larger |λ| is that of a point."""

    parts: "Sequence[DampedPart | StillPart]"
    radius: float
    of_parts: list[np.ndarray]
    rates: np.ndarray
    errors: np.ndarray
    groups: list[ShapesOf]
    resting: int
    of_points: float


class Known(NamedTuple):
    """All λ ≠ 0 with Im λ ≥ 0 within |λ| < radius, of each part; resting: how often 0 is one."""

    parts: "Sequence[DampedPart | StillPart]"
    radius: float
    of_parts: list[np.ndarray]
    resting: int


class RootsOfPart(NamedTuple):
    """λ by |λ|, their relative bounds and shapes; several: those among them, or beside, that are one or nearly so."""

    values: np.ndarray
    errors: np.ndarray
    groups: list[ShapesOf]
    several: "Sequence[CoincidentRoots]" = ()

    def by_themselves(self) -> np.ndarray:
        """Which are not among several."""
        return ~np.any([one.holds(self.values) for one in self.several], axis=0) if self.several else np.full(
            len(self.values), True)

    def all(self) -> tuple[np.ndarray, np.ndarray]:
        """λ and their bounds, of several their middle as often as they are."""
        own = self.by_themselves()
        middles = np.repeat([one.middle for one in self.several], [one.several for one in self.several])
        return np.append(self.values[own], middles), np.append(self.errors[own], np.zeros(len(middles)))

    def moving(self) -> tuple[np.ndarray, np.ndarray, list[ShapesOf]]:
        """What moves as a mode each: λ, their bounds, and shapes; of several the points about them."""
        own = self.by_themselves()
        place, count = np.where(own, np.cumsum(own) - 1, len(own)), int(own.sum())
        rates, errors = [self.values[own]], [self.errors[own]]
        groups = [group.among(place[group.numbers], count) for group in self.groups]
        for one in self.several:
            groups.append(one.shapes._replace(numbers=one.shapes.numbers + count))
            rates.append(one.points)
            errors.append(one.errors)
            count += len(one.points)
        return np.concatenate(rates), np.concatenate(errors), groups


def within_region(low: "Region") -> Known:
    """Those of a Region."""
    of_parts = [np.array([root.value for root in own], complex) for own in low.roots]
    return Known(low.parts, low.radius, of_parts, low.count - sum(_conjugates(rates) for rates in of_parts))


def _conjugates(rates: np.ndarray) -> int:
    """How many λ these are with their conjugates."""
    return int(np.where(rates.imag > 0, 2, 1).sum())


def zeros_of(parts: "Sequence[DampedPart | StillPart]", radius: float) -> int | None:
    """How many λ all parts have in |λ| < radius; None where that is not certain."""
    found = [part.zeros_within(radius) for part in parts]
    return None if None in found else sum(found)


def damped_series(known: "Known | DampedSeries", count: int) -> DampedSeries:
    """About `count` of them; known: the first of them."""
    pieces = [placed for part in known.parts for placed in part.matrix.pieces]
    top = float(where_waves_turn(pieces, np.array([np.pi * count]))[0])
    for effort in EFFORTS[:1] if count > MANY else EFFORTS:
        own = [part.series(rates, known.radius, top, effort)
               for part, rates in zip(known.parts, known.of_parts, strict=True)]
        values, errors = (np.concatenate(part) for part in zip(*(one.all() for one in own), strict=True))
        order = np.argsort(abs(values), kind="stable")
        values, errors = values[order], errors[order]
        radius = _circle(known.parts, values, min(count, len(values)), known.resting, [
            (abs(found.middle), found.radius) for one in own for found in one.several])
        if radius is not None and (errors[:np.searchsorted(abs(values), radius)] < SURE).all():
            return _within(radius, known, own)
    if not (errors < SURE).all():
        raise PhysicsError("damped modes of members are so nearly one that they are not told apart",
                           "give them a little more or less damping")
    raise PhysicsError("the damped modes of members are not counted so far: some of them may be missing",
                       "ask for steady(…)")


def swallowed(matrix: "DynamicMatrix", pace: float) -> bool:
    """Does a damper as √(Nμ) leave nothing of the waves that come to it, far above a frequency? Then D is singular far
    on the negative real axis."""
    if not matrix.n or not any(placed.piece.order == 2 for placed in matrix.pieces):
        return False
    s = np.array([-FAR * (pace or 1.0)])
    found = matrix.at(s, steep=True)
    units = 1 / np.sqrt(np.maximum(sizes(found, s)[:, 0] + found.given[:, 0], 1e-300))
    D = found.D[:, :, 0] * units[:, None] * units
    return bool(np.linalg.svd(D, compute_uv=False)[-1] < SWALLOWED)


def _circle(parts: "Sequence[DampedPart | StillPart]", roots: np.ndarray, count: int, resting: int,
            barred: "Sequence[tuple[float, float]]") -> float | None:
    """A radius within which there are as many roots as are found, about so many; None where these are others. barred:
    (|λ|, distance) of several that it does not part."""
    sizes = abs(roots)
    certain = resting + np.append(0, np.cumsum(np.where(roots.imag > 0, 2, 1)))
    for low in range(count - 1, max(count - 1 - GAPS, -1), -1):
        high = sizes[low + 1] if low + 1 < len(sizes) else sizes[low] * (1 + 0.5 / len(sizes))
        for share in SECTIONS if high > sizes[low] * (1 + ALIKE) else ():
            radius = float(sizes[low] + share * (high - sizes[low]))
            inside = None if any(abs(radius - size) < far for size, far in barred) else zeros_of(parts, radius)
            if inside is not None:
                return radius if inside == certain[low + 1] else None
    return None


def _within(radius: float, known: DampedSeries | Known, parts: "Sequence[RootsOfPart]") -> DampedSeries:
    """The DampedSeries of those within a radius."""
    moving, kept, first = [one.moving() for one in parts], [], 0
    rates, errors = (np.concatenate([one[k] for one in moving]) for k in range(2))
    order = np.argsort(abs(rates), kind="stable")
    place, count = np.argsort(order), int((abs(rates) < radius).sum())
    for own, _, groups in moving:
        kept += [group.among(place[first:first + len(own)][group.numbers], count) for group in groups]
        first += len(own)
    of_parts = [values[abs(values) < radius] for values, _ in (one.all() for one in parts)]
    points = [size for one in parts for several in one.several for size in abs(several.points) if size < radius]
    return DampedSeries(known.parts, radius, of_parts, rates[order][:count], errors[order][:count], kept,
                        known.resting, max(points, default=0.0))
