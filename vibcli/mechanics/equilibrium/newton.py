"""Newton's method on the forces from any place, so that saddles are found as well as minima; and its deflation.

Deflated by the zeros known (Farrell, Birkisson & Funke 2015, SIAM J. Sci. Comput. 37, A2026), G = η F with
η = Π (1 + 1/|z − z_k|²) has their places as poles: the same start leads to another zero. With g = ∇ log η the step is
−(J + F gᵀ)⁻¹ F; where it does not lower |G|, it is damped, and then turned downhill (Levenberg 1944). The distance of
periodic angles is that of the points on their circles, 2 sin(d/2).
"""

from collections.abc import Sequence
from math import cos, hypot, inf, log, log1p, sin
from operator import mul
from typing import TYPE_CHECKING

import numpy as np

from vibcli.numerics.few_unknowns import shortest_solution

if TYPE_CHECKING:
    from vibcli.mechanics.equilibrium.scaled_forces import Forces, Place

STEPS, POLISH, LONGEST, OUTSIDE = 60, 60, 1.0, 0.5
HALVINGS = (1.0, 0.5, 0.25, 0.0625, 0.015625)
DAMPINGS = (1e-4, 1e-2, 1.0, 100.0)
CLOSE, RANK, APART = 1e-11, 1e-14, 1e-30


def zero_from(forces: "Forces", z: np.ndarray, box: Sequence[np.ndarray],
              known: "Sequence[Place]" = ()) -> "Place | None":
    """The balanced Place that Newton's method reaches from z, away from the places `known`; None if it fails."""
    bounds = _bounds(forces, box)
    place = forces.at(z)
    for _ in range(STEPS):
        if place is None or any(not low <= x <= high for x, (low, high) in zip(place.where, bounds, strict=True)):
            return None
        if place.residual <= CLOSE or forces.balanced(place):
            return settled(forces, place)
        try:
            place = _step(forces, place, known)
        except np.linalg.LinAlgError:
            return None
    return None if place is None else settled(forces, place)


def _bounds(forces: "Forces", box: Sequence[np.ndarray]) -> list[tuple[float, float]]:
    """[(least, most)] of what is followed: half the box beyond it on either side, periodic angles anywhere."""
    return [(-inf, inf) if periodic else (low - OUTSIDE * (high - low), high + OUTSIDE * (high - low))
            for low, high, periodic in zip(*(side.tolist() for side in box), forces.periodic, strict=True)]


def settled(forces: "Forces", place: "Place", rank: float = RANK) -> "Place":
    """The place polished by plain Newton steps as long as they lower the residual; None if it is not balanced."""
    for _ in range(POLISH):
        trial = forces.at(_moved(place, place.step(rank)))
        if trial is None or trial.residual >= place.residual:
            break
        place = trial
    return place if forces.balanced(place) else None


def _step(forces: "Forces", place: "Place", known: "Sequence[Place]") -> "Place | None":
    """The place after one step, None where no step lowers |G|."""
    log_eta, slope = deflation(forces, place.where, known)
    F, merit = place.F, _merit(place, log_eta)
    J = [[x + f * s for x, s in zip(row, slope, strict=True)] for row, f in zip(place.J, F, strict=True)]
    whole = _shortened(shortest_solution(J, [-f for f in F], RANK))
    for factor in HALVINGS:
        trial = _lower(forces, _moved(place, whole, factor), merit, known)
        if trial is not None:
            return trial
    columns = list(zip(*J, strict=True))
    square = [[sum(map(mul, one, other)) for other in columns] for one in columns]
    downhill = [-sum(map(mul, column, F)) for column in columns]
    size = sum(square[i][i] for i in range(len(F))) / len(F)
    for damping in DAMPINGS if size > 0 else ():
        damped = [[x + damping * size * (i == j) for j, x in enumerate(row)] for i, row in enumerate(square)]
        trial = _lower(forces, _moved(place, _shortened(shortest_solution(damped, downhill, RANK))), merit, known)
        if trial is not None:
            return trial
    return None


def _moved(place: "Place", step: Sequence[float], factor: float = 1.0) -> list[float]:
    return [x + factor * dx for x, dx in zip(place.where, step, strict=True)]


def _lower(forces: "Forces", z: list[float], merit: float, known: "Sequence[Place]") -> "Place | None":
    trial = forces.at(z)
    return trial if trial is not None and _merit(trial, deflation(forces, z, known)[0]) < merit - 1e-4 else None


def _merit(place: "Place", log_eta: float) -> float:
    """log |G|."""
    size = hypot(*place.F)
    return (log(size) if size else -inf) + log_eta


def _shortened(step: list[float]) -> list[float]:
    longest = max(map(abs, step))
    return [x * (LONGEST / longest) for x in step] if longest > LONGEST else step


def deflation(forces: "Forces", z: Sequence[float], known: "Sequence[Place]") -> tuple[float, list[float]]:
    """(log η, ∇ log η) at z."""
    log_eta, slopes = 0.0, [0.0] * len(z)
    periodic = forces.periodic.tolist() if known else ()
    for place in known:
        square, along = 0.0, []
        for x, y, turns in zip(z, place.where, periodic, strict=True):
            d = x - y
            chord = 2.0 * sin(0.5 * d) if turns else d
            square += chord * chord
            along.append(chord * cos(0.5 * d) if turns else d)
        square = max(square, APART)
        log_eta += log1p(1.0 / square)
        factor = -2.0 / (square * (1.0 + square))
        for i, part in enumerate(along):
            slopes[i] += factor * part
    return log_eta, slopes
