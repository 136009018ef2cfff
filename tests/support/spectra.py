"""Modes without dampers beside the eigenvalues that mpmath finds."""

import mpmath
from support import families


def unit_masses(n):
    return [(1.0, {i: 1.0}) for i in range(n)]


def rate(mode):
    """λ of a mode without dampers."""
    return mpmath.mpc(mode.growth_rate or 0, mode.omega or 0)


def nearest(left, value):
    """Takes the number next to `value` out of a list."""
    return left.pop(min(range(len(left)), key=lambda i: abs(left[i] - value)))


def settled(square):
    """What a mode of −λ² = `square`, known to many digits, has to be: its kind, and λ with Re, Im >= 0."""
    root = mpmath.sqrt(-square)
    root = mpmath.mpc(abs(root.real), abs(root.imag))
    if abs(square.imag) > abs(square) * mpmath.mpf(10) ** -50:
        return "flutter", root
    return ("oscillation", mpmath.mpc(0, root.imag)) if square.real > 0 else ("divergence", mpmath.mpc(root.real, 0))


def compared(modes, squares):
    """(mode, exact λ) of modes without dampers and G; asserts their kinds and that none is missing."""
    left, top, out = list(squares), max(abs(x) for x in squares), []
    for mode in sorted(modes, key=lambda mode: -abs(rate(mode))):
        square = nearest(left, -rate(mode) ** 2)
        if mode.kind == "rigid":
            assert abs(square) <= top * mpmath.mpf(10) ** -40
            continue
        kind, exact = settled(square)
        assert mode.kind == kind
        if kind == "flutter":
            nearest(left, square.conjugate())
        out.append((mode, exact))
    assert not left
    return out


def relative(mode, exact):
    """The larger of the relative errors of growth rate and frequency; a part that is zero has to be zero."""
    found = rate(mode)
    pairs = (found.real, exact.real), (found.imag, exact.imag)
    assert all((a == 0) == (b == 0) for a, b in pairs)
    return max(abs((a - b) / b) for a, b in pairs if b)


def residual(elements, mode, value):
    """‖(λ²M + λ(C + G) + K) x‖ of the normalised shape."""
    m, c, k = families.pencil(elements)
    x = mpmath.matrix([mpmath.mpmathify(z) for z in mode.shape.tolist()])
    x = x / mpmath.norm(x)
    return mpmath.norm(value * value * (m * x) + value * (c * x) + k * x)
