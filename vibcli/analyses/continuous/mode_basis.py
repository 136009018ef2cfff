"""Modes of members as coordinates η of a motion in time: Φᵀ ∂D/∂s² Φ = 1, so that each obeys η̈ + ω² η = Φᵀ f.

Fields within pieces, the projections ∫ μ φ u dx of what a motion starts with, and what a driven end brings,

    η̈ + ω² η = −Q s(t),      Q = (d(iω) · ends) at that end, the force that holds it in the mode (Green's identity).
"""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.short_pieces import relative_coordinates
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.pieces.relative import (
    cantilever,
    leaning,
    relative_fields,
    relative_stiffness,
    told,
)
from vibcli.numerics.pieces.stiffness import stiffness

if TYPE_CHECKING:
    from vibcli.analyses.continuous.natural_frequencies import NaturalFrequency
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.mechanics.factored_system import PlacedPiece

SAME = 1e-12        # of a length
INSIDE = 1e-3       # of a part of a piece: what no division of pieces is as near to their ends as
INNER = np.array([0.0, 0.21, 0.5, 0.83, 1.0])    # parts of a piece that show how large a field is
ROUNDED = 2.0**-48  # of a field, where that is largest
PHASE = 2.0**-49    # of λ, to which it is found
LEAST = 8.0         # turns that the lowest complex modes have at least, as what rounds in D is felt in their λ
FORCES = 4.0        # times that is felt in what they bear: at their ends no coordinate holds that, as it does u
PLACED = 2.0**-51   # of a place, which is rounded as the difference of two
HELD = 1e-36, 1e36  # ω in rad/s, of whose eighth powers floats hold what sums over modes need


class ModesOnPart(NamedTuple):
    """What modes number `modes` do on a part of a piece, from `start` of the piece on: κ of each, (modes,), and their
    end values, (modes, order); bends: u₀, θ₀, F, P of a short piece of a beam, (modes, 4)."""

    modes: np.ndarray
    start: float
    piece: Piece
    kappa: np.ndarray
    ends: np.ndarray
    bends: np.ndarray | None = None

    def along(self, x: "float | np.ndarray") -> np.ndarray:
        """u and its derivatives at the distance x from the start of the whole piece, (…, modes, order)."""
        y = np.clip(np.asarray(x, float)[..., None] - self.start, 0.0, self.piece.length)
        found = fields(self.piece, self.kappa, self.ends, y)
        if self.bends is None:
            return found
        long = told(self.piece, self.kappa)
        found[..., long, :] = relative_fields(self.piece, self.kappa[long], self.bends[long],
                                              np.broadcast_to(y, found.shape[:-1])[..., long])
        return found

    def told_by(self, along: int) -> np.ndarray:
        """How large end values are together in what tells a derivative inside, (modes,): each rounds by itself."""
        half, length = self.piece.order // 2, self.piece.length
        if along < half:
            return np.zeros(len(self.modes))
        sizes = (abs(self.ends) * ([1.0] if half == 1 else [1.0, length / 2] * 2)).sum(axis=1)
        far = (1.0 if half == 1 else 6.0 * (along - 1)) * sizes / length**along
        return far if self.bends is None else np.where(told(self.piece, self.kappa), 0.0, far)

    def turns(self) -> np.ndarray:
        """How many times what λ is off by is felt in how far waves turn along it, (modes,): β ~ λ, of beams √λ."""
        long, steep = abs(self.kappa) * self.piece.length**2, abs(self.piece.tension)
        if self.piece.order == 2:
            return np.sqrt(long / steep) if steep else np.zeros(len(long))
        return cast("np.ndarray", 0.5 * (long / self.piece.bending) ** 0.25 * self.piece.length**0.5)

    def forces(self) -> np.ndarray:
        """Those that its ends need, (modes, order)."""
        found: np.ndarray = np.einsum("kab,kb->ka", stiffness(self.piece, self.kappa), self.ends)
        if self.bends is None:
            return found
        long = told(self.piece, self.kappa)
        d, bends = relative_stiffness(self.piece, self.kappa[long], False)[0], self.bends[long]
        own = np.einsum("kab,kb->ka", d, leaning(self.piece, bends))
        own[:, 2:] += bends[:, 2:]
        own[:, 0] -= own[:, 2]
        own[:, 1] -= self.piece.length * own[:, 2] + own[:, 3]
        found[long] = own
        return found


