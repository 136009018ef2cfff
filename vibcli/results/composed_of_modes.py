"""Functions of signals of motions by modes: searched as these are, first by few modes, then by more, with what is left
out of each part; the bounds of their extremes hold over the whole of the time that is searched."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.modal_grid import divided
from vibcli.analyses.continuous.modal_search import BENT, LEVELS, MOST, bends, top_between, width_about
from vibcli.base.errors import NoBound
from vibcli.results.composed_errors import spread
from vibcli.results.modal_signals import ModalSignal, by_waves
from vibcli.results.signal import Signal
from vibcli.results.signals import ComposedSignal

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.base.work import Work
    from vibcli.symbolic.node import Node

CANDIDATES = 4          # cells that are searched for the top


class ComposedOfModes(ComposedSignal):
    """A function of ModalSignals and perhaps of others."""

    KIND = "a signal composed of others of a motion that is followed by modes of members"
    LOOKED = ModalSignal.LOOKED
    signals: Any
    _cells: "dict[tuple[float, float, int], tuple[np.ndarray, np.ndarray, np.ndarray]] | None" = None

    def __init__(self, node: "Node", signals: "Mapping[str, Any]", floats: "Mapping[str, Any]", time: "Node",
                 work: "Work | None" = None, asked: tuple[Any, ...] = ()) -> None:
        super().__init__(node, signals, floats, time, None, work)
        self.asked = asked

    @property
    def why_estimated(self) -> str:
        return ", and ".join(dict.fromkeys(one.why_estimated for one in self.signals.values() if one.is_estimated))

    def read_at(self, t: float) -> Signal:
        return by_waves(self, self.asked, t)

    def error_of_time(self, t: float) -> float:
        near = self.values(np.array([t * (1 - 1e-6), t, t * (1 + 1e-6)]))
        return width_about(self.values, self.error(t), t, 1 if 2 * near[1] >= near[0] + near[2] else -1)

    def error_of_zero(self, t: float) -> float:
        return width_about(self.values, self.error(t), t, 0)

    def extreme(self, start: Any, end: float, sense: int) -> tuple[float, float]:
        if self._others:
            return super().extreme(start, end, sense)
        for part in self.signals.values():
            part.require_bound(start)
        cells, values, _ = self._searched(start, end, sense)
        best = cells[np.argsort(-values.max(axis=1))[:CANDIDATES]]
        times = np.array([top_between(lambda t: sense * self.values(t), low, high) for low, high in best])
        found = sense * self.values(times)
        return float(times[int(np.argmax(found))]), float(sense * found.max())

    def error_of_extreme(self, start: float, end: float, top: tuple[float, float], sense: int) -> float:
        if self._others:
            return self.error(top[0])
        cells, values, off = self._searched(start, end, sense)
        highest = float((values + off).max() + (BENT * bends(cells, values)).max())
        if not np.isfinite(highest):
            raise self._without_bound(end)
        return max(self.error(top[0]), highest - sense * top[1])

    def _without_bound(self, end: float) -> NoBound:
        """The refusal of its extremes: that of a part, or its own."""
        for part in self.signals.values():
            for stretch in part.modal.stretches(end):
                part.require_bound(stretch.start)
        return NoBound("how far this function of signals may be off has no bound, as where it divides by what passes "
                       "zero", "ask for values at instants, or for its parts")

    @property
    def _others(self) -> bool:
        """Does it hold the time by itself, or signals of other kinds?"""
        return bool(self.node.mask & self.time.mask) or not all(
            isinstance(part, ModalSignal) for part in self.signals.values())

    def _searched(self, start: float, end: float, sense: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The cells that may hold the extreme, the values at their ends in that sense, and how far these may be off."""
        if self._cells is None:
            self._cells = {}
        if (start, end, sense) not in self._cells:
            self._cells[start, end, sense] = self._found(start, end, sense)
        return self._cells[start, end, sense]

    def _found(self, start: float, end: float, sense: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        cells, total = np.array([[start, end]]), max(part.modal.count for part in self.signals.values())
        with self.work.task("the search along a motion by modes", MOST) as task:
            for count in [*(level for level in LEVELS if level < total), total]:
                for part in self.signals.values():
                    cells = divided(cells, part.modal, part.reads, count, task)
                known = {name: part.modal.values(part.reads, cells, modes=count)
                         for name, part in self.signals.items()}
                values = self.composed(cells, known)
                off = spread(lambda parts, at=cells: self.composed(at, parts), known,
                             {name: part.off(cells, end, count) for name, part in self.signals.items()})
                tops = sense * values
                chosen = (tops + off).max(axis=1) + BENT * bends(cells, values) >= (tops - off).max()
                cells, values, off = cells[chosen], tops[chosen], off[chosen]
        return cells, values, off
