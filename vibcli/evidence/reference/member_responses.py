"""Responses of scenes with members to waves, to many digits: the equations of their power series under loads.

A (q, a) = (b, p) with the matrix of reference/members.py at z = Ω² and s = iΩ, in which inputs are coordinates that are
given, and p what loads along pieces do; a signal is read off coordinates, or off the series at a place of a piece.
"""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.members import START, at_ends, derivatives, equations, require_plain
from vibcli.evidence.reference.settled import DIGITS, TrueValues, settled
from vibcli.mechanics.inputs_outputs.inputs import named_input
from vibcli.mechanics.inputs_outputs.outputs import linear_row
from vibcli.mechanics.inputs_outputs.place_signals import PlaceOutput, place_output
from vibcli.mechanics.precise_configuration import PreciseConfiguration
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import FactoredSystem
    from vibcli.mechanics.inputs_outputs.base_excitation import SystemWithInputs
    from vibcli.results.problem import Problem
    from vibcli.scene.spread_forces import SpreadForce

MOST = 12               # of the power of a load along a member
SAME = 1e-20            # of a length: places nearer than that are one


class DrivenMembers(NamedTuple):
    """The element data, inputs being the coordinates from `n` on; `spread`: {input: [(piece, coefficients of (x/L)ᵏ)]}
    of a unit of loads along pieces; rows: {coordinate: number} of s⁰, s¹, s² of a signal; or the place where it is."""

    elements: "FactoredSystem"
    n: int
    spread: dict[Any, Any]
    rows: tuple[Any, ...]
    place: "PlaceOutput | None"

    def at(self, Omega: Any, given: Mapping[int, Any]) -> tuple[Any, Any]:
        """(the phasor of the signal where inputs have these, the size of the terms that it is summed of)."""
        z, s = mpmath.mpf(Omega) ** 2, mpmath.mpc(0, Omega)
        A, right = self._loaded(z, s, given)
        found = mpmath.lu_solve(A, right)
        if self.place is None:
            terms = [s**power * x * found[i] for power, row in enumerate(self.rows) for i, x in row.items()]
        else:
            factor = s**self.place.primes * self.place.factor
            terms = [factor * x for x in self._along(found, z, s, given)]
        return mpmath.fsum(terms), mpmath.fsum(map(abs, terms))

    def _loaded(self, z: mpmath.mpf, s: mpmath.mpc, given: Mapping[int, Any]) -> tuple[mpmath.matrix, mpmath.matrix]:
        A = equations(self.elements, z, s)
        right = mpmath.zeros(A.rows, 1)
        for i in range(self.n, self.elements.n):
            A[i, :] = mpmath.zeros(1, A.cols)
            A[i, i], right[i] = 1, given.get(i, 0)
        column = self.elements.n
        for number, placed in enumerate(self.elements.pieces):
            order, load = placed.piece.order, self._load(number, given)
            if any(load):
                far = derivatives(placed.piece, z, s, None, load)[:order]
                moves, forces = at_ends(placed.piece, [[0]] * order, [[x] for x in far])
                for place, (row, move, force) in enumerate(zip(placed.rows, moves, forces, strict=True)):
                    right[column + place] -= move[0]
                    for i, x in row.items():
                        right[i] -= x * force[0] if i < self.n else 0
            column += order
        return A, right

    def _load(self, number: int, given: Mapping[int, mpmath.mpf]) -> list[mpmath.mpc]:
        """The coefficients of what is spread along a piece."""
        found = [mpmath.mpc(0)] * (MOST + 1)
        for i, parts in self.spread.items():
            for piece, coefficients in parts:
                if piece == number:
                    found = [x + given.get(i, 0) * y for x, y in zip(found, coefficients, strict=True)]
        return found

    def _along(self, found: mpmath.matrix, z: mpmath.mpf, s: mpmath.mpc, given: Mapping[int, Any]) -> list[mpmath.mpf]:
        """The terms of the derivative of u at the place."""
        number, share, order = self.place.piece, self.place.share, self.place.order
        piece = self.elements.pieces[number].piece
        column = self.elements.n + sum(placed.piece.order for placed in self.elements.pieces[:number])
        if not share and order < piece.order:
            return [found[column + order] * (1, 1, 2, 6)[order]]
        part = piece._replace(length=share * piece.length)
        load = [x * share**k for k, x in enumerate(self._load(number, given))]
        terms = [found[column + k] * derivatives(part, z, s, k)[order] for k in range(piece.order)]
        return [*terms, derivatives(part, z, s, None, load)[order]] if any(load) else terms


