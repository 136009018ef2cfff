"""Where Laplace images of members in time are infinite: the roots p of the determinant of their equations, in floats.

Without what damps they are iω, between which the determinant, real but for the factor that each pair of running waves
has, changes its sign; what damps moves them from there on, little by little. Each is followed by

    p ← p − wᵀ A v / wᵀ A′ v,       A v ≈ 0 ≈ wᵀ A

(two-sided iteration, Ostrowski 1959), the last time in NumPy's longest floats, with v and w of usual ones.
"""

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.member_images import MemberImages
from vibcli.evidence.reference.member_starts import StartedMembers

if TYPE_CHECKING:
    import mpmath

BLOCK = 2048            # half waves in the pieces, the poles up to which are found together
LOW, FIRST = 1e-4, 400      # of the first wave that fits in, where frequencies are looked for, and at how many places
FINE, HALVINGS = 12, 5      # places to a half wave, and halvings between two
PARTS, STEPS, LAST = 6, 2, 3        # in which what damps is put on, and steps of the two-sided iteration at each
SLOPE = 3e-4            # of the distance between two: steps by which A′ is a difference
UNIT = 1e-15            # of what a residue is summed of, by its number: what v, w and A′ in floats leave
NUDGE = 1e-15           # of the largest entry: what keeps an equation from being exactly singular


class NearPoles(NamedTuple):
    """p above the real line, a row each of v and w, and the distance to the next."""

    p: np.ndarray
    v: np.ndarray
    w: np.ndarray
    apart: np.ndarray


def in_floats(members: StartedMembers, kind: Any = float) -> StartedMembers:
    """The same in floats, of a kind of NumPy's."""
    def number(x: "mpmath.mpf") -> float:
        return cast("float", kind(str(x)))

    def numbers(part: "Mapping[int, mpmath.mpf]") -> "dict[int, float]":
        return {i: number(x) for i, x in part.items()}

    row = members.row and members.row._replace(q=numbers(members.row.q), v=numbers(members.row.v),
                                               a=numbers(members.row.a))
    places, speeds = ([number(x) for x in part] for part in members.start)
    place = members.place and members.place._replace(share=number(members.place.share),
                                                     factor=number(members.place.factor))
    return members._replace(
        elements=members.elements.each(number), start=(places, speeds),
        fields=[(u.in_floats(), rate.in_floats()) for u, rate in members.fields], row=row, place=place,
        inputs={i: [part._replace(start=number(part.start), function=part.function.in_floats()) for part in parts]
                for i, parts in members.inputs.items()},
        spread=[part._replace(along=part.along.in_floats()) for part in members.spread],
        holding=numbers(members.holding))


def damped_in_part(members: StartedMembers, share: float) -> StartedMembers:
    """The same with a share of what damps it."""
    elements = members.elements
    pieces = [placed._replace(piece=placed.piece._replace(drag=share * placed.piece.drag))
              for placed in elements.pieces]
    return members._replace(elements=elements.with_parts(
        dampers=tuple((share * c, row) for c, row in elements.dampers), pieces=pieces,
        C={pair: share * x for pair, x in elements.C.items()},
        drag={pair: share * x for pair, x in elements.drag.items()}))


def arrays(members: StartedMembers, s: np.ndarray) -> np.ndarray:
    """A at many s."""
    images = MemberImages(members, s, np)
    found = np.zeros((*s.shape, images.size, images.size), s.dtype)
    for (i, j), x in images.whole().items():
        found[..., i, j] = x
    return found


