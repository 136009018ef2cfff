"""Pieces and what is asked of them as flat arrays of equal length, and back."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.arithmetic import Arithmetic, arithmetic_of
from vibcli.numerics.pieces.piece import Piece

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

BESIDE_KAPPA = Piece._fields.index("inertia")       # the coefficients that κ does not hold


class Flat(NamedTuple):
    """piece: its coefficients as flat arrays; values: κ and what else was asked, flat; shape that all broadcast to."""

    piece: Piece
    values: list[np.ndarray]
    shape: tuple[int, ...]
    order: int
    numbers: Arithmetic

    def graded(self) -> "Iterator[tuple[Piece, np.ndarray]]":
        """(piece in numbers, which elements are of it) of those whose tension varies; what κ holds may differ."""
        left = np.flatnonzero(self.piece.gradient)
        while len(left):
            one = _piece(values[left[0]] for values in self.piece)
            same = np.logical_and.reduce([values[left] == value for values, value in zip(
                self.piece[:BESIDE_KAPPA], one[:BESIDE_KAPPA], strict=True)])
            yield one, left[same]
            left = left[~same]

    def filled(self, size: tuple[int, ...], uniform: "Callable[..., np.ndarray]",
               graded: "Callable[..., np.ndarray]") -> np.ndarray:
        """An array (…, *size): uniform(piece, *values) of flat arrays where nothing varies, graded of the others, one
        piece at a time."""
        if not np.count_nonzero(self.piece.gradient):
            return uniform(self.piece, *self.values).reshape((*self.shape, *size))
        even = self.piece.gradient == 0
        found = np.zeros((len(even), *size), np.result_type(*self.values, float))
        if even.any():
            found[even] = uniform(_piece(values[even] for values in self.piece),
                                  *(values[even] for values in self.values))
        for piece, chosen in self.graded():
            found[chosen] = graded(piece, *(values[chosen] for values in self.values))
        return found.reshape((*self.shape, *size))


def flattened(piece: Piece, *values: Any) -> Flat:
    """Of numbers and arrays that broadcast together."""
    numbers = arithmetic_of(*piece, *values)
    arrays = [numbers.array(value) for value in (*piece, *values)]
    shape = np.broadcast(*arrays).shape
    arrays = [_spread(array, shape) for array in arrays]
    return Flat(_piece(arrays[:len(piece)]), arrays[len(piece):], shape, piece.order, numbers)


def _spread(array: np.ndarray, shape: tuple[int, ...]) -> np.ndarray:
    """Flat, as long as the shape tells: by assignment, which costs a tenth of np.broadcast_to."""
    if array.shape == shape:
        return array.reshape(-1)
    found = np.empty(shape, array.dtype)
    found[...] = array
    return found.reshape(-1)


def _piece(values: "Iterator[Any] | Sequence[np.ndarray]") -> Piece:
    return Piece(*values)
