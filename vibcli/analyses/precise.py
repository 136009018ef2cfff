"""Fixed-point results as numbers: nearest floats, or mpmath's where digits were asked for; and what digits cost."""

import math

import numpy as np

from vibcli.analyses import fixed as fx

GUARD_DIGITS = 10


class Floats:
    """Turns fixed-point integers into the nearest floats."""

    @staticmethod
    def number(a, bits):
        """a / 2^bits."""
        return fx.to_float(int(a), bits)

    @staticmethod
    def array(a, bits):
        """An array of integers over 2^bits; bits may be an array of its shape."""
        if np.ndim(bits) == 0:
            return fx.floats(a, bits)
        return np.ldexp(fx.floats(a, int(bits.max())), int(bits.max()) - bits)


class Digits:
    """Turns fixed-point integers into mpmath.mpf without losing any."""

    @staticmethod
    def number(a, bits):
        """a / 2^bits."""
        from mpmath import libmp, mp

        return mp.make_mpf(libmp.from_man_exp(int(a), -int(bits)))

    @classmethod
    def array(cls, a, bits):
        """An array of integers over 2^bits; bits may be an array of its shape."""
        out = np.empty(a.shape, object)
        bits = np.broadcast_to(bits, a.shape)
        for at in np.ndindex(a.shape):
            out[at] = cls.number(a[at], bits[at])
        return out


def working_bits(digits):
    """The bits of accuracy that give `digits` correct ones."""
    return math.ceil((digits + GUARD_DIGITS) * math.log2(10))
