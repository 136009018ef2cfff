"""Damped modes as they are handed on: numbered, two real eigenvalues of one over-damped mode as a pair."""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.undamped import kind
from vibcli.numerics import fixed_point as fx

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.modal.damped import CertifiedEigenvalues
    from vibcli.analyses.modal.damped_in_modal_coordinates import Eigenvalue, ModalDamping

ULP = 2.0 ** -52
PROPORTIONAL = 1e-12
SAME = 45


class DampedMode:
    """One eigenvalue λ: of a conjugate pair that with Im λ > 0, or a real one; q = Re(shape e^{λt}).

    omega = |λ|, zeta = −Re λ/|λ|, omega_d = Im λ or None, decay = −Re λ = zeta·omega, growth_rate = Re λ where it is
    positive, else None. The two real eigenvalues of one over-damped mode share index, omega = √(λ₁λ₂),
    zeta = −(λ₁ + λ₂)/(2 omega) and decay = zeta·omega; a real one that belongs to no such pair has zeta None. shape:
    complex, with shapeᴴ M shape = 1. error: bound of |error of λ|/|λ|, without dampers of that relative to each of the
    two parts of λ that is not zero. bounds: of the relative errors of decay and ζ, and of ω_d; where they are not
    known, that of |λ| falls on the parts of λ, the small too. note: what has to be said, or None.
    """

    __slots__ = ("bounds", "decay", "eigenvalue", "error", "growth_rate", "index", "note", "omega", "omega_d", "shape",
                 "zeta")

    def __init__(self, index: int, eigenvalue: "complex | mpmath.mpc", omega: "float | mpmath.mpf",
                 zeta: "float | mpmath.mpf | None", shape: np.ndarray, error: "float | mpmath.mpf", note: Any = None,
                 decay: float | None = None, bounds: tuple[Any, Any] | None = None) -> None:
        self.index, self.eigenvalue, self.omega, self.zeta = index, eigenvalue, omega, zeta
        self.shape, self.error, self.note = shape, error, note
        re, im = eigenvalue.real, eigenvalue.imag
        self.omega_d = im if im else None
        self.decay = decay if decay is not None else -re if re else abs(re)
        self.growth_rate = re if re > 0 else None
        self.bounds = bounds or self._shared()

    def numbered(self, index: int, shape: np.ndarray) -> "DampedMode":
        """The same with another index and shape."""
        return DampedMode(index, self.eigenvalue, self.omega, self.zeta, shape, self.error, self.note, self.decay,
                          self.bounds)

    def _shared(self) -> tuple[float, float]:
        if not self.omega_d:
            return self.error, self.error
        real, imaginary = abs(float(self.decay)), abs(float(self.omega_d))
        size = math.hypot(real, imaginary)
        return self.error * size / real if real else self.error, self.error * size / imaginary

    @property
    def kind(self) -> str:
        """rigid, oscillation, decay, flutter or divergence."""
        return kind(self.eigenvalue.real, self.omega_d)


