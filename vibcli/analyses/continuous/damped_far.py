"""Damped modes of members far up, by their number, without those before them.

The argument principle counts N(R) eigenvalues with |λ| < R, conjugates counted. Of those between a small circle within
which all are known and R the ones that are real lie in two sectors about the real axis, which are counted alike; all
others are half as many modes. Between two such circles about those that are wanted all are found by Newton's method.
"""

from itertools import pairwise
from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.analyses.continuous.argument_count import fades, zeros_aside, zeros_within
from vibcli.analyses.continuous.damped_estimates import half_turns, inner_estimates, where_waves_turn
from vibcli.analyses.continuous.damped_series import SECTIONS
from vibcli.analyses.continuous.newton_of_members import Divisions, approached, distinct, polished
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.held_count import held_count

if TYPE_CHECKING:
    from vibcli.analyses.continuous.damped_source import Region
    from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix

EFFORTS = 1, 2, 4               # times as many estimates, in turn
DECAYS = 0.0, 0.15, 0.5, 1.2    # of the distance of frequencies: Re λ of estimates
BESIDE = 4                      # half turns of the waves beyond those that are wanted
BESIDE_HELD = np.outer([0.04, 0.004], [1, 1j, -1, -1j]).ravel()     # of the distance of frequencies
MOVES = 8                       # times that the range is moved or made wider
ASIDE = np.pi / 4, 0.4, 0.2     # angles from the real axis
GAPS = 6                        # between roots that are tried in turn for a circle
RAY = 200                       # estimates of real roots
SURE = 1e-3                     # relative bound of a root that is told
ALIKE = 1e-9                    # relative distance of roots between which no circle is laid


class Annulus(NamedTuple):
    """inner < |λ| < radius holds the roots of the modes with an index from first on, by |λ|, each as often as it is
    one; below, count: how many |λ| < inner and |λ| < radius are counted, conjugates too."""

    inner: float
    radius: float
    below: int
    count: int      # type: ignore[assignment]
    first: int
    roots: np.ndarray

    @property
    def last(self) -> int:
        """The index of the last one."""
        return self.first + len(self.roots) - 1


