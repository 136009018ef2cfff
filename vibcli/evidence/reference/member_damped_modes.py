"""Damped modes of members to many digits: roots λ of the determinant of reference/members.py at z = −λ² and s = λ, by
secants from where finite elements have them,

    (λ² M + λ (C + G + D) + K) q = 0,      D of drag along the pieces.
"""

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np

from vibcli.analyses.continuous.finite_elements import finite_elements
from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.members import (
    APART,
    ELEMENTS,
    FOUND,
    NEAR,
    START,
    STEP,
    STEPS,
    determinant,
    require_plain,
)
from vibcli.evidence.reference.modal import Elements
from vibcli.evidence.reference.settled import DIGITS, DoesNotSettle, TrueValues, settled

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import FactoredSystem

LARGE, SMALL = 1e9, 1e-5        # times the lowest, what is infinite; beside the others, what is zero


def eigenvalues(elements: Elements, count: int) -> TrueValues:
    """So many λ with Im λ ≥ 0 by ascending |λ|; PhysicsError where two are too close, or something rests or creeps."""
    first = elements(30)
    require_plain(first)
    near = by_elements(first, ELEMENTS * (count + 1))[:count + 1]
    if len(near) <= count or abs(near[0]) < SMALL * abs(near[1]):
        raise PhysicsError("no reference is found of damped modes where members rest anywhere")
    if any(abs(b - a) <= NEAR * abs(b) for a, b in pairwise(near)):
        raise PhysicsError("two damped modes are so close that no reference is found of them")
    last: list[Any] = near[:count]

    def found() -> "tuple[list[mpmath.mpc], None]":
        data = elements(mpmath.mp.dps)
        last[:] = [_root(data, start, at) for start, at in zip(last, near, strict=False)]
        return list(last), None

    return settled(found, DIGITS, START)


def by_elements(elements: "FactoredSystem", divisions: int) -> list[complex]:
    """λ with Im λ ≥ 0 in floats, by ascending |λ|, each piece being so many finite elements."""
    import scipy.linalg

    one = elements.each(float)
    K, M = finite_elements(one, divisions)
    drag = finite_elements(one.with_parts(inertias=(), M={}, pieces=[
        placed._replace(piece=placed.piece._replace(inertia=placed.piece.drag)) for placed in one.pieces]),
        divisions)[1]
    _, C, G, _ = one.with_parts(pieces=()).arrays()
    drag[:one.n, :one.n] += C + G
    zero, unit = np.zeros_like(M), np.eye(len(M))
    found = scipy.linalg.eigvals(np.block([[zero, unit], [-K, -drag]]), np.block([[unit, zero], [zero, M]]))
    found = found[np.isfinite(found) & (found.imag >= 0)]
    found = found[np.argsort(np.abs(found))]
    return [complex(x) for x in found[np.abs(found) < LARGE * np.abs(found[:1])]]


def _root(elements: "FactoredSystem", start: complex | mpmath.mpc, near: complex) -> mpmath.mpc:
    """By secants."""
    x, y = mpmath.mpmathify(start), mpmath.mpmathify(start) * (1 - mpmath.mpf(STEP))
    at_x, at_y = (determinant(elements, -p * p, p) for p in (x, y))
    for _ in range(STEPS):
        if at_x == at_y:
            break
        x, y, at_x = y, y - at_y * (y - x) / (at_y - at_x), at_y
        if abs(y - x) <= mpmath.mpf(10) ** -FOUND * abs(y):
            break
        at_y = determinant(elements, -y * y, y)
    else:
        raise ValueError("no root is found near by")
    if abs(y - near) > NEAR * abs(near):
        raise DoesNotSettle("the reference does not settle: a root lies elsewhere than finite elements have it")
    return mpmath.mpc(mpmath.re(y), 0 if abs(mpmath.im(y)) <= APART * abs(y) else mpmath.im(y))
