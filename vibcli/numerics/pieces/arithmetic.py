"""What kind of numbers a computation is in: doubles in arrays, or mpmath's in arrays of objects."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable


class Arithmetic(NamedTuple):
    """Functions of arrays, element by element; π, and the rounding unit."""

    sqrt: "Callable[[Any], np.ndarray]"                # of complex numbers too, with a real part ≥ 0
    exp: "Callable[[Any], np.ndarray]"
    real: "Callable[[Any], np.ndarray]"
    whole: "Callable[[Any], np.ndarray]"               # the nearest whole numbers, as integers
    inverse: "Callable[[np.ndarray], np.ndarray]"             # of matrices (…, m, m)
    pi: Any
    i: Any                          # the imaginary unit
    eps: float
    number: "Callable[[Any], Any] | None"       # one of mpmath's numbers of any

    def array(self, values: Any) -> np.ndarray:
        """Numbers as an array of this arithmetic, complex only where they are."""
        found = np.asarray(values)
        if self.number is not None:
            return np.asarray(self.number(found), object)
        return found if found.dtype.char in "dD" else found.astype(complex if found.dtype.kind == "c" else float)

    def terms(self, order: int) -> int:
        """How many terms the power series of parts of varying tension take: of strings they fall like 5⁻ᵏ."""
        return 8 - int(np.log(self.eps) / (1.6 if order == 2 else 1.2))

    def is_real(self, values: np.ndarray) -> bool:
        """Are all of them numbers of a real type?"""
        if values.dtype.kind != "O":
            return values.dtype.kind != "c"
        return not any(hasattr(value, "_mpc_") for value in values.flat)


def _root(values: np.ndarray) -> np.ndarray:
    """√ of doubles: real ones ≥ 0 stay real."""
    is_complex = values.dtype.kind == "c" or np.count_nonzero(values < 0) > 0
    found: np.ndarray = np.sqrt(values.astype(complex) if is_complex else values)
    return found


_DOUBLES = Arithmetic(_root, np.exp, np.real, lambda values: np.rint(values).astype(int), np.linalg.inv,
                      np.pi, 1j, 2.0**-52, None)


def arithmetic_of(*values: Any) -> Arithmetic:
    """mpmath's, at its precision of now, where one of the numbers is of it; else that of doubles."""
    if not any(_of_mpmath(value) for value in values):
        return _DOUBLES
    import mpmath

    functions = [np.frompyfunc(function, 1, 1) for function in (mpmath.sqrt, mpmath.exp, mpmath.re)]
    nearest = np.frompyfunc(lambda value: int(mpmath.nint(value)), 1, 1)
    number = np.frompyfunc(mpmath.mpmathify, 1, 1)
    return Arithmetic(*functions, lambda values: nearest(values).astype(int), _inverse, +mpmath.pi, mpmath.mpc(0, 1),
                      float(mpmath.mp.eps), number)


def _inverse(values: np.ndarray) -> np.ndarray:
    """Of arrays of mpmath's numbers, one matrix at a time."""
    import mpmath

    m = values.shape[-1]
    if m == 1:
        return np.asarray(1 / values)
    found = [(mpmath.matrix(one.tolist()) ** -1).tolist() for one in values.reshape(-1, m, m)]
    return np.array(found, object).reshape(values.shape)


def _of_mpmath(value: complex | np.ndarray) -> bool:
    if isinstance(value, np.ndarray):
        return value.dtype.kind == "O" and any(_of_mpmath(one) for one in value.flat)
    return type(value).__module__.startswith("mpmath")