class ModeBasis:
    """The first N modes: squares (N,) of ω, negative of what grows; shapes (n, N) over coordinates; parts[p]: the
    ModesOnParts of piece p; errors: relative bounds of ω, (N,); numbers: those that modes share whose shapes, next to
    each other, are orthogonal; blurred: √ of what rounds at each coordinate, as a part of
    ω, and at all further nodes, (N, n + 1)."""

    def __init__(self, modes: "Sequence[Mode]", placed: "Sequence[PlacedPiece]",
                 numbers: np.ndarray | None = None) -> None:
        self.placed = in_floats(placed)
        self.squares = np.array([float(mode.motion.z) for mode in modes])
        _require_held(abs(self.squares).max(initial=0.0) ** 0.5)
        self.shapes = np.array([_whole(mode.motion)[:len(mode.shape)] for mode in modes]).T.reshape(-1, len(modes))
        self.errors = np.array([float(mode.error) for mode in modes])
        self.numbers = np.arange(len(modes)) if numbers is None else numbers
        self.blurred = _blurred(modes)
        self._sizes: dict[tuple[int, int], np.ndarray] = {}
        groups: dict[int, list[tuple[int, Any]]] = defaultdict(list)
        for number, mode in enumerate(modes):
            groups[id(mode.motion.system)].append((number, mode.motion))
        self.parts: list[list[ModesOnPart]] = [[] for _ in placed]
        for group in groups.values():
            self._divide(np.array([number for number, _ in group]), [motion for _, motion in group])

    def _divide(self, numbers: np.ndarray, motions: "list[NaturalFrequency]") -> None:
        """Adds the ModesOnParts of modes whose pieces are divided in the same way."""
        shapes = np.array([_whole(motion) for motion in motions])
        left = _bends(motions)
        for place, one in enumerate(in_floats(motions[0].system.ordered)):
            kappa = one.piece.foundation - one.piece.inertia * self.squares[numbers]
            home, part = on_part(self.placed, one, numbers, kappa, shapes, left.get(place))
            self.parts[home].append(part)

    def field(self, piece: int, x: "float | np.ndarray", along: int = 0) -> np.ndarray:
        """The along-th derivative by x of all modes at x of a piece, (…, N)."""
        found = np.zeros((*np.shape(x), self.shapes.shape[1]), self.shapes.dtype)
        for part in self.parts[piece]:
            off = self._off(piece)
            inside = (np.asarray(x) >= part.start - off) & (np.asarray(x) <= part.start + part.piece.length + off)
            if inside.any():
                values = part.along(x)[..., along]
                found[..., part.modes] = np.where(np.asarray(inside)[..., None], values, found[..., part.modes])
        return found

    def _off(self, piece: int) -> float:
        """What places on a piece are rounded by."""
        whole = self.placed[piece]
        return cast("float", SAME * whole.piece.length + PLACED * (abs(whole.start) + whole.piece.length))

    def rows(self, output: "LinearOutput") -> np.ndarray:
        """(3, N): what an output reads of each η, η̇ and η̈."""
        found = np.zeros((3, self.shapes.shape[1]), self.shapes.dtype)
        for row, part in zip(found, (output.q, output.v, output.a), strict=True):
            for i, x in part.items():
                row += x * self.shapes[i]
        for place, x in output.places.items():
            found[place.rates] += x * self.field(place.piece, place.x, place.along)
        return found

    def lost(self, output: "LinearOutput") -> np.ndarray:
        """(3, N): what rounding leaves of these rows, of how large each is along its piece."""
        found = np.zeros((3, self.shapes.shape[1]))
        for row, part in zip(found, (output.q, output.v, output.a), strict=True):
            for i, x in part.items():
                row += abs(x) * self._size_of(i)
        for place, x in output.places.items():
            found[place.rates] += abs(x) * self._size(place.piece, place.along)
        return ROUNDED * found

    def _size_of(self, coordinate: int) -> np.ndarray:
        """How large what a coordinate is, u or a slope, is along the pieces that it moves."""
        ends = [(p, end % (one.piece.order // 2)) for p, one in enumerate(self.placed)
                for end, row in enumerate(one.rows) if row.get(coordinate)]
        largest = np.max([self._size(*end) for end in ends], axis=0, initial=0.0)
        return np.asarray(largest + abs(self.shapes[coordinate]))

    def _size(self, piece: int, along: int) -> np.ndarray:
        """The largest of a derivative along a piece, in each mode, as often as it rounds, (N,)."""
        if (piece, along) not in self._sizes:
            found = self._sizes[piece, along] = np.zeros(self.shapes.shape[1])
            for part in self.parts[piece]:
                values = abs(part.along(part.start + part.piece.length * INNER)[..., along]).max(axis=0)
                turns = part.turns()
                if np.iscomplexobj(self.shapes):
                    turns = (turns + LEAST) * (FORCES if along >= part.piece.order // 2 else 1.0)
                often = 1.0 + PHASE / ROUNDED * turns
                found[part.modes] = np.maximum(found[part.modes], often * np.maximum(values, part.told_by(along)))
        return self._sizes[piece, along]

    def end_forces(self, piece: int, end: int) -> np.ndarray:
        """(N,): the force that an end value of a piece needs in each mode."""
        found, length = np.zeros(self.shapes.shape[1], self.shapes.dtype), self.placed[piece].piece.length
        half, off = self.placed[piece].piece.order // 2, self._off(piece)
        for part in self.parts[piece]:
            last = part.start + part.piece.length >= length - off
            if (end < half and part.start <= off) or (end >= half and last):
                found[part.modes] = part.forces()[:, end]
        return found


def _require_held(highest: float) -> None:
    """PhysicsError of frequencies whose powers leave the floats."""
    if highest and not HELD[0] < highest < HELD[1]:
        raise PhysicsError(f"motions are summed over modes up to ω = {highest:.1e} rad/s, whose powers leave what "
                           "floats hold", "look for lengths, stiffnesses and masses of very different size")


def in_floats(placed: "Sequence[PlacedPiece]") -> "list[PlacedPiece]":
    """The same in floats."""
    return [one._replace(start=float(one.start), piece=one.piece._make(float(x) for x in one.piece),
                         rows=tuple({i: float(x) for i, x in row.items()} for row in one.rows)) for one in placed]


def on_part(placed: "Sequence[PlacedPiece]", one: "PlacedPiece", numbers: np.ndarray, kappa: np.ndarray,
            shapes: np.ndarray, bends: np.ndarray | None = None) -> tuple[int, ModesOnPart]:
    """What modes do on a piece, a part of one of those placed, and the number of that; shapes (modes, coordinates)."""
    home = max((p for p, whole in enumerate(placed) if whole.owner == one.owner
                and whole.start <= one.start + INSIDE * one.piece.length), key=lambda p: placed[p].start)
    ends = np.stack([shapes @ _row(row, shapes.shape[1]) for row in one.rows], axis=-1)
    return home, ModesOnPart(numbers, one.start - placed[home].start, one.piece, kappa, ends, bends)


def _blurred(modes: "Sequence[Mode]") -> np.ndarray:
    """Those at further nodes at one more coordinate; of rigid motions and closed forms none."""
    found = np.zeros((len(modes), len(modes[0].shape) + 1 if len(modes) else 0))
    for row, mode in zip(found, modes, strict=True):
        if mode.motion.blurred is not None:
            row[:-1] = mode.motion.blurred[:len(row) - 1]
            row[-1] = np.linalg.norm(mode.motion.blurred[len(row) - 1:])
    return found


def _whole(motion: "NaturalFrequency") -> np.ndarray:
    """A shape in floats, over the coordinates of the scene and those of further nodes."""
    shape = motion.shape if motion.whole is None else motion.system.in_scene(motion.whole)
    return shape if shape.dtype == float else np.array([float(x) for x in shape])


def _bends(motions: "Sequence[NaturalFrequency]") -> dict[int, np.ndarray]:
    """u₀, θ₀, F, P of short pieces, {place of the piece: (modes, 4)}; from shapes in more digits where there are."""
    system = motions[0].system
    if system.near is not None and motions[0].whole is not None:
        return system.bends(np.array([float(motion.z) for motion in motions]),
                            np.array([motion.whole for motion in motions]))
    if system.digits is None:
        return {}
    from vibcli.analyses.continuous.mode_source import working

    found = {}
    with working(system.digits):
        for number in relative_coordinates(system.ordered).short:
            one = system.ordered[number]
            u, turn, end, last = ([sum(x * motion.shape[i] for i, x in row.items()) for motion in motions]
                                  for row in one.rows)
            away = [b - a - one.piece.length * slope for a, slope, b in zip(u, turn, end, strict=True)]
            found[number] = np.array([u, turn, *(cantilever(one.piece) @ [away, np.subtract(last, turn)])], float).T
    return found


def _row(row: Mapping[int, float], n: int) -> np.ndarray:
    found = np.zeros(n)
    for i, x in row.items():
        found[i] = x
    return found
