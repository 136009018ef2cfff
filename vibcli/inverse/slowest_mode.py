"""How fast the slowest mode of a scene without damping is, or the one that grows fastest: what vanishes at its limit of
stability."""

from math import isfinite, pi
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

FEW, SEVERAL = 2, 6     # modes without end that are looked at
APART, ALIKE = 4, 1.1   # factors of ω², and of those that grow, at least
TOLD = 1e-13        # of that one: what may round in the slowest


def slowest(problem: "Problem") -> tuple[int, float | None, float] | None:
    """(rigid modes, ω² of the slowest other one, negative of what grows, its size), no number where all are rigid; None
    far beyond all limits."""
    linear = problem.configuration.linear_system
    if any(_waves_under_pressure(placed.piece) > SEVERAL for placed in linear.pieces):
        return None
    modes = problem.modal.modes
    if not modes.finite and linear.pieces:
        return _of_members(modes)
    shown = modes.first(SEVERAL) if not modes.finite and modes.ground.growing else modes.shown()
    rigid, mode = sum(mode.rigid for mode in shown), next((mode for mode in shown if not mode.rigid), None)
    if mode is None:
        return rigid, None, 0.0
    value = _square(mode)
    size = _stiffness_size(linear, mode.shape) if modes.finite else _next_size(abs(value), map(_square, shown))
    return rigid, value, size


def _of_members(modes):
    """The same of modes without end, in floats where these tell it; the size is that of the next one if it oscillates,
    and of more where these are alike: it goes continuously with the parameters, as each ω² does."""
    growing, rigid = modes.ground
    if growing >= SEVERAL:
        return None
    (value, rounds), (second, _) = _squares(modes, growing, rigid, range(FEW))
    size = abs(value) + max(second, 0.0)
    least, most = sorted((abs(value), abs(second)))
    alike = 1 - most / (least * (ALIKE if growing else APART)) if least else 0.0
    if alike > 0:
        size += alike * max(0.0, *(square for square, _ in _squares(modes, growing, rigid, range(FEW, SEVERAL))))
    if rounds > TOLD * size:
        value = _square(modes.alone(1 if growing else rigid + 1))
    return rigid, value, size


def _squares(modes: Any, growing, rigid, places):
    """(ω², what rounds in it) of modes at places from 0 on, rigid ones left out; of those that floats do not tell found
    in more digits."""
    found: list = []
    for part in ([i + 1 for i in places if i < growing], [i + rigid + 1 for i in places if i >= growing]):
        if part:
            seen = modes.squares(part[0], part[-1])
            found += [one if isfinite(one[0]) else (_square(modes.alone(i)), 0.0) for i, one in zip(
                part, seen, strict=True)]
    return found


def _waves_under_pressure(piece):
    """In how many half waves, at least, a piece buckles with all that it is held to at rest: what lies in that half of
    it which is pressed most, clamped there, buckles under the pressure at the middle in √(−N/B) l/(2π) − 1."""
    pressure = -float(piece.tension + piece.gradient * piece.length / 2)
    if piece.foundation or not piece.bending or pressure <= 0:
        return 0
    return int((pressure / float(piece.bending)) ** 0.5 * float(piece.length) / (2 * pi)) - 1


def _square(mode):
    """ω², negative of what grows."""
    return float(mode.omega) ** 2 if mode.omega is not None else -(float(mode.growth_rate) ** 2)


def _next_size(size, squares):
    """The least ω² of modes that is well above this one."""
    others = sorted(map(abs, squares))
    return next((other for other in others if other > APART * size), others[-1])


def _stiffness_size(elements, shape):
    """Σ |terms| of uᵀ K u."""
    shape = [complex(x).real for x in shape]
    total = sum(abs(k) * sum(x * shape[i] for i, x in row.items()) ** 2 for k, row in elements.springs)
    return total + sum(abs(elements.K_size.get(pair, value) * shape[pair[0]] * shape[pair[1]])
                       for pair, value in elements.K.items())
