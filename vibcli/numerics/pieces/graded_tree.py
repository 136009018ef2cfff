"""A piece whose tension varies along it at several κ: its short parts, joined two and two up to the whole."""

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.base.work import counted
from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.graded_parts import Series, coefficients, part_stiffness, parts_of
from vibcli.numerics.pieces.parity import separate_roots
from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.pieces.scattering import joined, scattered

if TYPE_CHECKING:
    import mpmath

    from vibcli.numerics.pieces.arithmetic import Arithmetic

KEPT, ALIKE = 16, 8     # trees of a piece at one κ or a few, and of mpmath's numbers at several
STEP = 25e-6            # steps of work for each entry of the stiffness of a part at one κ


class GradedTree(NamedTuple):
    """cuts, (levels, from parts to the whole), 1/√Z at the nodes (nodes, κ, m/2), and the power series in all parts."""

    cuts: "list[float | mpmath.mpf]"
    levels: list[Any]
    scale: np.ndarray
    series: Series


def graded_tree(piece: "Piece", kappa: np.ndarray, numbers: "Arithmetic", steep: bool = True) -> GradedTree:
    """The GradedTree of one piece at flat κ; `steep`: with slopes by κ, which those that are kept always have."""
    if numbers.number is not None:      # as for the stiffness and for the count at the same frequencies
        tree = _grown_precisely(tuple(piece), tuple(kappa.tolist()), numbers.eps)
    elif len(kappa) > ALIKE:
        tree = _grown(piece, kappa, numbers, steep)
    else:       # as at one frequency of all places along a piece, and at those of a count
        tree = _grown_again(Piece(*map(float, piece)), kappa.dtype.str, kappa.tobytes())
    counted((len(tree.cuts) - 1) * len(kappa) * piece.order**2 * STEP)
    return tree


@lru_cache(KEPT)
def _grown_again(piece: Piece, kind: str, kappa: bytes) -> GradedTree:
    return _grown(piece, np.frombuffer(kappa, kind), arithmetic_of(0.0))


@lru_cache(KEPT)
def _grown_precisely(piece: "tuple[mpmath.mpf, mpmath.mpf, mpmath.mpf, mpmath.mpf, mpmath.mpf, mpmath.mpf, mpmath.mpf]",
                     kappa: "tuple[mpmath.mpc | mpmath.mpf]", eps: float) -> GradedTree:
    """In numbers of mpmath of this rounding unit, which is that of now."""
    return _grown(Piece(*piece), np.array(kappa, object), arithmetic_of(*piece, *kappa))


def _grown(piece: Piece, kappa: np.ndarray, numbers: "Arithmetic", steep: bool = True) -> GradedTree:
    cuts = parts_of(piece, max(float(abs(value)) for value in kappa))
    scale = _scale(piece, cuts, kappa, numbers)
    ports = np.concatenate([scale[:-1], scale[1:]], axis=-1)
    series = coefficients(piece, cuts, kappa, numbers, steep)
    levels = [scattered(*part_stiffness(piece, cuts, kappa, series, numbers), ports, numbers)]
    while len(levels[-1].s) > 1:
        levels.append(joined(levels[-1], numbers))
    return GradedTree(cuts, levels, scale, series)


def _scale(piece: Piece, cuts: "Sequence[float | mpmath.mpf]", kappa: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
    """1/√Z of the nodes, of the order of what waves meet."""
    if piece.order == 2:
        each = [(piece.tension + piece.gradient * (a + b) / 2) / (b - a) for a, b in pairwise(cuts)]
        z = numbers.array([each[0], *map(max, each, each[1:]), each[-1]])
        found: np.ndarray = 1 / numbers.sqrt(z[:, None, None] + abs(kappa[None, :, None]) * 0)
        return found
    nu = 0 * kappa + (piece.tension + piece.gradient * piece.length / 2) / piece.bending
    one, other = separate_roots(nu, kappa / piece.bending + 2.0**-40 / piece.length**4, numbers)
    p, q = (np.sqrt(np.abs(root).astype(float)) + 1 / float(piece.length) for root in (one, other))
    z = float(piece.bending) * np.stack([p * q * (p + q), p + q], axis=-1)
    result: np.ndarray = numbers.array(1 / np.sqrt(z))[None] * numbers.array(np.ones((len(cuts), 1, 1)))
    return result


def ports(tree: GradedTree, i: int) -> np.ndarray:
    """1/√Z at both ends of the parts of a level."""
    nodes = [*range(0, len(tree.cuts) - 1, 2 ** (i % len(tree.levels))), -1]
    return np.concatenate([tree.scale[nodes[:-1]], tree.scale[nodes[1:]]], axis=-1)
