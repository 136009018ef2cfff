"""Loads spread along pieces: what they put on the ends, and the deflection that they leave between held ends.

f(x) = Σ Re c (x − a)ᵏ e^{λ(x − a)} on stretches from a on; by Gauss's rule to rounding: nothing is divided by what
vanishes at resonance of f's own form or at rest. Where κ is far above both, by the ends: with w = ∂ᵏ/∂λᵏ [e^{λy}/P(λ)],
P = B λ⁴ − N λ² + κ, so that B w⁗ − N w″ + κ w = yᵏ e^{λy}, by Green's identity

    ∫ φ (B w⁗ − N w″ + κ w) dx = [B (φ w‴ − φ′ w″ + φ″ w′ − φ‴ w) − N (φ w′ − φ′ w)].
"""

from math import comb
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.polynomial import polynomial

from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.panels import panel_rule
from vibcli.numerics.pieces.reaction_slopes import reaction_slope
from vibcli.numerics.pieces.stiffness import stiffness
from vibcli.numerics.pieces.uniform_fields import fourth_order_integrals

if TYPE_CHECKING:
    from vibcli.numerics.pieces.arithmetic import Arithmetic
    from vibcli.numerics.pieces.piece import Piece

AT_ONCE = 200_000       # fields at a time
HIGH = 6                # powers that no rule minds
FAR = 50.0              # times what else is in P: κ


class LoadTerm(NamedTuple):
    """Re c yᵏ e^{λy}."""

    coefficient: Any
    power: int
    exponent: Any


class LoadStretch(NamedTuple):
    """A sum of Terms of y = x − origin, from x = `start` to `end`."""

    start: Any
    end: Any
    origin: Any
    terms: tuple[LoadTerm, ...]

    def is_far(self, piece: "Piece", kappa: np.ndarray) -> np.ndarray:
        """Is κ far above what else is in P, and in what bends over the stretch, of which little is left at rest? Not
        where the tension varies along a piece."""
        if piece.gradient or not self.terms:
            return np.zeros(kappa.shape, bool)
        rate = max(float(abs(term.exponent)) + (1 + term.power) / float(self.end - self.start) for term in self.terms)
        found: np.ndarray = np.abs(kappa) > FAR * (abs(piece.bending) * rate**4 + abs(piece.tension) * rate**2)
        return found

    def at(self, x: Any, numbers: "Arithmetic") -> Any:
        """f(x) of a number or an array."""
        y, found = x - self.origin, 0 * x
        for coefficient, power, rate in self.terms:
            wave = numbers.array(coefficient) * y**power
            found = found + numbers.real(wave * numbers.exp(numbers.array(rate) * y) if rate else wave)
        return found

    @property
    def slope(self) -> "LoadStretch":
        """f′."""
        terms = [LoadTerm(c * rate, k, rate) for c, k, rate in self.terms if rate]
        return self._replace(terms=(*terms, *(LoadTerm(c * k, k - 1, rate) for c, k, rate in self.terms if k)))

    def size(self, x: np.ndarray) -> np.ndarray:
        """Σ |terms| at places, in floats."""
        y = np.clip(x, float(self.start), float(self.end)) - float(self.origin)
        found: np.ndarray = sum((abs(complex(c)) * abs(y)**k * np.exp(complex(rate).real * y)
                                 for c, k, rate in self.terms), 0 * y)
        return found

    @property
    def pace(self) -> float:
        """The largest |λ|, high powers as what grows as much."""
        length = float(self.end - self.start)
        return max((float(abs(rate)) + (power / length if power > HIGH else 0.0) for _, power, rate in self.terms),
                   default=0.0)


class LoadForm(NamedTuple):
    """f(x) along a member, LoadStretches from left to right."""

    stretches: tuple[LoadStretch, ...]

    def on(self, start: Any, end: Any) -> "LoadForm":
        """Its part from one place to another, which counts from there on."""
        found = [one._replace(start=max(one.start, start) - start, end=min(one.end, end) - start,
                              origin=one.origin - start) for one in self.stretches]
        return LoadForm(tuple(one for one in found if one.end > one.start))


