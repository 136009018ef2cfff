"""Functions of fixed-point numbers a / 2^bits, and the inverse of small matrices of them."""

from collections.abc import Callable, Sequence
from math import isqrt

from vibcli.numerics.fixed_point import mantissa, shifted

GUARD = 16      # bits
UNARY = ("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log")


def functions(bits: int) -> dict[str, Callable[..., int]]:
    """{name: function} of fixed-point numbers. ArithmeticError where one has no real value."""
    import mpmath

    def real(x: object) -> int:
        if not isinstance(x, mpmath.mpf) or not mpmath.isfinite(x):
            raise ArithmeticError
        m, e = mantissa(x)
        return shifted(m, e + bits)

    def of(function: "Callable[..., mpmath.mpf]") -> "Callable[..., int]":
        def value(*args: int) -> int:
            with mpmath.workprec(bits + GUARD + max(0, *(abs(a).bit_length() - bits for a in args))):
                try:
                    return real(function(*(mpmath.ldexp(a, -bits) for a in args)))
                except ValueError:
                    raise ArithmeticError from None
        return value

    def power(a: int, n: int, d: int) -> int:
        return of(lambda x: mpmath.power(x, mpmath.mpf(n) / d))(a)

    def root(a: int) -> int:
        if a <= 0:
            raise ArithmeticError
        return isqrt(a << bits)

    return {**{name: of(getattr(mpmath, name)) for name in UNARY}, "atan2": of(mpmath.atan2), "power": power,
            "root": root, "over": lambda a: (1 << 2 * bits) // a}


def inverse(rows: Sequence[Sequence[int]], bits: int) -> list[list[int]]:
    """A⁻¹ by elimination with pivots. ZeroDivisionError where A is singular."""
    n, one = len(rows), 1 << bits
    A = [[*row, *(one * (i == j) for j in range(n))] for i, row in enumerate(rows)]
    for i in range(n):
        best = max(range(i, n), key=lambda j: abs(A[j][i]))
        A[i], A[best] = A[best], A[i]
        pivot = A[i][i]
        A[i] = [(x << bits) // pivot for x in A[i]]
        for j in range(n):
            factor = A[j][i]
            if j != i and factor:
                A[j] = [x - (factor * y >> bits) for x, y in zip(A[j], A[i], strict=True)]
    return [row[n:] for row in A]