class FarModes:
    """low: what is known within a circle."""

    def __init__(self, matrix: "DynamicMatrix", low: "Region") -> None:
        self.matrix, self.low, self._divisions = matrix, low, Divisions(matrix)
        self._inner, self._real = self._divisions.inner, {}

    def numbered(self, first: int, last: int) -> Annulus:
        """The Annulus of at least those with an index from first to last."""
        begin, end = float(first), float(last)
        for _ in range(MOVES):
            found = self._between(max(begin - BESIDE, 0.0), end + BESIDE)
            early, late = first - found.first, found.last - last
            if early >= 0 and late >= 0:
                return found
            begin, end = begin + min(early - 1, 0), end - min(late - 1, 0)
            if early > 4 * BESIDE + last - first:
                begin += early - 2 * BESIDE
            if late > 4 * BESIDE + last - first:
                end -= late - 2 * BESIDE
        raise _uncertain(found.radius)

    def about(self, size: float) -> Annulus:
        """An Annulus that holds a |λ|."""
        turns = float(half_turns(self.matrix.pieces, size))
        for wider in range(1, MOVES):
            found = self._between(max(turns - wider * BESIDE, 0.0), turns + wider * BESIDE)
            if found.inner < size < found.radius:
                return found
        raise _uncertain(size)

    def _between(self, begin: float, end: float) -> Annulus:
        """The Annulus of roots with about so many half turns of the waves between them."""
        most = float(where_waves_turn(self.matrix.pieces, np.array([np.pi * end]))[0])
        if fades(self.matrix, most):
            raise _uncertain(most)
        for effort in EFFORTS:
            values, errors = self._roots(begin, end, effort)
            if float(where_waves_turn(self.matrix.pieces, np.array([np.pi * begin]))[0]) > self.low.radius:
                inner, below = self._circle(values[:GAPS + 1], 1)
            else:
                inner, below = self.low.radius, self.low.count
            outer, within = self._circle(values[-GAPS - 1:], -1)
            if inner is None or outer is None or outer <= inner:
                continue
            inside = (abs(values) > inner) & (abs(values) < outer)
            roots = values[inside]
            if within - below == np.where(roots.imag > 0, 2, 1).sum():
                if not (errors[inside] < SURE).all():
                    raise _uncertain(outer)
                return Annulus(inner, outer, below, within, self._before(inner, below) + 1, roots)
        raise _uncertain(most)

    def _roots(self, begin: float, end: float, effort: int) -> tuple[np.ndarray, np.ndarray]:
        """Polished ones beyond the small circle: values by size, and their bounds."""
        least, pieces = self.low.radius, self.matrix.pieces
        turns = np.arange(begin, end, 0.5 / effort)
        line = where_waves_turn(pieces, np.pi * np.append(turns, end + 1))
        apart = np.gradient(line) * 2 * effort
        line, apart = line[:-1], apart[:-1]
        most = float(line[-1])
        rows = [1j * line - share * apart for share in DECAYS]
        rays = np.geomspace(max(0.9 * float(line[0]), 0.9 * least), max(most, least), 4 * effort)
        starts = np.concatenate([*rows, *(-rays * np.exp(-1j * turn) for turn in (0.0, 0.3, 0.8))])
        within = inner_estimates(pieces, max(float(line[0]), least), most)
        if effort > 1:      # where several pieces vibrate alike, roots lie beside the one with all their ends at rest
            within = np.concatenate([within, *(within + part * apart.mean() for part in BESIDE_HELD)])
        found = np.concatenate([approached(self._divisions, starts[abs(starts) > 0.8 * least]),
                                approached(self._inner, within)])
        found = distinct(found[(abs(found) > max(float(line[0]), least)) & (abs(found) < most)])
        values, errors, _ = polished(self._divisions, found) if len(found) else (found, abs(found), [])
        return values, errors

    def _circle(self, roots: np.ndarray, way: int) -> tuple[float, int]:
        """A radius between neighbours, from the first on (way 1) or from the last, and how many lie within it."""
        sizes = abs(roots)[::way]
        for one, other in pairwise(sizes):
            for share in SECTIONS if abs(other - one) > ALIKE * one else ():
                radius = float(f"{one + share * (other - one):.8g}")
                count = zeros_within(self.matrix, radius)
                if count is not None:
                    return radius, count
        return None, None

    def _before(self, radius: float, count: int) -> int:
        """How many modes have |λ| < radius, within which so many eigenvalues are."""
        beyond, real = count - self.low.count, self._aside(radius)
        return len(self.low.modes) + real + (beyond - real) // 2

    def _aside(self, radius: float) -> int:
        """How many real λ there are beyond the small circle within this one."""
        if radius == self.low.radius:
            return 0
        if radius not in self._real:
            if not self._swings():
                raise _uncertain(radius)
            self._real[radius] = sum(self._on_axis(radius, sign) for sign in (-1, 1))
        return cast("int", self._real[radius])

    def _swings(self) -> bool:
        """Do pieces with their ends held all swing, beyond the small circle, near the imaginary axis?"""
        radius = self.low.radius
        for stack in self.matrix.stacks:
            mu, c, k = stack.piece.inertia, abs(stack.piece.drag), stack.piece.foundation
            if (radius * mu < 2 * c).any() or held_count(stack.piece._replace(
                    foundation=k + (mu * radius - c) * radius), 0).any():
                return False
        return True

    def _on_axis(self, radius: float, sign: int) -> int:
        """How many of them are positive, or negative."""
        for angle in ASIDE:
            count = zeros_aside(self.matrix, self.low.radius, radius, angle, sign)
            if count == 0:
                return 0
            if count is None:
                continue
            ray = sign * np.geomspace(self.low.radius, radius, RAY)
            found = distinct(approached(self._divisions, np.concatenate([ray, *(
                ray * np.exp(1j * sign * part * angle) for part in (0.2, 0.6))]) + 0j))
            size = abs(found)
            found = found[(size > self.low.radius) & (size < radius) & (sign * found.real > size * np.cos(angle))]
            values, errors, _ = polished(self._divisions, found)
            if np.where(values.imag > 0, 2, 1).sum() == count and (errors < SURE).all():
                return int((values.imag == 0).sum())
        raise _uncertain(radius)


def _uncertain(radius: float) -> PhysicsError:
    return PhysicsError(f"the number of damped modes with |λ| < {radius:.4g} 1/s is not certain",
                        "modes may be too near one another, or a damper near √(Nμ) swallow nearly all waves; ask for "
                        "lower modes, or for frequency responses")
