"""A whole scene shaken: it is read and solved again with its lengths, masses or times four times as large, its elements
in another order, each spring as two, and has to rest, swing and answer as before.

Where the scene rests and how it swings has to stay to the last bit where units change by powers of two (members apart,
which are solved by their own lengths, parameters that are searched, and lengths beside angles where nothing is drawn
that has a size), all else within the bounds of both.
"""

import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any, cast

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.stress.mirrored import NotDrawn, mirrored
from vibcli.evidence.stress.rewritten import (
    OF_ELEMENTS,
    PARTS,
    in_parallel,
    power_of_two,
    reordered,
    scaled,
    with_numbers,
)
from vibcli.evidence.stress.shaken import BROKEN, EQUAL, REFUSED, WITHIN, Shake
from vibcli.evidence.stress.turned_coordinates import turned_round
from vibcli.language.sections.law_table import LawTable
from vibcli.language.sections.record import dimension
from vibcli.quantities.dimensions import asked_dimension, dimension_of
from vibcli.quantities.expression import bounded
from vibcli.quantities.quantity import COMPLEX, LEAPING, OF_STATE, kind_of
from vibcli.reader.sections.choose import LIMIT
from vibcli.results.problem import Problem
from vibcli.symbolic.running_errors import error_in, number_in
from vibcli.symbolic.syntax import ExpressionError, QuantityRef

if TYPE_CHECKING:
    from vibcli.language.document.nodes import Mapping
    from vibcli.language.reader import Expression, Record
    from vibcli.language.spec import Spec

RATE = {"s": -1}
AT_LIMIT = 2.0**-26     # of the largest rate: what rounding leaves of one that vanishes at a limit of stability
CHOSEN = 2.0**-40       # of the largest rate: by what rounding of what is chosen moves others
NONE = 0, 0, 0
WORD = re.compile(r"[^\W\d]\w*")
SENSED = re.compile(r"\b(arg|phase|ritz|rayleigh|[MCKG])\b|\.(?=[^\W\d])")      # what hangs on the sense of coordinates
NUMBERED = re.compile(r"\b([MCKG]\[\d|modal_mass\[)")       # by the numbers of coordinates, or by which is the first
PLACED = re.compile(r"\[[^\]]*\([^)\]]*\d\s+[^\W\d]")     # at a place in numbers within [ ], which stay as they are
OF_ORDER = re.compile(r"\bmode(_d)?\[")         # shapes in which the first coordinate is 1, whichever that is


class SceneLaw(NamedTuple):
    """change(top of the document): of the scene written otherwise; the powers of 4 of lengths, masses and times."""

    name: str
    change: Callable[[Any], Any]
    powers: tuple[int, int, int] = NONE


class Bounded(NamedTuple):
    """A number, the bound of its error, and its dimension."""

    value: Any
    error: float
    dimension: Any


def _of_units(length: int, mass: int, time: int) -> SceneLaw:
    powers = length, mass, time
    name = ("lengths", "masses", "times")[powers.index(1)]
    return SceneLaw(f"{name} × 4", partial(with_numbers, change=scaled(*powers)), powers)


LAWS = (_of_units(1, 0, 0), _of_units(0, 1, 0), _of_units(0, 0, 1), SceneLaw("elements reordered", reordered),
        SceneLaw("springs as two in parallel", in_parallel), SceneLaw("mirrored", mirrored))


def shaken_as_a_whole(problem: Problem, remade: "Callable[[Callable[[Mapping], Mapping]], Problem]") -> Iterator[Shake]:
    """The Shakes of a scene in numbers; remade(change): the Problem of its document changed."""
    known = {what: numbers for what, find in GROUPS.items() if (numbers := _found(find, problem)[0])}
    for law in LAWS:
        if law.change is in_parallel and not problem.spec.get("springs"):
            continue
        turned: set[str] = set()
        try:
            _require_told(problem, law)
            other = remade(partial(_changed, problem, law, turned))
            other.draw()
        except NotDrawn:
            continue
        except (PhysicsError, SpecError) as error:
            yield Shake(law.name, 0, 0.0, REFUSED, getattr(error, "message", "") or error.diagnostics[0].message)
            continue
        for what, numbers in known.items():
            told = {key: one for key, one in numbers.items() if _is_told(key, law, problem, turned)}
            if told:
                yield _shake(problem, other, law, what, {
                    key: one._replace(value=-one.value) if key in turned else one for key, one in told.items()})


