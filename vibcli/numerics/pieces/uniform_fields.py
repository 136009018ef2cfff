"""The deflection of uniform pieces between their ends, from its even and odd parts about the middle.

With ξ = (x − a)/a and g either C(P ξ²) or ξ S(P ξ²), times P or P² for higher derivatives, at the two roots, what end
values U, Θ = a θ of an even (odd) motion leave is, Δ = P₁ − P₂ and d, σ as in `parity`,

    even: [(P₁ S₁ g₂ − P₂ S₂ g₁) U + (C₂ g₁ − C₁ g₂) Θ]/(Δ d),    odd: [(C₁ g₂ − C₂ g₁) U + (S₂ g₁ − S₁ g₂) Θ]/(Δ σ);

where the roots are near each other, f₁ g₂ − f₂ g₁ = Δ (f′ ḡ − f̄ g′) by means f̄ and divided differences f′.
What grows towards an end is scaled to 1 there.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.parity import separate_roots
from vibcli.numerics.pieces.scaled_functions import ALIKE, even_functions, even_functions_of, terms

if TYPE_CHECKING:
    from vibcli.numerics.pieces.arithmetic import Arithmetic
    from vibcli.numerics.pieces.scaled_functions import Even


class _Pair(NamedTuple):
    """A function at both roots: its mean and divided difference, or its two values."""

    one: np.ndarray
    other: np.ndarray


class _Form(NamedTuple):
    """The even and odd function at ξ; what multiplies a pair by P, and what crosses two; (C, S) and (d, σ) at the
    ends."""

    even: _Pair
    odd: _Pair
    times: Any
    cross: Any
    own: tuple[_Pair, _Pair]
    rest: tuple[_Pair, _Pair] | tuple[np.ndarray, np.ndarray]


def second_order_fields(xi: np.ndarray, near: np.ndarray, half: np.ndarray, tension: np.ndarray, kappa: np.ndarray,
                        ends: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
    """(u, u′), (…, 2), at ξ, near = 1 − |ξ|, of pieces with end values (…, 2), over flat arrays."""
    z = kappa * half * half / tension
    own, here = even_functions_of([z, z * xi * xi], numbers)
    fading = _fading(own, here, near, numbers)
    even, odd = (ends[..., 1] + ends[..., 0]) / 2 / own.c * fading, (ends[..., 1] - ends[..., 0]) / 2 / own.s * fading
    return np.array([even * here.c + odd * xi * here.s, (even * z * xi * here.s + odd * here.c) / half]).T


def fourth_order_fields(xi: np.ndarray, near: np.ndarray, half: np.ndarray, bending: np.ndarray, tension: np.ndarray,
                        kappa: np.ndarray, ends: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
    """(u, u′, u″, u‴), (…, 4), at ξ, near = 1 − |ξ|, of beams with end values (…, 4), over flat arrays."""
    nu, chi = tension * half * half / bending, kappa * half**4 / bending
    found = np.zeros((*chi.shape, 4), np.result_type(chi, nu, ends, xi))
    real = numbers.is_real(chi) and numbers.is_real(nu) and numbers.is_real(ends)
    for chosen, form in _forms(nu, chi, numbers):
        if chosen.any():
            parts = ends[chosen]
            u_0, t_0, u_l, t_l = (parts[..., i] for i in range(4))
            size = half[chosen]
            amplitudes = ((u_l + u_0) / 2, (t_l - t_0) / 2 * size, (u_l - u_0) / 2, (t_l + t_0) / 2 * size)
            values = _derivatives(form(nu[chosen], chi[chosen], xi[chosen], near[chosen], numbers), amplitudes)
            values = np.array([value / size**k for k, value in enumerate(values)]).T
            values = numbers.real(values) if real else values
            if chosen.all():
                return values.astype(found.dtype, copy=False)
            found[chosen] = values
    return found


def fourth_order_integrals(xi: np.ndarray, near: np.ndarray, weights: np.ndarray, half: Any, bending: Any, tension: Any,
                           kappa: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
    """Σ weights · u over places ξ of beams of one form, (κ, 4), of the fields that have one end value 1 each."""
    nu, chi = tension * half * half / bending + 0 * kappa, kappa * half**4 / bending
    found = np.zeros((*chi.shape, 4), np.result_type(chi, nu, xi, weights))
    for chosen, form in _forms(nu, chi, numbers):
        if chosen.any():
            summed = (weights,) if form is _by_series else ()
            parts = form(nu[chosen][:, None], chi[chosen][:, None], xi, near, numbers, *summed)
            (c, s), (d, sigma), cross, even, odd = parts.own, parts.rest, parts.cross, parts.even, parts.odd
            if not summed:
                even, odd = (_Pair(*((value * weights).sum(axis=-1, keepdims=True) for value in pair))
                             for pair in (even, odd))
            u, t = cross(parts.times(s), even) / d / 2, -cross(c, even) / d / 2 * half
            v, w = cross(c, odd) / sigma / 2, -cross(s, odd) / sigma / 2 * half
            values = np.concatenate([u - v, w - t, u + v, w + t], axis=-1)
            found[chosen] = numbers.real(values) if numbers.is_real(chi) and numbers.is_real(nu) else values
    return found


def _forms(nu: np.ndarray, chi: np.ndarray,
           numbers: "Arithmetic") -> tuple[tuple[np.ndarray, Callable[..., _Form]], ...]:
    """[(for which, the form in which fields are put there)]."""
    root = numbers.sqrt(chi)
    sums = [np.abs(nu + 2 * root), np.abs(nu - 2 * root)]
    small = np.abs(nu) + 2 * np.abs(root) <= ALIKE
    alike = ~small & ((sums[0] < 1) | (sums[1] < 1))
    return (small, _by_series), (alike, _by_means), (~small & ~alike, _by_roots)


def _fading(own: "Even", here: "Even", near: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
    """e to what a function at ξ was scaled by less what it was at the end."""
    found: np.ndarray = numbers.exp(np.where(here.r == 0, -own.r, -own.r * near))
    return found


def _by_roots(nu: np.ndarray, chi: np.ndarray, xi: np.ndarray, near: np.ndarray, numbers: "Arithmetic") -> _Form:
    one, other = separate_roots(nu, chi, numbers)
    gap, square = one - other, xi * xi
    if one.shape == square.shape:
        f, g, f_here, g_here = even_functions_of([one, other, one * square, other * square], numbers)
    else:
        f, g = even_functions_of([one, other], numbers)
        f_here, g_here = even_functions_of([one * square, other * square], numbers)
    f_fading, g_fading = _fading(f, f_here, near, numbers), _fading(g, g_here, near, numbers)
    even = _Pair(f_here.c * f_fading, g_here.c * g_fading)
    odd = _Pair(xi * f_here.s * f_fading, xi * g_here.s * g_fading)

    def times(pair: _Pair) -> _Pair:
        return _Pair(pair.one * one, pair.other * other)

    def cross(own: _Pair, pair: _Pair) -> np.ndarray:
        found: np.ndarray = (own.one * pair.other - own.other * pair.one) / gap
        return found

    c, s = _Pair(f.c, g.c), _Pair(f.s, g.s)
    d, sigma = cross(times(s), c), cross(c, s)
    return _Form(even, odd, times, cross, (c, s), (d, sigma))


def _by_means(nu: np.ndarray, chi: np.ndarray, xi: np.ndarray, near: np.ndarray, numbers: "Arithmetic") -> _Form:
    """Near double roots: from A/4 and B/4, of which the second is small."""
    root = numbers.sqrt(chi)
    root = np.where(np.abs(nu + 2 * root) >= np.abs(nu - 2 * root), root, -root)
    large, little = nu / 4 + root / 2, nu / 4 - root / 2

    def pairs(square: np.ndarray) -> "tuple[Even, Even, _Pair, _Pair]":
        f, g = even_functions(large * square, numbers), even_functions(little * square, numbers)
        difference = (f.c * g.s - f.s * g.c) / (2 * root)
        c = _Pair(f.c * g.c, square * f.s * g.s / 2)
        return f, g, c, _Pair((large * f.s * g.c - little * g.s * f.c) / root, difference)

    f, g, c, s = pairs(nu * 0 + 1)
    here, _, even, odd = pairs(xi * xi)
    fading = _fading(f, here, near, numbers)
    double, single = f.s * f.c, g.s * g.c * numbers.exp(-2 * f.r)
    rest = ((double + single) / 2, (double - single) / (2 * root))
    even, odd = _Pair(*(value * fading for value in even)), _Pair(*(value * xi * fading for value in odd))
    return _Form(even, odd, *_of_means(nu, chi), (c, s), rest)


def _by_series(nu: np.ndarray, chi: np.ndarray, xi: np.ndarray, near: np.ndarray, numbers: "Arithmetic",
               weights: np.ndarray | None = None) -> _Form:
    """Means and divided differences of Pᵏ by their recurrence; of `weights`, sums of what is told over places ξ."""
    zero = nu * chi * 0
    powers = [np.array([zero + 1, zero]), np.array([zero + nu / 2, zero + 1])]      # means, differences
    for k in range(1, terms(ALIKE, numbers)):
        powers.append(nu * powers[k] - chi * powers[k - 1])

    def pairs(x: np.ndarray, weights: "np.ndarray | None") -> "tuple[_Pair, _Pair]":
        share, square, even, odd = numbers.array(1) + x * 0, x * x, 0 * powers[0], 0 * powers[0]
        for k, power in enumerate(powers):
            share = share * square / (2 * k * (2 * k - 1)) if k else share
            evenly, oddly = (share, share) if weights is None else (
                (part * weights).sum(axis=-1, keepdims=True) for part in (share, share * x))
            even, odd = even + evenly * power, odd + oddly * power / (2 * k + 1)
        lean = x if weights is None else 1
        return _Pair(*even), _Pair(*(part * lean for part in odd))

    (c, s), (even, odd) = pairs(nu * 0 + 1, None), pairs(xi, weights)
    times, cross = _of_means(nu, chi)
    return _Form(even, odd, times, cross, (c, s), (cross(times(s), c), cross(c, s)))


def _of_means(nu: np.ndarray, chi: np.ndarray) -> tuple[Callable[[_Pair], _Pair], Callable[[_Pair, _Pair], np.ndarray]]:
    """What multiplies a pair by P, and the crossed product."""
    quarter = nu * nu / 4 - chi

    def times(pair: _Pair) -> _Pair:
        return _Pair(nu / 2 * pair.one + quarter * pair.other, nu / 2 * pair.other + pair.one)

    def cross(own: _Pair, pair: _Pair) -> np.ndarray:
        found: np.ndarray = own.other * pair.one - own.one * pair.other
        return found

    return times, cross


def _derivatives(form: _Form, amplitudes: tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]) -> np.ndarray:
    """u and its three derivatives by ξ; g of the even part follow one another as C, ξPS, PC, ξP²S, of the odd part
    as ξS, C, ξPS, PC."""
    (even, odd, times, cross, (c, s), rest) = form
    slope = times(odd)
    u, t, v, w = amplitudes[0] / rest[0], amplitudes[1] / rest[0], amplitudes[2] / rest[1], amplitudes[3] / rest[1]
    ps = times(s)
    bend = times(even)
    g, h = _stacked(even, slope, bend, times(slope)), _stacked(odd, even, slope, bend)
    found: np.ndarray = cross(ps, g) * u - cross(c, g) * t + cross(c, h) * v - cross(s, h) * w
    return found


def _stacked(*pairs: _Pair) -> _Pair:
    """Several pairs as one."""
    return _Pair(*map(np.array, zip(*pairs, strict=True)))
