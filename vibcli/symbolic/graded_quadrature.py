"""∫₀ᵘ f(x) dx for many u at once, by Gauss's rule on panels that grow with the distance from 0 and from given places,
and are halved until the halves tell no more than the whole."""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

POINTS, GRADES, LEVELS = 16, 20, 64
ROUNDING = 2.0**-51     # of ∫ |f| dx, for each panel
FINEST = 2.0**-43       # of u: the shortest panel, which is no longer halved
MOST = 500              # panels of each u at once that are halved: more do so for rounding alone
ENOUGH = 2.0**-12       # of ∫ |f| dx: more that is open is no integral


class Integrals(NamedTuple):
    """∫₀ᵘ f dx, ∫ |f| |dx|, and what panels that did not settle leave open."""

    value: np.ndarray
    size: np.ndarray
    open: np.ndarray


class _Panels(NamedTuple):
    low: np.ndarray
    high: np.ndarray
    owner: np.ndarray

    def chosen(self, which: np.ndarray) -> "_Panels":
        return _Panels(*(part[which] for part in self))

    def halves(self) -> "tuple[_Panels, _Panels]":
        middle = 0.5 * (self.low + self.high)
        return _Panels(self.low, middle, self.owner), _Panels(middle, self.high, self.owner)


def integrals(f: "Callable[[np.ndarray, np.ndarray], np.ndarray]", u: np.ndarray,
              places: "Sequence[np.ndarray]") -> Integrals:
    """f(x, owner): values at x of shape (panels, points), `owner` being the number of the u of each panel; places:
    where f bends or changes fast, arrays like u."""
    at, weights = np.polynomial.legendre.leggauss(POINTS)

    def over(panels: _Panels) -> "tuple[np.ndarray, np.ndarray]":
        half = 0.5 * (panels.high - panels.low)
        x = (panels.low + half)[:, None] + half[:, None] * at
        values = np.broadcast_to(f(x, panels.owner), x.shape)
        return half * (values @ weights), np.abs(half) * (np.abs(values) @ weights)

    panels, count = _graded(u, places), len(u)

    def added(owner: np.ndarray, values: np.ndarray) -> np.ndarray:
        return np.bincount(owner, values, count)

    whole, size = over(panels)
    scale, value, left = added(panels.owner, size), np.zeros(count), np.zeros(count)
    for _ in range(LEVELS):
        first, second = panels.halves()
        (one, _), (two, _) = over(first), over(second)
        gap = np.abs(one + two - whole)
        far = np.abs(panels.high - panels.low) > FINEST * np.abs(u[panels.owner])
        rough = ~(gap <= ROUNDING * scale[panels.owner])
        dead = np.isnan(value + added(panels.owner, gap)) | (added(panels.owner, rough) > MOST)
        go_on = rough & far & ~dead[panels.owner]
        value += added(panels.owner, np.where(go_on, 0.0, one + two))
        left += added(panels.owner, np.where(rough & ~go_on, gap, 0.0))
        if not go_on.any():
            return Integrals(value, scale, left)
        panels, whole = _joined(first.chosen(go_on), second.chosen(go_on)), np.concatenate([one[go_on], two[go_on]])
    return Integrals(value + added(panels.owner, whole), scale, left + added(panels.owner, np.abs(whole)))


def _joined(a: _Panels, b: _Panels) -> _Panels:
    return _Panels(*(np.concatenate(pair) for pair in zip(a, b, strict=True)))


def _graded(u: np.ndarray, places: "Sequence[np.ndarray]") -> _Panels:
    """Panels between 0, the places on the way, and u, cut in halves towards both ends."""
    zero = np.zeros_like(u)
    edges = [np.clip(place, np.minimum(u, 0), np.maximum(u, 0)) for place in places]
    edges = np.sort([zero, *(np.where(np.isfinite(edge), edge, 0) for edge in edges), u], axis=0)
    low, high = edges[:-1, None], edges[1:, None]
    near = (high - low) * 0.5 ** np.arange(GRADES, 0, -1)[:, None]
    cuts = np.concatenate([low, low + near, high - near[:, -2::-1], high], axis=1)
    first, second = cuts[:, :-1], cuts[:, 1:]
    kept, back = second > first, np.broadcast_to(u < 0, first.shape)
    owner = np.broadcast_to(np.arange(len(u)), first.shape)
    return _Panels(np.where(back, second, first)[kept], np.where(back, first, second)[kept], owner[kept])
