"""Newton's method on the forces from any place, so that saddles are found as well as minima; and its deflation.

Deflated by the zeros known (Farrell, Birkisson & Funke 2015, SIAM J. Sci. Comput. 37, A2026), G = η F with
η = Π (1 + 1/|z − z_k|²) has their places as poles: the same start leads to another zero. With g = ∇ log η the step is
−(J + F gᵀ)⁻¹ F; where it does not lower |G|, it is damped, and then turned downhill (Levenberg 1944).
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from vibcli.mechanics.equilibrium.scaled_forces import Forces, Place

STEPS, POLISH, LONGEST, OUTSIDE = 60, 60, 1.0, 0.5
HALVINGS = (1.0, 0.5, 0.25, 0.0625, 0.015625)
DAMPINGS = (1e-4, 1e-2, 1.0, 100.0)
CLOSE = 1e-11


def zero_from(forces: "Forces", z: np.ndarray, box: Sequence[np.ndarray], known: Sequence[Any] = ()) -> "Place | None":
    """The balanced Place that Newton's method reaches from z, away from the places `known`; None if it fails."""
    low, high = box
    margin = OUTSIDE * (high - low)
    place = forces.at(z)
    for _ in range(STEPS):
        if place is None or np.any((place.z < low - margin) & ~forces.periodic) or np.any(
                (place.z > high + margin) & ~forces.periodic):
            return None
        if place.residual <= CLOSE or forces.balanced(place):
            return settled(forces, place)
        try:
            place = _step(forces, place, known)
        except np.linalg.LinAlgError:
            return None
    return None if place is None else settled(forces, place)


def settled(forces: "Forces", place: "Place", rank: float = 1e-14) -> "Place":
    """The place polished by plain Newton steps as long as they lower the residual; None if it is not balanced."""
    for _ in range(POLISH):
        trial = forces.at(place.z + place.step(rank))
        if trial is None or trial.residual >= place.residual:
            break
        place = trial
    return place if forces.balanced(place) else None


def _step(forces, place, known):
    """The place after one step, None where no step lowers |G|."""
    log_eta, slope = deflation(forces, place.z, known)
    J = place.J + np.outer(place.F, slope)
    merit = _merit(place, log_eta)
    whole = _shortened(np.linalg.lstsq(J, -place.F, rcond=1e-14)[0])
    for factor in HALVINGS:
        trial = _lower(forces, place.z + factor * whole, merit, known)
        if trial is not None:
            return trial
    square, downhill = J.T @ J, -J.T @ place.F
    size = np.trace(square) / len(square)
    for damping in DAMPINGS if size > 0 else ():
        step = np.linalg.solve(square + damping * size * np.eye(len(square)), downhill)
        trial = _lower(forces, place.z + _shortened(step), merit, known)
        if trial is not None:
            return trial
    return None


def _lower(forces, z, merit, known):
    trial = forces.at(z)
    return trial if trial is not None and _merit(trial, deflation(forces, z, known)[0]) < merit - 1e-4 else None


def _merit(place, log_eta):
    """log |G|."""
    size = float(np.linalg.norm(place.F))
    return (np.log(size) if size else -np.inf) + log_eta


def _shortened(step):
    longest = float(np.abs(step).max())
    return step * min(1.0, LONGEST / longest) if longest else step


def deflation(forces: "Forces", z: np.ndarray, known: Sequence[np.ndarray]) -> tuple[float, np.ndarray]:
    """(log η, ∇ log η) at z; the distance of periodic angles is that of the points on their circles."""
    if not len(known):
        return 0.0, np.zeros(len(z))
    d = forces.gap(z, np.array(known))
    chord = np.where(forces.periodic, 2 * np.sin(d / 2), d)
    turn = np.where(forces.periodic, np.cos(d / 2), 1.0)
    square = np.maximum(np.sum(chord * chord, axis=1), 1e-30)
    slopes = chord * turn * (-2 / (square * (1 + square)))[:, None]
    return float(np.sum(np.log1p(1 / square))), np.sum(slopes, axis=0)
