"""The frequency response of scenes with members as a FrequencyResponseFunction: values by D(s), poles and zeros by
counts."""

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.dynamic_matrix import BLOWN, SHARES
from vibcli.analyses.frequency_response import member_marks
from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction
from vibcli.analyses.frequency_response.member_errors import of_value, of_value_at
from vibcli.analyses.frequency_response.member_marks import error_of
from vibcli.analyses.frequency_response.member_poles_and_zeros import taking_part
from vibcli.base.errors import LostDigits
from vibcli.numerics.ascending import ascending, median

if TYPE_CHECKING:
    from collections.abc import Callable

    from vibcli.analyses.frequency_response.beside_rigid_motions import AtRest
    from vibcli.analyses.frequency_response.member_marks import Marks
    from vibcli.analyses.frequency_response.member_system import MemberSystem, Solved

BESIDE, AT_POLE = 1e-3, 1e-8        # relative distances from a frequency: where poles are looked for, where it is one


class MemberTransfer(FrequencyResponseFunction):
    """system: the MemberSystem; marks: its Marks."""

    __slots__ = ("_kept", "marks", "system")

    def __init__(self, system: "MemberSystem", marks: "Marks", order: int = 0) -> None:
        super().__init__(order)
        self.system, self.marks = system, marks
        self._kept: dict[Any, Any] = {}

    @property
    def undamped(self) -> bool:
        rows = self.system.output.rows
        whole = not any(isinstance(x, complex) for x in (*rows[0].values(), *rows[2].values(),
                                                         *self.system.given.weights.values()))
        return self.system.matrix.undamped and not rows[1] and whole

    @property
    def moves_by_modes(self) -> bool:
        """Are its poles the natural frequencies, counted ones?"""
        return self.system.matrix.conservative and (self.system.matrix.undamped or self.marks.tells_poles)

    @property
    def pace(self) -> float:
        shown = self.natural()
        return float(np.exp(np.mean(np.log(shown)))) if shown else 1.0

    @property
    def end(self) -> float:
        return 1.25 * max(self.natural(), default=math.inf)

    def natural(self) -> list[float]:
        return [float(mode.omega) for mode in self.marks.shown()]

    def at(self, s: np.ndarray, steep: bool = False) -> "tuple[np.ndarray, np.ndarray | None, np.ndarray]":
        """Near what a held piece vibrates at by divided pieces."""
        found = self.system.in_blocks(s, steep)
        for share in SHARES:
            near = np.flatnonzero(~(found.excess < BLOWN))
            if not len(near):
                break
            other = self.system.divided(share).in_blocks(s[near], steep)
            better = ~(other.excess > found.excess[near])
            for part, put in zip(found, other, strict=True):
                if part is not None:
                    part[near[better]] = put[better]
        for k in np.flatnonzero(found.singular & (s == 0)).tolist():
            self._put_at_rest(found, k)
        self._require_digits(s[found.singular & (s != 0)])
        return found.values, found.slopes, found.resonant

    @property
    def _at_rest(self) -> "AtRest":
        """H at s = 0, where D is singular; None where that is no rigid motion."""
        from vibcli.analyses.frequency_response.beside_rigid_motions import at_rest

        if "rest" not in self._kept:
            next_pole = self.marks.next_to_zero
            self._kept["rest"] = None if next_pole is None else at_rest(self, next_pole, lambda s: max(
                of_value_at(self, complex(at)) for at in s[:len(s) // 2]))
        found: AtRest = self._kept["rest"]
        return found

    @property
    def drifting(self) -> "AtRest | None":
        """What its output has at s = 0 where a steady input drives what nothing holds; None where that is not found."""
        rest = self._at_rest
        return None if rest is None or not rest.resonant else rest.of_rate(self.order)

    def _put_at_rest(self, found: "Solved", k: int) -> None:
        rest = self._at_rest
        if rest is None:
            raise self._lost_digits
        found.values[k], found.resonant[k] = 0.0 if rest.resonant else rest.value, rest.resonant
        if found.slopes is not None:
            found.slopes[k] = rest.slope

    def _require_digits(self, s: np.ndarray) -> None:
        """LostDigits where D is nearly singular away from all natural frequencies."""
        for Omega in np.abs(s[s.real == 0].imag):
            near = self.poles((1 - BESIDE) * Omega, (1 + BESIDE) * Omega)
            if not (abs(near - 1j * Omega) <= AT_POLE * Omega).any():
                raise self._lost_digits

    @property
    def _lost_digits(self) -> LostDigits:
        piece = min((one.piece for one in self.system.matrix.pieces), key=lambda one: one.length)
        return LostDigits("responses lose their digits: places on a member are too near each other beside its "
                          f"length: {float(piece.length):.3g} m",
                          "move them further apart, or put what they hold at one place")

    def to_pole(self, s: np.ndarray) -> np.ndarray:
        """Newton's step towards the next pole of any response of the scene, seen at its nodes."""
        found: np.ndarray = self._to_pole(self.system, s)
        return found

    def to_pole_within(self, s: np.ndarray) -> np.ndarray:
        """The same, seen within pieces too, whose ends may rest."""
        found: np.ndarray = self._to_pole(self.system.divided(SHARES[0]), s)
        return found

    def _to_pole(self, system: "MemberSystem", s: np.ndarray) -> np.ndarray:
        step, excess = system.to_pole(s)
        for share in SHARES[1:]:
            near = np.flatnonzero(~(excess < BLOWN))
            if not len(near):
                break
            other, least = self.system.divided(share).to_pole(s[near])
            better = ~(least > excess[near])
            step[near[better]], excess[near[better]] = other[better], least[better]
        return step

    def counts(self, what: str) -> bool:
        scene = self.marks.scene
        return super().counts(what) and (what != "poles" or scene is None or scene.counts(what))

    def poles(self, low: float = 0.0, high: float = math.inf) -> np.ndarray:
        scene = self.marks.scene
        return self._found(member_marks.poles, low, high) if scene is None else scene.poles(low, high)

    def zeros(self, low: float = 0.0, high: float = math.inf) -> np.ndarray:
        found: np.ndarray = self._found(member_marks.zeros, low, high)
        return found

    def _found(self, find: "Callable[[MemberTransfer, float, float], np.ndarray]", low: float,
               high: float) -> np.ndarray:
        high = high if math.isfinite(high) else self.end
        found: np.ndarray = self.once((find, low, high), lambda: find(self, low, high))
        return found

    def once(self, key: Any, find: "Callable[[], Any]") -> Any:
        """What is found, kept."""
        if key not in self._kept:
            self._kept[key] = find()
        return self._kept[key]

    @property
    def without_damping(self) -> "MemberTransfer":
        """The same without dampers and drag."""
        return MemberTransfer(self.system.without_damping(), self.marks.changed, self.order)

    def endless(self, low: float = 0.0, high: float = math.inf) -> list[np.ndarray]:
        places = [taking_part(self, ascending(self.poles(low, high).imag)), self.zeros(low, high).imag]
        return [ascending(part[part > 0]) for part in places]

    def error(self, Omega: float) -> float:
        if not Omega and self.marks.next_to_zero is not None and self._at_rest is not None:
            return 0.0 if self.order else self._at_rest.error
        return of_value(self, Omega)

    def noise(self, Omega: np.ndarray) -> np.ndarray:
        return self.errors(Omega)

    def error_of_pole(self, Omega: float) -> float:
        return Omega * error_of(self.marks.natural(0.5 * Omega, 1.5 * Omega), Omega)

    def with_damper(self, other: Any, c: float) -> "MemberTransfer":
        return MemberTransfer(self.system.mixed(other.system, c), self.marks.changed, self.order)

    def felt(self, other: Any) -> float:
        one, two = self.system.matrix.polynomial, other.system.matrix.polynomial
        added = np.abs(np.diag(two[1] - one[1]))
        return median(1 / added[added > 0]) if added.any() else 1.0
