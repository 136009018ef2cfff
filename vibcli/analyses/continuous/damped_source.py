"""The damped modes of a scene with continuous members, as they are asked for: by ascending |λ|, none missed.

Estimates are polished to rounding; how many λ there are with |λ| < R is certain by the argument principle. Where as
many are found as there are none is missing, and each is simple or has the multiplicity with which it is listed.
"""

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.argument_count import held_within
from vibcli.analyses.continuous.damped_estimates import half_turns
from vibcli.analyses.continuous.damped_far import FarModes
from vibcli.analyses.continuous.damped_parts import SURE, cleaned, damped_parts
from vibcli.analyses.continuous.damped_roots import DampedRoot, Whole, roots_at
from vibcli.analyses.continuous.damped_series import zeros_of
from vibcli.analyses.continuous.dynamic_matrix import dynamic_matrix
from vibcli.analyses.continuous.newton_of_members import distinct
from vibcli.analyses.modal.damped_modes import DampedMode
from vibcli.analyses.modal.mode_sequence import FEW, NoMoreTold
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.continuous.damped_far import Annulus
    from vibcli.analyses.continuous.damped_parts import DampedPart, StillPart
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.mechanics.factored_system import FactoredSystem

WIDER, TRIES = 1.35, 14     # times by which the circle grows, and how often
EFFORTS = 1, 1.6, 2.5       # more functions within pieces, in turn
RESTING = 1e-5              # of the radius: what is nearer to 0 is looked for there
BELOW = 0.9                 # of 1/β, where damped modes pile up
NEAR, LOW = 60, 6   # modes that are found with all below them; those from which others are counted
OVERLAP = 0.9               # of the known region: beyond that estimates are polished
GAPS = 4                    # that are tried in turn for the circle


class Region(NamedTuple):
    """|λ| < radius holds `count` eigenvalues, conjugates counted, those of rigid motions too; its modes by |λ|, and
    the roots that they are of, those of each part of the scene."""

    radius: float
    count: int      # type: ignore[assignment]
    modes: list[DampedMode]
    below: int = 0  # known without a count
    inner: float = 0.0
    roots: "Sequence[Sequence[DampedRoot]]" = ()
    parts: "Sequence[DampedPart | StillPart]" = ()


