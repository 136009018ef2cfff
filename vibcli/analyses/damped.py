"""Damped free vibration: (λ² M + λ (C + G) + K) x = 0, q = Re(x e^{λt})."""

import math

from vibcli.analyses.modal import CERTIFIED, prepared

GOAL = 160
ZERO = 2.0 ** -90
ULP = 2.0 ** -52


class DampedMode:
    """One eigenvalue λ: of a conjugate pair that with Im λ > 0, or a real one.

    omega = |λ|, zeta = −Re λ/|λ|, omega_d = Im λ or None, decay = −Re λ, growth_rate = Re λ where positive, else
    None. The two real eigenvalues of one over-damped mode share index, omega = √(λ₁λ₂) and
    zeta = −(λ₁ + λ₂)/(2 omega); a real one that belongs to no such pair has zeta None. shape: complex, with
    shapeᴴ M shape = 1. error: bound of |error of λ|/|λ|. note: what has to be said, or None.
    """

    __slots__ = ("decay", "eigenvalue", "error", "growth_rate", "index", "note", "omega", "omega_d", "shape", "zeta")

    def __init__(self, eigenvalue, omega, zeta, shape, error, note=None):
        self.index, self.eigenvalue, self.omega, self.zeta = 0, eigenvalue, omega, zeta
        self.shape, self.error, self.note = shape, error, note
        self.omega_d = eigenvalue.imag if eigenvalue.imag else None
        self.decay = -eigenvalue.real if eigenvalue.real else abs(eigenvalue.real)
        self.growth_rate = eigenvalue.real if eigenvalue.real > 0 else None


def damps(elements):
    """Whether any damper or matrix C acts."""
    return any(c for c, _ in elements.dampers) or any(elements.C.values())


def damped(elements, precise=None, exact=None, digits=None):
    """The damped modes by ascending |λ|; None where nothing damps and nothing turns (no C and no G).

    `precise(dps)`: the elements to dps digits; `exact()`: as Fractions, or exact None where they are irrational.
    """
    if not damps(elements) and not any(elements.G.values()):
        return None
    from vibcli.analyses.certified import enclosed
    from vibcli.analyses.quadratic import ModalDamping, eigenvalues

    scale, zeros = prepared(elements)
    data = exact() if exact is not None else elements
    answer = enclosed(data, scale, zeros, goal=GOAL)
    modal = ModalDamping(answer, data, scale, untouched(elements, zeros, data))
    return collected(modal, eigenvalues(modal), scale)


def untouched(elements, zeros, data):
    """How many rigid motions no damper resists; 0 where the damping is not all of the form Σ c ∇s ∇sᵀ."""
    from fractions import Fraction

    from vibcli.analyses.rigid import rank

    if not zeros or any(elements.C.values()) or any(elements.G.values()):
        return 0
    rows = [row for k, row in data.springs if k] + [row for c, row in data.dampers if c]
    rational = all(isinstance(x, (int, Fraction)) for row in rows for x in row.values())
    return elements.n - rank(elements.n, rows, rows if rational else None)


def collected(modal, found, scale):
    """DampedMode objects by ascending |λ|, numbered."""
    import numpy as np

    from vibcli.analyses import fixed as fx

    bits, phi = modal.bits, fx.floats(modal.phi, modal.bits)
    phi = np.ldexp(phi, np.array(scale.coordinates)[:, None])
    phi = np.ldexp(phi / math.sqrt(2.0) if scale.mass % 2 else phi, -(scale.mass // 2))
    found = sorted(found, key=lambda d: (d.re * d.re + d.im * d.im, -d.re))
    numbers, out = {}, []
    for d in found:
        size = math.hypot(fx.to_float(d.re, bits), fx.to_float(d.im, bits))
        re = 0 if d.radius <= ZERO * size and abs(fx.to_float(d.re, bits)) <= d.radius else d.re
        square = math.isqrt(re * re + d.im * d.im)
        value = complex(fx.to_float(re, bits - scale.time), fx.to_float(d.im, bits - scale.time))
        omega, zeta, note = fx.to_float(square, bits - scale.time), None, None
        if d.im:
            zeta = -fx.to_float((re << bits) // square, bits) if re else 0.0
        if d.mode is not None and d.excess is not None and d.excess >= 0 and modal.values[d.mode] > 0:
            root = math.isqrt(int(modal.values[d.mode]) << bits)
            omega = fx.to_float(root, bits - scale.time)
            zeta = fx.to_float((int(modal.c[d.mode, d.mode]) << bits) // (2 * root), bits)
        if zeta is not None and d.mode is not None:
            note = _critical(d, zeta)
        error = d.radius / size + ULP / 2 if size else 0.0
        mode = DampedMode(value, omega, zeta, _normal(phi @ d.x, d.x), error, note)
        key = ("mode", d.mode) if d.mode is not None and d.excess is not None and d.excess >= 0 else ("own", len(out))
        mode.index = numbers.setdefault(key, len(numbers) + 1)
        out.append(mode)
    return out


def _critical(d, zeta):
    if d.excess == 0:
        return "ζ = 1"
    off = abs(abs(zeta) - 1.0) / ULP
    return f"ζ = 1 within {max(1, round(off))} ulp" if off <= 16 else None


def _normal(shape, x):
    """The shape with xᴴx = 1 and its largest component real and positive."""
    import numpy as np

    size = np.linalg.norm(x)
    lead = shape[int(np.argmax(np.abs(shape)))]
    return shape / size * (abs(lead) / lead) if lead else shape / size


_ = CERTIFIED
