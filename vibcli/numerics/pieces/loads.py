"""Loads spread along pieces: what they put on the ends, and the deflection that they leave between held ends.

f(x) = Σ Re c (x − a)ᵏ e^{λ(x − a)} on stretches from a on; by Gauss's rule to rounding, whatever κ: nothing is divided
by what vanishes at resonance of f's own form or at rest.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.panels import panel_rule
from vibcli.numerics.pieces.stiffness import stiffness_and_slope

if TYPE_CHECKING:
    from vibcli.numerics.pieces.arithmetic import Arithmetic
    from vibcli.numerics.pieces.piece import Piece

AT_ONCE = 200_000       # fields at a time
RADIUS, TURNS = 1e-3, 4     # of the circle on which a slope is found, over the stiffness of a wave, and its points


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

    def at(self, x: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
        """f(x)."""
        y, found = x - self.origin, 0 * x
        for coefficient, power, rate in self.terms:
            wave = numbers.array(coefficient) * y**power
            found = found + numbers.real(wave * numbers.exp(numbers.array(rate) * y) if rate else wave)
        return found

    @property
    def pace(self) -> float:
        """The largest |λ|."""
        return max((float(abs(rate)) for _, _, rate in self.terms), default=0.0)


class LoadForm(NamedTuple):
    """f(x) along a member, LoadStretches from left to right."""

    stretches: tuple

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
    flat, found = kappa.reshape(-1), []
    unit = numbers.array(np.eye(piece.order))[:, None, :]
    for x, weights in _rules(piece, flat, form, numbers):
        step = max(1, AT_ONCE // (len(x) * piece.order))
        parts = []
        for i in range(0, max(len(flat), 1), step):
            shapes = fields(piece, flat[i:i + step, None, None], unit, x)[..., 0]
            parts.append((shapes * weights).sum(axis=-1))
        found.append(np.concatenate(parts))
    total = sum(found[1:], found[0]) if found else 0 * flat[:, None] * unit[:, 0, 0]
    return total.reshape((*kappa.shape, piece.order))


def _rules(piece: "Piece", kappa: np.ndarray, form: LoadForm,
           numbers: "Arithmetic") -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """(places, f times weights) on each stretch of a load."""
    for one in form.stretches:
        start, end = max(one.start, 0), min(one.end, piece.length)
        if end > start:
            cut = piece._replace(length=end - start, tension=piece.tension + piece.gradient * start)
            y, weights = panel_rule(cut, kappa, one.pace, numbers)
            x = start + (end - start) * y
            yield x, weights * (end - start) * one.at(x, numbers)


def end_loads_slope(piece: "Piece", kappa: Any, form: LoadForm) -> np.ndarray:
    """∂/∂κ of the same, (…, order), to some ten digits: the mean over a small circle (Cauchy)."""
    kappa = np.asarray(kappa)
    size = np.abs(kappa).astype(float)
    length, bending, force = (abs(float(value)) for value in (piece.length, piece.bending, piece.tension))
    wave = (12 * bending / length**3 + bending**0.25 * size**0.75 + force / length + np.sqrt(force * size)) / length
    radius, found = RADIUS * wave, 0.0
    for turn in np.exp(2j * np.pi * (np.arange(TURNS) + 0.5) / TURNS):
        found = found + end_loads(piece, kappa + radius * turn, form) / turn
    slope = found / (TURNS * radius[..., None])
    return slope if kappa.dtype.kind == "c" else slope.real


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
    own, other = stiffness_and_slope(left, kappa)[0], stiffness_and_slope(right, kappa)[0]
    force = end_loads(left, kappa, form.on(0, x))[..., h:]
    both = force + end_loads(right, kappa, form.on(x, piece.length))[..., :h]
    moved = (numbers.inverse(own[..., h:, h:] + other[..., :h, :h]) @ both[..., None])[..., 0]
    return _state(piece, x, moved, (own[..., h:, h:] @ moved[..., None])[..., 0] - force)


def _state(piece, x, moved, pulled):
    """From (u) and (N u′), of beams (u, u′) and (N u′ − B u‴, B u″)."""
    tension = piece.tension + piece.gradient * x
    if moved.shape[-1] == 1:
        return np.stack([moved[..., 0], pulled[..., 0] / tension], axis=-1)
    third = (tension * moved[..., 1] - pulled[..., 0]) / piece.bending
    return np.stack([moved[..., 0], moved[..., 1], pulled[..., 1] / piece.bending, third], axis=-1)
