"""The natural modes of a scene with continuous members, as they are asked for: without end, none missed."""

import cmath
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.brackets import Ground, KnownCounts, flat, ground
from vibcli.analyses.continuous.counting import count
from vibcli.analyses.continuous.local_modes import local_modes
from vibcli.analyses.continuous.natural_frequencies import SURE, NaturalFrequency, better, natural_frequencies
from vibcli.analyses.continuous.rigid_motions import never_grows, rigid_count, rigid_shapes
from vibcli.analyses.continuous.system import ContinuousSystem, continuous_system
from vibcli.analyses.continuous.uniform_members import uniform_member
from vibcli.analyses.continuous.uniform_shapes import uniform_modes
from vibcli.analyses.modal.scaling import mechanism
from vibcli.analyses.modal.undamped import Mode
from vibcli.base.errors import PhysicsError
from vibcli.numerics.sparse_elimination import quadratic

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.continuous.brackets import Bracket
    from vibcli.mechanics.factored_system import FactoredSystem

DEEPER = 40, 80, 160    # digits that are tried in turn where floats do not tell
ABOVE = 1e-14, 1e-13, 1e-12, 1e-11      # relative distances above a frequency that are tried in turn
NEVER_BELOW = 2.0 ** -53
SEARCHED = 64       # modes of a uniform member with places on it that are found beside these, as those of others are


class NaturalModes:
    """A ModeSource: `numbered(first, last)` and `count(Omega)` of the system without its dampers.

    precise(dps): the same elements to so many digits, or None; digits: so many are asked for, as numbers of mpmath;
    at_limit: is what floats do not tell from zero zero, as a limit of stability is chosen?
    ahead: modes beyond those asked for that are found with them, since shapes are told apart from the next one.
    """

    ahead = 1

    def __init__(self, elements: "FactoredSystem", precise: "Callable[[int], FactoredSystem] | None" = None,
                 digits: int | None = None, at_limit: bool = False) -> None:
        if elements.circulatory:
            raise PhysicsError("modes of members are not found where forces follow what they act on",
                               "take the force along a fixed direction, or make the member massless")
        _require_tied(elements)
        self.elements, self.precise, self.digits = elements, precise, digits
        self._known: dict[int | None, KnownCounts] = {}
        self._divided: dict[tuple[int, ...], ContinuousSystem] = {}
        self.ground, self._resting = self._grounded(at_limit)
        uniform = uniform_member(elements) if digits is None else None
        self.uniform = uniform if uniform is not None and uniform.resting == self.ground.resting else None

    def numbered(self, first: int, last: int) -> list[Mode]:
        """The modes with an index from first to last."""
        growing, resting = self.ground.growing, self.ground.resting
        found = self._found(first, min(last, growing)) if first <= growing else []
        found += self._rigid(first, last)
        start = max(first, resting + 1)
        return found + self._found(start, last) if start <= last else found

    def _found(self, first: int, last: int) -> list[Mode]:
        """Modes that are not rigid."""
        uniform = self.uniform
        if uniform is not None and uniform.cuts:
            if first <= SEARCHED < last:
                return self._found(first, SEARCHED) + self._found(SEARCHED + 1, last)
            uniform = uniform if first > SEARCHED else None
        if self.digits is not None:
            near = natural_frequencies(self._at(None), first, last)
            roots = self._precise_roots(first, last, near, 10.0 ** -self.digits)
        elif uniform is not None:
            resting = uniform.resting
            known = uniform_modes(uniform, self._at(None).system, first - resting, last - resting, self._divided)
            roots = {root.index: root for root in known}
        else:
            roots = natural_frequencies(self._at(None), first, last)
            for low, high in _runs([i for i in range(first, last + 1) if _doubtful(roots, i)]):
                roots |= self._precise_roots(low, high, roots, SURE)
        if uniform is None:
            return [self._mode(roots[i], _rate(roots[i])) for i in range(first, last + 1)]
        rates = uniform.frequencies(np.arange(first, last + 1) - uniform.resting)
        return [self._mode(roots[i], rate) for i, rate in zip(range(first, last + 1), rates, strict=True)]

    def count(self, Omega: float) -> int:
        """How many have ω ≤ Omega, those that grow and the rigid ones among them."""
        z, system = Omega * Omega * (1 + 1e-15), self._at(None).system
        found = count(system, system.numbers([z]))
        for digits in DEEPER:
            if found.below[0] == found.above[0]:
                break
            with working(digits):
                system = self._at(digits).system
                found = count(system, system.numbers([z]))
        return int(found.below[0])

    def counted_above(self, mode: Mode) -> int | None:
        """J just above the frequency of a mode, certain; None where close ones leave it open."""
        home = mode.motion.system
        system, omega = home if home.digits is None else self._at(None).system, float(mode.omega)
        for away in (4 * float(mode.error), *ABOVE):
            found = count(system, system.numbers([(omega * (1 + away)) ** 2]))
            if found.below[0] == found.above[0]:
                return int(found.below[0])
        return None

    def _at(self, digits: int | None) -> KnownCounts:
        """The KnownCounts in floats or in so many digits."""
        if digits not in self._known:
            elements = _in_digits(self.elements, self.precise, digits)
            self._known[digits] = KnownCounts(continuous_system(elements, digits))
        return self._known[digits]

    def _precise_roots(self, first: int, last: int, roots: Mapping[int, NaturalFrequency],
                       goal: float) -> dict[int, NaturalFrequency]:
        """Roots in more digits, until their bounds are below the goal."""
        found: dict[int, NaturalFrequency] = {}
        for more in DEEPER:
            digits = more + (self.digits or 0)
            with working(digits):
                counts = self._at(digits)
                for i in range(first, last + 1):
                    if i in roots:
                        counts.add([counts.system.number(roots[i].z) * (1 + side * 1e-8) for side in (-1, 1)])
                found = better(found, natural_frequencies(counts, first, last))
            if all(i in found and found[i].error < goal for i in range(first, last + 1)):
                return found
        raise _undecided()

    def _grounded(self, at_limit: bool) -> tuple[Ground, np.ndarray | None]:
        """The Ground, and the shapes of what is rigid: from structure, or of what no number of digits tells from it."""
        if any(self.elements.G.values()):
            return self._held_and_turning(), None
        near = flat(self._at(None)) if at_limit else None
        if near is not None and near.below < near.above:
            return self._flat(None, near)
        rigid, sure = rigid_count(self.elements), never_grows(self.elements)
        found = ground(self._at(None), rigid, sure)
        for digits in DEEPER if found is None else ():
            with working(digits):
                found = found or ground(self._at(digits), rigid, sure)
        if found is not None:
            return found, rigid_shapes(self.elements, self._at(None).system.plain, rigid) if rigid else None
        with working(DEEPER[-1]):
            near = flat(self._at(DEEPER[-1]))
            if near is None:
                raise _undecided()
            return self._flat(DEEPER[-1], near)

    def _flat(self, digits: int | None, near: "Bracket") -> tuple[Ground, np.ndarray]:
        """The Ground, and the shapes of what is taken for rigid."""
        system, _, shapes, _ = local_modes(self._at(digits).system, near)
        return Ground(near.below, near.above - near.below), shapes / _sizes(system, shapes)

    def _rigid(self, first: int, last: int) -> list[Mode]:
        growing, resting = self.ground.growing, self.ground.resting
        system = self._at(None).system
        return [self._mode(NaturalFrequency(i, 0.0, 0.0, self._resting[:, i - growing - 1], system), 0.0)
                for i in range(max(first, growing + 1), min(last, resting) + 1)]

    def _mode(self, root: NaturalFrequency, size: "float | mpmath.mpf") -> Mode:
        """A root with √|z| as a Mode, in floats unless digits are asked for: one found in more digits is then rounded
        once."""
        n, digits = self.elements.n, self.digits
        number = float if digits is None else lambda x: x
        rounds = 0.0 if digits is not None or root.system.digits is None else NEVER_BELOW
        rate, error = number(size), root.error + rounds if digits is not None else max(root.error + rounds, NEVER_BELOW)
        shape = root.shape[:n]
        if digits is None:
            kind = shape.dtype.kind
            shape = shape if kind == "f" else shape.astype(complex if kind == "c" else float)
            if not all(map(cmath.isfinite, shape.tolist())):
                raise PhysicsError(f"the shape of mode {root.index} is not found",
                                   "ask for more digits, as in --digits 30")
        rates = (None, rate) if root.z < 0 else (rate, None)
        return Mode(root.index, *rates, shape, shape, error if root.z else 0.0, root)

    def _held_and_turning(self) -> Ground:
        """The Ground beside gyroscopic terms, which leave the count what it is only where a positive stiffness holds
        every motion."""
        counts = self._at(None)
        if count(counts.system, counts.system.numbers([0])).above[0]:
            raise PhysicsError("modes of members beside gyroscopic terms are counted only where every motion is held "
                               "by a positive stiffness", "hold what is free, or take the turning out")
        return ground(counts, 0, True)


