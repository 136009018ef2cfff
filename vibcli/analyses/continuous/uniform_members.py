"""Natural frequencies of a uniform member with classical ends alone, in closed form: no search, none missed.

    order 2:  ω² = (N β² + k)/μ     βL = nπ, (n − ½)π                        Blevins, Formulas for Dynamics, ch. 4
    order 4:  ω² = (B β⁴ + k)/μ     free–free, clamped–clamped               cos βL cosh βL = 1
                                    clamped–free                             cos βL cosh βL = −1
                                    clamped–pinned, free–pinned              tan βL = tanh βL
                                    clamped–guided, free–guided              tan βL = −tanh βL
                                    pinned and guided alone                  as of order 2, N β² beside

βL = (n + c)π + e, e of order exp(−βL): e is found, which keeps all digits.
"""

from itertools import pairwise
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.numerics.pieces.piece import Piece

SAME = 1e-14        # of a place
NEWTON = 8          # steps; from e = 0 five reach the last digit,
FADED = 38.0        # where exp −x is no more than a rounding none is needed: e is then it, or twice it
PINNED, GUIDED = (False, True), (True, False)
SINES = frozenset({PINNED, GUIDED})


class UniformMember(NamedTuple):
    """A piece by itself; ends: which of the end values move, (u,), of beams (u, θ), at either end; cuts: where it is
    divided by places at which nothing is attached."""

    piece: Any
    ends: tuple[tuple[bool, ...], tuple[bool, ...]]
    cuts: tuple[float, ...] = ()

    @property
    def resting(self) -> int:
        """How many shapes have β = 0: rigid, unless the member lies on a foundation."""
        first, last = self.ends
        if self.piece.order == 2:
            return int(first[0] and last[0])
        return 1 if first == last == GUIDED else max(0, sum(first) + sum(last) - 2)

    def wave_numbers(self, n: np.ndarray) -> np.ndarray:
        """βL of the modes 1, 2 … that bend or stretch."""
        turns, rest = self.phases(n)
        return cast("np.ndarray", np.pi * turns + rest)

    def phases(self, n: np.ndarray) -> tuple[np.ndarray, Any]:
        """The same in two parts: n + c, exact, and e."""
        n, kinds = np.asarray(n, float), set(self.ends)
        if self.piece.order == 2 or kinds <= SINES:
            return (n if len(kinds) == 1 else n - 0.5), 0.0 * n
        if kinds & SINES:
            shift, sign = (0.25, -1) if PINNED in kinds else (-0.25, 1)
            return n + shift, _tangent(np.pi * (n + shift), sign)
        sign = 1 if len(kinds) == 1 else -1
        return n + 0.5 * sign, _product(n, sign)

    def squares(self, n: np.ndarray) -> np.ndarray:
        """ω² of those modes."""
        piece, beta = self.piece, self.wave_numbers(n) / self.piece.length
        elastic = piece.bending * beta ** 4 + (piece.tension * beta ** 2 if piece.tension else 0.0)
        return cast("np.ndarray", (elastic + piece.foundation) / piece.inertia)

    def frequencies(self, n: np.ndarray) -> np.ndarray:
        """ω of those modes; without foundation and tension beside bending a root is taken of the data alone."""
        piece = self.piece
        if piece.foundation or (piece.bending and piece.tension):
            return cast("np.ndarray", np.sqrt(self.squares(n)))
        phase = self.wave_numbers(n)
        if piece.order == 2:
            return cast("np.ndarray", phase * (np.sqrt(piece.tension / piece.inertia) / piece.length))
        value: np.ndarray = phase * phase * (np.sqrt(piece.bending / piece.inertia) / (piece.length * piece.length))
        return value


def uniform_member(elements: Any) -> UniformMember | None:
    """The UniformMember that a FactoredSystem is, without what nothing moves; None where it is something else."""
    lumped = any(any(row.values()) for _, row in (*elements.inertias, *elements.springs))
    joined = None if lumped or elements.M or elements.K or elements.G else _joined(elements.pieces)
    if joined is None:
        return None
    piece, rows, cuts, within = joined
    touched = [*within, *(i for row in rows for i, x in row.items() if x)]
    own = all(sum(1 for x in row.values() if x) <= 1 for row in rows) and sorted(touched) == list(range(elements.n))
    if not own or piece.gradient or piece.inertia <= 0 or (piece.bending or piece.tension) <= 0 or piece.foundation < 0:
        return None
    half = piece.order // 2
    moved = [any(row.values()) for row in rows]
    ends = (tuple(moved[:half]), tuple(moved[half:]))
    if half == 2 and piece.tension and (piece.tension < 0 or not set(ends) <= SINES):
        return None
    return UniformMember(piece, ends, cuts)


def _joined(placed: "tuple[PlacedPiece, ...]"
            ) -> "tuple[Piece, tuple[dict[int, float], ...], tuple[float, ...], list[int]] | None":
    """(piece, rows of its ends, cuts, coordinates of these) of pieces that are one but for places on it; None of
    others."""
    if not placed:
        return None
    first, half, within = placed[0], placed[0].piece.order // 2, []
    for one, other in pairwise(placed):
        joint = one.rows[half:]
        alike = one.piece._replace(length=0, drag=0) == other.piece._replace(length=0, drag=0)
        meets = one.owner == other.owner and abs(one.start + one.piece.length - other.start) <= SAME * other.start
        if not (alike and meets) or joint != other.rows[:half] or any([*row.values()] != [1] for row in joint):
            return None
        within += [i for row in joint for i in row]
    length = placed[-1].start + placed[-1].piece.length - first.start
    cuts = tuple(float(one.start - first.start) for one in placed[1:])
    return first.piece._replace(length=length), (*first.rows[:half], *placed[-1].rows[half:]), cuts, within


def _tangent(start: np.ndarray, sign: int) -> np.ndarray:
    """e of the roots of tan x = −sign·tanh x near x₀ = (n ∓ ¼)π: e = sign·arctan exp(−2x)."""
    e, near = sign * np.exp(-2 * start), 2 * start < FADED
    e[near] = 0
    for _ in range(NEWTON):
        fading = np.exp(-2 * (start[near] + e[near]))
        value, slope = e[near] - sign * np.arctan(fading), 1 + 2 * sign * fading / (1 + fading * fading)
        e[near] -= value / slope
    return cast("np.ndarray", e)


def _product(n: np.ndarray, sign: int) -> np.ndarray:
    """e of the roots of cos x cosh x = sign near x₀ = (n + ½ sign)π: sin e = −(−1)ⁿ sech x."""
    start, turn = np.pi * (n + 0.5 * sign), np.where(n % 2, -1.0, 1.0)
    e, near = -2 * turn * np.exp(-start), start < FADED
    e[near], turn = 0, turn[near]
    for _ in range(NEWTON):
        x = start[near] + e[near]
        fading = np.exp(-x)
        sech = 2 * fading / (1 + fading * fading)
        value, slope = np.sin(e[near]) + turn * sech, np.cos(e[near]) - turn * sech * np.tanh(x)
        e[near] -= value / slope
    return e
