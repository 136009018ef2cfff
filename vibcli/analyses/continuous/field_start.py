"""Twice the energy of a motion z that starts in fields, and of its rate A z = (v, a) then:

    μ a = −(B u⁗ − (N u′)′ + k u + c v),      M a = −(what ends need + K q + C q̇)

What is not in balance where nothing has mass is a blow of A z there; it is infinite where v is not what ends do.
"""

from functools import cached_property
from itertools import pairwise
from math import inf
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.disturbances import derivatives
from vibcli.analyses.continuous.start_energy import GAP, edges_of, of_field, rule_between, start_energy
from vibcli.analyses.continuous.uncounted_modes import inverse_where_massive
from vibcli.numerics.pieces.stiffness import stiffness

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.exact_transfer import ExactTransfer
    from vibcli.analyses.excitation.forcing import Forcing, Segment
    from vibcli.mechanics.factored_system import PlacedPiece

ORDERS = 5          # u … u⁗


class StartInFields:
    """Coordinates and their rates at t = 0, and (u, v) over each piece, Forcings of the place, as of start_energy."""

    def __init__(self, transfer: "ExactTransfer", begun: tuple[np.ndarray, np.ndarray], given: "Sequence[Any]") -> None:
        self.transfer, self.begun, self.given = transfer, begun, given

    def twice(self, k: int) -> float:
        """Of z, k being 0, and of A z without its blows, 1; beyond these inf."""
        return (self._of_motion, self._of_rate[0])[k] if k < 2 else inf

    @property
    def blows(self) -> np.ndarray:
        """Those of A z, (coordinates,)."""
        return self._of_rate[1]

    @cached_property
    def _of_motion(self) -> float:
        return start_energy(self.transfer, self.begun, self.given)

    @cached_property
    def _of_rate(self) -> tuple[float, np.ndarray]:
        (q, v), (K, C, M) = self.begun, self.transfer.matrix.polynomial
        forces, sizes = K @ q + C @ v, np.abs(K) @ np.abs(q) + np.abs(C) @ np.abs(v)
        found = float(v @ K @ v)
        for one, (u, speed) in zip(self.transfer.pieces, self.given, strict=True):
            rows = np.array([[row.get(i, 0.0) for i in range(len(q))] for row in one.rows])
            d = stiffness(one.piece, np.float64(one.piece.foundation)) @ rows
            own, size = (d @ q, np.abs(d) @ np.abs(q)) if u is None else _end_forces(one, u)
            if not np.isfinite(own).all():
                return inf, 0 * q
            forces, sizes = forces + rows.T @ own, sizes + np.abs(rows.T) @ size
            found += _accelerated(one, u, speed)
            if speed is not None:
                found += of_field(one, speed, rows @ v)
            elif (rows @ v).any():
                found = inf
        a = -inverse_where_massive(M) @ forces
        left = forces + M @ a
        return found + float(a @ M @ a), -np.where(np.abs(left) <= GAP * sizes, 0.0, left)


def _end_forces(one: "PlacedPiece", u: "Forcing") -> tuple[np.ndarray, np.ndarray]:
    """(those that the ends of a piece need in a field, what they are rounded from); inf where forces act inside."""
    piece, half = one.piece, one.piece.order // 2
    sides = [[_along(segment, x) for x in (low, high)] for segment, low, high in edges_of(u, piece.length)]
    values, sizes = (np.array([part[k] for side in sides for part in side]) for k in range(2))
    apart = np.abs(values[1:-1:2] - values[2::2]) > GAP * sizes.max(axis=0)
    if apart[:, half:piece.order].any():
        return np.full(piece.order, inf), np.full(piece.order, inf)
    need, turn = np.zeros((half, ORDERS, 2)), np.array([-1.0, 1.0])
    need[0, 1] = turn * (piece.tension + piece.gradient * np.array([0.0, piece.length]))
    if half == 2:
        need[0, 3], need[1, 2] = -piece.bending * turn, piece.bending * turn
    found, size = (np.einsum("aoe,eo->ea", part, ends[[0, -1]]).ravel()
                   for part, ends in ((need, values), (np.abs(need), sizes)))
    return found, size


def _accelerated(one: "PlacedPiece", u: "Forcing | None", speed: "Forcing | None") -> float:
    """∫ μ a² dx of a piece."""
    piece, places = one.piece, [given for given in (u, speed) if given is not None]
    cuts = sorted({x for given in places for _, *ends in edges_of(given, piece.length) for x in ends})
    found = 0.0
    for low, high in pairwise(cuts):
        parts = [next((segment for segment, *ends in edges_of(given, piece.length) if ends[0] <= low < ends[1]), None)
                 if given is not None else None for given in (u, speed)]
        x, weights = rule_between([part for part in parts if part is not None], low, high, piece.length)
        w, v = (np.array([_along(part, at)[0] for at in x]) if part is not None else np.zeros((len(x), ORDERS))
                for part in parts)
        held = piece.foundation * w[:, 0] - (piece.tension + piece.gradient * x) * w[:, 2] - piece.gradient * w[:, 1]
        bent = piece.bending * w[:, 4] if piece.order == 4 else 0.0
        found += float(weights @ (held * (u is not None) + bent + piece.drag * v[:, 0]) ** 2) / piece.inertia
    return found


def _along(segment: "Segment", x: float) -> np.ndarray:
    """u, u′ … u⁗, and what they are rounded from."""
    return sum((np.array(derivatives(wave, x - segment.start, ORDERS)) for wave in segment.waves if not wave.channel),
               np.zeros((2, ORDERS)))