def _require_told(problem: Problem, law: SceneLaw) -> None:
    """PhysicsError where units change, and not all that is given does with them, or springs, and what is chosen hangs
    on the name of one."""
    conditions = [record["so"].text for record in (problem.spec.choices or {}).values()]
    if law.change is in_parallel and any(_names_a_spring(problem.spec, text) for text in conditions):
        raise PhysicsError("what is chosen hangs on one of its springs by name")
    if (law.powers != NONE or law.change is in_parallel) and any(map(_measured, _parts(problem.spec))):
        raise PhysicsError("its tables stay as they were measured")
    if law.powers == NONE:
        return
    letters = set(problem.given).difference(problem.spec.choices or ())
    if problem.spec.free_numbers or letters:
        raise PhysicsError(f"its {'letters' if letters else 'numbers'} have no units: nobody says how they change")
    for record in (problem.spec.get("records") or {}).values():
        if law.powers[2] or _power(dimension(record) or {}, law):
            raise PhysicsError("its records stay as they were measured")


def _parts(spec: "Spec") -> "Iterator[Record]":
    """The records of springs and dampers, and of all that they consist of."""
    pending = [record for kind in ("springs", "dampers") for record in (spec.get(kind) or {}).values()]
    while pending:
        yield (record := pending.pop())
        pending += [part for key in PARTS for part in record.get(key, ())]


def _measured(record: "Record") -> bool:
    """Is its law a table of a file?"""
    law = record.get("law")
    return isinstance(law, LawTable) and law.points[0][0].expression is None


def _require_alike(problem: Problem, law: SceneLaw, turned: set[str]) -> None:
    """PhysicsError where what is chosen hangs on a sense that a mirror turns."""
    conditions = [record["so"] for record in (problem.spec.choices or {}).values()]
    if not all(one.word or _is_told(one.text, law, problem, turned) for one in conditions):
        raise PhysicsError("what is chosen hangs on what has another sense in a mirror")


def _power(measured: Any, law: SceneLaw) -> Fraction:
    """That of 4 by which what has a dimension grows."""
    return sum((step * Fraction(measured.get(base, 0)) for base, step in
                zip(("m", "kg", "s"), law.powers, strict=True)), Fraction(0))


def _changed(problem: Problem, law: SceneLaw, turned: set[Any], top: "Mapping") -> "Mapping":
    """The document changed; `turned` holds the coordinates then that have the other sign in it."""
    if law.change is mirrored:
        turned |= turned_round(top)
        _require_alike(problem, law, turned)
    return cast("Mapping", law.change(top))


def _found(find: Callable[[Problem], dict[str, Bounded]], problem: Problem) -> tuple[dict[str, Bounded], str]:
    """(numbers, ""), or (nothing, why) of what is refused."""
    try:
        return find(problem), ""
    except PhysicsError as error:
        return {}, error.message


def _shake(problem: Problem, other: Problem, law: SceneLaw, what: str, numbers: dict[str, Bounded]) -> Shake:
    """The Shake of the numbers of a scene beside those of the one written otherwise."""
    name = f"{law.name}: {what}"
    if what == "answers" and set(other.scene.coordinates) != set(problem.scene.coordinates):
        return Shake(name, 0, 0.0, REFUSED, "other coordinates are independent then")
    its, why = _found(GROUPS[what], other)
    if law.powers != NONE and what == "answers":        # by their places, as numbers within them are others
        its = dict(zip(numbers, its.values(), strict=False)) if len(its) == len(numbers) else {}
    pairs = {key: (one, _back(its[key], law)) for key, one in numbers.items() if key in its}
    if what == "modes" and not why and len(its) != len(numbers):
        return Shake(name, 0, float("inf"), BROKEN, "another number of them")
    if not pairs:
        return Shake(name, 0, 0.0, REFUSED, why or "not found there")
    far = [(abs(a.value - b.value) / max(a.error + b.error, 5e-324), key)
           for key, (a, b) in pairs.items() if a.value != b.value]
    apart, worst = max(far, default=(0.0, ""))
    exact = what != "answers" and law.powers != NONE and not problem.scene.pieces and not problem.spec.choices and not (
        what == "rest" and law.powers[0] and _beside_angles(problem))
    return Shake(name, len(pairs), apart, EQUAL if not far else WITHIN if apart <= 1 and not exact else BROKEN, worst)