def _rate(root: NaturalFrequency) -> "float | mpmath.mpf":
    """√|z| in the digits that z has."""
    digits = root.system.digits
    if digits is None or not root.z:
        return math.sqrt(abs(root.z))
    from mpmath import mp

    with working(digits):
        return mp.sqrt(abs(root.z))


def _require_tied(elements: "FactoredSystem") -> None:
    """UnheldCoordinate of a coordinate without inertia that no spring and no member ties."""
    ends = [row for placed in elements.pieces for row in placed.rows]
    rows = [*(row for _, row in elements.springs), *elements.K, *elements.G, *ends]
    for i in elements.massless:
        if not any(i in row for row in rows):
            raise mechanism(i)


def _undecided() -> PhysicsError:
    return PhysicsError("the frequencies are so close to one another, or the data so far apart, that digits do not "
                        "tell them", "look for stiffnesses of very different size, or ask for lower modes")


def _sizes(system: ContinuousSystem, shapes: np.ndarray) -> np.ndarray:
    """√(xᵀ ∂D/∂s² x) of columns, at rest."""
    return quadratic(system.pattern, system.dynamic_stiffness(system.numbers([0]))[2], shapes) ** 0.5


def _doubtful(roots: Mapping[int, NaturalFrequency], i: int) -> bool:
    """Is a root not known, not proved, or not told apart from a neighbour?"""
    if i not in roots or not roots[i].error < SURE:
        return True
    return any(abs(roots[j].z - roots[i].z) <= 2 * (roots[i].error + roots[j].error) * abs(roots[i].z)
               for j in (i - 1, i + 1) if j in roots)


def _runs(numbers: Sequence[int]) -> list[tuple[int, int]]:
    """The (first, last) of ascending numbers without a gap."""
    found: list[Any] = []
    for i in numbers:
        if found and found[-1][1] == i - 1:
            found[-1] = found[-1][0], i
        else:
            found.append((i, i))
    return found


def _in_digits(elements: "FactoredSystem", precise: "Callable[[int], FactoredSystem] | None",
               digits: int | None) -> "FactoredSystem":
    if digits is None:
        return elements
    from mpmath import mp

    return elements.each(mp.mpf) if precise is None else precise(digits + 5)


@contextmanager
def working(digits: int) -> Iterator[None]:
    """With numbers of mpmath of so many digits."""
    from mpmath import mp

    with mp.workdps(digits + 5):
        yield
