"""First-order bounds of the errors of H(s) of scenes with members: |δH| ≤ |y|ᵀ |δD| |X| + |δc|ᵀ |X|.

δD holds what the sums and the elimination round, and a change of every coefficient of a piece by a few roundings: that
changes κ, and d by as much as dd/ds tells.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.dynamic_matrix import BLOWN, SHARES
from vibcli.analyses.frequency_response.places_within_pieces import weights_within
from vibcli.analyses.transient.data_errors import DATA

if TYPE_CHECKING:
    from vibcli.analyses.continuous.dynamic_matrix import EvaluatedMatrix
    from vibcli.analyses.frequency_response.member_response import MemberTransfer
    from vibcli.analyses.frequency_response.member_system import MemberSystem

EPSILON = 2.0**-52
GUARD = 8       # roundings of what d is made of
GIVEN = 4 * DATA


def of_value(response: "MemberTransfer", Omega: float) -> float:
    """|δH| at a frequency."""
    return of_value_at(response, 1j * Omega) * abs(Omega)**response.order


def of_value_at(response: "MemberTransfer", at: complex) -> float:
    """|δH| of the output itself at a complex frequency."""
    s = np.array([at], complex)
    systems = [response.system, *(response.system.divided(share) for share in SHARES)]
    least = None
    for system in systems:
        found = system.matrix.at(s, True)
        if least is None or found.excess[0] < least[1].excess[0]:
            least = system, found
        if least[1].excess[0] < BLOWN:
            break
    return _bound(*least, s)


def _bound(system: "MemberSystem", found: "EvaluatedMatrix", s: np.ndarray) -> float:
    matrix, free, driven = system.matrix, system.free, system.driven
    (g, _), (c, c_slope) = system.driving(s), system.seen(found, s, True)
    D = found.D[:, :, 0]
    size = np.exp2(-np.round(np.log2(np.where(found.size[free, 0] > 0, found.size[free, 0], 1.0)) / 2))
    inverse = np.linalg.pinv(D[np.ix_(free, free)] * np.outer(size, size)) * np.outer(size, size)
    X = np.zeros(matrix.n, complex)
    X[driven] = g[:, 0]
    X[free] = -inverse @ (D[np.ix_(free, driven)] @ g[:, 0])
    y = np.abs(c[free, 0] @ inverse)
    parts = _magnitudes(found, s)
    rounded = ((len(free) + GUARD) * EPSILON * parts[0] + GIVEN * parts[1]) @ np.abs(X)
    seen = (GIVEN * np.abs(c[:, 0]) + 2 * DATA * np.abs(s[0] * c_slope[:, 0])) @ np.abs(X)
    return float(y @ rounded[free] + seen + 8 * EPSILON * abs(c[:, 0] @ X) + _of_places(system, s, X))


def _of_places(system: "MemberSystem", s: np.ndarray, X: np.ndarray) -> float:
    """What rounding of places within pieces changes of what is seen there."""
    found = 0.0
    for factor, number, share, order in system.output.within:
        placed = system.matrix.pieces[number]
        if order + 1 < placed.piece.order:
            weights = weights_within(placed, s, share, order + 1, False)[0][:, 0]
            ends = [sum(float(x) * X[i] for i, x in row.items()) for row in placed.rows]
            reach = float(placed.start + placed.piece.length)
            found += 2 * EPSILON * reach * abs(factor * (weights @ np.array(ends)))
    return found


def _magnitudes(found: "EvaluatedMatrix", s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(Σ of the magnitudes that the entries of D were added from, how much of them moves with the coefficients)."""
    matrix, large = found.matrix, abs(s[0])
    K, C, M = (np.abs(part) for part in matrix.polynomial)
    added = K + large * C + large**2 * M
    moved = added.copy()
    for stack, (d, slope) in zip(matrix.stacks, found.ends, strict=True):
        for p, rows in enumerate(stack.ends):
            of_d, of_slope = np.abs(d[:, :, p, 0]), large * np.abs(slope[:, :, p, 0])
            S = np.zeros((len(rows), matrix.n))
            for a, row in enumerate(rows):
                for i, x in row.items():
                    S[a, i] = abs(float(x))
            added, moved = added + S.T @ of_d @ S, moved + S.T @ (of_d + 2 * of_slope) @ S
    for number, loads in found.put.items():
        for j, put, steeper in loads:
            whole = matrix.spread[j].size(matrix.pieces[number])
            for a, row in enumerate(matrix.pieces[number].rows):
                for i, x in row.items():
                    size, change = abs(float(x)) * np.abs([put[0, a], large * steeper[0, a]])
                    added[i, j] += size + abs(float(x)) * whole[a]
                    moved[i, j] += size + 2 * change
    return added, moved
