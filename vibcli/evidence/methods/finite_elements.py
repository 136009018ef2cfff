"""Members cut into 1 … 128 elements a piece, cubic ones of beams, linear ones of others; `eigh` of K and M, or LU at a
frequency."""

from collections.abc import Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.finite_elements import finite_elements
from vibcli.evidence.methods.assembled_modes import rates_of
from vibcli.evidence.reference.member_damped_modes import by_elements
from vibcli.evidence.reference.members import with_inertia
from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject

if TYPE_CHECKING:
    from vibcli.evidence.reference.member_responses import DrivenMembers
    from vibcli.mechanics.factored_system import FactoredSystem

DIVISIONS = (1, 2, 4, 8, 16, 32, 64, 128)


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """Of each number of elements that has enough modes; assembled beforehand."""
    import scipy.linalg  # noqa: F401

    if subject.kind == "member response":
        yield from _responses(subject)
        return
    elements, count = subject.data
    if subject.kind == "damped member modes":
        for divisions in DIVISIONS:
            yield MethodRun("finite elements", f"{divisions} a piece", partial(_damped, elements, divisions, count))
        return
    for divisions in DIVISIONS:
        K, M = with_inertia(*finite_elements(elements, divisions))
        if len(K) >= count:
            yield MethodRun("finite elements", f"{divisions} a piece", partial(_rates, K, M, count))


def _responses(subject: Subject) -> Iterator[MethodRun]:
    """Of signals that are displacements or turns, and loads that act at coordinates."""
    exact, given, Omega, read = subject.data
    elements, row = _cut(exact)
    if row is None or any(given.get(i) for i in exact.spread):
        return
    dragged = elements.with_parts(inertias=(), M={}, pieces=[
        placed._replace(piece=placed.piece._replace(inertia=placed.piece.drag)) for placed in elements.pieces])
    for divisions in DIVISIONS:
        matrices = *finite_elements(elements, divisions), finite_elements(dragged, divisions)[1]
        yield MethodRun("finite elements", f"{divisions} a piece", partial(
            _response, exact, (elements, matrices, row), given, Omega, read))


def _cut(exact: "DrivenMembers") -> "tuple[FactoredSystem, tuple[dict, ...] | None]":
    """(the elements, rows of s⁰, s¹, … of a signal): with a piece in two where it is u, or u′ of a beam, at a place of
    that; no rows of others."""
    place, elements = exact.place, exact.elements
    if place is None:
        return elements, exact.rows
    placed = elements.pieces[place.piece]
    piece, half = placed.piece, placed.piece.order // 2
    if place.order >= half:
        return elements, None
    rows = tuple({} for _ in range(place.primes))
    if place.share in (0, 1):
        end = placed.rows[place.order + (half if place.share else 0)]
        return elements, (*rows, {i: place.factor * x for i, x in end.items()})
    node, at = tuple({elements.n + i: 1.0} for i in range(half)), place.share * piece.length
    parts = [placed._replace(piece=piece._replace(length=at), rows=(*placed.rows[:half], *node)),
             placed._replace(start=placed.start + at, rows=(*node, *placed.rows[half:]), piece=piece._replace(
                 length=piece.length - at, tension=piece.tension + piece.gradient * at))]
    pieces = [*elements.pieces[:place.piece], *parts, *elements.pieces[place.piece + 1:]]
    return (elements.with_parts(n=elements.n + half, pieces=pieces),
            (*rows, {elements.n + place.order: place.factor}))


def _response(exact: "DrivenMembers", assembled: tuple, given: Mapping[int, complex], Omega: float, read: Any,
              _: Deadline) -> MethodAnswer:
    """The phasor by LU of the matrix at a frequency, inputs being coordinates that are given."""
    (elements, (K, M, drag), rows), s = assembled, 1j * Omega
    D = K + s * (s * M + drag)
    _, C, G, _ = elements.with_parts(pieces=()).arrays()
    D[:elements.n, :elements.n] += s * (C + G)
    driven = range(exact.n, exact.elements.n)
    free = np.delete(np.arange(len(K)), driven)
    q = np.zeros(len(K), complex)
    q[driven] = [complex(given.get(i, 0)) for i in driven]
    q[free] = np.linalg.solve(D[np.ix_(free, free)], -D[free] @ q)
    return MethodAnswer([read(sum(s**power * sum(x * q[i] for i, x in row.items()) for power, row in enumerate(rows)))])


def _damped(elements: "FactoredSystem", divisions: int, count: int, _: Deadline) -> MethodAnswer:
    return MethodAnswer(by_elements(elements, divisions)[:count])


def _rates(K: np.ndarray, M: np.ndarray, count: int, _: Deadline) -> MethodAnswer:
    import scipy.linalg

    squares = scipy.linalg.eigh(K, M, eigvals_only=True, subset_by_index=[0, count - 1])
    return rates_of(squares)
