"""A value with its gradient and its matrix of second derivatives: sums, products and functions by the chain rule.

The numbers are floats, complex (for derivatives by a complex step) or those of mpmath.
"""

import cmath
import math

import mpmath
import numpy as np


class Jet:
    __slots__ = ("g", "h", "v")
    __array_ufunc__ = None      # numbers of numpy leave products with a jet to the jet

    def __init__(self, v, g, h):
        self.v, self.g, self.h = v, g, h

    def __add__(self, other):
        if isinstance(other, Jet):
            return Jet(self.v + other.v, self.g + other.g, self.h + other.h)
        return Jet(self.v + other, self.g, self.h)

    __radd__ = __add__

    def __neg__(self):
        return Jet(-self.v, -self.g, -self.h)

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other

    def __mul__(self, other):
        if not isinstance(other, Jet):
            return Jet(self.v * other, self.g * other, self.h * other)
        cross = self.g[:, None] * other.g
        return Jet(self.v * other.v, self.v * other.g + other.v * self.g,
                   self.v * other.h + other.v * self.h + cross + cross.T)

    __rmul__ = __mul__

    def chain(self, f, f1, f2):
        """f of the jet, given its value and its first two derivatives there."""
        return Jet(f, f1 * self.g, f1 * self.h + f2 * (self.g[:, None] * self.g))

    def __truediv__(self, other):
        return self * (other**-1 if isinstance(other, Jet) else 1 / other)

    def __rtruediv__(self, other):
        return self**-1 * other

    def __pow__(self, n):
        if isinstance(n, Jet):
            n = n.v
        v = self.v
        if n in (0, 1, 2, 3):
            return self.chain(v**n, n * v ** (n - 1) if n else 0 * v, n * (n - 1) * v ** (n - 2) if n > 1 else 0 * v)
        return self.chain(v**n, n * v ** (n - 1), n * (n - 1) * v ** (n - 2))


def variables(values):
    """The values as jets of themselves."""
    n = len(values)
    kind = np.asarray(values).dtype
    none, one = np.zeros((n, n), kind), np.eye(n, dtype=kind)
    return [Jet(v, one[i], none) for i, v in enumerate(values)]


def plain(x):
    return x.v if isinstance(x, Jet) else x


def real(x):
    x = plain(x)
    return x if isinstance(x, int | float | mpmath.mpf) else x.real


def _of(x):
    if isinstance(x, mpmath.mpf | mpmath.mpc):
        return mpmath
    return cmath if isinstance(x, complex) else math


def _function(value, first, second):
    """A function of numbers made one of jets: first and second are derivatives from the argument and the value."""
    def apply(x):
        v = plain(x)
        lib = _of(v)
        f = value(lib, v)
        return x.chain(f, first(lib, v, f), second(lib, v, f)) if isinstance(x, Jet) else f
    return apply


def _sign(v):
    return int(real(v) > 0) - int(real(v) < 0)


sin = _function(lambda m, v: m.sin(v), lambda m, v, f: m.cos(v), lambda m, v, f: -f)
cos = _function(lambda m, v: m.cos(v), lambda m, v, f: -m.sin(v), lambda m, v, f: -f)
exp = _function(lambda m, v: m.exp(v), lambda m, v, f: f, lambda m, v, f: f)
sqrt = _function(lambda m, v: m.sqrt(v), lambda m, v, f: 1 / (2 * f), lambda m, v, f: -1 / (4 * f * v))
atan = _function(lambda m, v: m.atan(v), lambda m, v, f: 1 / (1 + v * v), lambda m, v, f: -2 * v / (1 + v * v) ** 2)
tanh = _function(lambda m, v: m.tanh(v), lambda m, v, f: 1 - f * f, lambda m, v, f: -2 * f * (1 - f * f))
tan = _function(lambda m, v: m.tan(v), lambda m, v, f: 1 + f * f, lambda m, v, f: 2 * f * (1 + f * f))
asin = _function(lambda m, v: m.asin(v), lambda m, v, f: (1 - v * v) ** -0.5, lambda m, v, f: v * (1 - v * v) ** -1.5)
acos = _function(lambda m, v: m.acos(v), lambda m, v, f: -(1 - v * v) ** -0.5, lambda m, v, f: -v * (1 - v * v) ** -1.5)
sinh = _function(lambda m, v: m.sinh(v), lambda m, v, f: m.cosh(v), lambda m, v, f: f)
cosh = _function(lambda m, v: m.cosh(v), lambda m, v, f: m.sinh(v), lambda m, v, f: f)
log = _function(lambda m, v: m.log(v), lambda m, v, f: 1 / v, lambda m, v, f: -1 / (v * v))
magnitude = _function(lambda m, v: v * _sign(v), lambda m, v, f: _sign(v), lambda m, v, f: 0)
sign = _function(lambda m, v: _sign(v), lambda m, v, f: 0, lambda m, v, f: 0)
step = _function(lambda m, v: 1 if real(v) >= 0 else 0, lambda m, v, f: 0, lambda m, v, f: 0)
square = _function(lambda m, v: 1 if real(v) / (2 * math.pi) % 1 < 0.5 else -1, lambda m, v, f: 0, lambda m, v, f: 0)


def ramp(x):
    return x * step(x)


def sawtooth(x):
    """From −1 at 0 to 1 within a period of 2π."""
    turns = math.floor(real(x) / (2 * math.pi))
    return (x - 2 * math.pi * turns) / math.pi - 1


def angle(x, y):
    """Of a vector that points to the right: within a right angle of +x."""
    return atan(y / x)


def atan2(y, x):
    """The angle of a vector."""
    if real(x) > 0:
        return atan(y / x)
    return _of(real(x)).atan2(real(y), real(x))


def larger(x, y):
    return x if real(x) >= real(y) else y


def smaller(x, y):
    return y if real(x) >= real(y) else x
