"""Values of the chosen parameters of a scene with numbers: candidates in letters where these are all that there can
be, else a search over the admissible range; each is tried by substitution."""

from collections.abc import Sequence
from fractions import Fraction
from math import asinh, atanh, exp, isfinite, log, sinh
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.inverse import infeasible
from vibcli.inverse.admissible_ranges import grid
from vibcli.inverse.conditions import ConditionSystem
from vibcli.inverse.folds import followed
from vibcli.inverse.solution import choosing, in_numbers, shortened
from vibcli.inverse.symbolic_conditions import candidates, determined_alone, independent
from vibcli.numerics.root_finding import holds_everywhere, longest_plateau, zeros

if TYPE_CHECKING:
    from vibcli.inverse.admissible_ranges import Range
    from vibcli.numerics.root_finding import Scan
    from vibcli.results.problem import Problem
    from vibcli.symbolic.equations.univariate import Candidates
    from vibcli.symbolic.node import Node

SAME, ALIKE, NEARLY, DECADES, SPARSE = 1e-6, 1e-11, 1.0 - 1e-15, 3, 8
PLACES = (1e-2, 0.13, 1.0, 7.0, 1e2)


def solve(system: ConditionSystem,
          thorough: bool = False) -> "list[tuple[list[Fraction], tuple[Node | None, ...]]]":
    """[(values, closed forms, None where unknown)], ascending, of what the problem of a ConditionSystem chooses."""
    problem = system.problem
    system.settle_scales([[span.scale * factor for span in system.ranges] for factor in PLACES])
    letters = candidates(problem, thorough)
    always = system.shares and _in_place(problem) and (letters.always if letters is not None else independent(problem))
    if letters is not None and letters.always:
        letters = None
    accepted = []
    for nodes in letters.tuples if letters is not None else ():
        values = in_numbers(problem, nodes)
        if values is not None and _new(values, accepted) and system.admits(values) and system.holds(values)[0]:
            accepted.append((values, nodes))
    proven = letters is not None and letters.complete and system.shares and _in_place(problem)
    if not proven:
        found = _one_by_one(problem, system, thorough) if len(system.names) > 1 and system.shares else None
        if found is None:
            found = [(values, _form_of(problem, letters, values)) for values in _looked_for(system, always)]
        accepted += [pair for pair in found if _new(pair[0], accepted)]
    if not accepted:
        raise infeasible.none_found(system, _scanned(system)[1] if len(system.names) == 1 else None, proven)
    return sorted(accepted, key=lambda pair: pair[0])


def _in_place(problem: "Problem") -> bool:
    """Is the equilibrium the same one for all values, so that conditions in letters are those of the scene?"""
    return problem.system.is_linear or problem.symbolic.balanced_as_drawn


def _form_of(problem: "Problem", letters: "Candidates | None", values: list[Fraction]) -> "tuple[Node | None, ...]":
    """The closed forms of a solution that was looked for, where letters give the same numbers: at a fold they hold
    though the equilibrium there is none that a search would reach."""
    for nodes in letters.tuples if letters is not None else ():
        known = in_numbers(problem, nodes)
        if known is not None and all(abs(x - y) <= ALIKE * abs(y) for x, y in zip(known, values, strict=True)):
            return tuple(nodes)
    return (None,) * len(values)


def _new(values: list[Fraction], accepted: "list[tuple[list[Fraction], tuple[Node, ...]]]") -> bool:
    """Is this none of the solutions that are known already?"""
    return not any(all(abs(x - y) <= SAME * max(abs(x), abs(y)) for x, y in zip(values, known, strict=True))
                   for known, _ in accepted)


def _one_by_one(problem: "Problem", system: ConditionSystem,
                thorough: bool) -> "list[tuple[list[Fraction], tuple[Node | None, ...]]]":
    """The solutions where one condition determines one parameter alone; None where none does. The others are solved for
    at each of its values, the conditions given to the parameters that are left in order."""
    alone = determined_alone(problem)
    if alone is None:
        return None
    name, found, entry = alone
    left = [other for other in system.names if other != name]
    records = [record for key, record in problem.spec.choices.items() if key != entry]
    pairs = {other: problem.spec.choices[other].with_values({**problem.spec.choices[other], "so": record["so"]})
             for other, record in zip(left, records, strict=True)}
    accepted = []
    for node, in found.tuples:
        value = in_numbers(problem, [node])
        if value is None or not system.ranges[system.names.index(name)].holds(value[0]):
            continue
        try:
            inner = solve(ConditionSystem(choosing(problem.with_values({name: value[0]}), pairs)), thorough)
        except PhysicsError:
            continue
        for values, _ in inner:
            known = {name: value[0], **dict(zip(left, values, strict=True))}
            forms = {**dict.fromkeys(left), name: node}
            accepted.append(([known[key] for key in system.names], tuple(forms[key] for key in system.names)))
    return [pair for pair in accepted if system.holds(pair[0])[0]]


