"""Damped mode shapes to many digits: a bordered solve for each eigenvalue, which is known to all of them."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import mpmath
import numpy as np

from vibcli.analyses.modal.mode_numbers import Digits

if TYPE_CHECKING:
    from vibcli.analyses.modal.damped_in_modal_coordinates import Eigenvalue, ModalDamping
    from vibcli.analyses.modal.nonsymmetric import Follower
    from vibcli.analyses.modal.scaling import Scaling


def shapes(system: "ModalDamping | Follower", found: "Sequence[Eigenvalue]", scale: "Scaling") -> np.ndarray:
    """The vectors in all coordinates as mpmath numbers, a column for each eigenvalue."""
    out = np.empty((len(system.basis), len(found)), object)
    with mpmath.workprec(system.bits):
        basis = Digits.array(system.basis, system.bits)
        for i, p in enumerate(scale.coordinates):
            basis[i] = [mpmath.ldexp(x, p) / mpmath.sqrt(mpmath.ldexp(1, scale.mass)) for x in basis[i]]
        c, k = Digits.array(system.c, system.bits), _stiffness(system)
        for place, d in enumerate(found):
            x = _vector(system, d, c, k)
            q = basis.dot(x)
            lead = max(q.tolist(), key=abs)
            out[:, place] = [component * abs(lead) / lead for component in q.tolist()]
    return out


def _stiffness(system: "ModalDamping | Follower") -> np.ndarray:
    if hasattr(system, "k"):
        return Digits.array(system.k, system.bits)
    return np.diag(Digits.array(system.values, system.bits))


def _vector(system: "ModalDamping | Follower", d: "Eigenvalue", c: np.ndarray, k: np.ndarray) -> np.ndarray:
    """x with (λ² m + λ c + k) x = 0 and xᴴ m x = 1, next to the one known in floats."""
    n = len(c)
    massive = getattr(system, "massive", n)
    start = np.array([mpmath.mpmathify(complex(x)) for x in d.x], object)
    if d.mode is not None or not (d.re or d.im):
        return start
    value = Digits.complex(d.re, d.im, system.bits)
    block = value * c + k
    block[range(massive), range(massive)] += value * value
    a = mpmath.matrix(np.block([[block, start[:, None]], [start.conj(), np.zeros(1, object)]]).tolist())
    right = mpmath.zeros(n + 1, 1)
    right[n] = 1
    try:
        x = mpmath.lu_solve(a, right)
    except ZeroDivisionError:  # a multiple eigenvalue: a step beside it turns to its vectors
        for i in range(n):
            a[i, i] += mpmath.ldexp(1, -system.bits // 2)
        x = mpmath.lu_solve(a[:n, :n], mpmath.matrix(start.tolist()))
    size = mpmath.sqrt(sum(abs(x[i]) ** 2 for i in range(massive or n)))
    return np.array([x[i] / size for i in range(n)], object)
