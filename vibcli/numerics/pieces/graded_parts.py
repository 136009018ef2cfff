"""A piece whose tension N + n x varies along it, cut into parts so short that power series about their middles serve.

In η = (x − middle)/h, h half a part's length, u = Σ c_k ηᵏ follows from its first coefficients by

    beams: (k+4)(k+3)(k+2)(k+1) c_{k+4} = ν (k+2)(k+1) c_{k+2} + γ (k+1)² c_{k+1} − χ c_k,
    else:              (k+2)(k+1) c_{k+2} = χ c_k − ρ (k+1)² c_{k+1},

ν = N h²/B, γ = n h³/B, χ = κ h⁴/B, but χ = κ h²/N, ρ = n h/N of strings. Where N vanishes at an end only one solution
is bounded there, c_{k+1} = (κ x/n) c_k/(k+1)²; that end then bears no force whatever its value is.
"""

from functools import lru_cache
from math import inf, log, perm
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    import mpmath

    from vibcli.numerics.pieces.arithmetic import Arithmetic
    from vibcli.numerics.pieces.piece import Piece

MEASURE = 4.0       # |ν| + |γ| + 2 √|χ| at most: nothing cancels in the series, and no part vibrates between held ends
WIDEN = 0.5         # a part of a string is at most so long as this times its distance to where N would vanish
BEYOND = 5.0        # nepers past rounding
GUARD = 20          # bits of integers beyond those of numbers
NIL = 2.0**-50      # of the largest tension: an end with less has none


def parts_of(piece: "Piece", most: float) -> "list[float | mpmath.mpf]":
    """The places of the cuts, ends included, for |κ| ≤ most; one piece in numbers, N ≥ 0 growing with x where it is
    no beam."""
    length = piece.length
    if piece.order == 4:
        largest = max(abs(piece.tension), abs(piece.tension + piece.gradient * length))
        need = (largest + abs(piece.gradient) * length / 2 + 2 * float(most * piece.bending) ** 0.5) / piece.bending
        count = max(1, int(float(length) / 2 * (float(need) / MEASURE) ** 0.5) + 1)
        return [length * i / count for i in range(count + 1)]
    if piece.tension < 0 and not is_slack(piece):
        raise ValueError("what does not bend is pressed")
    cuts = [0 * length]
    if is_slack(piece):
        cuts.append(cuts[0] + min(length, piece.gradient / most if most else length))
    while cuts[-1] < length:
        tension = piece.tension + piece.gradient * cuts[-1]
        step = WIDEN * tension / piece.gradient
        if most:
            step = min(step, 2 * (tension / most) ** 0.5)
        rest = length - cuts[-1]
        cuts.append(length if rest < 1.2 * step else cuts[-1] + step)
    return cuts


def depth_of(piece: "Piece", kappa: Any, numbers: "Arithmetic") -> float:
    """How far from x = 0 what moves there is felt at a real κ, to rounding, going there and back; infinite where that
    is not plain. With κ > 0 all decays: like √(κ/N) per length where nothing bends, else by ½ (κ/B)^¼ at least, as long
    as N² ≤ B κ."""
    kappa, tension, gradient = float(kappa), float(piece.tension), float(piece.gradient)
    nepers = BEYOND - log(numbers.eps) / 2
    if kappa <= 0:
        return inf
    if piece.order == 2:
        found: float = nepers * (max(tension, 0.0) / kappa) ** 0.5 + gradient * nepers**2 / (4 * kappa)
        return found
    if max(abs(tension), abs(tension + gradient * float(piece.length))) ** 2 > float(piece.bending) * kappa:
        return inf
    result: float = 2 * nepers * (float(piece.bending) / kappa) ** 0.25
    return result


def is_slack(piece: "Piece") -> bool:
    """Does the tension of what is no beam vanish at x = 0?"""
    return bool(abs(piece.tension) <= NIL * abs(piece.gradient * piece.length))