def _looked_for(system: ConditionSystem, always: bool) -> list[list[Fraction]]:
    """Solutions by looking, as lists of Fractions; always: do letters prove that the conditions hold everywhere?"""
    if len(system.names) == 1:
        found, scan = _scanned(system)
        if holds_everywhere(scan):
            raise infeasible.undetermined(system.problem, None if always else [x for x, _ in scan.defined()])
        plateau = longest_plateau(scan)
        if plateau and (not found or any(plateau[0] <= x <= plateau[1] for x in found)):
            tried = [x for x, _ in scan.defined() if plateau[0] <= x <= plateau[1]]
            raise infeasible.undetermined(system.problem, tried)
        places: list[Any] = [*_followed_to(system, scan), *([x] for x in found)]
    else:
        places = _newton(system)
    return [values for values in (_shortened(system, place) for place in places) if values is not None]


def _followed_to(system: ConditionSystem, scan: "Scan") -> list[list[float]]:
    """The limits of an equilibrium that moves with the parameter, followed from value to value."""
    if _in_place(system.problem):
        return []
    limits, ends = followed(system, [x for x in grid(system.ranges[0]) if x in scan.points])
    system.know(limits, ends)
    return [[limit.value] for limit in limits if system.admits([limit.value])]


def _shortened(system: ConditionSystem, place: Sequence[Any]) -> list[Fraction]:
    """A solution whose numbers are short decimals where those hold as well; None where it does not hold."""
    good, residual = system.holds(place)
    if not good:
        return None
    short = list(map(shortened, place))
    near = all(abs(y - Fraction(x)) <= abs(x) * 1e-12 for x, y in zip(place, short, strict=True))
    if near and system.limit(place) is None:
        better, rest = system.holds(short)
        if better and rest <= max(residual, 1e-14):
            return short
    return [Fraction(x) for x in place]


def _scanned(system: ConditionSystem) -> "tuple[list[float], Scan]":
    """(zeros, Scan) of the conditions on one parameter."""
    span = system.ranges[0]
    points = grid(span)
    system.settle_scales([[x] for x in points[::SPARSE]])
    row = _liveliest(system, points[::SPARSE])

    def function(x: float) -> float | None:
        found = system.misfits([x])
        return None if found is None else found[row]

    return zeros(function, points, span.closed)


def _liveliest(system: ConditionSystem, points: list[float]) -> int:
    """Of several conditions of equilibrium the one that depends most on the parameter."""
    found = [misfits for misfits in (system.misfits([x]) for x in points) if misfits is not None]
    if not found or len(found[0]) == 1:
        return 0
    return max(range(len(found[0])), key=lambda i: max(m[i] for m in found) - min(m[i] for m in found))


def _newton(system: ConditionSystem) -> list[list[float]]:
    """Zeros of several conditions, in logarithms of what is positive."""
    spans = system.ranges

    def values(u: Sequence[float]) -> list[float]:
        return [span.scale * (exp(x) if span.low >= 0 else sinh(x)) for span, x in zip(spans, u, strict=True)]

    def function(u: Sequence[float]) -> list[float] | None:
        if max(map(abs, u)) > 50:
            return None
        place = values(u)
        found = system.misfits(place) if system.admits(place) else None
        return None if found is None else [2 * atanh(max(-NEARLY, min(NEARLY, h))) for h in found]

    def start(point: Sequence[float]) -> list[float]:
        return [_start(span, p) for span, p in zip(spans, point, strict=True)]

    from vibcli.numerics.newton_systems import common_zeros

    return sorted(values(u) for u in common_zeros(function, start, len(spans)))


def _start(span: "Range", p: float) -> float:
    """A place within a range for p from 0 to 1, as a logarithm (or asinh) of its ratio to the natural scale."""
    if isfinite(span.low) and isfinite(span.high):
        x = span.low + (span.high - span.low) * (0.02 + 0.96 * p)
        if span.low > 0 and span.high > 10 * span.low:
            x = span.low * (span.high / span.low) ** p
        return log(x / span.scale) if span.low >= 0 else asinh(x / span.scale)
    return (2 * p - 1) * DECADES * log(10)
