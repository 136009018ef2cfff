"""Modes along members at single places, in floats or in mpmath's numbers where the mode has more digits, and the factor
that normalises a shape. Pieces without inertia deflect as at rest between their stations.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.shapes import Moved, antinodes_and_displacements, resting_and_turning, shape_along
from vibcli.analyses.modal.normalisation import sign
from vibcli.base.errors import PhysicsError
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.piece import Piece
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.modal.undamped import Mode
    from vibcli.elements.member import Member
    from vibcli.elements.member_line import Station
    from vibcli.elements.member_segments import MemberSegment
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SAME = 1e-9         # of a length or displacement: nearer ones are one
SHARES = np.append(np.arange(1, 62) * 0.6180339887498949 % 1, [0.0, 1.0])
ALLOWED, PLACE = 1e-11, 1e-15       # what a shape is off in any case, as a part; a place and what is reckoned of it
STEPS = 8           # of Newton's method, from a place that is known in floats


class ModeFields:
    """A mode along the members of a scene, as its shape is: of unit modal mass. arithmetic, values: the numbers at
    rest; number: makes one of them of any."""

    def __init__(self, mode: "Mode", scene: "Scene", arithmetic: Any, values: Any,
                 number: Callable[[Any], Any] = float) -> None:
        self.mode, self.scene, self.arithmetic, self.values, self.number = mode, scene, arithmetic, values, number
        self._known: dict[Any, Any] = {}

    def _kept(self, what: Callable[..., Any], member: Any) -> Any:
        """What is asked several times of a member."""
        if (what, member) not in self._known:
            self._known[what, member] = what(member)
        return self._known[what, member]

    def pieces(self, member: str) -> list[Moved]:
        """Those of a member from left to right, as they move."""
        return cast("list[Moved]", self._kept(self._moving, member))

    def _moving(self, member: str) -> list[Moved]:
        motion, found = self.mode.motion, []
        for placed in motion.system.ordered if motion is not None else ():
            if placed.owner == member:
                piece = Piece(*map(self.number, placed.piece))
                kappa = piece.foundation - piece.inertia * self.number(motion.z)
                ends = [self._times(row, motion.shape) for row in placed.rows]
                moved = self._moved(placed.start, piece, kappa, ends, not any(placed.rows[0].values()))
                found.append(moved._replace(curves=motion.curves))
        found += self._light(member)
        return sorted(found, key=lambda moved: moved.start)

    def _light(self, name: str) -> Iterator[Moved]:
        """The pieces without inertia and drag."""
        member = self.scene.members[name]
        for number, (left, right) in enumerate(pairwise(member.stations)):
            middle = (self.scene.number(left.place) + self.scene.number(right.place)) / 2
            segment = next(part for part in member.segments if middle < self.scene.number(part.end))
            if segment.inertia.is_zero and segment.drag.is_zero:
                tension, _ = member.tension(number, segment, self.scene)
                yield self._at_rest(member, segment, tension, left, right)

    def _at_rest(self, member: "Member", segment: "MemberSegment", tension: "Node", left: "Station",
                 right: "Station") -> Moved:
        zero, bends = self.scene.table.zero, member.kind.bends
        nodes = [left.place, right.place - left.place, segment.stiffness if bends else zero, tension, zero, zero, zero,
                 segment.foundation]
        start, *coefficients = map(self.number, evaluate(nodes, self.arithmetic, self.values))
        rows = [gradient(motion) for motion in (*member.motions(left), *member.motions(right))]
        numbers = [dict(zip(row, evaluate(list(row.values()), self.arithmetic, self.values), strict=True))
                   for row in rows]
        ends = [self._times({self.scene.q.index(q): x for q, x in row.items() if q in self.scene.q}, self.mode.shape)
                for row in numbers]
        piece = Piece(*coefficients)
        return self._moved(start, piece, piece.foundation, ends, not rows[0])

    def _moved(self, start: "float | mpmath.mpf", piece: Piece, kappa: "float | mpmath.mpf",
               ends: "Sequence[float | mpmath.mpf]", supported: bool) -> Moved:
        kind = object if self.number is not float else complex if any(isinstance(x, complex) for x in ends) else float
        return Moved(self.number(start), piece, kappa, np.array(ends, kind), supported)

    def _times(self, row: "Mapping[int, float | mpmath.mpf]", shape: np.ndarray) -> "float | mpmath.mpf":
        total = sum((self.number(x) * shape[i] for i, x in row.items()), self.number(0))
        total = total if total.imag else total.real
        return total if self.number is not float else complex(total) if total.imag else float(total)

    def at(self, member: str, x: Any) -> list[Any]:
        """u and its derivatives by x, of bars, shafts and strings up to the second, of beams to the third; at a jump
        those on its right."""
        pieces = self.pieces(member)
        moved = pieces[0]
        for later in pieces[1:]:
            if later.start <= x + SAME * later.piece.length:
                moved = later
        return self._on(moved, x)

    def _on(self, moved: Moved, x: "float | mpmath.mpf") -> "list[float | mpmath.mpf]":
        piece = moved.piece
        if moved.curves is not None:
            found: list[float | mpmath.mpf] = moved.curves.along(x).tolist()
        else:
            place = min(max(self.number(x) - moved.start, 0 * piece.length), piece.length)
            found = list(fields(piece, moved.kappa, moved.ends, place))
        if piece.order == 2:        # (N u′)′ = κ u
            N = piece.tension + piece.gradient * (self.number(x) - moved.start)
            found.append((moved.kappa * found[0] - piece.gradient * found[1]) / N if N else
                         moved.kappa * found[1] / (2 * piece.gradient))
        return found

    def displacements(self, member: str, places: Sequence[float]) -> np.ndarray:
        """u at places of a member, in floats: found once for all frames that show it there."""
        return cast("np.ndarray", self._kept(self._displaced, (member, *places)))

    def _displaced(self, asked: tuple[Any, ...]) -> np.ndarray:
        member, *places = asked
        return shape_along(self.in_floats(member), places)[:, 0]

    def largest(self, member: str) -> tuple[Any, Any]:
        """(x, u) where a member moves furthest, the leftmost of equal antinodes."""
        return cast("tuple[Any, Any]", self._kept(self._furthest, member))

    def _furthest(self, member: str) -> "tuple[float | mpmath.mpf, float | mpmath.mpf]":
        ends, places, u, antinodes = self._kept(self._tops, member)
        sizes = np.abs(u)
        if not np.isfinite(sizes).all():
            raise PhysicsError(f"the shape of a mode along '{member}' is not found", "ask for its frequency alone")
        tops = np.flatnonzero(sizes >= sizes.max() * (1 - SAME)).tolist()
        top = next((k for k in tops if places[k] in antinodes), tops[0])
        if self.number is float:
            return places[top], u[top].item()
        x = places[top] if places[top] in ends else self._polished(member, places[top], 1)
        return x, self.at(member, x)[0]

    def size(self, member: str, order: int) -> float:
        """How large a derivative of u by x is on a member, or would be if it moved as far as any: what its rounding is
        measured by. So many waves that what their length is off shows count as a larger one."""
        pieces = self.in_floats(member)
        most = max(_most(moved, 0) for name in self.scene.members for moved in self.in_floats(name))
        largest = max(max(_most(moved, order), most * _wave_number(moved)**order) for moved in pieces)
        phase = sum(_wave_number(moved) * moved.piece.length for moved in pieces)
        return cast("float", largest * max(1.0, phase * (float(self.mode.error) + PLACE) / ALLOWED))

    def node_places(self, member: str) -> list[Any]:
        """The places from left to right at which a member rests, its ends and supports not counted."""
        return [self._polished(member, x, 0) for x in self.nodes_in_floats(member)]

    def nodes_in_floats(self, member: str) -> list[float]:
        """The same in floats."""
        return cast("list[float]", self._kept(self._marks, member)[0])

    def antinode_places(self, member: str) -> list[float]:
        """The places from left to right at which a member moves more than beside them, in floats."""
        return cast("list[float]", self._kept(self._tops, member)[3])

    def _tops(self, member: str) -> tuple[list[float], list[float], np.ndarray, list[float]]:
        """Ends of pieces, these and the turning places, u there, and the antinodes among them."""
        pieces, turning = self.in_floats(member), self._kept(self._marks, member)[1]
        ends = [place for moved in pieces for place in (moved.start, moved.start + moved.piece.length)]
        places = sorted([*ends, *turning])
        found, u = antinodes_and_displacements(pieces, turning, places)
        return ends, places, u, found

    def _marks(self, member: str) -> tuple[list[float], list[float]]:
        return resting_and_turning(self.in_floats(member))

    def in_floats(self, member: str) -> list[Moved]:
        """The pieces of a member, their numbers rounded to floats."""
        return cast("list[Moved]", self._kept(self._rounded, member))

    def _rounded(self, member: str) -> list[Moved]:
        return [Moved(float(moved.start), Piece(*map(float, moved.piece)), float(moved.kappa),
                      moved.ends.astype(complex if any(map(_is_complex, moved.ends)) else float), moved.supported,
                      moved.curves)
                for moved in self.pieces(member)]

    def _polished(self, member: str, x: float, order: int) -> "float | mpmath.mpf":
        """The zero of u or u′ next to one in floats, by Newton's method in more digits; x where the member rests."""
        if self.number is float:
            return x
        x = self.number(x)
        for _ in range(STEPS):
            found = self.at(member, x)
            if not found[order + 1]:
                break
            x = x - (found[order] / found[order + 1]).real
        return x

    def scale(self, how: str, weights: Sequence[float], named: int) -> Any:
        """What the shape is multiplied by: `first` makes the first of the `named` coordinates that moves 1, where none
        does the largest displacement of the first member that moves, and where they rest too the end of a bar that
        turns, or else an oscillator; `largest` the largest of all of these; `mass` the sign that makes the former
        positive.

        weights: √M of each coordinate, by which those that move are told from those that rest.
        """
        shape, moves = self.mode.shape, MOVES * max(1.0, *map(abs, self._weighted(weights)))
        first = next((x for x, part in zip(shape[:named], self._weighted(weights), strict=False) if abs(part) > moves),
                     None)
        if how == "first" and first is not None:
            return 1 / first
        if how == "mass" and first is not None:
            return sign(first)
        tops = [*(self.largest(member)[1] for member in self.scene.members), *self._turning()]
        tops = tops if any(tops) else shape[named:]
        most = max(map(abs, tops))
        if how == "largest":
            return 1 / max([*shape[:named], *tops], key=abs)
        pivot = next(top for top in tops if abs(top) > MOVES * most)
        return sign(pivot) if how == "mass" else 1 / pivot

    def _turning(self) -> list[Any]:
        """How far ends of bars move across, where nothing else holds them."""
        q = self.scene.q
        return [self.mode.shape[q.index(station.u)] for member in self.scene.members.values() if member.turns
                for station in member.stations if station.u in q]

    def _weighted(self, weights: Sequence[float]) -> "list[float | mpmath.mpf]":
        return [x * weight for x, weight in zip(self.mode.shape, weights, strict=True)] or [0.0]


MOVES = 1e-9        # of a mode of unit modal mass: what moves less rests


def _most(moved: Moved, order: int) -> float:
    """The largest of a derivative of u on a piece, at places that no mode finds all at rest."""
    return float(np.abs(moved.along(moved.start + moved.piece.length * SHARES)[:, order]).max())


def _wave_number(moved: Moved) -> float:
    """Of what vibrates on a piece, at least as many as one on its length."""
    piece = moved.piece
    stiffness = piece.bending or max(piece.tension, piece.tension + piece.gradient * piece.length)
    return cast("float", max(abs(moved.kappa / stiffness) ** (1 / piece.order), 1 / piece.length))


def _is_complex(x: "float | mpmath.mpf") -> bool:
    return bool(getattr(x, "imag", 0))
