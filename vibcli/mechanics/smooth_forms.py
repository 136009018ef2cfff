"""Loads f(x) that are no sums of powers, exponentials and sines, as polynomials on panels, to rounding.

On each panel f = Σ cⱼ Pⱼ, cⱼ = (2j + 1) ∫₀¹ f Pⱼ dr by Gauss's rule, as powers of the distance from its middle: the
coefficients fall faster than those of Pⱼ grow. Next to an end at which f is finite but no power series panels are
halved until what is left of it is rounding.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.numerics.pieces.loads import LoadForm, LoadStretch, LoadTerm
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.gauss_points import gauss_points
from vibcli.symbolic.smooth_panels import POINTS, NotSmooth, intervals, panels

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from vibcli.symbolic.node import Node
    from vibcli.symbolic.running_errors import RunningErrors

PRECISE = 96            # points of a panel where more digits are asked for
ROUNDING = 2.0**-51     # of coefficients in floats


def smooth_form(f: "Node", x: "Node", ends: "tuple[Node, Node]", values: "Mapping[str, Any]",
                arithmetic: Any) -> LoadForm:
    """f between two places; values: {name: number} of all symbols but x. NotSmooth where there is none, or
    not to the digits that are asked for."""
    floats, found = {name: float(value) for name, value in values.items()}, []
    for low, high in intervals([f], x, ends, floats):
        a, b = evaluate([low, high], Floats, floats)
        first, last = evaluate([low, high], arithmetic, values)
        for panel in panels(lambda place: evaluate([f], Floats, {**floats, x.name: place}), (a, b), broken=False):
            if not panel.plain and arithmetic is not Floats:
                raise NotSmooth(f"is no power series at {a if panel.a == 0 else b:.6g} m: more digits of what it does "
                                "are not found", "ask for fewer digits")
            start, end = (first + (last - first) * arithmetic.number(share) for share in (panel.a, panel.b))
            count = POINTS * 3 // 4 if panel.plain else 1
            found.append(_stretch(f, x, (start, end), values, arithmetic, count))
    return LoadForm(tuple(found))


def _stretch(f: "Node", x: "Node", ends: tuple[Any, Any], values: "Mapping[str, Any]", arithmetic: "RunningErrors",
             count: int) -> LoadStretch:
    middle, half = (ends[0] + ends[1]) / 2, (ends[1] - ends[0]) / 2
    found = legendre_powers(f, x, ends, values, arithmetic, count)
    return LoadStretch(*ends, middle, tuple(LoadTerm(c / half**k, k, 0) for k, c in enumerate(found) if c))


def legendre_powers(f: "Node", x: "Node", ends: "tuple[Any, Any]", values: "Mapping[str, Any]",
                    arithmetic: Any = Floats, count: int = POINTS * 3 // 4) -> list[Any]:
    """Coefficients of powers of −1 … 1 of a function on a panel; in floats no more than `count`."""
    middle, half = (ends[0] + ends[1]) / 2, (ends[1] - ends[0]) / 2
    rule = gauss_points(POINTS if arithmetic is Floats else PRECISE)
    places = [arithmetic.number(2 * r - 1) for r, _ in rule]
    given = [evaluate([f], arithmetic, {**values, x.name: middle + half * r})[0] for r in places]
    weighted = [arithmetic.number(w) * y for (_, w), y in zip(rule, given, strict=True)]
    return _powers(weighted, places, count if arithmetic is Floats else PRECISE * 3 // 4)


def powers_between(value: "Callable[[float], float]", start: float, end: float) -> list[float]:
    """Coefficients of powers of −1 … 1 of a function between two places, in floats."""
    middle, half, rule = (start + end) / 2, (end - start) / 2, gauss_points(POINTS)
    places = [float(2 * r - 1) for r, _ in rule]
    weighted = [float(w) * value(middle + half * r) for (_, w), r in zip(rule, places, strict=True)]
    return _powers(weighted, places, POINTS * 3 // 4)


def _powers(weighted: Sequence[Any], places: Sequence[Any], count: int) -> list[Any]:
    """Coefficients of powers on −1 … 1, of values at places times their weights: as many Legendre polynomials as are
    not rounding."""
    before, now = [0 * places[0] for _ in places], [0 * places[0] + 1 for _ in places]
    older, newer, total, most = [], now[:1], [0 * places[0]] * count, 0.0
    for j in range(count):
        c = (2 * j + 1) * sum(w * p for w, p in zip(weighted, now, strict=True))
        most = max(most, abs(c))
        for k, one in enumerate(newer if abs(c) > ROUNDING * most or len(places) > POINTS else ()):
            total[k] = total[k] + c * one
        before, now = now, [((2 * j + 1) * t * p - j * q) / (j + 1)
                            for t, p, q in zip(places, now, before, strict=True)]
        older, newer = newer, [((2 * j + 1) * a - j * b) / (j + 1)
                               for a, b in zip([0, *newer], [*older, 0, 0], strict=True)]
    return total
