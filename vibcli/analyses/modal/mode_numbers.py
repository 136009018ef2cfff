"""Fixed-point results as numbers: floats, or mpmath's where digits were asked for."""

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.numerics import fixed_point as fx

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.modal.scaling import Scaling

SMALLEST = 2.0 ** -1022


class NearestFloats:
    """Turns fixed-point integers into the nearest floats."""

    @staticmethod
    def error(bits: float) -> float:
        """2^bits and the rounding to a float; 1 where no digit is known."""
        return float(2.0 ** bits + 2.0 ** -53) if bits < 0 else 1.0

    @classmethod
    def complex(cls, re: int, im: int, bits: int) -> Any:
        """(re + i im) / 2^bits."""
        return complex(cls.number(re, bits), cls.number(im, bits))

    @staticmethod
    def number(a: int, bits: int) -> float:
        """a / 2^bits."""
        try:
            out = fx.to_float(int(a), bits)
        except OverflowError:
            out = math.inf
        if math.isinf(out) or (a and abs(out) < SMALLEST):
            raise beyond()
        return out

    @staticmethod
    def array(a: np.ndarray, bits: np.ndarray) -> np.ndarray:
        """An array of integers over 2^bits, an array of its shape."""
        top = int(bits.max())
        out: np.ndarray = np.ldexp(fx.floats(a, top), top - bits)
        if not np.isfinite(out).all():
            raise beyond()
        return out


def in_units(shapes: np.ndarray, scale: "Scaling") -> tuple[np.ndarray, np.ndarray]:
    """Scaled shapes in floats, a column each, in the units of the coordinates: D q̂, and that over √(mass unit)."""
    direction = np.ldexp(shapes, np.array(scale.coordinates)[:, None])
    full = np.ldexp(direction / math.sqrt(2.0) if scale.mass % 2 else direction, -(scale.mass // 2))
    if not np.isfinite(full).all():
        raise beyond()
    return direction, full


class Digits:
    """Turns fixed-point integers into mpmath.mpf without losing any."""

    @staticmethod
    def error(bits: float) -> "mpmath.mpf":
        """2^bits, rounded up; 1 where no digit is known."""
        from mpmath import mp

        return mp.ldexp(mp.mpf(1), math.ceil(bits) if bits < 0 else 0)

    @classmethod
    def complex(cls, re: int, im: int, bits: int) -> "mpmath.mpc":
        """(re + i im) / 2^bits."""
        from mpmath import mp

        return mp.make_mpc((cls.number(re, bits)._mpf_, cls.number(im, bits)._mpf_))

    @staticmethod
    def number(a: Any, bits: Any) -> "mpmath.mpf":
        """a / 2^bits."""
        from mpmath import libmp, mp

        return mp.make_mpf(libmp.from_man_exp(int(a), -int(bits)))

    @classmethod
    def array(cls, a: np.ndarray, bits: int | np.ndarray) -> np.ndarray:
        """An array of integers over 2^bits, a number or an array of its shape."""
        out = np.empty(a.shape, object)
        bits = np.broadcast_to(bits, a.shape)
        for at in np.ndindex(a.shape):
            out[at] = cls.number(a[at], bits[at])
        return out


def beyond() -> PhysicsError:
    """The refusal of a result that floats cannot hold."""
    return PhysicsError("a frequency or a mode shape is beyond the range of floating-point numbers",
                        hint="check the units, or ask for it with --digits")
