"""Poles and zeros of frequency responses of scenes with members, within a range of Ω.

Poles are the natural frequencies, which counts tell completely; with dampers they are followed from there. Zeros where
load and signal share a place are the natural frequencies of the same system held there, counted in the same way.
Elsewhere they are where H changes its sign between poles, and the argument principle, Z − P = ∮ H′/H ds/2πi about what
lies between two poles, tells whether any is missing.
"""

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction
from vibcli.numerics.ascending import ascending
from vibcli.numerics.bracketing import zeros_between

if TYPE_CHECKING:
    from collections.abc import Callable

POINTS, MORE = 33, 4        # places between two poles at which the sign of H is looked at; how many more if some miss
TRIES, AROUND = 5, (48, 96, 192, 384)       # points on a contour
FLAT = 0.4                  # height of a contour over half its width
BESIDE, INSET = 1e-8, 1e-4     # of the distance of two poles: how near to them signs are looked at, contours end
CLOSE = 1e-6, 1e-7, 1e-10, 1e-11    # of a pole, by tens: a zero may lie as near
STEPS, NEAR, STILL = 12, 0.05, 1e-6


def signs(response: FrequencyResponseFunction, Omega: np.ndarray) -> np.ndarray:
    """H of the output itself on the axis without damping, where it is real."""
    return response.at(1j * Omega)[0].real


def zeros_on_axis(response: FrequencyResponseFunction, poles: np.ndarray, low: float, high: float) -> np.ndarray:
    """Ω of the zeros without damping, ascending; poles: Ω of those that take part in H, ascending."""
    edges = ascending([low, *poles[(poles > low) & (poles < high)], high])
    found = []
    for a, b in pairwise(edges):
        found.append(_between(response, a, b))
    return np.concatenate(found) if found else np.zeros(0)


def _between(response, a, b):
    """Those between two neighbours, of which one may be no pole: as many as the argument principle counts."""
    points, inside = POINTS, None
    for _ in range(TRIES):
        share = np.sin(np.linspace(0.0, np.pi / 2, points)) ** 2
        near = np.concatenate([[BESIDE], share[1:-1], [1 - BESIDE]])
        Omega = a + (b - a) * near
        sign = np.sign(signs(response, Omega))
        turns = np.flatnonzero(sign[1:] * sign[:-1] < 0)
        exact = Omega[sign == 0]
        if inside is None:
            inside = enclosed(response, a + INSET * (b - a), b - INSET * (b - a))
        if len(turns) + len(exact) >= inside:
            break
        points = MORE * points
    found = zeros_between(lambda at: signs(response, at), Omega[turns], Omega[turns + 1]) if len(turns) else turns
    return np.sort(np.concatenate([found, exact]))


def enclosed(response: FrequencyResponseFunction, a: float, b: float) -> int:
    """How many zeros less poles lie in an ellipse about a … b of the axis Ω, complex ones too."""
    middle, width = (a + b) / 2, (b - a) / 2
    last = None
    for count in AROUND:
        turn = np.exp(2j * np.pi * (np.arange(count) + 0.5) / count)
        Omega = middle + width * (turn.real + 1j * FLAT * turn.imag)
        ahead = width * (1j * turn.real * FLAT - turn.imag) * (2 * np.pi / count)
        values, slopes, _ = response.at(1j * Omega, True)
        with np.errstate(all="ignore"):
            found = float(np.sum(1j * slopes / values * ahead / (2j * np.pi)).real)
        if last is not None and abs(found - round(found)) < 0.1 and round(found) == round(last):
            return round(found)
        last = found if math.isfinite(found) else None
    return round(last) if last is not None else 0


def taking_part(response: FrequencyResponseFunction, places: np.ndarray) -> np.ndarray:
    """Those of the natural frequencies Ω that are poles of H: beside them H grows as they are neared."""
    if not len(places):
        return places
    grows = response.at(1j * places)[2]
    for side in (1, -1):
        sizes = [np.abs(response.at(1j * places * (1 + side * step))[0]) for step in CLOSE]
        grows = grows | (sizes[1] > 3 * sizes[0]) | (sizes[3] > 3 * sizes[2])
    return places[grows]


def followed(step: "Callable[[np.ndarray], np.ndarray]", places: np.ndarray) -> np.ndarray:
    """Places to which Newton's method leads from some, complex; those that it does not settle near are left out."""
    at, moved = places.astype(complex), np.zeros(len(places))
    for _ in range(STEPS if len(places) else 0):
        with np.errstate(all="ignore"):
            moved = step(at)
        moved = np.where(np.isfinite(moved), moved, np.inf)
        at = np.where(np.abs(moved) <= NEAR * np.abs(at), at + moved, at)
    return at[np.abs(moved) <= STILL * np.abs(at)]


def distinct(places: Any) -> np.ndarray:
    """Complex places without those that stand for one, by ascending Im s."""
    found: list[complex] = []
    for s in sorted(places, key=lambda s: (s.imag, s.real)):
        if not any(abs(s - other) <= STILL * abs(s) for other in found[-4:]):
            found.append(s)
    return np.array(found, complex)
