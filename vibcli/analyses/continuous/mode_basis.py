"""Modes of members as coordinates η of a motion in time: Φᵀ ∂D/∂s² Φ = 1, so that each obeys η̈ + ω² η = Φᵀ f.

Fields within pieces, the projections ∫ μ φ u dx of what a motion starts with, and what a driven end brings,

    η̈ + ω² η = −Q s(t),      Q = (d(iω) · ends) at that end, the force that holds it in the mode (Green's identity).
"""

from collections import defaultdict
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.pieces.stiffness import stiffness

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.mechanics.factored_system import PlacedPiece

SAME = 1e-12        # of a length


class ModesOnPart(NamedTuple):
    """What modes number `modes` do on a part of a piece, from `start` of the piece on: κ of each, (modes,), and their
    end values, (modes, order)."""

    modes: np.ndarray
    start: float
    piece: Piece
    kappa: np.ndarray
    ends: np.ndarray

    def along(self, x: "float | np.ndarray") -> np.ndarray:
        """u and its derivatives at the distance x from the start of the whole piece, (…, modes, order)."""
        y = np.clip(np.asarray(x, float)[..., None] - self.start, 0.0, self.piece.length)
        return fields(self.piece, self.kappa, self.ends, y)

    def forces(self) -> np.ndarray:
        """Those that its ends need, (modes, order)."""
        return np.einsum("kab,kb->ka", stiffness(self.piece, self.kappa), self.ends)


class ModeBasis:
    """The first N modes: squares (N,) of ω, negative of what grows; shapes (n, N) over coordinates; parts[p]: the
    ModesOnParts of piece p; error: the largest relative bound of an ω."""

    def __init__(self, modes: "Sequence[Mode]", placed: "Sequence[PlacedPiece]"):
        self.placed = in_floats(placed)
        self.squares = np.array([float(mode.motion.z) for mode in modes])
        self.shapes = np.array([[float(x) for x in mode.shape] for mode in modes]).T.reshape(-1, len(modes))
        self.error = max((float(mode.error) for mode in modes), default=0.0)
        groups: dict = defaultdict(list)
        for number, mode in enumerate(modes):
            groups[id(mode.motion.system)].append((number, mode.motion))
        self.parts: list[list[ModesOnPart]] = [[] for _ in placed]
        for group in groups.values():
            self._divide(np.array([number for number, _ in group]), [motion for _, motion in group])

    def _divide(self, numbers, motions):
        """Adds the ModesOnParts of modes whose pieces are divided in the same way."""
        shapes = np.array([[float(x) for x in motion.shape] for motion in motions])
        for one in in_floats(motions[0].system.ordered):
            kappa = one.piece.foundation - one.piece.inertia * self.squares[numbers]
            home, part = on_part(self.placed, one, numbers, kappa, shapes)
            self.parts[home].append(part)

    def field(self, piece: int, x: "float | np.ndarray", along: int = 0) -> np.ndarray:
        """The along-th derivative by x of all modes at x of a piece, (…, N)."""
        found = np.zeros((*np.shape(x), self.shapes.shape[1]), self.shapes.dtype)
        for part in self.parts[piece]:
            inside = (np.asarray(x) >= part.start - SAME * part.piece.length) & (
                np.asarray(x) <= part.start + part.piece.length * (1 + SAME))
            if inside.any():
                values = part.along(x)[..., along]
                found[..., part.modes] = np.where(np.asarray(inside)[..., None], values, found[..., part.modes])
        return found

    def rows(self, output: "LinearOutput") -> np.ndarray:
        """(3, N): what an output reads of each η, η̇ and η̈."""
        found = np.zeros((3, self.shapes.shape[1]), self.shapes.dtype)
        for row, part in zip(found, (output.q, output.v, output.a), strict=True):
            for i, x in part.items():
                row += x * self.shapes[i]
        for place, x in output.places.items():
            found[place.rates] += x * self.field(place.piece, place.x, place.along)
        return found

    def end_forces(self, piece: int, end: int) -> np.ndarray:
        """(N,): the force that an end value of a piece needs in each mode."""
        found, length = np.zeros(self.shapes.shape[1], self.shapes.dtype), self.placed[piece].piece.length
        half = self.placed[piece].piece.order // 2
        for part in self.parts[piece]:
            last = part.start + part.piece.length >= (1 - SAME) * length
            if (end < half and part.start <= SAME * length) or (end >= half and last):
                found[part.modes] = part.forces()[:, end]
        return found


def in_floats(placed: "Sequence[PlacedPiece]") -> "list[PlacedPiece]":
    """The same in floats."""
    return [one._replace(start=float(one.start), piece=one.piece._make(float(x) for x in one.piece),
                         rows=tuple({i: float(x) for i, x in row.items()} for row in one.rows)) for one in placed]


def on_part(placed: "Sequence[PlacedPiece]", one: "PlacedPiece", numbers: np.ndarray, kappa: np.ndarray,
            shapes: np.ndarray) -> tuple[int, ModesOnPart]:
    """What modes do on a piece, a part of one of those placed, and the number of that; shapes (modes, coordinates)."""
    home = next(p for p, whole in enumerate(placed) if whole.owner == one.owner
                and -SAME * whole.piece.length <= one.start - whole.start < (1 - SAME) * whole.piece.length)
    ends = np.stack([shapes @ _row(row, shapes.shape[1]) for row in one.rows], axis=-1)
    return home, ModesOnPart(numbers, one.start - placed[home].start, one.piece, kappa, ends)


def _row(row, n):
    found = np.zeros(n)
    for i, x in row.items():
        found[i] = x
    return found