def collected(answer: "CertifiedEigenvalues", numbers: type[Any], shapes: np.ndarray) -> list[DampedMode]:
    """DampedMode objects by ascending |λ| of a damped.Answer; shapes: a column for each of its eigenvalues."""
    system, found, scale = answer.system, answer.found, answer.scale
    bits, index, out = system.bits, {}, []
    partner = pairs(system, found)
    for i in _by_size(found):
        d = found[i]
        size = fx.magnitude(math.isqrt(d.re * d.re + d.im * d.im), bits)
        re = 0 if _imaginary(d, size, answer) else d.re
        value = numbers.complex(re, d.im, bits - scale.time)
        square, zeta, decay = math.isqrt(re * re + d.im * d.im), None, None
        if d.im:
            zeta = numbers.number((-re << bits) // square, bits)
        mode = partner.get(i)
        if mode is not None:
            square = math.isqrt(int(system.values[mode]) << bits)
            zeta = numbers.number((int(system.c[mode, mode]) << bits) // (2 * square), bits)
            decay = numbers.number(int(system.c[mode, mode]), bits + 1 - scale.time)
        note = _note(d, zeta)
        key = ("mode", mode) if mode is not None else ("own", i)
        place = index.setdefault(key, len(index) + 1)
        least = fx.magnitude(min(abs(re), d.im), bits) if answer.undamped and re and d.im else size
        error = numbers.error(d.radius - least) if square else 0.0
        omega, bounds = numbers.number(square, bits - scale.time), None
        if re and d.im:
            bounds = tuple(numbers.error(d.radius + 1 - fx.magnitude(part, bits)) for part in (abs(re), d.im))
        out.append(DampedMode(place, value, omega, zeta, shapes[:, i], error, note, decay, bounds))
    return out


def _by_size(found: "Sequence[Eigenvalue]") -> list[int]:
    """Places by ascending |λ|; of eigenvalues of one size, to SAME bits, that which decays least comes first."""
    squares = [d.re ** 2 + d.im ** 2 for d in found]
    order = sorted(range(len(found)), key=squares.__getitem__)
    first = [k for k, i in enumerate(order) if not k or squares[i] - squares[order[k - 1]] > squares[i] >> SAME]
    for a, b in pairwise([*first, len(order)]):
        order[a:b] = sorted(order[a:b], key=lambda i: -found[i].re)
    return order


def _imaginary(d: "Eigenvalue", size: float, answer: "CertifiedEigenvalues") -> bool:
    """Whether Re λ is zero: nothing at the depth asked for, or a conservative system.

    There −λ̄ is an eigenvalue too, so one that stands alone next to the axis is on it.
    """
    near = fx.log2(d.re, answer.system.bits) <= d.radius + 1
    return near and d.radius <= size - (40 if answer.conservative else answer.system.deep - 5)


def pairs(system: Any, found: "Sequence[Eigenvalue]") -> dict[int, int]:
    """{place: mode} of the real eigenvalues that are two of one over-damped mode.

    A mode has two of its own if no damping couples it, or only as much as rounding of the data would.
    """
    out = {i: d.mode for i, d in enumerate(found)
           if d.mode is not None and d.excess >= 0 and system.values[d.mode] > 0}
    if not hasattr(system, "values"):
        return out
    real = [i for i, d in enumerate(found) if d.mode is None and not d.im and d.re]
    for mode, ends in _nearly_alone(system) if real else ():
        near = []
        for end in ends:
            i = min(real, key=lambda i: abs(_real(found[i], system.bits) - end), default=None)
            if i is not None and abs(_real(found[i], system.bits) - end) <= 1e-6 * abs(end):
                near.append(i)
        if len(set(near)) == 2:
            out |= dict.fromkeys(near, mode)
            real = [i for i in real if i not in near]
    return out


def _real(d: "Eigenvalue", bits: int) -> float:
    return fx.to_float(d.re, bits)


def _nearly_alone(system: "ModalDamping") -> Iterator[tuple[int, tuple[float, float]]]:
    """Over-damped modes coupled no more than by rounding, each with its two eigenvalues."""
    c, values = fx.floats(system.c, system.bits), fx.floats(system.values, system.bits)
    own = np.abs(c.diagonal())
    with np.errstate(divide="ignore", invalid="ignore"):
        strong = np.maximum(np.abs(c), np.abs(c.T)) > PROPORTIONAL * np.sqrt(np.multiply.outer(own, own))
    np.fill_diagonal(strong, False)
    for i in np.flatnonzero(~strong.any(axis=1)).tolist():
        excess = c[i, i] ** 2 - 4 * values[i]
        if values[i] > 0 and excess >= 0:
            far = -(c[i, i] + math.copysign(math.sqrt(excess), c[i, i])) / 2
            yield i, (far, values[i] / far)


def _note(d: "Eigenvalue", zeta: "float | mpmath.mpf | None") -> str | None:
    """What to say of a mode at or next to critical damping, and of a zero."""
    if not d.re and not d.im:
        return "rigid motion: λ = 0"
    if d.mode is None or zeta is None:
        return None
    if d.excess == 0:
        return "ζ = 1"
    off = abs(abs(float(zeta)) - 1.0) / ULP
    return f"ζ = 1 within {max(1, math.ceil(off))} ulp" if off <= 8 else None