class DampedModes:
    """What `Modes` asks for damped modes; natural: what gives those without dampers."""

    def __init__(self, elements: "FactoredSystem", natural: "Callable[[], Modes]") -> None:
        self.matrix, self._natural = dynamic_matrix(elements), natural
        self.whole, self.region = Whole(self.matrix), Region(0.0, 0, [])
        self.annuli: list[Annulus] = []
        self.parts = damped_parts(elements, self.matrix)
        beta = self.matrix.retardation
        self._limit, self._ended = BELOW / beta if beta else np.inf, False
        self._resting = [mode.shape for mode in natural().shown() if mode.rigid]

    @property
    def most_shown(self) -> int:
        """How many are shown unasked: more grow than without dampers only where a damper drives."""
        return len(self._natural().shown()) + FEW

    def numbered(self, first: int, last: int) -> list[DampedMode]:
        """The modes with an index from first to last."""
        if last > NEAR and self._counts_far:
            return self._far_up(first, last)
        try:
            self._reach(lambda sizes: len(sizes) + len(self._resting) >= last, self._start(last))
        except NoMoreTold:
            self._reach_limit()
            if len(self.region.modes) < first:
                raise
        return self.region.modes[first - 1:last]

    def count(self, Omega: float) -> int:
        """How many have |λ| ≤ Omega, the rigid ones among them."""
        if self._counts_far and half_turns(self.matrix.pieces, Omega) > NEAR:
            found = self._far.about(Omega)
            return found.first - 1 + int((abs(found.roots) <= Omega).sum())
        self._reach(lambda sizes: True, 1.02 * Omega, Omega)
        return sum(float(mode.omega) <= Omega for mode in self.region.modes)

    @property
    def _counts_far(self) -> bool:
        """Do waves travel on all pieces, the faster the shorter they are?"""
        return not self.matrix.retardation and all(placed.piece.inertia for placed in self.matrix.pieces)

    @cached_property
    def _far(self) -> FarModes:
        """What finds those far up, from some that are known."""
        self.numbered(1, LOW + len(self._resting))
        fastest = max(abs(float(placed.piece.drag / placed.piece.inertia)) for placed in self.matrix.pieces)
        self._reach(lambda sizes: True, 2.1 * fastest, 2.01 * fastest)
        return FarModes(self.matrix, self.region)

    def _far_up(self, first: int, last: int) -> list[DampedMode]:
        """Those of which the last is beyond many."""
        low = self._far.low.modes
        if first <= len(low):
            return low[first - 1:] + self._far_up(len(low) + 1, last)
        found = self._far.numbered(first, last)
        roots = []
        for s in distinct(found.roots[first - found.first:last - found.first + 1]):
            roots += [cleaned(root, self.matrix) for root in roots_at(self.whole, complex(s))]
        if len(roots) != last - first + 1 or not all(root.error < SURE for root in roots):
            raise _undecided(found.radius)
        self.annuli.append(found)
        return [_mode(i, root) for i, root in enumerate(_by_size(roots), first)]

    def proof(self, first: int, last: int) -> "Region | Annulus | None":
        """What tells that none of the indices from first to last is missing."""
        if last <= len(self.region.modes):
            return self.region
        beyond = max(first, len(self.region.modes) + 1)
        return next((one for one in self.annuli if one.first <= beyond and last <= one.last), None)

    def _start(self, last: int) -> float:
        """A radius in which so many may be: the frequency of the next mode without dampers."""
        oscillating = [mode for mode in self._natural().first(last + 2) if mode.omega]
        return 1.05 * float(oscillating[-1].omega) if oscillating else 2 * self.region.radius

    def _reach(self, enough: Callable[..., bool], radius: float, least: float = 0.0) -> None:
        """Widens the region until its roots are enough."""
        if self.region.radius >= max(least, 1e-300) and enough([1] * (len(self.region.modes) - len(self._resting))):
            return
        if self._ended:
            raise _piled_up(self.matrix.retardation)
        for _ in range(TRIES):
            found = self._search(min(radius, self._limit), enough, least) if least < self._limit else None
            if found is not None:
                self.region = found
                return
            if radius >= self._limit:
                raise _piled_up(self.matrix.retardation)
            radius *= WIDER
        raise _few(radius / WIDER)

    def _reach_limit(self) -> None:
        """Widens the region up to where damped modes pile up, as far as their number is certain."""
        if self._ended:
            return
        roots = [root for own in self._roots(self._limit, EFFORTS[-1]) for root in own if abs(root.value) < self._limit]
        for count in range(len(roots), len(self.region.modes) - len(self._resting), -1):
            try:
                found = self._search(self._limit, lambda sizes, count=count: len(sizes) >= count, 0.0)
            except PhysicsError:
                continue
            if found is not None:
                self.region = found
                break
        self._ended = True

    def _search(self, radius: float, enough: Callable[..., bool], least: float) -> Region | None:
        """The Region about this radius or less; None where its roots are not enough."""
        undecided = None
        for effort in EFFORTS:
            by_part = self._roots(radius, effort)
            roots = [root for own in by_part for root in own]
            sizes = sorted(abs(root.value) for root in roots if abs(root.value) < radius)
            circles = _circles(sizes, self._held(radius), radius, least, enough)
            for circle in circles:
                count = zeros_of(self.parts, circle)
                inside = [root for root in roots if abs(root.value) < circle]
                rigid = self._at_rest(sizes[0] if sizes else circle) if count is not None else 0
                if count is not None and count == rigid + sum(2 if root.value.imag else 1 for root in inside):
                    known = [[root for root in own if abs(root.value) < circle] for own in by_part]
                    return Region(circle, count, self._listed(inside), roots=known, parts=self.parts)
                undecided = circle
            if not circles and effort == EFFORTS[-1]:
                return None
            if not circles and undecided is None and not sizes and zeros_of(self.parts, radius) in (0, None):
                return None
        raise _undecided(undecided)

    def _roots(self, radius: float, effort: float) -> list[list[DampedRoot]]:
        """Of each part the known roots, and polished ones from estimates between the known region and a radius."""
        known, edge = self.region.roots or [()] * len(self.parts), self.region.radius
        least = max(RESTING * radius if self._resting else 0.0, OVERLAP * edge)
        return [part.roots(radius, effort, own, least, edge) for part, own in zip(self.parts, known, strict=True)]

    def _held(self, radius: float) -> Callable[..., int]:
        """The number of frequencies of held pieces within a radius, as a function."""
        return lambda size: sum(int(held_within(stack, size).sum()) for stack in self.matrix.stacks)

    def _at_rest(self, nearest: float) -> int:
        """How often λ = 0 is an eigenvalue."""
        return (zeros_of(self.parts, 0.03 * nearest) or 0) if self._resting else 0

    def _listed(self, roots: list[DampedRoot]) -> list[DampedMode]:
        rigid = [DampedMode(i, 0.0, 0.0, None, shape, 0.0, "rigid motion: λ = 0")
                 for i, shape in enumerate(self._resting, 1)]
        return rigid + [_mode(i, root) for i, root in enumerate(_by_size(roots), len(rigid) + 1)]


