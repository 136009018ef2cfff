"""Members cut into finite elements, cubic ones of beams, linear ones of others: what is needed of them beside K and M
in order to calculate responses at a frequency, and the motion of all of it under loads.

    (K + s C + s² M) q = f,     M q̈ + C q̇ + K q = Σ v Re tᵖ e^{λt}
"""

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any, cast

import mpmath
import numpy as np

from vibcli.analyses.continuous.finite_elements import AT, WEIGHTS, element_nodes, finite_elements, shapes
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.exponential_polynomials import NOTHING, ExponentialPolynomial
from vibcli.evidence.reference.member_pole_sums import DIGITS
from vibcli.evidence.reference.member_poles import in_floats
from vibcli.evidence.reference.member_starts import started_members
from vibcli.evidence.reference.rated_members import rated_members

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from vibcli.evidence.reference.member_responses import DrivenMembers
    from vibcli.evidence.reference.member_starts import StartedMembers
    from vibcli.evidence.reference.rated_members import GivenDamping
    from vibcli.mechanics.factored_system import FactoredSystem
    from vibcli.mechanics.inputs_outputs.place_signals import PlaceOutput
    from vibcli.results.problem import Problem

SAME = 1e-9             # of the largest: what jumps by less does not


class MeshedMembers:
    """A system in floats each of whose pieces is so many elements."""

    def __init__(self, elements: "FactoredSystem", divisions: int) -> None:
        self.elements, self.divisions = elements, divisions
        self.size, self.nodes = element_nodes(elements, divisions)

    def matrices(self) -> "list[np.ndarray]":
        """M, C, K, what is gyroscopic being in C."""
        K, M = finite_elements(self.elements, self.divisions)
        dragged = self.elements.with_parts(inertias=(), M={}, pieces=[
            placed._replace(piece=placed.piece._replace(inertia=placed.piece.drag))
            for placed in self.elements.pieces])
        C = finite_elements(dragged, self.divisions)[1]
        n = self.elements.n
        C[:n, :n] += self.elements.with_parts(pieces=()).coefficients()[1]
        return [M, C, K]

    def row(self, terms: "dict[int, float]") -> np.ndarray:
        """A linear function of coordinates, as an array."""
        found = np.zeros(self.size)
        for i, x in terms.items():
            found[i] = x
        return found

    def rows(self, place: "PlaceOutput | None", parts: "Sequence[dict[int, float]]") -> np.ndarray:
        """Of a signal, over q, q̇, q̈: at a place, or of coordinates."""
        found = np.zeros((3, self.size))
        if place is not None:
            found[place.primes] = self.at(place)
        for row, terms in zip(found, parts, strict=False):
            row += self.row(terms)
        return found

    def at(self, place: "PlaceOutput") -> np.ndarray:
        """What the element at a place has there, as a function of all coordinates."""
        piece, at = self.elements.pieces[place.piece].piece, place.share * self.divisions
        i = min(int(at), self.divisions - 1)
        values = shapes(piece.order, piece.length / self.divisions, np.array([at - i]))
        return cast("np.ndarray", place.factor * self._spread(place.piece, i, values[place.order][:, 0]))

    def load(self, piece: int, along: "Callable[[np.ndarray], np.ndarray]") -> Any:
        """What a load along a piece does: ∫ N p dx."""
        one = self.elements.pieces[piece].piece
        length = one.length / self.divisions
        N = shapes(one.order, length, AT)[0] * WEIGHTS * length
        return sum(self._spread(piece, i, N @ along((i + AT) * length)) for i in range(self.divisions))

    def _spread(self, piece: int, i: int, shares: np.ndarray) -> np.ndarray:
        rows = *self.nodes[piece][i], *self.nodes[piece][i + 1]
        return cast("np.ndarray", sum(x * self.row(row) for x, row in zip(shares, rows, strict=True)))


class MeshAtFrequency(NamedTuple):
    """M, C, K of what moves freely; loads: on it, of s⁰, s¹, s²; rows: of a signal, over q, q̇, q̈; own: what inputs
    add to that."""

    M: np.ndarray
    C: np.ndarray
    K: np.ndarray
    loads: np.ndarray
    rows: np.ndarray
    own: np.ndarray

    def pushed(self, s: complex) -> np.ndarray:
        """f at a rate s."""
        return cast("np.ndarray", s ** np.arange(3) @ self.loads)

    def signal(self, s: complex, q: np.ndarray) -> complex:
        """That of these coordinates."""
        return complex(s ** np.arange(3) @ (self.rows @ q + self.own))


def at_frequency(members: "DrivenMembers", given: "Mapping[int, complex]", divisions: int) -> MeshAtFrequency:
    """Members in floats whose inputs have these phasors."""
    mesh, driven = MeshedMembers(members.elements, divisions), np.arange(members.n, members.elements.n)
    matrices, free = mesh.matrices(), np.delete(np.arange(mesh.size), driven)
    inputs = np.array([complex(given.get(int(i), 0)) for i in driven])
    loads = np.array([-part[np.ix_(free, driven)] @ inputs for part in reversed(matrices)])
    for i, parts in members.spread.items():
        for piece, coefficients in parts:
            length = members.elements.pieces[piece].piece.length
            along = np.polynomial.Polynomial(coefficients, (0, length), (0, 1))
            loads[0] += given.get(i, 0) * mesh.load(piece, along)[free]
    rows = mesh.rows(members.place, members.rows)
    M, C, K = (part[np.ix_(free, free)] for part in matrices)
    return MeshAtFrequency(M, C, K, loads, rows[:, free], rows[:, driven] @ inputs)