def _beside_angles(problem: Problem) -> bool:
    """Do lengths stand beside angles in a scene that has no size to measure them by?"""
    lengths = {bool(problem.system.dimension(name)) for name in problem.scene.coordinates}
    return len(lengths) > 1 and not problem.numeric.figure_size


def _back(one: Bounded, law: SceneLaw) -> Bounded:
    """A number of the scene written otherwise in the units of the first."""
    factor = float(power_of_two(_power(one.dimension, law)))
    return Bounded(one.value / factor, one.error / factor, one.dimension)


def _is_told(key: str, law: SceneLaw, problem: Problem, turned: set[str]) -> bool:
    """Where springs are two, what is asked of one by its name is another thing; what has a sense is in a mirror, what
    is numbered in another order."""
    if law.change is mirrored and ("." in key or key not in problem.scene.coordinates):
        named = {name for kind in OF_ELEMENTS for name in problem.spec.get(kind) or ()} | turned
        return named.isdisjoint(WORD.findall(key)) and not SENSED.search(key)
    if law.change is reordered:
        return not NUMBERED.search(key)
    if law.powers != NONE and PLACED.search(key):
        return False
    return law.change is not in_parallel or not _names_a_spring(problem.spec, key)


def _names_a_spring(spec: "Spec", text: str) -> bool:
    return any(re.search(rf"\b{re.escape(name)}[.,\]]", text) for name in spec.get("springs") or ())


def _places(problem: Problem) -> dict[str, Bounded]:
    """{coordinate: where it rests}."""
    values = problem.configuration.bounded_rest[1]
    return {name: Bounded(float(number_in(values[name])), float(error_in(values[name])), problem.system.dimension(name))
            for name in problem.scene.coordinates}


def _rates(problem: Problem) -> dict[str, Bounded]:
    """{which mode: λ} of natural modes, and of damped ones, by Im λ and Re λ, of lumped bodies."""
    if problem.scene.pieces or problem.modal.many:
        return {}
    natural = [(complex(mode.growth_rate or 0.0, mode.omega or 0.0), float(mode.error)) for mode in problem.modal.modes]
    damped = [(complex(mode.eigenvalue), float(mode.error)) for mode in problem.modal.damped or ()]
    felt = _felt(problem, max((abs(rate) for rate, _ in natural + damped), default=0.0))
    return {f"{what} {number}": Bounded(rate, max(abs(rate) * error, felt(abs(rate))), RATE)
            for what, found in (("mode", natural), ("damped mode", damped))
            for number, (rate, error) in enumerate(sorted(found, key=lambda one: (one[0].imag, one[0].real)), 1)}


def _felt(problem: Problem, largest: float) -> Callable[..., float]:
    """By how much what is chosen may be off in a rate of a size."""
    conditions = [record["so"] for record in (problem.spec.choices or {}).values()]
    vanishing = AT_LIMIT * largest * any(one.word == LIMIT or "0" in [side.text for side in one.sides]
                                         for one in conditions)
    others = CHOSEN * largest * bool(conditions)
    return lambda size: max(others, vanishing if size <= vanishing else 0.0)


def _answers(problem: Problem) -> dict[str, Bounded]:
    """{what is asked: its value} of numbers that hang on no order of coordinates, in the order of the file."""
    found = {}
    for answer in problem.spec.answers:
        dimension = _dimension(problem.spec, answer.asked)
        if dimension is None or OF_ORDER.search(answer.asked.text) or (
                kind_of(problem.spec, answer.asked.tree) in (*OF_STATE, *LEAPING, COMPLEX)):
            continue
        try:
            value, error = bounded(problem, answer.asked)
        except PhysicsError:
            continue
        found[answer.asked.text] = Bounded(float(value), float(error), dimension)
    return found


def _dimension(spec: "Spec", asked: "Expression") -> Any:
    try:
        found = (asked_dimension(spec, asked.tree) if isinstance(asked.tree, QuantityRef) else
                 dimension_of(spec, asked))
    except ExpressionError:
        return None
    return None if found is None else spec.dimensions.resolve(found)


GROUPS: dict[str, Callable[[Problem], dict[str, Bounded]]] = {"rest": _places, "modes": _rates, "answers": _answers}