def end_loads(piece: "Piece", kappa: Any, form: LoadForm) -> np.ndarray:
    """∫ f H_i dx, (…, order): the forces on the ends in place of a load f(x) e^{st}, d · ends = forces + these.

    H_i is the field with the i-th end value 1, so that ∫ f u dx of a field is these times its end values; f counts from
    the left end of the piece; its coefficients are numbers, κ broadcasts to (…).
    """
    numbers = arithmetic_of(*piece, kappa)
    kappa = numbers.array(kappa)
    flat, found = kappa.reshape(-1), 0 * kappa.reshape(-1)[:, None] * numbers.array(np.ones(piece.order))
    for one in form.on(0, piece.length).stretches:
        far = one.is_far(piece, flat) if numbers.number is None else np.zeros(len(flat), bool)
        for chosen, integral in ((far, _by_ends), (~far, _by_panels)):
            if chosen.any():
                found[chosen] += integral(piece, flat[chosen], one, numbers)
    result: np.ndarray = found.reshape((*kappa.shape, piece.order))
    return result


def _by_panels(piece: "Piece", kappa: np.ndarray, one: LoadStretch, numbers: "Arithmetic") -> np.ndarray:
    cut = piece._replace(length=one.end - one.start, tension=piece.tension + piece.gradient * one.start)
    y, weights = panel_rule(cut, kappa, one.pace, numbers)
    x, found = one.start + cut.length * y, []
    weights = weights * cut.length * one.at(x, numbers)
    if piece.gradient:
        from vibcli.numerics.pieces.graded import graded_integrals

        return graded_integrals(piece, kappa, x, weights, numbers)
    if piece.order == 4:
        return _by_parity(piece, kappa, x, weights, numbers)
    step, unit = max(1, AT_ONCE // (len(x) * piece.order)), numbers.array(np.eye(piece.order))[:, None, :]
    for i in range(0, len(kappa), step):
        found.append((fields(piece, kappa[i:i + step, None, None], unit, x)[..., 0] * weights).sum(axis=-1))
    return np.concatenate(found)


def _by_parity(piece: "Piece", kappa: np.ndarray, x: np.ndarray, weights: np.ndarray,
               numbers: "Arithmetic") -> np.ndarray:
    """On a uniform beam, whose four fields share an even and an odd function."""
    half, rest, found = piece.length / 2, piece.length - x, []
    near = np.where(x < rest, x, rest) / half
    xi, step = np.where(x < rest, near - 1, 1 - near), max(1, AT_ONCE // len(x))
    for i in range(0, len(kappa), step):
        found.append(fourth_order_integrals(xi, near, weights, half, piece.bending, piece.tension, kappa[i:i + step],
                                            numbers))
    return np.concatenate(found)


def _by_ends(piece: "Piece", kappa: np.ndarray, one: LoadStretch, numbers: "Arithmetic") -> np.ndarray:
    unit = np.eye(piece.order)
    end, start = (bracket(piece, kappa[:, None], fields(piece, kappa[:, None], unit, x), one, x)
                  for x in (one.end, one.start))
    found: np.ndarray = end - start
    return found


def bracket(piece: "Piece", kappa: np.ndarray, phi: np.ndarray, one: LoadStretch, x: Any) -> np.ndarray:
    """Green's bracket at x of fields φ (…, order) with κ (…) and the w of a stretch."""
    w = particular(piece, kappa, one, x)
    found: np.ndarray = -piece.tension * (phi[..., 0] * w[1] - phi[..., 1] * w[0])
    if piece.order == 4:
        found = found + piece.bending * (phi[..., 0] * w[3] - phi[..., 1] * w[2] + phi[..., 2] * w[1]
                                         - phi[..., 3] * w[0])
    return found


def particular(piece: "Piece", kappa: np.ndarray, one: LoadStretch, x: Any) -> np.ndarray:
    """w, w′, w″, w‴ of a stretch at places, (4, …)."""
    w = np.zeros((4, *np.broadcast_shapes(kappa.shape, np.shape(x))), kappa.dtype)
    for rate, powers in _by_rates(one).items():
        half = _particular(piece, kappa, rate, powers / 2, x - one.origin)
        if kappa.dtype.kind != "c":
            w = w + 2 * half.real
        elif rate.imag or powers.imag.any():
            w = w + half + _particular(piece, kappa, rate.conjugate(), powers.conj() / 2, x - one.origin)
        else:
            w = w + 2 * half
    return w


def _by_rates(one: LoadStretch) -> dict[complex, np.ndarray]:
    """{λ: coefficients of 1, y, y² …} of a stretch."""
    found: dict[complex, list[complex]] = {}
    for coefficient, power, rate in one.terms:
        powers = found.setdefault(complex(rate), [])
        powers += [0j] * (power + 1 - len(powers))
        powers[power] += complex(coefficient)
    return {rate: np.array(powers) for rate, powers in found.items()}


def _particular(piece: "Piece", kappa: np.ndarray, rate: complex, powers: np.ndarray, y: float) -> np.ndarray:
    """w, w′, w″, w‴ for p(y) e^{λy}, (4, …): with 1/P(λ + μ) = Σ rⱼ μʲ it is w = e^{λy} q, q = Σ rⱼ p⁽ʲ⁾."""
    series = [kappa + piece.bending * rate**4 - piece.tension * rate**2,
              4 * piece.bending * rate**3 - 2 * piece.tension * rate, 6 * piece.bending * rate**2 - piece.tension,
              4 * piece.bending * rate, piece.bending]
    inverse = [1 / series[0]]
    for i in range(1, len(powers)):
        inverse.append(-sum(series[m] * inverse[i - m] for m in range(1, min(i, 4) + 1) if series[m]) / series[0])
    slopes = [polynomial.polyval(y, polynomial.polyder(powers, j)) for j in range(len(powers))]
    q = [sum((slopes[j + m] * inverse[j] for j in range(len(powers) - m)), 0 * inverse[0]) for m in range(4)]
    found: np.ndarray = np.exp(rate * y) * np.array([sum(comb(d, m) * rate**(d - m) * q[m] for m in range(d + 1))
                                                     for d in range(4)])
    return found


def end_loads_slope(piece: "Piece", kappa: Any, form: LoadForm) -> np.ndarray:
    """∂/∂κ of the same, (…, order), to some ten digits."""
    return reaction_slope(piece, kappa, lambda kappa: end_loads(piece, kappa, form))


def loaded_fields(piece: "Piece", kappa: Any, form: LoadForm, x: Any) -> np.ndarray:
    """(u, u′) or (u, u′, u″, u‴) at one place x of a piece under a load between ends that are held, (…, order).

    As of `fields`, to which it adds. The piece is cut at x, where the ends of both parts take what is spread on them.
    """
    numbers = arithmetic_of(*piece, kappa, x)
    kappa, h = numbers.array(kappa), piece.order // 2
    if not 0 < x < piece.length:
        ends, right = end_loads(piece, kappa, form), x > 0
        pulled = -ends[..., h:] if right else ends[..., :h]
        return _state(piece, piece.length if right else 0, 0 * pulled, pulled)
    left = piece._replace(length=x)
    right = piece._replace(length=piece.length - x, tension=piece.tension + piece.gradient * x)
    own, other = stiffness(left, kappa), stiffness(right, kappa)
    force = end_loads(left, kappa, form.on(0, x))[..., h:]
    both = force + end_loads(right, kappa, form.on(x, piece.length))[..., :h]
    moved = (numbers.inverse(own[..., h:, h:] + other[..., :h, :h]) @ both[..., None])[..., 0]
    return _state(piece, x, moved, (own[..., h:, h:] @ moved[..., None])[..., 0] - force)


def _state(piece: "Piece", x: float, moved: np.ndarray, pulled: np.ndarray) -> np.ndarray:
    """From (u) and (N u′), of beams (u, u′) and (N u′ − B u‴, B u″)."""
    tension = piece.tension + piece.gradient * x
    if moved.shape[-1] == 1:
        return np.stack([moved[..., 0], pulled[..., 0] / tension], axis=-1)
    third = (tension * moved[..., 1] - pulled[..., 0]) / piece.bending
    return np.stack([moved[..., 0], moved[..., 1], pulled[..., 1] / piece.bending, third], axis=-1)
