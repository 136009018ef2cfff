"""A piece whose tension N + n x varies along it, cut into parts so short that power series about their middles serve.

In η = (x − middle)/h, h half a part's length, u = Σ c_k ηᵏ follows from its first coefficients by

    beams: (k+4)(k+3)(k+2)(k+1) c_{k+4} = ν (k+2)(k+1) c_{k+2} + γ (k+1)² c_{k+1} − χ c_k,
    else:              (k+2)(k+1) c_{k+2} = χ c_k − ρ (k+1)² c_{k+1},

ν = N h²/B, γ = n h³/B, χ = κ h⁴/B, but χ = κ h²/N, ρ = n h/N of strings. Where N vanishes at an end only one solution
is bounded there, c_{k+1} = (κ x/n) c_k/(k+1)²; that end then bears no force whatever its value is.
"""

from functools import cache
from math import inf, log, perm
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from vibcli.numerics.pieces.arithmetic import Arithmetic
    from vibcli.numerics.pieces.piece import Piece

MEASURE = 4.0       # |ν| + |γ| + 2 √|χ| at most: nothing cancels in the series, and no part vibrates between held ends
WIDEN = 0.5         # a part of a string is at most so long as this times its distance to where N would vanish
BEYOND = 5.0        # nepers past rounding
NIL = 2.0**-50      # of the largest tension: an end with less has none


def parts_of(piece: "Piece", most: float) -> list:
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
        return nepers * (max(tension, 0.0) / kappa) ** 0.5 + gradient * nepers**2 / (4 * kappa)
    if max(abs(tension), abs(tension + gradient * float(piece.length))) ** 2 > float(piece.bending) * kappa:
        return inf
    return 2 * nepers * (float(piece.bending) / kappa) ** 0.25


def is_slack(piece: "Piece") -> bool:
    """Does the tension of what is no beam vanish at x = 0?"""
    return bool(abs(piece.tension) <= NIL * abs(piece.gradient * piece.length))


def part_stiffness(piece: "Piece", cuts: list, kappa: np.ndarray, series: tuple,
                   numbers: "Arithmetic") -> tuple[np.ndarray, np.ndarray]:
    """(d, ∂d/∂κ) of all parts, (parts, κ, m, m), from their `coefficients`."""
    ends, forces, slopes, force_slopes = _end_values(piece, cuts, series, numbers)
    inverse = numbers.inverse(ends)
    stiffness = forces @ inverse
    slope = (force_slopes - stiffness @ slopes) @ inverse
    if piece.order == 2 and is_slack(piece):
        stiffness[0], slope[0] = _slack(piece, cuts[1], kappa, numbers)
    return tuple((values + values.swapaxes(-1, -2)) / 2 for values in (stiffness, slope))


def coefficients(piece: "Piece", cuts: list, kappa: np.ndarray,
                 numbers: "Arithmetic") -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(c_k, ∂c_k/∂κ, h): arrays (terms, parts, κ, m), a column for each first coefficient; h (parts, 1, 1)."""
    cuts_array = numbers.array(cuts)
    half = ((cuts_array[1:] - cuts_array[:-1]) / 2)[:, None, None]
    tension = (cuts_array[1:, None, None] - half) * piece.gradient + piece.tension
    order, kappa = piece.order, kappa[None, :, None]
    zero = kappa * half * 0
    scale = half**order / (piece.bending if order == 4 else tension)
    nu, gamma = tension * half**2 * scale / half**4, half**3 * piece.gradient * scale / half**4
    chi, rho = kappa * scale, half * piece.gradient / tension if order == 2 else None
    first = np.stack([zero + numbers.array([int(i == j) for j in range(order)]) for i in range(order)])
    both = np.stack([first, first * 0], axis=1)         # c_k and ∂c_k/∂κ, (terms, 2, parts, κ, m)
    both = np.concatenate([both, np.zeros((numbers.terms(order), *both.shape[1:]), both.dtype)])
    for k in range(numbers.terms(order)):
        if order == 4:
            below = (k + 4) * (k + 3) * (k + 2) * (k + 1)
            found = nu * ((k + 2) * (k + 1)) * both[k + 2] + gamma * (k + 1) ** 2 * both[k + 1] - chi * both[k]
            found[1] -= scale * both[k, 0]
        else:
            below = (k + 2) * (k + 1)
            found = chi * both[k] - rho * (k + 1) ** 2 * both[k + 1]
            found[1] += scale * both[k, 0]
        both[k + order] = found / below
    return both[:, 0], both[:, 1], half


def sums(c: np.ndarray, eta: Any, derivative: int) -> Any:
    """Σ k!/(k − j)! c_k ηᵏ⁻ʲ: the j-th derivative by η."""
    found = c[-1] * 0
    for k in range(len(c) - 1, derivative - 1, -1):
        found = found * eta + perm(k, derivative) * c[k]
    return found


def end_derivatives(c: np.ndarray, count: int, numbers: "Arithmetic") -> np.ndarray:
    """The same of the first `count` derivatives at η = −1 and η = 1, (2, count, …), in one product."""
    return np.tensordot(numbers.array(_weights_at_ends(len(c), count)), c, 1)


@cache
def _weights_at_ends(terms, count):
    return [[[perm(k, derivative) * eta ** (k - derivative) if k >= derivative else 0 for k in range(terms)]
             for derivative in range(count)] for eta in (-1, 1)]


def slack_series(piece: "Piece", x: Any, kappa: np.ndarray, numbers: "Arithmetic") -> tuple[Any, Any, Any, Any]:
    """(u, x u′) of the bounded solution, 1 where N = 0, and their derivatives by κ."""
    z = kappa * x / piece.gradient
    term, slope = z * 0 + 1, z * 0
    found = [term, slope, slope, slope]
    for k in range(1, numbers.terms(2)):
        term, slope = term * z / k**2, (term + slope * z) / k**2
        found = [found[0] + term, found[1] + k * term, found[2] + slope, found[3] + k * slope]
    return found[0], found[1], found[2] * x / piece.gradient, found[3] * x / piece.gradient


def _end_values(piece, cuts, series, numbers):
    """End values and end forces of the solutions, rows, and their derivatives by κ: arrays (parts, κ, m, m)."""
    c, dc, half = series
    places = numbers.array(cuts)
    found = []
    for series in (c, dc):
        values, forces = [], []
        at_ends = end_derivatives(series, piece.order, numbers)
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


def _slack(piece, end, kappa, numbers):
    """Of the part next to the end without tension: forces only at its other end."""
    u, pull, u_slope, pull_slope = slack_series(piece, end, kappa, numbers)
    own = pull * piece.gradient / u
    zero = own * 0
    slope = (pull_slope * piece.gradient - own * u_slope) / u
    return tuple(np.stack([np.stack([zero, zero], axis=-1), np.stack([zero, value], axis=-1)], axis=-2)
                 for value in (own, slope))