class PoleSearch:
    """The poles of StartedMembers, block by block."""

    def __init__(self, members: StartedMembers) -> None:
        self.members, self.finest = in_floats(members), in_floats(members, np.longdouble)
        self._plain = damped_in_part(self.members, 0.0)
        self._pieces = [placed.piece for placed in self.members.elements.pieces]
        self._known: dict[int, NearPoles] = {}

    @property
    def cost(self) -> int:
        """Of a block, in entries of matrices."""
        elements = self.members.elements
        size = elements.n + sum(piece.order for piece in self._pieces)
        return cast("int", BLOCK * size**2 * (FINE + 4 * (LAST + STEPS * (PARTS - 1) * bool(elements.damps))))

    def waves(self, omega: np.ndarray) -> np.ndarray:
        """How many half waves fit into the pieces, of waves that run: about as many frequencies are below."""
        images = MemberImages(self._plain, 1j * omega, np)
        found: np.ndarray = sum(np.where(_runs(k), np.abs(k.imag), 0.0) * piece.length
                                for piece, waves in zip(self._pieces, images.waves, strict=True) for k in waves) / np.pi
        return found

    def block(self, number: int) -> NearPoles:
        """Those of one block, the lowest being number 0."""
        if number not in self._known:
            omega = self._frequencies(number)
            p, apart = 1j * omega, np.gradient(omega)
            parts = range(1, PARTS + 1) if self.members.elements.damps else [PARTS]
            for part in parts:
                members = damped_in_part(self.members, part / PARTS)
                for _ in range(LAST if part == PARTS else STEPS):
                    p, v, w = self._step(members, p, apart)
            self._known[number] = NearPoles(p, v, w, apart)
        return self._known[number]

    @cached_property
    def _first(self) -> float:
        """An ω at which half a wave fits into the pieces."""
        omega = 1.0
        while self.waves(np.array([omega]))[0] > 0.5:
            omega /= 2
        while self.waves(np.array([omega]))[0] < 0.5:
            omega *= 2
        return omega

    def _frequencies(self, number: int) -> np.ndarray:
        """Without what damps, by signs on a grid."""
        low = top = self._first
        while self.waves(np.array([top]))[0] < (number + 1) * BLOCK + 1:
            top *= 2
        known = np.geomspace(low, top, 60 * int(np.log2(top / low)) + 2)
        lowest = number * BLOCK if number else self.waves(np.array([low]))[0]
        places = np.linspace(lowest, (number + 1) * BLOCK, int(((number + 1) * BLOCK - lowest) * FINE) + 1)
        grid = np.interp(places, self.waves(known), known)
        if not number:
            grid = np.concatenate([np.geomspace(LOW * low, low, FIRST, endpoint=False), grid])
        sign, running = self._sign(grid), self._running(grid)
        here = np.flatnonzero((sign[:-1] != sign[1:]) & (running[:-1] == running[1:]))
        low, high, below = grid[here], grid[here + 1], sign[here]
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            same = self._sign(middle) == below
            low, high = np.where(same, middle, low), np.where(same, high, middle)
        return (low + high) / 2

    def _running(self, omega: np.ndarray) -> Any:
        """How many waves run: where one begins to, on a foundation, its two ways are one, which is no pole."""
        images = MemberImages(self._plain, 1j * omega, np)
        return sum(_runs(k).astype(int) for waves in images.waves for k in waves)

    def _sign(self, omega: np.ndarray) -> np.ndarray:
        """Of the determinant at iω, each pair of waves e^{∓ikx} counted as sine and cosine."""
        images = MemberImages(self._plain, 1j * omega, np)
        turned = np.ones(len(omega), complex)
        for piece, waves in zip(self._pieces, images.waves, strict=True):
            for k in waves:
                turned *= np.where(_runs(k), 1j * np.exp(1j * k.imag * piece.length), 1)
        sign = np.linalg.slogdet(balanced(arrays(self._plain, 1j * omega))[0])[0] * turned
        found: np.ndarray = np.where(np.abs(sign.real) > np.abs(sign.imag), np.sign(sign.real), np.sign(sign.imag))
        return found

    def _step(self, members: StartedMembers, p: np.ndarray,
              apart: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        A = arrays(members, p)
        scaled, rows, columns = balanced(A)
        v, w = null_vectors(scaled) * columns, null_vectors(np.swapaxes(scaled, -1, -2)) * rows
        return p - _form(w, A, v) / _form(w, _slope(members, p, apart), v), v, w

    def with_residues(self, number: int, members: StartedMembers,
                      sources: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(p in longer floats, residues of the signal of `members`, each source a row, what rounding may leave of them)
        of a block; sources: of MemberImages, [(right side, fields)]."""
        p, v, w, apart = self.block(number)
        longer = p.astype(np.clongdouble)
        rise = _form(w, _slope(self.finest, longer, apart), v)
        images = MemberImages(members, p, np)
        seen = images.signal(v.T) / rise
        terms = [[w[:, i] * x for i, x in enumerate(right)] for right, _ in sources(images)]
        sizes = [sum(map(np.abs, part)) * np.maximum.accumulate(np.abs(seen)) for part in terms]
        rounding = UNIT * (number * BLOCK + 1 + np.arange(len(p))) * np.array(sizes, float)
        return (longer - _form(w, arrays(self.finest, longer), v) / rise,
                np.array([sum(part) * seen for part in terms], np.clongdouble), rounding)


def _runs(k: np.ndarray) -> np.ndarray:
    """Of waves e^{∓kx}, as none of those do that a foundation holds back."""
    return cast("np.ndarray", np.abs(k.real) < 1e-9 * np.abs(k.imag))


def _slope(members: StartedMembers, p: np.ndarray, apart: np.ndarray) -> np.ndarray:
    """A′"""
    step = 1j * SLOPE * apart
    one, two = (arrays(members, p + k * step) - arrays(members, p - k * step) for k in (1, 2))
    return cast("np.ndarray", (8 * one - two) / (12 * step)[:, None, None])


def _form(w: np.ndarray, A: np.ndarray, v: np.ndarray) -> np.ndarray:
    return cast("np.ndarray", ((A * v[:, None, :]).sum(-1) * w).sum(-1))


def balanced(A: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(D A E, D, E) with largest entries of 1 in each row, then in each column."""
    rows = 1 / np.abs(A).max(axis=-1)
    A = A * rows[..., None]
    columns = 1 / np.abs(A).max(axis=-2)
    return A * columns[..., None, :], rows, columns


def null_vectors(A: np.ndarray) -> np.ndarray:
    """v of A v ≈ 0, by inverse iteration."""
    v = np.exp(1j * np.arange(A.shape[-1]) ** 2) * np.ones(A.shape[:-1], complex)
    A = A + NUDGE * np.eye(A.shape[-1])
    for _ in range(2):
        v = np.linalg.solve(A, v[..., None])[..., 0]
        v /= np.abs(v).max(axis=-1)[..., None]
    return v
