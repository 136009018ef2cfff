"""A scene shaken: its modes again of the same system written otherwise, which leaves them as they are.

Masses, stiffnesses and dampers by powers of two, units of coordinates by two, every other coordinate the other way
round: equal to the last bit. Coordinates and elements in another order, each spring as two in parallel or in series:
within the bounds of both.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, cast

import mpmath

from vibcli.analyses.modal.modes import damped_modes, natural_modes
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.factored_system import FactoredSystem, summed
from vibcli.results.problem import Problem

EXACT = 4000        # bits in which changes of numbers of mpmath are exact
EQUAL, WITHIN, BROKEN, REFUSED = "equal", "within bounds", "broken", "refused"
Change = Callable[[Any], Any]


class Shake(NamedTuple):
    """What was changed; `compared`: how many numbers were; `apart`: the largest difference of two values beside the sum
    of their bounds; verdict: equal, within bounds, broken or refused; why, or of which number."""

    change: str
    compared: int
    apart: float
    verdict: str
    why: str = ""


class Rewriting(NamedTuple):
    """A change of element data by which rates become `rate` times as large, to the last bit where `bits`."""

    name: str
    change: Change
    rate: int
    bits: bool


def shaken(problem: Problem) -> Iterator[Shake]:
    """The Shakes of a scene without members, none of one with; PhysicsError of one that is in letters."""
    if problem.numeric.has_free_symbols:
        raise PhysicsError("a scene in letters is not shaken: its parameters need values", "give them with --set")
    if problem.scene.pieces or problem.modal.many or not problem.scene.q:
        return
    for law in LAWS:
        yield _shake(problem, law)


def _shake(problem: Problem, law: Rewriting) -> Shake:
    try:
        pairs = [pair for damped in (False, True) for pair in _pairs(problem, law, damped)]
    except PhysicsError as error:
        return Shake(law.name, 0, 0.0, REFUSED, error.message)
    if None in pairs:
        return Shake(law.name, 0, float("inf"), BROKEN, "another number of modes")
    apart = max((abs(a - b) / max(bound, 5e-324) for a, b, bound in pairs if a != b), default=0.0)
    same = all(a == b for a, b, _ in pairs)
    verdict = EQUAL if same else WITHIN if apart <= 1 and not law.bits else BROKEN
    return Shake(law.name, len(pairs), apart, verdict)


def _pairs(problem: Problem, law: Rewriting, damped: bool) -> list[tuple[complex, complex, float]]:
    """[(λ, λ of the changed system over its rate, the sum of their bounds)] of natural or damped modes; [None] where
    these are not as many."""
    configuration = problem.configuration
    if damped and not problem.modal.damps:
        return []
    one = _rates(configuration.linear_system, configuration.sources, damped)
    sources = [_following(law.change, source) for source in configuration.sources]
    two = _rates(law.change(configuration.linear_system), sources, damped)
    if len(one) != len(two):
        return [None]
    return [(a, b / law.rate, abs(a) * error + abs(b / law.rate) * other)
            for (a, error), (b, other) in zip(one, two, strict=True)]


def _rates(elements: FactoredSystem, sources: Sequence[Callable[..., Any]],
           damped: bool) -> list[tuple[complex, float]]:
    """[(λ, the relative bound of its error)] by Im λ and Re λ."""
    precise, exact = sources
    found = natural_modes(elements, precise, exact)
    if damped:
        modes = damped_modes(elements, lambda: found, precise, exact)
        pairs = [(complex(mode.eigenvalue), mode.error) for mode in modes or ()]
    else:
        pairs = [(complex(mode.growth_rate or 0.0, mode.omega or 0.0), mode.error) for mode in found]
    return sorted(pairs, key=lambda pair: (pair[0].imag, pair[0].real))


def _following(change: Callable[..., Any], source: Callable[..., Any]) -> Callable[..., FactoredSystem] | None:
    """What evaluates element data, changed."""
    def changed(*args: Any) -> "FactoredSystem | None":
        with mpmath.workprec(EXACT):
            found = source(*args)
            return cast("FactoredSystem | None", None if found is None else change(found))
    return None if source is None else changed


def _weighed(mass: int, damper: int, stiffness: int) -> Change:
    """Weights of each kind by integers."""
    factors = {"inertias": mass, "M": mass, "dampers": damper, "C": damper, "G": damper, "drag": damper,
               "springs": stiffness, "K": stiffness, "K_size": stiffness}

    def change(elements: FactoredSystem) -> FactoredSystem:
        parts: dict[str, Any] = {}
        for kind, factor in factors.items():
            part = getattr(elements, kind)
            parts[kind] = ({pair: factor * x for pair, x in part.items()} if isinstance(part, dict)
                           else [(factor * weight, row) for weight, row in part])
        return elements.with_parts(**parts)
    return change


def _moved(number: Callable[[int, int], int], factor: Callable[[int], int]) -> Change:
    """Coordinate i as number(i, n), factor(i) times as large a unit."""
    def change(elements: FactoredSystem) -> FactoredSystem:
        n = elements.n

        def row(entries: Any) -> dict[int, Any]:
            return {number(i, n): factor(i) * x for i, x in entries.items()}

        parts: dict[str, Any] = {kind: [(weight, row(entries)) for weight, entries in getattr(elements, kind)]
                                 for kind in ("inertias", "springs", "dampers")}
        parts |= {kind: {(number(i, n), number(j, n)): factor(i) * factor(j) * x
                         for (i, j), x in getattr(elements, kind).items()} for kind in ("M", "C", "G", "K", "drag")}
        parts["K_size"] = {(number(i, n), number(j, n)): abs(factor(i) * factor(j)) * x
                           for (i, j), x in elements.K_size.items()}
        rows = elements.rational_rows
        return elements.with_parts(massless=[number(i, n) for i in elements.massless],
                                   rational_rows=None if rows is None else list(map(row, rows)), **parts)
    return change


def _reordered(elements: FactoredSystem) -> FactoredSystem:
    """Coordinates and elements from the last to the first."""
    found = _moved(lambda i, n: n - 1 - i, lambda i: 1)(elements)
    rows = found.rational_rows
    return cast("FactoredSystem", found.with_parts(
        inertias=found.inertias[::-1], springs=found.springs[::-1], dampers=found.dampers[::-1],
        rational_rows=None if rows is None else rows[::-1]))


def _in_parallel(elements: Any) -> Any:
    """Each spring as two of half the stiffness."""
    rows = elements.rational_rows
    return elements.with_parts(springs=[(k / 2, row) for k, row in elements.springs for _ in "ab"],
                               rational_rows=None if rows is None else [row for row in rows for _ in "ab"])


def _in_series(elements: Any) -> Any:
    """Each spring as two of twice the stiffness, between them a coordinate without inertia."""
    springs, rows, n = [], elements.rational_rows, elements.n
    for place, (k, row) in enumerate(elements.springs):
        springs += [(2 * k, {n + place: 1}), (2 * k, summed(row, {n + place: -1}))]
    exact = None if rows is None else [half for place, row in enumerate(rows)
                                       for half in ({n + place: 1}, {**row, n + place: -1})]
    return elements.with_parts(n=n + len(elements.springs), springs=springs, rational_rows=exact,
                               massless=[*elements.massless, *range(n, n + len(elements.springs))])


LAWS = (
    Rewriting("masses, dampers, stiffnesses × 4", _weighed(4, 4, 4), 1, True),
    Rewriting("times / 2", _weighed(1, 2, 4), 2, True),
    Rewriting("every other coordinate × 2", _moved(lambda i, n: i, lambda i: 1 + i % 2), 1, True),
    Rewriting("every other coordinate the other way", _moved(lambda i, n: i, lambda i: 1 - 2 * (i % 2)), 1, True),
    Rewriting("coordinates and elements reordered", _reordered, 1, False),
    Rewriting("springs as two in parallel", _in_parallel, 1, False),
    Rewriting("springs as two in series", _in_series, 1, False),
)