def part_stiffness(piece: "Piece", cuts: "list[float | mpmath.mpf]", kappa: np.ndarray, series: "Series",
                   numbers: "Arithmetic") -> tuple[np.ndarray, np.ndarray | None]:
    """(d, ∂d/∂κ or None) of all parts, (parts, κ, m, m), from their `coefficients`."""
    ends, forces, *slopes = _end_values(piece, cuts, series, numbers)
    inverse = numbers.inverse(ends)
    found = [forces @ inverse]
    if slopes:
        found.append((slopes[1] - found[0] @ slopes[0]) @ inverse)
    if piece.order == 2 and is_slack(piece):
        for values, next_to_slack in zip(found, _slack(piece, cuts[1], kappa, numbers), strict=False):
            values[0] = next_to_slack
    found = [(values + values.swapaxes(-1, -2)) / 2 for values in found]
    return found[0], found[1] if slopes else None


class Series(NamedTuple):
    """c_k and ∂c_k/∂χ (or None) of all parts, (terms, parts, κ, m), a column for each first coefficient; ∂χ/∂κ and h,
    (parts, 1, 1). bits: the c are integers, multiples of 2^−bits; None where they are numbers."""

    c: np.ndarray
    slope: np.ndarray | None
    scale: np.ndarray
    half: np.ndarray
    bits: int | None

    def numbers(self, values: np.ndarray) -> np.ndarray:
        """What is found of the c, as numbers."""
        if self.bits is None:
            return values
        from mpmath import mp

        found: np.ndarray = np.frompyfunc(lambda value: mp.ldexp(value, -self.bits), 1, 1)(values)
        return found


def coefficients(piece: "Piece", cuts: "list[float | mpmath.mpf]", kappa: np.ndarray, numbers: "Arithmetic",
                 steep: bool = True) -> Series:
    """The Series of a piece: as no coefficient is large, those of real numbers of mpmath are found in integers."""
    cuts_array, order = numbers.array(cuts), piece.order
    half = ((cuts_array[1:] - cuts_array[:-1]) / 2)[:, None, None]
    tension = (cuts_array[1:, None, None] - half) * piece.gradient + piece.tension
    scale = half**order / (piece.bending if order == 4 else tension)
    shares = [kappa[None, :, None] * scale, half * piece.gradient * (half**2 / piece.bending if order == 4 else
                                                                     1 / tension)]
    shares += [tension * half**2 / piece.bending] if order == 4 else []
    bits, one = None, 1
    if numbers.number is not None and numbers.is_real(kappa):
        from mpmath import mp

        bits = mp.prec + GUARD
        one, whole = 1 << bits, np.frompyfunc(lambda value: int(mp.ldexp(value, bits)), 1, 1)
        shares = [whole(share) for share in shares]
    both = np.zeros((numbers.terms(order) + order, 1 + steep, len(half), len(kappa), order), shares[0].dtype)
    for i in range(order):
        both[i, 0, ..., i] = one
    _continued(both, shares, one, bits is not None)
    return Series(both[:, 0], both[:, 1] if steep else None, scale, half, bits)


def _continued(both: np.ndarray, shares: list[np.ndarray], one: int, whole: bool) -> None:
    """All further c_k, and ∂c_k/∂χ where it stands beside them, (terms, 1 or 2, …), from the first; shares: χ and γ, ν
    or χ and ρ, multiples of 1/one."""
    chi, gamma, *nu = shares
    order = 4 if nu else 2
    for k in range(len(both) - order):
        below = (k + 2) * (k + 1)
        if nu:
            found = nu[0] * below * both[k + 2] + gamma * (k + 1) ** 2 * both[k + 1] - chi * both[k]
            found[1:] -= one * both[k, :1]
            below *= (k + 4) * (k + 3)
        else:
            found = chi * both[k] - gamma * (k + 1) ** 2 * both[k + 1]
            found[1:] += one * both[k, :1]
        both[k + order] = found // (below * one) if whole else found / below


