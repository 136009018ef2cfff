"""How fast the slowest mode of a scene without damping is, or the one that grows fastest: what vanishes at its limit of
stability."""

from collections.abc import Iterable
from math import pi
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.modal.undamped import Mode
    from vibcli.numerics.pieces.piece import Piece
    from vibcli.results.problem import Problem

SEVERAL = 6             # modes without end that are looked at
APART, ALIKE = 4, 1.1   # factors of ω², and of those that grow, at least
ROUNDED = 1e-9          # of those beyond them: two as small are alike


def slowest(problem: "Problem") -> tuple[int, float | None, float] | None:
    """(rigid modes, ω² of the slowest other one, negative of what grows, its size), no number where all are rigid; None
    far beyond all limits."""
    linear = problem.configuration.linear_system
    if any(_waves_under_pressure(placed.piece) > SEVERAL for placed in linear.pieces):
        return None
    if any(placed.piece.inertia for placed in linear.pieces):
        found = problem.modal.slow_squares
        return found and (found[0], found[1][0], _size(found[1]))
    modes = problem.modal.modes
    shown = modes.first(SEVERAL) if not modes.finite and modes.grow else modes.shown()
    rigid, mode = sum(mode.rigid for mode in shown), next((mode for mode in shown if not mode.rigid), None)
    if mode is None:
        return rigid, None, 0.0
    value = _square(mode)
    size = _stiffness_size(linear, mode.shape) if modes.finite else _next_size(abs(value), map(_square, shown))
    return rigid, value, size


def _size(squares: list[float]) -> float:
    """What the first of ascending ω² is measured by: the next one if it oscillates, and more where these are alike, so
    that it goes continuously with the parameters, as each ω² does."""
    value, second = squares[:2]
    beyond = max(0.0, *squares[1:SEVERAL])
    least, most = sorted((abs(value), abs(second)))
    least = (least + ROUNDED * beyond) * (ALIKE if second < 0 else APART)
    return abs(value) + max(second, 0.0) + max(0.0, 1 - most / least if least else 0.0) * beyond


def _waves_under_pressure(piece: "Piece") -> int:
    """In how many half waves, at least, a piece buckles with all that it is held to at rest: what lies in that half of
    it which is pressed most, clamped there, buckles under the pressure at the middle in √(−N/B) l/(2π) − 1."""
    pressure = -float(piece.tension + piece.gradient * piece.length / 2)
    if piece.foundation or not piece.bending or pressure <= 0:
        return 0
    return int((pressure / float(piece.bending)) ** 0.5 * float(piece.length) / (2 * pi)) - 1


def _square(mode: "Mode") -> float:
    """ω², negative of what grows."""
    return float(mode.omega) ** 2 if mode.omega is not None else -(float(mode.growth_rate) ** 2)


def _next_size(size: float, squares: Iterable[float]) -> float:
    """The least ω² of modes that is well above this one."""
    others: list[float] = sorted(map(abs, squares))
    return next((other for other in others if other > APART * size), others[-1])


def _stiffness_size(elements: Any, shape: "np.ndarray") -> float:
    """Σ |terms| of uᵀ K u."""
    shape = [complex(x).real for x in shape]
    total: float = sum(abs(k) * sum(x * shape[i] for i, x in row.items()) ** 2 for k, row in elements.springs)
    return total + sum(float(abs(elements.K_size.get(pair, value) * shape[pair[0]] * shape[pair[1]]))
                       for pair, value in elements.K.items())
