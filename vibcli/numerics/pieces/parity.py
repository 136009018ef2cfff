"""A uniform beam of half length a about its middle: the functions of which its stiffness is made.

In ξ = x/a: u⁗ − ν u″ + χ u = 0 with ν = N a²/B, χ = κ a⁴/B. Its roots P₁, P₂ of P² − ν P + χ = 0 give even solutions
C(P ξ²) and odd ones ξ S(P ξ²). With A, B = ν ± 2 √χ = (√P₁ ± √P₂)² each function has two forms; one of them has
well separated roots, and where all are small both are power series in ν and χ:

    c = C₁ C₂             = (C(A) + C(B))/2
    s = S₁ S₂             = 2 (C(A) − C(B))/(A − B)
    d = (P₁ C₂ S₁ − P₂ C₁ S₂)/(P₁ − P₂) = (S(A) + S(B))/2
    σ = (C₁ S₂ − C₂ S₁)/(P₁ − P₂)       = 2 (S(A) − S(B))/(A − B)

Beams held at both ends vibrate evenly where d = 0, oddly where σ = 0.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.scaled_functions import ALIKE, even_functions, terms

if TYPE_CHECKING:
    from vibcli.numerics.pieces.arithmetic import Arithmetic


VALUES = 7      # of a Parity, before its slopes


class Parity(NamedTuple):
    """Arrays: the four functions and their derivatives by χ, where asked for, times e^{−R}; what couples the ends times
    e^{−2R}.

    uu = c d − χ s σ, ut = χ σ² − d², tt = c σ − d s, without the cancellation of these. R = Re √P₁ + Re √P₂.
    """

    c: np.ndarray
    s: np.ndarray
    d: np.ndarray
    sigma: np.ndarray
    uu: np.ndarray
    ut: np.ndarray
    tt: np.ndarray
    slopes: tuple[np.ndarray, ...] = ()


def parity_functions(nu: np.ndarray, chi: np.ndarray, numbers: "Arithmetic", steep: bool) -> Parity:
    """Of arrays of equal shape (flat); steep: with the slopes of c, s, d and σ."""
    real = numbers.is_real(nu) and numbers.is_real(chi)
    root = numbers.sqrt(chi)
    small = np.abs(nu) + 2 * np.abs(root) <= ALIKE
    apart = np.abs(nu * nu - 4 * chi) >= 16 * np.abs(chi)
    if real and numbers.number is None:
        apart |= chi < 0        # one is positive, the other negative: no complex numbers
    found: list[Any] = None if len(nu) else [part for parts in _by_roots(nu, chi, numbers, steep) for part in parts]
    for chosen, form in ((small, _series), (~small & apart, _by_roots), (~small & ~apart, _by_sums)):
        if count := np.count_nonzero(chosen):
            every = count == len(nu)
            found_here, slopes = form(*((nu, chi) if every else (nu[chosen], chi[chosen])), numbers, steep)
            part = [*found_here, *slopes]
            part = [numbers.real(values) for values in part] if real else part
            found = part if every else _put(found, part, chosen)
    return Parity(*found[:VALUES], tuple(found[VALUES:]))


def separate_roots(nu: np.ndarray, chi: np.ndarray, numbers: "Arithmetic") -> tuple[np.ndarray, np.ndarray]:
    """P₁ and P₂, the larger first, without cancellation; not both 0."""
    half, middle = numbers.sqrt(nu * nu / 4 - chi), nu / 2
    one = np.where(np.abs(middle + half) >= np.abs(middle - half), middle + half, middle - half)
    return one, chi / one


def _put(found: list[np.ndarray] | None, part: Sequence[np.ndarray], chosen: np.ndarray) -> list[np.ndarray]:
    """Values of some elements among those known."""
    if found is None:
        found = [np.zeros(chosen.shape, values.dtype) for values in part]
    for i, values in enumerate(part):
        if found[i].dtype != values.dtype:
            found[i] = found[i].astype(np.result_type(found[i], values))
        found[i][chosen] = values
    return found


def _series(nu: np.ndarray, chi: np.ndarray, numbers: "Arithmetic",
            steep: bool) -> tuple[tuple[np.ndarray, ...], tuple[np.ndarray, ...]]:
    """By sums of Xₖ = (Aᵏ + Bᵏ)/2 and Yₖ = (Aᵏ − Bᵏ)/(A − B), both weighed by 1/(2k)! and by 1/(2k + 1)!."""
    weights = [numbers.array(1)[()]]
    for k in range(1, 2 * terms(ALIKE, numbers) + 2):
        weights.append(weights[-1] / k)
    (c, d), (s, sigma), *rates = _summed(nu, chi, numbers.array(weights).reshape(-1, 2, 1), steep)
    slopes = (sigma / 2, rates[1][0], rates[0][1], rates[1][1]) if steep else ()
    return (c, s, d, sigma, c * d - chi * s * sigma, chi * sigma * sigma - d * d, c * sigma - d * s), slopes


def _summed(nu: np.ndarray, chi: np.ndarray, weights: np.ndarray, steep: bool) -> tuple[np.ndarray, ...]:
    """(Σ wₖ Xₖ, 2 Σ wₖ Yₖ and, if it is `steep`, their derivatives by χ), each for both w, (2, N): Xₖ and Yₖ obey
    Xₖ₊₁ = (A + B) Xₖ − A B Xₖ₋₁, and are summed by Clenshaw's recurrence from the last term on, which is least.

    Arrays stand before numbers in sums: a number of mpmath before an array writes it out in full to refuse it.
    """
    total, product = 2 * nu, 4 * chi - nu * nu      # A + B and −A B, of which the derivative is 4
    leaning, nothing = bool(total.any()), product * 0
    one, two, slope_one, slope_two = (nothing,) * 4
    for weight in weights[:0:-1]:
        if steep:
            slope = product * slope_two + two * 4
            slope_one, slope_two = slope + total * slope_one if leaning else slope, slope_one
        value = product * two + weight
        one, two = value + total * one if leaning else value, one
    sums = product * two + nu * one + weights[0], one * 2
    return (*sums, product * slope_two + two * 4 + nu * slope_one, slope_one * 2) if steep else sums


def _by_roots(nu: np.ndarray, chi: np.ndarray, numbers: "Arithmetic",
              steep: bool) -> tuple[tuple[np.ndarray, ...], tuple[np.ndarray, ...]]:
    """From C, S and S′ at P₁ and P₂, which are not near each other."""
    one, other = separate_roots(nu, chi, numbers)
    f, g, gap = even_functions(one, numbers), even_functions(other, numbers), one - other
    c, s, f_g, g_f = f.c * g.c, f.s * g.s, f.s * g.c, f.c * g.s
    d, sigma = (one * f_g - other * g_f) / gap, (g_f - f_g) / gap
    fading, other_fading = numbers.exp(-2 * g.r), numbers.exp(-2 * f.r)
    slopes = (sigma / 2, (f.s * g.slope - f.slope * g.s) / gap,
              (nu * s / 2 - c - (f_g + g_f) / 2 + 2 * d) / gap**2,
              (g.c * f.slope + f.c * g.slope - s + 2 * sigma) / gap**2) if steep else ()
    return (c, s, d, sigma, (one * f.s * f.c * fading - other * g.s * g.c * other_fading) / gap,
            -(one * f.s * f.s * fading - other * g.s * g.s * other_fading) / gap,
            -(f.s * f.c * fading - g.s * g.c * other_fading) / gap), slopes


def _by_sums(nu: np.ndarray, chi: np.ndarray, numbers: "Arithmetic",
             steep: bool) -> tuple[tuple[np.ndarray, ...], tuple[np.ndarray, ...]]:
    """From C, S and S′ at A and B, which are not near each other."""
    root = numbers.sqrt(chi)
    f, g = even_functions(nu + 2 * root, numbers), even_functions(nu - 2 * root, numbers)
    least = np.where(f.r < g.r, f.r, g.r)
    f_scale, g_scale = numbers.exp(least - g.r), numbers.exp(least - f.r)
    f_c, f_s, g_c, g_s = f.c * f_scale, f.s * f_scale, g.c * g_scale, g.s * g_scale
    s, d, sigma = (f_c - g_c) / (2 * root), (f_s + g_s) / 2, (f_s - g_s) / (2 * root)
    slopes: tuple[np.ndarray, ...] = ()
    if steep:
        f_slope, g_slope = f.slope * f_scale, g.slope * g_scale
        slopes = (sigma / 2, (d - s) / (2 * chi), (f_slope - g_slope) / (2 * root),
                  (f_slope + g_slope - sigma) / (2 * chi))
    return ((f_c + g_c) / 2, s, d, sigma, (f_c * g_s + g_c * f_s) / 2, -f_s * g_s,
            (g_c * f_s - f_c * g_s) / (2 * root)), slopes
