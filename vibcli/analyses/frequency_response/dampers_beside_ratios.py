"""The frequency response of a scene with members whose modes have ratios, beside dampers C at some of its coordinates.

With H₀ what answers without dampers, by the ratios of the modes without them, T the coordinates that C holds to, y an
output, u an input with displacements g of supports, the dampers pull with s f (Woodbury's identity):

    H = H₀[y, u] − s H₀[y, T] f,      (1 + s C H₀[T, T]) f = C H₀[T, u] + C_u g.
"""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix
from vibcli.analyses.frequency_response.counted_zeros import CountedPoles, CountedRoots, counted_among
from vibcli.analyses.frequency_response.damped_member_response import BEYOND, DampedMemberTransfer
from vibcli.analyses.frequency_response.member_poles_and_zeros import ABOVE, LOWEST, distinct, followed
from vibcli.analyses.frequency_response.member_response import MemberTransfer
from vibcli.analyses.frequency_response.member_system import MemberInput, MemberOutput, MemberSystem
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.continuous.member_damping import MemberDamping
    from vibcli.analyses.modal.mode_sequence import Modes

UNIT, SOLVED = 2.0**-52, 16.0       # roundings of a small system
ASIDE = 1e-6        # relative step of a difference about a pole
COUPLED, FEWEST = 4.0, 64       # times a frequency: modes up to there move with a pole; modes


