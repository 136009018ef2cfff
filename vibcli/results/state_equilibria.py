"""The equilibria of one degree of freedom in its phase plane, each of its kind."""

import math
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.nonlinear.equilibrium_kinds import Around, StateEquilibrium, kind_of, line_of_rest
from vibcli.base.errors import PhysicsError
from vibcli.mechanics.equilibrium.all_equilibria import find_equilibria

if TYPE_CHECKING:
    from vibcli.analyses.nonlinear.state_field import StateField
    from vibcli.analyses.nonlinear.well import Well
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.equilibrium.all_equilibria import Equilibria, Item

BESIDE = 1e-3           # of the way to the next equilibrium or kink
SAME, NEAR = 1e-9, 1e-6  # of the range
FLAT = ("held", "falling", "neutral")


class StateEquilibria:
    """Those within a `range` that hangs on the first search, or on the wider one that it makes necessary."""

    def __init__(self, configuration: "Configuration", search: "Equilibria | None", field: "StateField",
                 well: "Well | None", reversible: bool, ranged: "Callable[[Equilibria], tuple[float, float]]") -> None:
        self.configuration, self.field, self.well, self.reversible = configuration, field, well, reversible
        search = search or find_equilibria(configuration)
        self.range = ranged(search)
        self.search = self._wide_enough(search)
        found = self._places()
        self.around = [self._around(q, [place for place, _ in found]) for q, _ in found]
        self.items: list[StateEquilibrium] = [self._judged(q, item, around)
                                              for (q, item), around in zip(found, self.around, strict=True)]

    def _judged(self, q: float, item: "Item | None", around: Around) -> StateEquilibrium:
        if self._rests_beside(q):
            return line_of_rest(self.field, *self._line(q))
        return kind_of(self.field, q, around, item is not None and self._is_flat(item), self._bends(q))

    def _wide_enough(self, search: "Equilibria | None") -> "Equilibria":
        for name in [name for item in search.items if not search.forces.names for name in item.free[0]]:
            raise rests_anywhere(name)
        name, = search.forces.names
        bounds, (low, high) = search.bounds.get(name), self.range
        if bounds is None or search.forces.periodic[0] or (bounds[0] <= low and high <= bounds[1]):
            return search
        return find_equilibria(self.configuration, {name: self.range})

    def _places(self) -> "list[tuple[float, Item | None]]":
        """[(q, Item or None of a place where the force jumps)] ascending, images a turn apart included."""
        (name,), (low, high) = self.search.forces.names, self.range
        known = [(item.equilibrium.values[name], item) for item in self.search.items]
        known = [(0.5 * sum(self._line(q)) if self._rests_beside(q) else q, item) for q, item in known]
        if self.search.forces.periodic[0]:
            known = [(q + math.tau * k, item) for q, item in known
                     for k in range(math.ceil((low - q) / math.tau), math.floor((high - q) / math.tau) + 1)]
        known = [one for i, one in enumerate(known) if not any(self._same(one[0], q) for q, _ in known[:i])]
        inside = [(q, item) for q, item in known if low <= q <= high and self._rests(q)]
        inside += [(q, None) for q in self._kinks if not any(self._same(q, p) for p, _ in inside) and self._turned(q)]
        return sorted(inside, key=lambda one: one[0])

    def _rests(self, q: float) -> bool:
        """Is the force smaller there than beside it? At a pole, to which a scene falls, it is not."""
        step = NEAR * (self.range[1] - self.range[0])
        left, here, right = np.abs(self.field.acceleration(np.array([q - step, q, q + step]), np.zeros(3)))
        return not here or here < max(left, right)

    def _rests_beside(self, q: float) -> bool:
        """Does no force act on either side either?"""
        step = SAME * (self.range[1] - self.range[0])
        return not self.field.acceleration(np.array([q - step, q + step]), np.zeros(2)).any()

    def _line(self, q: float) -> tuple[float, float]:
        """The ends of the places about one at which it rests as well."""
        stops = [self.range[0], *self._kinks, self.range[1]]
        low, high = max(p for p in stops if p <= q), min(p for p in stops if p >= q)
        if low == self.range[0] or high == self.range[1]:
            raise rests_anywhere(self.search.forces.names[0])
        return low, high

    @cached_property
    def _kinks(self) -> list[float]:
        return [] if self.well is None else self.well.kinks(*self.range)

    def _same(self, p: float, q: float) -> bool:
        return abs(p - q) <= SAME * (self.range[1] - self.range[0])

    def _turned(self, q: float) -> bool:
        """Does the force jump there to the other sense?"""
        step = SAME * (self.range[1] - self.range[0])
        left, right = self.well.force(np.array([q - step, q + step]))
        far = np.abs(self.well.force(np.linspace(self.range[0], self.range[1], 9)))
        least = 1e-6 * float(np.max(far[np.isfinite(far)], initial=0))
        return bool(left * right < 0 and min(abs(left), abs(right)) > least)

    def _around(self, q: float, places: Sequence[float]) -> Around:
        others = [abs(p - q) for p in (*places, *self._kinks, *self.range) if not self._same(p, q)]
        reach = BESIDE * min(others)
        left, right = self.field.acceleration(np.array([q - reach, q + reach]), np.zeros(2))
        return Around(float(left), float(right), reach, self.reversible)

    def _bends(self, q: float) -> bool:
        return any(self._same(q, kink) for kink in self._kinks)

    def _is_flat(self, item: "Item") -> bool:
        """Has it no linear stiffness?"""
        if not item.singular:
            return False
        from vibcli.analyses.modal.modal_analysis import ModalAnalysis
        from vibcli.analyses.modal.stability import judged
        from vibcli.mechanics.equilibrium.degenerate import about

        found = ModalAnalysis(about(self.configuration, item, self.search.forces), len(item.free))
        return judged(found).kind in FLAT


def rests_anywhere(name: str) -> PhysicsError:
    return PhysicsError(f"this scene rests anywhere along '{name}', or in a range that ends nowhere near: its phase "
                        "plane has no equilibria to show", "ask for its motion in time")
