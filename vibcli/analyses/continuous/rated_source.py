"""The damped modes of members by ratios of their modes beside dampers, as they are asked for: by ascending |λ|, none
missed.

As of dampers alone, estimates are polished, and the argument principle counts how many λ there are with |λ| < R.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.coupled_transfer import Dampers
from vibcli.analyses.continuous.damped_source import Region
from vibcli.analyses.continuous.dynamic_matrix import dynamic_matrix
from vibcli.analyses.continuous.rated_expansion import REACH, RatedExpansion
from vibcli.analyses.continuous.rated_roots import RatedRoot, RatedRoots
from vibcli.analyses.modal.damped_modes import DampedMode
from vibcli.analyses.modal.mode_sequence import NoMoreTold
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.continuous.member_damping import MemberDamping
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.mechanics.factored_system import FactoredSystem

WIDER, TRIES = 1.35, 12     # times by which the circle grows, and how often
SURE = 1e-3         # relative bound of a root that is told
RESTING = 1e-7      # of the radius: what is nearer to 0 is at rest
UNFELT = 1e-12      # of the dampers: what is a motion that they do not feel
GAPS = 4            # between roots that are tried in turn for the circle


class RatedDampedModes:
    """What `Modes` asks for; elements: with the dampers alone; natural: the modes without damping."""

    def __init__(self, elements: "FactoredSystem", natural: "Modes", damping: "MemberDamping") -> None:
        self._damping, self._modes = damping, natural
        matrix = dynamic_matrix(elements)
        C = matrix.polynomial[1]
        self._refused = _creeping() if damping.creeps else _turning() if (C != C.T).any() else None
        self._dampers, self._still = Dampers(C), matrix.without_damping()
        self._resting = [mode.shape for mode in self._modes.shown() if mode.rigid]
        self._limit = 0.9 / (REACH * float(damping.series[1])) if len(damping.series) > 1 else np.inf
        self.region = Region(0.0, 0, [])

    def numbered(self, first: int, last: int) -> list[DampedMode]:
        """The modes with an index from first to last."""
        if len(self.region.modes) < last:
            oscillating = [mode for mode in self._modes.first(last + 2) if mode.omega]
            try:
                self._reach(1.05 * float(oscillating[-1].omega), 0.0, last - len(self._resting))
            except NoMoreTold:
                if len(self.region.modes) < first:
                    raise
        return self.region.modes[first - 1:last]

    def count(self, Omega: float) -> int:
        """How many have |λ| ≤ Omega, the rigid ones among them."""
        if self.region.radius <= Omega:
            self._reach(1.3 * Omega, Omega, 0)
        return sum(float(mode.omega) <= Omega for mode in self.region.modes)

    def proof(self, first: int, last: int) -> Region | None:
        """What tells that none of the indices from first to last is missing."""
        return self.region if last <= len(self.region.modes) else None

    def _reach(self, radius: float, least: float, wanted: int) -> None:
        """The Region beyond `least` of so many that move."""
        if self._refused:
            raise self._refused
        for _ in range(TRIES):
            if radius > self._limit:
                self.region = self._search(self._limit, 0.0, len(self.region.modes) - len(self._resting)) or self.region
                raise _piled_up(self._limit)
            found = self._search(radius, least, wanted)
            if found is not None:
                self.region = found
                return
            radius *= WIDER
        raise PhysicsError(f"so many damped modes are not found: fewer with |λ| < {radius / WIDER:.4g} 1/s are certain",
                           "ask for fewer modes, or for frequency responses")

    def _search(self, radius: float, least: float, wanted: int) -> Region | None:
        """The Region about this radius or less; None where it is not told, or does not hold so many."""
        roots = RatedRoots(RatedExpansion(self._still, self._dampers.rows, self._modes, self._damping, radius),
                           self._dampers.rates)
        found = [one for one in roots.found(RESTING * radius) if one.error < SURE]
        found.sort(key=lambda one: abs(one.value))
        for circle in _circles([abs(one.value) for one in found], least, radius, wanted):
            inside = [_cleaned(one) for one in found if abs(one.value) < circle]
            at_rest = self._at_rest()
            if roots.zeros_within(circle) == at_rest + sum(2 if one.value.imag else 1 for one in inside):
                return Region(circle, at_rest + sum(2 if one.value.imag else 1 for one in inside), self._listed(inside))
        return None

    def _at_rest(self) -> int:
        """How often λ = 0 is one: twice of each motion that nothing holds, once where dampers feel it."""
        if not self._resting:
            return 0
        shapes = np.array([[float(x) for x in shape] for shape in self._resting]) @ self._dampers.rows
        felt = np.linalg.eigvalsh((shapes * self._dampers.rates) @ shapes.T)
        size = (abs(shapes)**2 * abs(self._dampers.rates)).sum() or 1.0
        return 2 * len(self._resting) - int((abs(felt) > UNFELT * size).sum())

    def _listed(self, roots: Sequence[RatedRoot]) -> list[DampedMode]:
        found = [DampedMode(i, 0.0, 0.0, None, shape + 0j, 0.0, "rigid motion: λ = 0")
                 for i, shape in enumerate(self._resting, 1)]
        for index, root in enumerate(roots, len(found) + 1):
            omega = abs(root.value)
            zeta = -root.value.real / omega if root.value.imag else None
            found.append(DampedMode(index, root.value, omega, zeta, root.shape, root.error))
        return found


def _cleaned(root: RatedRoot) -> RatedRoot:
    """Without an imaginary part that is nothing beside its bound."""
    if abs(root.value.imag) <= 2 * root.error * abs(root.value):
        return root._replace(value=complex(root.value.real, 0.0))
    return root


def _circles(sizes: Sequence[float], least: float, radius: float, wanted: int) -> list[float]:
    """Radii between roots within which so many are and that are beyond `least`; the clearest first."""
    ends, found = [0.0, *sizes, radius], []
    for i in range(wanted, len(sizes) + 1):
        low, high = max(ends[i], least), min(ends[i + 1], radius)
        if high > low * (1 + 1e-6):
            middle = (low + high) / 2
            found.append(((high - low) / middle, float(f"{middle:.6g}")))
    return [at for _, at in sorted(found[:GAPS], reverse=True)]


def _creeping() -> NoMoreTold:
    return NoMoreTold("damped modes of members are not found where a Caughey series of three terms or more stands "
                      "beside dampers: modes without end creep about λ = 0",
                      "ask for frequency responses or steady(…), or write `modal: […]`")


def _turning() -> NoMoreTold:
    return NoMoreTold("damped modes of members are not found where modes have ratios beside forces that no potential "
                      "gives", "ask for frequency responses or steady(…)")


def _piled_up(limit: float) -> NoMoreTold:
    return NoMoreTold(f"damping that grows as the square of frequencies makes modes without end creep: beside ratios "
                      f"of modes damped modes are told below {limit:.4g} 1/s alone",
                      "ask for fewer modes, or for frequency responses")