class MembersInTime(NamedTuple):
    """members: in floats; damping: that their modes are given; until: an instant; feature: of their signal, its `value`
    then or its `max`, `min`, `argmax`, `argmin` until then."""

    members: "StartedMembers"
    damping: "GivenDamping | None"
    until: float
    feature: str


def members_in_time(problem: "Problem", signal: str, until: float, feature: str) -> MembersInTime:
    """What other methods than ours are given of a motion of members."""
    with mpmath.workdps(DIGITS):
        end, damping = max(mpmath.mpf(until), mpmath.mpf(problem.response.until)), None
        if problem.spec.get("damping") is None:
            members = started_members(problem, signal, end)
        else:
            rated = rated_members(problem, signal, end)
            members, damping = rated.members, rated.damping
        return MembersInTime(in_floats(members), damping, until, feature)


class MeshInMotion(NamedTuple):
    """start: (q, q̇); loads: [(instant, {(λ, p): v})] from instants on; rows: of a signal, over q, q̇, q̈; own: [(instant,
    function)] that inputs add to it from instants on; held: what it is counted from."""

    M: np.ndarray
    C: np.ndarray
    K: np.ndarray
    start: tuple[np.ndarray, np.ndarray]
    loads: list[tuple[float, dict[Any, Any]]]
    rows: np.ndarray
    own: list[tuple[float, ExponentialPolynomial]]
    held: float

    def beside(self, times: np.ndarray) -> np.ndarray:
        """What the signal has beside that of its rows."""
        total = np.full(len(times), self.held)
        for instant, function in self.own:
            here = times >= instant
            total[here] += values_of(function, times[here] - instant)
        return total


def values_of(function: ExponentialPolynomial, x: np.ndarray) -> np.ndarray:
    """A function in floats at many places."""
    return sum(((c * np.exp(complex(rate) * x)).real * x**power for (rate, power), c in function.terms.items()),
               np.zeros(len(x)))


def in_motion(members: "StartedMembers", divisions: int) -> MeshInMotion | None:
    """Members in floats; None where supports jump, as loads then do so without end."""
    mesh, driven = MeshedMembers(members.elements, divisions), range(members.n, members.end)
    M, C, K = mesh.matrices()
    free = np.delete(np.arange(mesh.size), driven)
    row = members.row
    rows = mesh.rows(members.place, (row.q, row.v, row.a) if row else ())
    pushes = {i: -K[:, i] for i in driven}
    for part in members.spread:
        pushes[part.input] += mesh.load(part.piece, partial(values_of, part.along))
    loads, own = [], []
    for i, instant, change in _changes(members):
        if instant and (M[free, i].any() or C[free, i].any()) and not _is_smooth(change, members.inputs[i]):
            return None
        slopes = change, change.rate().in_floats(), change.rate().rate().in_floats()
        loads.append((instant, _summed(zip(slopes, (pushes[i][free], -C[free, i], -M[free, i]), strict=True))))
        own.append((instant, sum((function * x for function, x in zip(slopes, rows[:, i], strict=True)),
                                  NOTHING).in_floats()))
    start = tuple(values[free] for values in _start(members, mesh))
    held = 0.0
    if members.holding:
        pushed = sum(x * pushes[i][free] for i, x in members.holding.items())
        held = rows[0, free] @ np.linalg.solve(K[np.ix_(free, free)], pushed)
    M, C, K = (part[np.ix_(free, free)] for part in (M, C, K))
    return MeshInMotion(M, C, K, start, loads, rows[:, free], own, float(held))


def _changes(members: "StartedMembers") -> Iterator[tuple[int, float, ExponentialPolynomial]]:
    """(input, instant, by what it changes from there on)"""
    for i, parts in members.inputs.items():
        before = NOTHING
        for part in parts:
            yield i, part.start, (part.function - before).from_(part.start).in_floats()
            before = part.function


def _is_smooth(change: ExponentialPolynomial, parts: "Sequence[Any]") -> bool:
    """Does neither it nor its rate jump?"""
    for function, others in ((change, [part.function for part in parts]),
                             (change.rate(), [part.function.rate() for part in parts])):
        size = max(abs(c) for one in others for c in one.terms.values()) if any(one.terms for one in others) else 0.0
        if abs(function.at(0)) > SAME * size:
            return False
    return True


def _summed(pairs: Iterator[Any]) -> dict[tuple[complex, int], np.ndarray]:
    """{(λ, p): v} of functions times vectors."""
    found: dict[tuple[Any, ...], np.ndarray] = {}
    for function, vector in pairs:
        for key, c in function.terms.items():
            found[key] = found.get(key, 0) + c * vector
    return found


def _start(members: "StartedMembers", mesh: MeshedMembers) -> np.ndarray:
    """(q, q̇) of all nodes."""
    both = np.zeros((2, mesh.size))
    n = len(members.start[0])
    both[:, :n] = np.array(members.start, float)
    for placed, nodes, fields in zip(members.elements.pieces, mesh.nodes, members.fields, strict=True):
        for k, rows in enumerate(nodes[1:-1], 1):
            x = np.array([k * placed.piece.length / mesh.divisions])
            for values, field in zip(both, fields, strict=True):
                for function, row in zip((field, field.rate()), rows, strict=False):
                    (i, _), = row.items()
                    values[i] = values_of(function, x)[0]
    return both
