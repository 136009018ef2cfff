"""Where the response of a scene with members has its poles and zeros, and which natural frequencies are shown."""

import math
from contextlib import suppress
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.mode_source import NaturalModes
from vibcli.analyses.frequency_response.held_systems import held
from vibcli.analyses.frequency_response.member_poles_and_zeros import (
    ABOVE,
    LOWEST,
    distinct,
    followed,
    taking_part,
    zeros_on_axis,
)
from vibcli.base.errors import PhysicsError
from vibcli.numerics.ascending import ascending

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.analyses.frequency_response.counted_zeros import CountedPoles
    from vibcli.analyses.frequency_response.member_response import MemberTransfer
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.mechanics.factored_system import FactoredSystem

ROUNDING, ASIDE = 1e-15, 1e-5
BESIDE = 0.05       # relative distance of a damped pole from where it is without dampers, within which it is its own
DAMPINGS, EVEN, EACH = (0.003, 0.05, 0.2, 0.7), 40, 8      # where damped poles are looked for besides: ratios, places


class Marks:
    """modal: the ModalAnalysis of a scene, its elements; shared: the row of the place that load and signal have in
    common, else None; scene: a MemberTransfer of the scene that has the poles of all its responses, where those of this
    one are no others."""

    def __init__(self, modal: "ModalAnalysis", shared: "Mapping[int, float] | None",
                 scene: "MemberTransfer | None" = None) -> None:
        self._modal, self.shared, self.scene = modal, shared, scene
        self._held: Any = None

    @property
    def changed(self) -> "Marks":
        """Of the scene with other dampers."""
        return Marks(self._modal, self.shared)

    def natural(self, low: float, high: float) -> "list[Mode]":
        """The modes without dampers that oscillate, with low ≤ ω ≤ high."""
        return [mode for mode in self._modal.modes.up_to(high) if mode.omega and mode.omega >= low]

    def shown(self) -> "list[Mode]":
        """The modes without dampers that oscillate and are shown."""
        return [mode for mode in self._modal.modes.shown() if mode.omega]

    @property
    def tells_poles(self) -> bool:
        """Are the modes without dampers those of the scene without them, whatever loads depend on velocities?"""
        return not any(self._modal.configuration.linear_system.drag.values())

    @cached_property
    def next_to_zero(self) -> float | None:
        """How far from 0 the next pole is where nothing holds the scene; None where that is held."""
        from vibcli.analyses.frequency_response.beside_rigid_motions import next_to_zero

        return next_to_zero(self._modal)

    @cached_property
    def slow(self) -> list[complex]:
        """The first damped λ of what nothing holds, which need not be near any frequency without dampers."""
        modal = self._modal
        with suppress(PhysicsError):
            if self.next_to_zero is not None and modal.damped is not None:
                return [complex(mode.eigenvalue) for mode in modal.damped.first(len(modal.modes.shown()))]
        return []

    def held(self, low: float, high: float) -> np.ndarray:
        """The natural frequencies of the scene held where load and signal act."""
        if self._held is None:
            self._held = NaturalModes(held(still(self._modal.configuration.linear_system), self.shared or {}))
        last = self._held.count(high)
        modes = self._held.numbered(1, last) if last else []
        return np.array([mode.omega for mode in modes if mode.omega and mode.omega >= low])


def still(elements: "FactoredSystem") -> "FactoredSystem":
    """The same elements without what damps."""
    pieces = [placed._replace(piece=placed.piece._replace(drag=0 * placed.piece.drag), retardation=0)
              for placed in elements.pieces]
    return elements.with_parts(dampers=(), C=None, drag=None, pieces=pieces)


def poles(response: "MemberTransfer", low: float, high: float) -> np.ndarray:
    """The poles with low ≤ Im s ≤ high: without dampers the natural frequencies; with them counted beside the axis,
    where the count is certain."""
    if response.moves_by_modes or not math.isfinite(high):
        return 1j * np.array([mode.omega for mode in response.marks.natural(low, high)])
    counted = None if low else _counted(response, high)
    if not low and counted is None:
        response.leave_uncounted("poles")
    found = _looked_for(response, low, high) if counted is None else counted.poles
    result: np.ndarray = found[(found.imag >= low) & (found.imag <= high)]
    return result


def _looked_for(response: "MemberTransfer", low: float, high: float) -> np.ndarray:
    """Damping may turn or merge what would move without it: from many places; a frequency without dampers near which
    none is found stands for its own."""
    start = 1j * np.array([mode.omega for mode in response.marks.natural(low, high)])
    axis = np.linspace(low, high, EVEN + EACH * len(start) + 1)[1:]
    starts = np.concatenate([start, response.marks.slow, *((1j - damping) * axis for damping in DAMPINGS)])
    found = distinct(np.concatenate([followed(response.to_pole, starts), followed(response.to_pole_within, starts)]))
    alone = [s for s in start if not (np.abs(found - s) <= BESIDE * abs(s)).any()]
    found = np.concatenate([found[(found.imag >= low) & (found.imag <= high)], alone])
    return found[np.argsort(found.imag)]


def _counted(response: "MemberTransfer", high: float) -> "CountedPoles | None":
    """The CountedPoles up to some way beyond a frequency, None where they are not certain."""
    from vibcli.analyses.frequency_response.counted_zeros import CountedPoles, counted_poles

    response = response.marks.scene or response
    top = ABOVE * high

    def find() -> "CountedPoles | None":
        if response.moves_by_modes:
            return CountedPoles(poles(response, 0.0, top), high / (1 + len(response.marks.natural(0.0, high))))
        with suppress(PhysicsError):
            return counted_poles(response, _looked_for(response, 0.0, top), LOWEST * response.pace, top)
    known: CountedPoles | None = response.once(("counted", high), find)
    return known


def zeros(response: "MemberTransfer", low: float, high: float) -> np.ndarray:
    """The zeros with low ≤ Im s ≤ high, counted; with dampers followed from those without where the count is not
    certain."""
    if response.marks.shared is not None and response.moves_by_modes:
        with suppress(PhysicsError):        # beside gyroscopic terms what nothing else holds is not counted
            found: np.ndarray = _newton_kept(response, 1j * ascending(response.marks.held(low, high)))
            return found
    if response.undamped:
        natural = np.array([mode.omega for mode in response.marks.natural(low, high)])
        return 1j * zeros_on_axis(response, taking_part(response, ascending(natural)), low or LOWEST * response.pace,
                                  high)
    from vibcli.analyses.frequency_response.counted_zeros import zeros_beside

    return zeros_beside(response, _counted(response, high), response.without_damping, low, high)


def _newton_kept(response: "MemberTransfer", places: np.ndarray) -> np.ndarray:
    """Without those that no zero of H is near: modes in which the place rests anyhow. Where modes of the scene have the
    same frequency, no slope is seen there, and H beside it tells."""
    if not len(places):
        return places
    values, slopes, _ = response.at(places, True)
    beside, steep, _ = response.at(places * (1 + ASIDE), True)
    with np.errstate(all="ignore"):
        shared = (slopes == 0) & ((steep * places * ASIDE / beside).real > 0.5)
        found: np.ndarray = places[(np.abs(values / slopes) <= 1e-6 * np.abs(places)) | shared]
        return found


def error_of(modes: "list[Mode]", Omega: float) -> float:
    """The relative bound of a natural frequency."""
    near = min(modes, key=lambda mode: abs(float(mode.omega) - Omega), default=None)
    return ROUNDING if near is None else max(float(near.error), ROUNDING)


