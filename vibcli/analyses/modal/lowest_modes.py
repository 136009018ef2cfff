"""The lowest modes of so many coordinates that no dense matrix of them all is made, found as they are asked for.

From the terms √k ∇s and √w ∇s, which stay sparse (numerics/lowest_eigenvalues.py); none is missed, by counts.
"""

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.modal.method import SQUARES, form_of
from vibcli.analyses.modal.mode_numbers import in_units
from vibcli.analyses.modal.scaling import Scaling, unmoved
from vibcli.analyses.modal.undamped import Mode, prepared
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.factored_system import MOST_DENSE, require_dense
from vibcli.numerics.inertia import Pencil
from vibcli.numerics.lowest_eigenvalues import Slice, Unsettled, lowest
from vibcli.numerics.sparse_form import UNIT, SparseForm

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import FactoredSystem

LARGEST = 20_000_000        # amplitudes that are kept
DATA = 4 * UNIT             # relative rounding of weights, components and entries
APART = 60                  # of the search for a shift at which signs are certain


class Counted(NamedTuple):
    """growing: how many grow; resting: how many do not oscillate, those that grow among them."""

    growing: int
    resting: int


class LowestModes:
    """A source of Modes: `numbered(first, last)`, `count(Omega)`, `counted_above(mode)`."""

    def __init__(self, elements: "FactoredSystem") -> None:
        self.elements = elements
        if form_of(elements) != SQUARES:
            require_dense(elements.n, "what turns, or a force that follows what it acts on,")
        self.scale, self.zeros = prepared(elements)
        if elements.massless:
            raise PhysicsError(f"the lowest modes of more than {MOST_DENSE} coordinates need an inertia at each of "
                               "them", "give every coordinate a mass")
        self.pencil = _pencil(elements, self.scale)
        if not self.pencil.least > 0:
            raise unmoved(int(np.argmin(self.pencil.M.assembled().diagonal())))
        self._slices: list[Slice] = []
        self._modes: list[Mode] = []
        self.ground = self._grounded()

    def numbered(self, first: int, last: int) -> list[Mode]:
        """The modes with an index from first to last, fewer where there are no more."""
        n = self.elements.n
        if first > n:
            raise PhysicsError(f"there is no mode {first}: this scene has {n} modes", "ask for one that it has")
        last, most = min(last, n), min(n // 4, LARGEST // n)
        if last > most:
            raise PhysicsError(f"mode {last} is asked for; of {n} coordinates the lowest {most} are found",
                               f"ask for {most} at most")
        while len(self._modes) < last:
            self._find(last - len(self._modes))
        return self._modes[max(first, 1) - 1:last]

    def count(self, Omega: float) -> int:
        """How many have ω ≤ Omega, those that grow and the rigid ones among them."""
        square, reach = math.ldexp(Omega, -self.scale.time) ** 2, 1
        while True:
            known = self.numbered(1, reach)
            if len(known) < reach or (known[-1].omega or 0.0) * (1 - known[-1].error) > Omega:
                return sum((mode.omega or 0.0) * (1 - mode.error) <= Omega for mode in known)
            factors = self.pencil.factors(square)
            reach = max(reach, 0 if factors is None else factors.below) + 1

    def counted_above(self, mode: Mode) -> int | None:
        """How many have at most the frequency of this one, certain."""
        known = self.numbered(1, mode.index)
        upper = mode.omega * (1 + mode.error)
        found: int = sum((other.omega or 0.0) * (1 - other.error) <= upper for other in self._modes[:len(known)])
        found += sum(other.omega * (1 - other.error) <= upper for other in self._modes[len(known):])
        return found

    def require_all(self) -> None:
        """The refusal of what needs all of them."""
        require_dense(self.elements.n, "what needs all modes")

    def _find(self, count: int) -> None:
        """Find more modes."""
        start = self._slices[-1].end if self._slices else None
        try:
            slices = lowest(self.pencil, count, self.zeros or 0, start)
        except (Unsettled, np.linalg.LinAlgError):
            raise _untold() from None
        for found in slices:
            self._slices.append(found)
            self._modes += self._of(found)

    def _of(self, found: "Slice") -> list[Mode]:
        """The Modes of a Slice."""
        (direction, full), out = in_units(found.vectors, self.scale), []
        errors = found.errors + DATA * (self.pencil.K.data_error(found.vectors)
                                        + abs(found.values) * self.pencil.M.data_error(found.vectors))
        for i, (value, error) in enumerate(zip(found.values.tolist(), errors.tolist(), strict=True)):
            index = found.before + i + 1
            if self.zeros is not None and index <= self.zeros:
                value, relative = 0.0, 0.0
            elif abs(value) <= 2 * error:
                value, relative = 0.0, 1.0
            else:
                relative = error / abs(value) * (0.5 + error / abs(value)) + 2 * UNIT
            rate = math.ldexp(math.sqrt(abs(value)), self.scale.time)
            rates = (None, rate) if value < 0 else (rate, None)
            out.append(Mode(index, *rates, full[:, i], direction[:, i], relative))
        return out

    def _grounded(self) -> Counted:
        """The Counted of those that do not oscillate, by structure or by counts beside zero."""
        if self.zeros is not None:
            return Counted(0, self.zeros)
        near = self.pencil.top * UNIT
        for _ in range(APART):
            sides = self.pencil.factors(-near), self.pencil.factors(near)
            if all(side is not None and side.margin < near for side in sides):
                return Counted(*(side.below for side in sides))
            near *= 2
        raise _untold()


def _untold() -> PhysicsError:
    return PhysicsError("the lowest frequencies are not told apart in floats: stiffnesses or masses differ too much, "
                        "or too many frequencies coincide",
                        f"take parts of the scene by themselves, of at most {MOST_DENSE} coordinates")


def _pencil(elements: "FactoredSystem", scale: Scaling) -> Pencil:
    """The Pencil of K̂ and M̂ in scaled coordinates."""
    K = _form(elements.n, elements.springs, elements.K, elements.K_size, scale, scale.stiffness)
    return Pencil(K, _form(elements.n, elements.inertias, elements.M, None, scale, scale.mass))


def _form(n: int, terms: Sequence[tuple[float, dict[int, float]]], entries: Mapping[tuple[int, int], float],
          size: Mapping[tuple[int, int], float] | None, scale: Scaling, power: int) -> SparseForm:
    """2^-power D (Σ w s sᵀ + entries) D, D the powers of two of the coordinates."""
    from scipy.sparse import csr_matrix

    powers = np.array(scale.coordinates)
    weights = np.ldexp(np.array([weight for weight, _ in terms], float), -power)
    counts = [len(row) for _, row in terms]
    columns = np.fromiter((i for _, row in terms for i in row), int, sum(counts))
    values = np.fromiter((x for _, row in terms for x in row.values()), float, sum(counts))
    starts = np.concatenate([[0], np.cumsum(counts, dtype=int)])
    rows = csr_matrix((np.ldexp(values, powers[columns]), columns, starts), (len(weights), n))

    def sparse(matrix: Mapping[tuple[int, int], float]) -> "csr_matrix | None":
        if not any(matrix.values()):
            return None
        i, j = np.array(list(matrix)).T
        data = np.ldexp(np.array(list(matrix.values()), float), powers[i] + powers[j] - power)
        return csr_matrix((data, (i, j)), (n, n))

    return SparseForm(weights, rows, sparse(entries), sparse(size or {}))