class DampersBesideRatios(DampedMemberTransfer):
    """still: the MemberTransfer with dampers and without ratios; counted: the damped modes."""

    __slots__ = ("_C", "_counted", "_forced", "_g", "_held", "_kept", "_plain", "_read", "_shared")

    def __init__(self, still: MemberTransfer, modes: "Modes", damping: "MemberDamping", driven: bool, turns: int,
                 counted: "Modes") -> None:
        super().__init__(still.without_damping, modes, damping, driven, turns)
        self._counted, self._kept = counted, {}
        system = still.system
        C, free, inputs = system.matrix.polynomial[1], system.free, system.driven
        held = np.array([i for i in free if C[i, free].any() or C[free, i].any() or C[i, inputs].any()], int)
        g = np.array([system.given.weights.get(j, 0.0) for j in inputs])
        self._held, self._C, self._g = held, C[np.ix_(held, held)], C[np.ix_(held, inputs)] @ g
        loaded = _with_loads(self.still.system, held)

        def one(output: MemberOutput, given: MemberInput, by_supports: bool = False) -> DampedMemberTransfer:
            plain = MemberTransfer(_between(*loaded, output, given), self.still.marks)
            return DampedMemberTransfer(plain, modes, damping, by_supports, 0)

        numbers = range(loaded[0].n - len(held), loaded[0].n)
        loads = [MemberInput({number: 1.0}) for number in numbers]
        seen = [MemberOutput(({i: 1.0}, {}, {})) for i in held]
        output, given = system.output, system.given._replace(turns=0)
        self._plain = one(output, given, driven)
        self._read = [one(output, load) for load in loads]
        self._forced = [one(row, given, driven) for row in seen]
        self._shared = [[one(row, load) for load in loads] for row in seen]

    def _parts(self, s: np.ndarray,
               of: Callable[..., np.ndarray]) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """H₀[y, u] (N,), H₀[y, T] (N, T), H₀[T, u] (N, T), H₀[T, T] (N, T, T), or their bounds."""
        shared = [np.stack([of(one) for one in row], axis=-1) for row in self._shared]
        return (of(self._plain), np.stack([of(one) for one in self._read], axis=-1),
                np.stack([of(one) for one in self._forced], axis=-1), np.stack(shared, axis=-2))

    def _values(self, s: np.ndarray) -> np.ndarray:
        if not len(s):
            return s
        plain, read, forced, shared = self._parts(s, lambda one: one._values(s))
        pull = self._pulls(s, forced, shared)
        return np.asarray((-s * s)**self.turns * (plain - s * np.einsum("nt,nt->n", read, pull)))

    def _pulls(self, s: np.ndarray, forced: np.ndarray, shared: np.ndarray) -> np.ndarray:
        """f, (N, T)."""
        whole = np.eye(len(self._C)) + s[:, None, None] * (self._C @ shared)
        return np.linalg.solve(whole, (forced @ self._C.T + self._g)[:, :, None])[:, :, 0]

    @property
    def drifting(self) -> None:
        """It is not found."""

    def poles(self, low: float = 0.0, high: float = math.inf) -> np.ndarray:
        """The damped modes; where these are not told those of the modes without dampers that C couples, polished where
        Newton's method settles."""
        high = high if math.isfinite(high) else self.end
        found = self._told(high) if math.isfinite(high) else np.zeros(0, complex)
        if found is None:
            counted = self._counted_up_to(high)
            found = self._followed(high) if counted is None else counted.poles
        return found[(found.imag >= low) & (found.imag <= high)]

    def _told(self, high: float) -> np.ndarray | None:
        """The damped modes of so high a frequency, by Im λ; None where they are not told."""
        try:
            modes = self._counted.numbered(1, max(len(self._counted.up_to(BEYOND * high)), 1))
        except PhysicsError:
            return None
        found = np.array([mode.eigenvalue for mode in modes if mode.omega_d], complex)
        return found[np.argsort(found.imag)]

    def _told_up_to(self, high: float) -> CountedPoles | None:
        top = ABOVE * high
        return self._counted_up_to(top) if self._told(top) is None else super()._told_up_to(high)

    def _counted_up_to(self, high: float) -> CountedPoles | None:
        """The CountedPoles as zeros of det(1 + s C H₀[T, T]), whose poles are those without dampers; None where the
        count does not tell."""
        if high not in self._kept:
            own, known = super().poles(0.0, BEYOND * high), self._followed(high)
            roots = CountedRoots(self._steepness, [self._to_pole], own, known)
            try:
                self._kept[high] = counted_among(roots, known, LOWEST * self.pace, high)
            except PhysicsError:
                self._kept[high] = None
                self.leave_uncounted("poles")
        found: CountedPoles | None = self._kept[high]
        return found

    def _followed(self, high: float) -> np.ndarray:
        estimates = self._coupled(high)
        polished = [followed(self._to_pole, np.array([s])) for s in estimates]
        return distinct([one[0] if len(one) else s for one, s in zip(polished, estimates, strict=True)])

    def _coupled(self, high: float) -> np.ndarray:
        """Im λ > 0 of λ² + λ (c + Φᵀ C Φ) + ω² = 0 over the modes up to a multiple of a frequency."""
        modes = self._modes.first(max(FEWEST, len(self._modes.up_to(COUPLED * high))))
        shapes = np.array([[float(mode.shape[i]) for mode in modes] for i in self._held])
        c = np.diag([float(self.damping.rate(mode)) for mode in modes]) + shapes.T @ self._C @ shapes
        squares = np.diag([float(mode.omega or 0.0)**2 for mode in modes])
        found = np.linalg.eigvals(np.block([[np.zeros_like(c), np.eye(len(c))], [-squares, -c]]))
        return found[(found.imag > 0) & (found.imag <= BEYOND * high)]

    def _to_pole(self, s: np.ndarray) -> np.ndarray:
        return -1 / self._steepness(s)

    def _steepness(self, s: np.ndarray) -> np.ndarray:
        """f′/f of f = det(1 + s C H₀[T, T])."""
        ahead, behind = (self._determinant(s * (1 + side * ASIDE)) for side in (1, -1))
        found: np.ndarray = (ahead - behind) / (2 * ASIDE * s * self._determinant(s))
        return found

    def _determinant(self, s: np.ndarray) -> np.ndarray:
        """det(1 + s C H₀[T, T])."""
        shared = np.stack([np.stack([one._values(s) for one in row], axis=-1) for row in self._shared], axis=-2)
        found: np.ndarray = np.linalg.det(np.eye(len(self._C)) + s[:, None, None] * (self._C @ shared))
        return found

    def error(self, Omega: float) -> float:
        """|δH| of bounds E of H₀, to first order, and of what solving for f rounds."""
        s = np.array([1j * Omega])
        plain, read, forced, shared = (x[0] for x in self._parts(s, lambda one: one._values(s)))
        lost = self._parts(s, lambda one: np.array([one.error(Omega)]))
        e_plain, e_read, e_forced, e_shared = (x[0] for x in lost)
        pull = np.abs(self._pulls(s, forced[None], shared[None])[0])
        inverse = np.linalg.inv(np.eye(len(self._C)) + s[0] * (self._C @ shared))
        back = abs(Omega) * np.abs(read @ inverse)
        moved = np.abs(self._C) @ (e_forced + abs(Omega) * e_shared @ pull)
        size = np.abs(self._C) @ (np.abs(forced) + abs(Omega) * np.abs(shared) @ pull) + np.abs(self._g) + pull
        rounded = SOLVED * UNIT * len(pull) * size
        found = e_plain + abs(Omega) * e_read @ pull + back @ (moved + rounded)
        found += 8 * UNIT * (abs(plain) + abs(Omega) * np.abs(read) @ pull)
        return float(found) * abs(Omega)**(self.order + 2 * self.turns)


def _with_loads(system: MemberSystem, held: np.ndarray) -> "tuple[DynamicMatrix, np.ndarray]":
    """(the matrix with a further input for a load along each of some coordinates, the numbers of all inputs)."""
    matrix, n = system.matrix, system.matrix.n
    polynomial = np.pad(matrix.polynomial, ((0, 0), (0, len(held)), (0, len(held))))
    for number, i in enumerate(held, n):
        polynomial[0, i, number] = -1.0
    return (DynamicMatrix(polynomial, matrix.pieces, matrix.spread),
            np.array([*system.driven, *range(n, n + len(held))], int))


def _between(matrix: DynamicMatrix, driven: np.ndarray, output: MemberOutput, given: Any) -> MemberSystem:
    return MemberSystem(matrix, driven, given, output)
