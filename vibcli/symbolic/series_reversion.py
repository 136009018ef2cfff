"""Parts in series as power series: F(D) and the inner deflections dᵢ(D) from those of the laws Fᵢ(dᵢ).

With wᵢ, W and f the deviations of dᵢ, D and F from where they are, Fᵢ = cᵢ wᵢ^nᵢ (1 + …) and n the largest of the nᵢ,
f = uⁿ makes every wᵢ a power series of u where all nᵢ divide n:

    u^(n/nᵢ) = yᵢ(wᵢ) = wᵢ (cᵢ (1 + …))^(1/nᵢ)        W = Σ wᵢ(u)        f = u(W)ⁿ

each of them reversed by Lagrange's formula, wₖ = (1/k) [t^(k−1)] (y(t)/t)^(−k) (Henrici, Applied and Computational
Complex Analysis 1, 1974, 1.9). Where some nᵢ does not divide n there is no such series.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.truncated_polynomials import NoDerivative, Polynomial, Polynomials

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.running_errors import Rounded
    from vibcli.symbolic.series_of_laws import SeriesOfLaws

DEGREES = 1, 3, 12      # up to which the degree is looked for with which a law begins

Coefficients = list[Any]


def expanded(parts: "SeriesOfLaws", outer: Polynomials, args: Sequence[Any],
             order: int) -> tuple[Coefficients, list[Coefficients]]:
    """(coefficients of F, those of each dᵢ, in all of them that of order 0 first) about the arguments of a call, D and
    the parameters, in the numbers of the arithmetic inside `outer`."""
    inner, side = outer.inner, outer.side
    places = _places(parts, inner, args, side)
    degrees = [_degree(parts, i, inner, side, args, places) for i in range(parts.count)]
    n = max(degrees)
    if any(n % degree for degree in degrees):
        raise NoDerivative("power")
    ring = ring_to(order + n, inner, side)
    deviations = [_deviation(ring, _series(parts, i, ring, args, places), degree, n)
                  for i, degree in enumerate(degrees)]
    total = _line(ring, _sums(ring, deviations))
    u = _line(ring, reversed_series(ring, total))
    found = [_coefficients(ring.composed(deviation, u), order) for deviation in deviations]
    force = _coefficients(ring.power(u, n), order)
    return force, [[place, *own[1:]] for place, own in zip(places, found, strict=True)]


def ring_to(order: int, inner: Any, side: Any) -> Polynomials:
    """Polynomials in one variable to an order."""
    return Polynomials(inner, 1, lambda powers: powers[0] <= order, order, side)


def reversed_series(ring: Polynomials, series: Any) -> Coefficients:
    """The coefficients of w(y), of order 0 first, where y(w) = Σ_{k>0} yₖ wᵏ."""
    shifted = Polynomial(ring, {(k - 1,): c for (k,), c in series.terms.items() if k})
    found = [ring.inner.number(0)]
    for k in range(1, ring.order + 1):
        power = ring.power(shifted, Fraction(-k))
        found.append(power.terms.get((k - 1,), ring.inner.number(0)) * ring.inner.number(Fraction(1, k)))
    return found


def _places(parts: "SeriesOfLaws", inner: Any, args: Sequence[Any], side: Callable[..., Any]) -> list[Any]:
    """The inner deflections about which is expanded."""
    if side(args[0]) == 0:
        return [inner.number(0)] * parts.count
    return [inner.called(parts.functions[f"{parts.name}.{i + 1}"])(*args) for i in range(parts.count)]


def _series(parts: "SeriesOfLaws", i: int, ring: Polynomials, args: Sequence[Any], places: Sequence[Any]) -> Polynomial:
    """Fᵢ as a polynomial of the deviation of dᵢ."""
    values = {symbol.name: ring.still(value) for symbol, value in zip(parts.p, args[1:], strict=True)}
    values[parts.d[i].name] = ring.variable(0, places[i])
    found: Polynomial = evaluate([parts.forces[i]], ring, values)[0]
    return found


def _degree(parts: "SeriesOfLaws", i: int, inner: Any, side: Callable[..., Any], args: Sequence[Any],
            places: Sequence[Any]) -> int:
    """The degree with which Fᵢ begins to deviate."""
    for order in DEGREES:
        series = _series(parts, i, ring_to(order, inner, side), args, places)
        for k in range(1, order + 1):
            if (k,) in series.terms and side(series.terms[k,]) != 0:
                return k
    raise NoDerivative("power")


def _deviation(ring: Polynomials, series: Polynomial, degree: int, n: int) -> Coefficients:
    """The coefficients of wᵢ by powers of u."""
    ratio = Polynomial(ring, {(k - degree,): c for (k,), c in series.terms.items() if k >= degree})
    root = ratio if degree == 1 else ring.power(ratio, Fraction(1, degree))
    reversed_ = reversed_series(ring, root * ring.variable(0, ring.inner.number(0)))
    found = [ring.inner.number(0)] * (ring.order + 1)
    for k, c in enumerate(reversed_[:ring.order * degree // n + 1]):
        found[k * n // degree] = c
    return found


def _sums(ring: Polynomials, columns: "Sequence[list[Node | Rounded]]") -> "list[Node | Rounded]":
    return [sum(column[1:], column[0]) for column in zip(*columns, strict=True)]


def _line(ring: Polynomials, coefficients: "Sequence[Node | Rounded]") -> Polynomial:
    """The polynomial that has these coefficients, but for its constant."""
    return Polynomial(ring, {(k,): c for k, c in enumerate(coefficients) if k})


def _coefficients(series: Polynomial, order: int) -> "list[Node | Rounded]":
    zero = series.ring.inner.number(0)
    return [series.terms.get((k,), zero) for k in range(order + 1)]