def _by_size(roots: Sequence[DampedRoot]) -> list[DampedRoot]:
    """By |λ|, of equal ones those first that decay slowest."""
    return sorted(roots, key=lambda root: (round(abs(root.value) / abs(roots[0].value), 12), -root.value.real))


def _circles(sizes: list[float], held: Callable[..., int], radius: float, least: float,
             enough: Callable[..., bool]) -> list[float]:
    """Radii between roots, and away from frequencies of held pieces, within which roots are enough; the clearest
    first."""
    ends, found = [*sizes, radius], []
    for i in range(len(sizes) + 1):
        low, high = max(ends[i - 1] if i else 0.0, least), ends[i]
        if not high > low * (1 + 1e-6) or not enough(sizes[:i]):
            continue
        parts = low + (high - low) * np.linspace(0, 1, 9)
        counts = [held(float(part)) for part in parts]
        clear = [(a + b) / 2 for a, b, one, two in zip(parts, parts[1:], counts, counts[1:], strict=False)
                 if one == two]
        best = max(clear or [(low + high) / 2], key=lambda at: min(at - low, high - at))
        found.append((min(best - low, high - best) / best, float(f"{best:.6g}")))     # as it is printed
    return [at for _, at in sorted(found[:GAPS], reverse=True)]


def _mode(index: int, root: DampedRoot) -> DampedMode:
    value, omega = root.value, abs(root.value)
    zeta = -value.real / omega if value.imag else None
    return DampedMode(index, value, omega, zeta, root.shape.astype(complex), root.error)


def _few(radius: float) -> PhysicsError:
    return PhysicsError(f"so many damped modes are not there: there are fewer with |λ| < {radius:.4g} 1/s",
                        "a damper near √(Nμ) of a bar, shaft or string lets no wave come back: ask for fewer modes")


def _piled_up(beta: float) -> NoMoreTold:
    return NoMoreTold(f"damping in proportion to stiffness makes modes without end creep at rates about "
                      f"1/beta = {1 / beta:.4g} 1/s: damped modes are told below that alone",
                      "ask for fewer modes, or for frequency responses")


def _undecided(radius: float) -> PhysicsError:
    return PhysicsError(f"the number of damped modes with |λ| < {radius:.4g} 1/s is not certain"
                        if radius else "the damped modes are not told from one another",
                        "modes may be too near one another, or a damper near √(Nμ) swallow nearly all waves; ask for "
                        "frequency responses")
