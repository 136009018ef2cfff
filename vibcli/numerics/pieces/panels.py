"""Gauss's rule along pieces: on panels so short that waves and loads are polynomials on them, to rounding."""

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from vibcli.numerics.pieces.arithmetic import Arithmetic
    from vibcli.numerics.pieces.piece import Piece

POINTS, SPAN = 32, 16.0         # of doubles: points of a panel, and the growth or phase over half of it that they bear
WEAK = 2.0**-40                 # part of a string's length beside an end of little tension that is one panel


def panel_rule(piece: "Piece", kappa: Any, rate: float, numbers: "Arithmetic") -> tuple[np.ndarray, np.ndarray]:
    """(places y, weights) on 0 … 1, for ∫ f dx = l Σ w f(l y) of products of fields of these pieces and κ, and of what
    grows or turns by `rate` per length."""
    at, weights = _gauss(numbers)
    edges = _edges(piece, kappa, rate, SPAN if numbers.number is None else 4.0)
    low, half = numbers.array(edges[:-1]), numbers.array(np.diff(edges) / 2)
    return (low[:, None] + half[:, None] * (1 + at)).ravel(), (half[:, None] * weights).ravel()


def _edges(piece: "Piece", kappa: np.ndarray, rate: float, span: float) -> np.ndarray:
    """Panels of equal lengths, halved again and again towards an end with little tension."""
    length, bending, tension, slope = (_size(value) for value in piece[:4])
    other, kappa = _size(piece.tension + piece.gradient * piece.length), _size(kappa)
    if piece.order == 4:
        growth = np.sqrt((np.maximum(tension, other) + np.sqrt(kappa * bending)) / bending)
        far = 0.0
    else:
        growth = np.sqrt(kappa / np.maximum(np.maximum(tension, other) / 2, 1e-300))
        far = (slope * length / np.maximum(np.maximum(tension, other), 1e-300)).max()
    count = max(1, int(np.ceil((length * (2 * growth + rate)).max() / (2 * span))))
    edges = np.linspace(0, 1, count + 1)
    if far < 1e-3:
        return edges
    nearer = edges[1] * 2.0 ** np.arange(np.log2(WEAK), 0)
    return np.unique(np.concatenate([edges, nearer, 1 - nearer]))


def _size(value: float | np.ndarray) -> np.ndarray:
    found: np.ndarray = np.abs(np.atleast_1d(np.asarray(value))).astype(float)
    return found


def _gauss(numbers: "Arithmetic") -> tuple[np.ndarray, np.ndarray]:
    if numbers.number is None:
        return plain_rule()
    import mpmath

    rule = mpmath.calculus.quadrature.GaussLegendre(mpmath.mp)
    degree = 3 + int(np.ceil(np.log2(1 + mpmath.mp.dps / 12)))
    nodes = rule.calc_nodes(degree, mpmath.mp.prec + 10)
    places, weights = (np.array(values, object) for values in zip(*nodes, strict=True))
    return places, weights


@cache
def plain_rule() -> tuple[np.ndarray, np.ndarray]:
    """(places, weights) of a panel on −1 … 1, in doubles."""
    return np.polynomial.legendre.leggauss(POINTS)