def sums(c: np.ndarray, eta: Any, derivative: int) -> Any:
    """Σ k!/(k − j)! c_k ηᵏ⁻ʲ: the j-th derivative by η."""
    found = c[-1] * 0
    for k in range(len(c) - 1, derivative - 1, -1):
        found = found * eta + perm(k, derivative) * c[k]
    return found


def end_derivatives(c: np.ndarray, count: int) -> np.ndarray:
    """The same of the first `count` derivatives at η = −1 and η = 1, (2, count, …): of doubles in one product, else by
    what is even and odd in η."""
    if c.dtype.kind != "O":
        return np.tensordot(_at_ends(len(c), count), c, 1)
    found = np.empty((2, count, *c.shape[1:]), c.dtype)
    for derivative in range(count):
        weights = np.array([perm(k, derivative) for k in range(derivative, len(c))], object)
        terms = weights.reshape(-1, *[1] * (c.ndim - 1)) * c[derivative:] if derivative else c
        even, odd = terms[::2].sum(axis=0), terms[1::2].sum(axis=0)
        found[:, derivative] = even - odd, even + odd
    return found


@lru_cache
def _at_ends(terms: int, count: int) -> np.ndarray:
    """The derivatives of ηᵏ at η = −1 and η = 1, (2, count, terms)."""
    return np.array([[[perm(k, derivative) * eta ** (k - derivative) if k >= derivative else 0 for k in range(terms)]
                      for derivative in range(count)] for eta in (-1.0, 1.0)])


def slack_series(piece: "Piece", x: Any, kappa: np.ndarray, numbers: "Arithmetic") -> tuple[Any, Any, Any, Any]:
    """(u, x u′) of the bounded solution, 1 where N = 0, and their derivatives by κ."""
    z = kappa * x / piece.gradient
    term, slope = z * 0 + 1, z * 0
    found = [term, slope, slope, slope]
    for k in range(1, numbers.terms(2)):
        term, slope = term * z / k**2, (term + slope * z) / k**2
        found = [found[0] + term, found[1] + k * term, found[2] + slope, found[3] + k * slope]
    return found[0], found[1], found[2] * x / piece.gradient, found[3] * x / piece.gradient


def _end_values(piece: "Piece", cuts: "list[float | mpmath.mpf]", series: Series,
                numbers: "Arithmetic") -> list[np.ndarray]:
    """End values and end forces of the solutions, rows, and their derivatives by κ if there are slopes: arrays (parts,
    κ, m, m)."""
    places, half = numbers.array(cuts), series.half
    found = []
    for c, scale in ((series.c, 1), (series.slope, series.scale))[:1 if series.slope is None else 2]:
        values, forces = [], []
        at_ends = series.numbers(end_derivatives(c, piece.order)) * scale
        for eta, place, sums_at in zip((-1, 1), (places[:-1], places[1:]), at_ends, strict=True):
            tension = (place * piece.gradient + piece.tension)[:, None, None]
            first = sums_at[1] / half
            values.append(sums_at[0])
            if piece.order == 4:
                values.append(first)
                forces.append(eta * (tension * first - sums_at[3] * piece.bending / half**3))
                forces.append(eta * sums_at[2] * piece.bending / half**2)
            else:
                forces.append(eta * tension * first)
        found += [np.stack(values, axis=-2), np.stack(forces, axis=-2)]
    return found


def _slack(piece: "Piece", end: "float | mpmath.mpf", kappa: np.ndarray,
           numbers: "Arithmetic") -> tuple[np.ndarray, np.ndarray]:
    """Of the part next to the end without tension: forces only at its other end."""
    u, pull, u_slope, pull_slope = slack_series(piece, end, kappa, numbers)
    own = pull * piece.gradient / u
    zero = own * 0
    slope = (pull_slope * piece.gradient - own * u_slope) / u
    one, rate = (np.stack([np.stack([zero, zero], axis=-1), np.stack([zero, value], axis=-1)], axis=-2)
                 for value in (own, slope))
    return one, rate