def driven_members(problem: "Problem", signal: str, about: PreciseConfiguration | None = None,
                   lossless: bool = False) -> DrivenMembers:
    """Those of a scene that lead to a signal, at the working precision, about another configuration perhaps;
    PhysicsError of members that lose energy in their material, unless that is left out."""
    configuration = about or PreciseConfiguration(problem.configuration)
    opened, place = configuration.with_inputs, place_output(configuration, signal)
    require_plain(opened.elements)
    if not lossless and (problem.spec.get("damping") is not None or any(
            placed.retardation for placed in opened.elements.pieces)):
        raise PhysicsError("no reference is found of responses of members that lose energy in their material, or by "
                           "`damping:`")
    row = None if place else linear_row(configuration, signal)
    if row is not None and row.time:
        raise PhysicsError("no reference is found of signals of scenes with members that loads enter themselves")
    return DrivenMembers(opened.elements, opened.n, _spread(opened), (row.q, row.v, row.a) if row else (), place)


def _spread(opened: "SystemWithInputs") -> dict[Any, Any]:
    """{input: [(piece, coefficients)]} of a unit of each load along members that varies in time."""
    scene = opened.scene
    return {i: _on_pieces(opened, scene.spread_forces[one.spread]) for i, one in enumerate(
        scene.inputs.values(), opened.n) if one.spread is not None}


def _on_pieces(opened: "SystemWithInputs", force: "SpreadForce") -> list[tuple[int, list[mpmath.mpf]]]:
    """What a unit of a load does on pieces that lie within it."""
    found, (start, end) = [], evaluate([force.start, force.end], opened.arithmetic, opened.values)
    for number, placed in enumerate(opened.elements.pieces):
        left, right = placed.start, placed.start + placed.piece.length
        slack = SAME * placed.piece.length
        if placed.owner != force.member or right <= start + slack or left >= end - slack:
            continue
        if left < start - slack or right > end + slack:
            raise PhysicsError("no reference is found of a load that ends within a piece of a member")
        found.append((number, _taylor(opened, force, left, placed.piece.length)))
    return found


def _taylor(opened: "SystemWithInputs", force: "SpreadForce", start: mpmath.mpf, length: int) -> list[mpmath.mpf]:
    """The coefficients of (x/L)ᵏ of a load from the left end of a piece on."""
    node, found, factor = force.along, [], mpmath.mpf(1)
    for k in range(MOST + 1):
        x, = evaluate([node], opened.arithmetic, {**opened.values, force.x.name: start})
        found.append(x * factor)
        node, factor = gradient(node).get(force.x, opened.scene.table.zero), factor * length / (k + 1)
    if not node.is_zero:
        raise PhysicsError("no reference is found of loads along members that are no polynomials")
    return found


def driven_in_floats(problem: "Problem", signal: str, given: Callable[[], Mapping[int, Any]], lossless: bool = False
                     ) -> tuple[DrivenMembers, dict[int, complex]]:
    """(them, the phasors of inputs) in floats."""
    with mpmath.workdps(30):
        exact, inputs = driven_members(problem, signal, None, lossless), given()
    return _in_floats(exact), {i: complex(x) for i, x in inputs.items()}


def _in_floats(exact: Any) -> DrivenMembers:
    rows = tuple({i: float(x) for i, x in row.items()} for row in exact.rows)
    spread = {i: [(piece, [float(x) for x in part]) for piece, part in parts] for i, parts in exact.spread.items()}
    place = exact.place and exact.place._replace(share=float(exact.place.share), factor=float(exact.place.factor))
    return DrivenMembers(exact.elements.each(float), exact.n, spread, rows, place)


def given_by(problem: "Problem", driver: str) -> Callable[[Any], dict[int, Any]]:
    """Ω ↦ {input: phasor} of a unit of an input by its name, at the working precision."""
    chosen = named_input(PreciseConfiguration(problem.configuration), driver)
    if chosen.carried:
        raise PhysicsError("no reference is found of a load that turns with what is driven")
    return lambda Omega: {i: x * mpmath.mpf(Omega) ** (2 * chosen.turns) for i, x in chosen.weights.items()}


def value(problem: "Problem", signal: str, driver: str, Omega: Callable[[], Any]) -> TrueValues:
    """H at a frequency, which is evaluated at the working precision."""
    def found() -> "tuple[list[mpmath.mpc], None]":
        here = Omega()
        return [driven_members(problem, signal).at(here, given_by(problem, driver)(here))[0]], None

    return settled(found, DIGITS, START)
