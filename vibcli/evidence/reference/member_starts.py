"""Members in time, as far as the element data say: what moves their inputs, what is spread along them, and the fields
and coordinates that they start with, in numbers of mpmath at the working precision.

A force that lets go has held them: they start where it bends them, d, and move as under its opposite from rest,
y = d + y₋F.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.exponential_polynomials import EvenStretch, ExponentialPolynomial, stretches
from vibcli.language.spec import RELEASED
from vibcli.mechanics.initial_fields import member_fields
from vibcli.mechanics.inputs_outputs.outputs import linear_row
from vibcli.mechanics.inputs_outputs.place_signals import PlaceOutput, place_output
from vibcli.mechanics.linearise import load_at_rest
from vibcli.mechanics.precise_configuration import PreciseConfiguration
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece
    from vibcli.mechanics.inputs_outputs.base_excitation import SystemWithInputs
    from vibcli.mechanics.inputs_outputs.linear_functions import LinearFunction
    from vibcli.results.problem import Problem

AGREE = 1e-9            # of the largest: how near a start in floats is to that of more digits


class SpreadPart(NamedTuple):
    """What a unit of an input is along a piece, from its left end on."""

    input: int
    piece: int
    along: ExponentialPolynomial


class StartedMembers(NamedTuple):
    """elements: with inputs as coordinates from n up to `end`, inputs: {number: what moves it}; start: (q, q̇) of all of
    them at t = 0; fields: (u, u̇) of each piece there, counted from its left end; held: what a signal is counted
    from; holding: {input: what it is before it lets go}."""

    elements: "FactoredSystem"
    n: int
    end: int
    inputs: "dict[int, list[EvenStretch]]"
    spread: list[SpreadPart]
    start: tuple[list[Any], list[Any]]
    fields: list[tuple[ExponentialPolynomial, ...]]
    row: "LinearFunction | None"
    place: PlaceOutput | None
    held: Any
    holding: dict[int, Any]

    def at_first(self) -> Any:
        """The signal at t = 0; PhysicsError of accelerations and of what is made of them."""
        row, place, total = self.row, self.place, self.held
        if place is not None and place.primes < 2:
            field = self.fields[place.piece][place.primes]
            for _ in range(place.order):
                field = field.rate()
            return total + place.factor * field.at(place.share * self.elements.pieces[place.piece].piece.length)
        if row is None or any(row.a.values()):
            raise PhysicsError("no reference is found of this signal at its start")
        return total + mpmath.fsum(x * values[i] for part, values in zip((row.q, row.v), self.start, strict=True)
                                   for i, x in part.items())


def started_members(problem: "Problem", signal: str, until: Any) -> StartedMembers:
    """Those of a scene, and a signal of them, up to an instant; PhysicsError of what is not found of them."""
    near = problem.configuration
    _require_no_load_at_rest(near)
    configuration = PreciseConfiguration(near)
    configuration = configuration if near.preloaded is None else configuration.preloaded
    opened, place = configuration.with_inputs, place_output(configuration, signal)
    row = None if place else linear_row(configuration, signal)
    if row is not None and row.time:
        raise PhysicsError("no reference is found of signals of scenes with members that loads enter themselves")
    moves = _inputs(problem, opened, mpmath.mpf(until or 1))
    spread = [part for i, one in enumerate(opened.scene.inputs.values(), opened.n) if one.spread is not None
              for part in _spread(opened, opened.scene.spread_forces[one.spread], i)]
    elements, cuts, fields = _with_fields(problem, opened)
    spread = [SpreadPart(i, new, along.from_(offset)) for i, piece, along in spread
              for new, offset in cuts[piece]]
    place = place and _in_parts(place, cuts, opened.elements.pieces, elements.pieces)
    held, holding = mpmath.mpf(0), {}
    if near.preloaded is not None:
        from vibcli.evidence.reference.member_responses import driven_members

        holding = {i: -one[0].function.at(0) for i, one in moves.items() if _lets_go(problem, opened, i)}
        held, _ = driven_members(problem, signal, configuration, True).at(0, holding)
    start = _start(problem, opened, elements, fields, moves)
    return StartedMembers(elements, opened.n, opened.elements.n, moves, spread, start, fields, row, place,
                          mpmath.re(held), holding)


def _require_no_load_at_rest(near: "Configuration") -> None:
    scene = near.scene
    loaded = any(not load.q.is_zero for load in scene.spread_loads)
    if scene.gravity or loaded or any(near.equilibrium.values.values()):
        raise PhysicsError("no reference in time is found of members that rest under loads")
    if any(placed.piece.gradient for placed in near.linear_system.pieces):
        raise PhysicsError("no reference in time is found of members whose tension varies along them")


def _lets_go(problem: "Problem", opened: "SystemWithInputs", number: int) -> bool:
    return list(opened.scene.inputs.values())[number - opened.n].name == problem.spec.let_go


def _inputs(problem: "Problem", opened: "SystemWithInputs", until: mpmath.mpf) -> dict[int, list[EvenStretch]]:
    """{number of an input: what moves it}, of a force that lets go its opposite."""
    scene, found = opened.scene, {}
    known = {name: x for name, x in opened.values.items() if name != scene.time.name}
    for number, one in enumerate(scene.inputs.values(), opened.n):
        lets_go = _lets_go(problem, opened, number)
        node = one.node
        if one.spread is not None:
            node = scene.spread_forces[one.spread].weight
        elif one.load is not None:
            steady, turning, waving, constant = load_at_rest(scene, scene.forces[one.load])
            if turning.mask:
                raise PhysicsError("no reference is found of a load that turns with what is driven")
            node = -(steady + waving + constant) if lets_go else waving + constant
        if node is not None and not node.is_zero:
            found[number] = stretches(-node if lets_go and one.spread is not None else node, scene.time, known, until)
    return found


def _spread(opened: "SystemWithInputs", force: Any, number: int) -> Iterator[Any]:
    """The SpreadParts of a load along a member, on pieces that lie within it."""
    start, end = evaluate([force.start, force.end], opened.arithmetic, opened.values)
    known = {name: x for name, x in opened.values.items() if name != force.x.name}
    for piece, placed in enumerate(opened.elements.pieces):
        left, right = placed.start, placed.start + placed.piece.length
        slack = placed.piece.length * mpmath.mpf(10) ** -20
        if placed.owner != force.member or right <= start + slack or left >= end - slack:
            continue
        parts = stretches(force.along, force.x, known, right)
        inside = [part for part in parts if part.end > left + slack]
        if left < start - slack or right > end + slack or len(inside) > 1:
            raise PhysicsError("no reference is found of a load that ends or bends within a piece of a member")
        yield SpreadPart(number, piece, inside[0].function.from_(left))


def _with_fields(problem: "Problem", opened: "SystemWithInputs"
                 ) -> "tuple[FactoredSystem, dict[int, list[tuple[int, Any]]], list[tuple[Any, ...]]]":
    """(elements whose pieces end where a field bends, {piece: [(its number there, how far on)]}, the fields)."""
    given, scene = member_fields(problem.scene), problem.scene
    known = {name: x for name, x in opened.values.items() if name != scene.time.name}
    elements, cuts, fields, n = opened.elements, {}, [], opened.elements.n
    pieces: list[Any] = []
    for number, placed in enumerate(elements.pieces):
        own, end = given.get(placed.owner), placed.start + placed.piece.length
        both = [stretches(scene.table.zero if node is None else node, scene.time, known, end)
                for node in (own or (None, None))]
        places = sorted({part.end for parts in both for part in parts
                         if placed.start < part.end < end * (1 - mpmath.mpf(10) ** -20)})
        parts = _cut(placed, places, n)
        n += (len(parts) - 1) * (placed.piece.order // 2)
        cuts[number] = [(len(pieces) + k, part.start - placed.start) for k, part in enumerate(parts)]
        pieces += parts
        fields += [tuple(_at(one, part.start + part.piece.length / 2).from_(part.start) for one in both)
                   for part in parts]
    return elements.with_parts(n=n, pieces=pieces), cuts, fields


def _at(parts: Sequence[EvenStretch], place: mpmath.mpf) -> ExponentialPolynomial:
    return next(part.function for part in parts if part.end is None or place < part.end)


def _cut(placed: "PlacedPiece", places: Sequence[Any], n: int) -> "list[PlacedPiece]":
    """A piece in parts, between which it has coordinates of their own from n on."""
    found, half = [], placed.piece.order // 2
    for place in places:
        node = tuple({n + i: mpmath.mpf(1)} for i in range(half))
        length = place - placed.start
        found.append(placed._replace(piece=placed.piece._replace(length=length), rows=(*placed.rows[:half], *node)))
        placed = placed._replace(start=place, rows=(*node, *placed.rows[half:]), piece=placed.piece._replace(
            length=placed.piece.length - length))
        n += half
    return [*found, placed]


def _in_parts(place: PlaceOutput, cuts: Mapping[int, list[tuple[int, mpmath.mpf]]], before: "tuple[PlacedPiece, ...]",
              after: "tuple[PlacedPiece, ...]") -> PlaceOutput:
    """The same place on the part of its piece on which it lies."""
    at = place.share * before[place.piece].piece.length
    number, offset = [one for one in cuts[place.piece] if one[1] <= at][-1]
    return place._replace(piece=number, share=(at - offset) / after[number].piece.length)


def _start(problem: "Problem", opened: "SystemWithInputs", elements: "FactoredSystem",
           fields: Sequence[tuple[ExponentialPolynomial, ...]],
           moves: Mapping[int, list[EvenStretch]]) -> tuple[list[mpmath.mpf], list[mpmath.mpf]]:
    """(q, q̇) of all coordinates, by the fields where members start with these."""
    record, scene = problem.spec.get("initial"), problem.scene
    places, speeds = ([mpmath.mpf(0)] * elements.n for _ in range(2))
    given = {key: evaluate([scene.lower(expression)], opened.arithmetic, opened.values)[0]
             for key, expression in (record.items() if record is not None else ()) if key != RELEASED}
    for i, name in enumerate(scene.coordinates):
        places[i], speeds[i] = given.get(name, places[i]), given.get(name + "'", speeds[i])
    for number, parts in moves.items():
        places[number], speeds[number] = parts[0].function.at(0), parts[0].function.rate().at(0)
    for placed, (u, rate) in zip(elements.pieces, fields, strict=True):
        for row, x, order in _ends(placed):
            for values, field in ((places, u), (speeds, rate)):
                if len(row) == 1 and field.terms:
                    (i, factor), = row.items()
                    values[i] = (field if not order else field.rate()).at(x) / factor
    _require_alike(problem, places, speeds)
    if any(not u.terms and any(sum(x * places[i] for i, x in row.items()) for row in placed.rows)
           for placed, (u, _) in zip(elements.pieces, fields, strict=True)):
        raise PhysicsError("no reference is found of members without a field whose ends start elsewhere than they rest")
    return places, speeds


def _ends(placed: "PlacedPiece") -> list[tuple[dict[int, mpmath.mpf], mpmath.mpf, int]]:
    half = placed.piece.order // 2
    return [(row, placed.piece.length if k >= half else mpmath.mpf(0), k % half) for k, row in enumerate(placed.rows)]


def _require_alike(problem: "Problem", places: list[mpmath.mpf], speeds: list[mpmath.mpf]) -> None:
    """PhysicsError where the program's start in floats is another one."""
    if problem.configuration.preloaded is not None:
        return
    for kind, values in zip(problem.initial.start, (places, speeds), strict=True):
        size = max(map(abs, kind.values()), default=0.0)
        if any(abs(float(x) - kind[name]) > AGREE * size
               for name, x in zip(problem.scene.coordinates, values, strict=False)):
            raise PhysicsError("no reference is found of how these members start")
