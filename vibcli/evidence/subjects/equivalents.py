"""What springs or dampers that end at a place resist with there, other ends held: how the force on that place changes
where it is moved, of dampers with how fast it moves,

    F = Σ N(|r + u|) (r + u)/|r + u|,       r from the other end to the place,       K = ∂F/∂u,

N being the tension over the length, of a damper over its rate v·n."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np

from vibcli.evidence.reference.differences import coefficient
from vibcli.evidence.reference.settled import TrueValues, settled
from vibcli.evidence.reference.static_positions import equations, resting_place
from vibcli.evidence.subject import BY_DIFFERENCES, Subject, of_number
from vibcli.evidence.subjects.expansions import moved, tension
from vibcli.mechanics.concurrent import ending_at, same_place
from vibcli.mechanics.configuration import Configuration
from vibcli.quantities import equilibrium
from vibcli.quantities.equivalents import SECTIONS
from vibcli.quantities.expression import measure
from vibcli.quantities.quantity import about_which, declared
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef

DIGITS, START, LIMIT = 30, 60, 240
UPRIGHT = 1e-8          # the tangent of what floats cannot tell from a right angle
Force = Callable[[Sequence[Any]], tuple[Any, Any]]      # on a place, as a function of how far it is moved


def of_place(problem: "Problem", tree: "QuantityRef") -> Subject:
    """stiffness[P].max, damping[P].xy …"""
    measure(problem, tree)          # refused where there is none
    asked, which = about_which(tree)
    one = problem if which is None else equilibrium.about(problem, int(which))
    static, size = equations(one.configuration), declared(asked).size(one, asked)

    def found() -> "tuple[list[mpmath.mpf], float | mpmath.mpf]":
        arithmetic = multiprecision()
        known = one.numeric.values(arithmetic)
        rest = {**known, **resting_place(one.configuration, static, known)}
        step, small = (mpmath.mpf(10) ** (-mpmath.mp.dps // part) for part in (3, 2))
        value = _read(asked.component, _tensor(_force(one, asked, arithmetic, rest), step), mpmath, small)
        nothing = abs(value) <= size * small
        return [mpmath.mpf(0) if nothing else value], max(size, abs(value))

    true: TrueValues = settled(found, DIGITS, START, LIMIT, sized=True)
    plain = _force(one, asked, Floats, one.configuration.at_rest)
    return of_number(BY_DIFFERENCES, one, tree, "of the force on a place, its neighbours held", true,
                     lambda step: float(_read(asked.component, _tensor(plain, step), np, UPRIGHT)),
                     abs(float(true.values[0])) or size, lambda: problem.about(Configuration(problem.numeric)))


def _tensor(force: Callable[..., tuple[mpmath.mpf, mpmath.mpf]], step: mpmath.mpf) -> list[mpmath.mpf]:
    """(xx, xy, yy) of K."""
    def entry(axis: int, powers: tuple[int, int]) -> Any:
        return coefficient(lambda u: force(u)[axis], powers, [step, step])

    return [entry(0, (1, 0)), entry(0, (0, 1)), entry(1, (0, 1))]


def _read(component: str, tensor: list[mpmath.mpf], numbers: Any, small: mpmath.mpf) -> mpmath.mpf:
    """Its entry, or its largest or least value, or the direction of the largest: a part of it as small is none."""
    xx, xy, yy = tensor
    if component in ("xx", "xy", "yy"):
        return tensor[("xx", "xy", "yy").index(component)]
    middle, half = (xx + yy) / 2, numbers.sqrt((xx - yy) ** 2 / 4 + xy**2)
    if component == "angle":        # of the column of K − kmin that is the longer
        x, y = max((xx - middle + half, xy), (xy, yy - middle + half), key=lambda way: way[0] ** 2 + way[1] ** 2)
        return numbers.pi / 2 if abs(x) <= small * abs(y) else (np.arctan if numbers is np else mpmath.atan)(y / x)
    return middle + half if component == "max" else middle - half


def _force(problem: "Problem", asked: "QuantityRef", arithmetic: Any, rest: dict[str, float | mpmath.mpf]) -> Force:
    """The sum of what all elements exert that end there."""
    section, place = SECTIONS[asked.head], asked.indices[0]
    here, scene = same_place(problem.spec, problem.scene.resting, place), problem.scene.resting
    parts = [_of_element(problem, problem.spec.get(section)[name], here, arithmetic, rest)
             for name in ending_at(problem.spec, scene, place, section)]
    return lambda u: tuple(sum(axis) for axis in zip(*(part(u) for part in parts), strict=True))


def _of_element(problem: "Problem", record: "Record", here: set[str], arithmetic: Any,
                rest: dict[str, float | mpmath.mpf]) -> Callable[[Sequence[Any]], tuple[Any, Any]]:
    """That of one, by its tension along the line of its ends."""
    scene = problem.scene.resting
    ends = sorted(record["between"], key=lambda end: getattr(end, "text", None) in here)
    nodes = [x for end in ends for x in scene.place_of(end)]
    known = moved(problem, [], arithmetic, rest)([])
    ax, ay, bx, by = evaluate(nodes, arithmetic, known)
    terms, half = scene.terms_of(record.name), arithmetic.number(1) / 2
    if len(terms) > 1:              # without free length
        k, = evaluate([terms[0].weight], arithmetic, known)
        return lambda u: (k * (bx - ax + u[0]), k * (by - ay + u[1]))
    s, force = tension(scene, terms[0])
    length, damps = _root(bx - ax, by - ay, half), terms[0] in scene.dampers or getattr(terms[0], "damper", False)
    s0 = arithmetic.number(0) if damps else evaluate([s], arithmetic, known)[0]

    def on_place(u: Sequence[Any]) -> tuple[Any, Any]:
        x, y = (bx - ax, by - ay) if damps else (bx - ax + u[0], by - ay + u[1])
        far = _root(x, y, half)
        N = force(arithmetic, known, (x * u[0] + y * u[1]) / far if damps else s0 + far - length)
        return N * x / far, N * y / far

    return on_place


def _root(x: float | mpmath.mpf, y: float | mpmath.mpf, half: float | mpmath.mpf) -> float | mpmath.mpf:
    return (x * x + y * y) ** half
