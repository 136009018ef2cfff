"""Poles and zeros of frequency responses of scenes with members, within a range of Ω.

Poles are the natural frequencies, which counts tell completely; with dampers they are followed from there. Zeros where
load and signal share a place are the natural frequencies of the same system held there, counted in the same way.
Elsewhere they are where H changes its sign between poles, and the argument principle, Z − P = ∮ H′/H ds/2πi about what
lies between two poles, tells whether any is missing; where H is not real there, `counted_zeros` are in its stead.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction
from vibcli.numerics.ascending import ascending
from vibcli.numerics.bracketing import zeros_between

if TYPE_CHECKING:
    from collections.abc import Callable

POINTS, MORE = 33, 4        # places between two poles at which the sign of H is looked at; how many more if some miss
TOGETHER = 64               # intervals, so that what is kept of their points takes no more than 100 MB
TRIES, AROUND = 5, (48, 96, 192, 384)       # points on a contour
FLAT = 0.4                  # height of a contour over half its width
BESIDE, INSET = 1e-8, 1e-4     # of the distance of two poles: how near to them signs are looked at, contours end
CLOSE = 1e-6, 1e-7, 1e-10, 1e-11    # of a pole, by tens: a zero may lie as near
STEPS, NEAR, STILL = 12, 0.05, 1e-6
LOWEST = 1e-3       # of a typical frequency: from where on zeros are looked for
ABOVE = 1.1         # times a frequency: so far poles are known where zeros are counted up to there
SETTLED = 1e-10     # relative: a step after which the next one is lost in rounding


def signs(response: FrequencyResponseFunction, Omega: np.ndarray) -> np.ndarray:
    """H of the output itself on the axis without damping, where it is real."""
    return response.at(1j * Omega)[0].real


def zeros_on_axis(response: FrequencyResponseFunction, poles: np.ndarray, low: float, high: float) -> np.ndarray:
    """Ω of the zeros without damping, ascending; poles: Ω of those that take part in H, ascending.

    Between two neighbours, of which one may be no pole, as many as the argument principle counts; many of these
    intervals are looked at together.
    """
    edges = ascending([low, *poles[(poles > low) & (poles < high)], high])
    found = [_between(response, edges[at:at + TOGETHER + 1]) for at in range(0, len(edges) - 1, TOGETHER)]
    return np.concatenate(found) if found else np.zeros(0)


def _between(response: FrequencyResponseFunction, edges: np.ndarray) -> np.ndarray:
    """Those between the neighbours among some poles."""
    a, width = edges[:-1], np.diff(edges)
    inside, points = enclosed(response, a + INSET * width, edges[1:] - INSET * width), POINTS
    exact, starts, ends = [], [], []
    for last in [False] * (TRIES - 1) + [True]:
        share = np.sin(np.linspace(0.0, np.pi / 2, points)) ** 2
        near = np.concatenate([[BESIDE], share[1:-1], [1 - BESIDE]])
        Omega = a[:, None] + width[:, None] * near
        sign = np.sign(signs(response, Omega.ravel())).reshape(Omega.shape)
        turns, nothing = sign[:, 1:] * sign[:, :-1] < 0, sign == 0
        done = (turns.sum(axis=1) + nothing.sum(axis=1) >= inside) | last
        exact.append(Omega[nothing & done[:, None]])
        for kept, part in ((starts, Omega[:, :-1]), (ends, Omega[:, 1:])):
            kept.append(part[turns & done[:, None]])
        a, width, inside, points = a[~done], width[~done], inside[~done], MORE * points
        if not len(a):
            break
    between = np.concatenate(starts), np.concatenate(ends)
    found = zeros_between(lambda at: signs(response, at), *between) if len(between[0]) else between[0]
    return np.sort(np.concatenate([found, *exact]))


def enclosed(response: FrequencyResponseFunction, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """How many zeros less poles lie in ellipses about each a … b of the axis Ω, complex ones too."""
    middle, width = (a + b) / 2, (b - a) / 2
    last, open_ = np.full(len(a), np.nan), np.arange(len(a))
    for count in AROUND:
        turn = np.exp(2j * np.pi * (np.arange(count) + 0.5) / count)
        Omega = middle[open_, None] + width[open_, None] * (turn.real + 1j * FLAT * turn.imag)
        ahead = width[open_, None] * (1j * turn.real * FLAT - turn.imag) * (2 * np.pi / count)
        values, slopes, _ = response.at(1j * Omega.ravel(), True)
        with np.errstate(all="ignore"):
            parts = (1j * slopes / values).reshape(Omega.shape) * ahead / (2j * np.pi)
            found = parts.sum(axis=1).real
        sure = (np.abs(found - np.round(found)) < 0.1) & (np.round(found) == np.round(last[open_]))
        last[open_] = found
        open_ = open_[~sure]
        if not len(open_):
            break
    return np.round(np.where(np.isfinite(last), last, 0.0)).astype(int)


def taking_part(response: FrequencyResponseFunction, places: np.ndarray) -> np.ndarray:
    """Those of the natural frequencies Ω that are poles of H: beside them H grows as they are neared."""
    if not len(places):
        return places
    beside = [places * (1 + side * step) for side in (1, -1) for step in CLOSE]
    values, _, resonant = response.at(1j * np.concatenate([places, *beside]))
    grows, sizes = resonant[:len(places)], np.abs(values).reshape(-1, len(places))[1:]
    for first in range(0, len(beside), len(CLOSE)):
        near = sizes[first:first + len(CLOSE)]
        grows = grows | (near[1] > 3 * near[0]) | (near[3] > 3 * near[2])
    found: np.ndarray = places[grows]
    return found


def followed(step: "Callable[[np.ndarray], np.ndarray]", places: np.ndarray) -> np.ndarray:
    """Places to which Newton's method leads from some, complex; those that it does not settle near are left out."""
    at, moved, left = places.astype(complex), np.full(len(places), np.inf), np.arange(len(places))
    for _ in range(STEPS):
        if not len(left):
            break
        with np.errstate(all="ignore"):
            steps = step(at[left])
        steps = np.where(np.isfinite(steps), steps, np.inf)
        moved[left] = np.abs(steps)
        near = moved[left] <= NEAR * np.abs(at[left])
        left, steps = left[near], steps[near]
        at[left] += steps
        left = left[moved[left] > SETTLED * np.abs(at[left])]
    found: np.ndarray = at[moved <= STILL * np.abs(at)]
    return found


def to_zero(response: FrequencyResponseFunction, s: np.ndarray) -> np.ndarray:
    """Newton's step towards the next zero."""
    values, slopes, _ = response.at(s, True)
    found: np.ndarray = -values / slopes
    return found


def distinct(places: Any) -> np.ndarray:
    """Complex places without those that stand for one, by ascending Im s."""
    found: list[complex] = []
    for s in sorted(places, key=lambda s: (s.imag, s.real)):
        if not any(abs(s - other) <= STILL * abs(s) for other in found[-4:]):
            found.append(s)
    return np.array(found, complex)
