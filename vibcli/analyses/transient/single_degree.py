"""One degree of freedom, m ẍ + c ẋ + k x = f, without loss at any damping."""

import math
from fractions import Fraction

import numpy as np

from vibcli.analyses.transient.modal_block import ModalBlock


def poles(m: float, c: float, k: float) -> tuple[complex, complex]:
    """The roots of m λ² + c λ + k, the slower first; each part correctly rounded or next to it.

    Over-damped, the slow one is k / (m λ₂): −ω (ζ − √(ζ² − 1)) cancels.
    """
    m, c, k = Fraction(m), Fraction(c), Fraction(k)
    excess = c * c - 4 * m * k
    root = square_root(abs(excess) / (4 * m * m))
    if excess < 0:
        real = float(-c / (2 * m))
        return complex(real, root), complex(real, -root)
    half = c / (2 * m)
    fast = half + Fraction(root if c >= 0 else -root)
    if not fast:
        return 0j, 0j
    return complex(-float(k / (m * fast))), complex(-float(fast))


def poles_of_mode(omega: float, growth: float, half: float) -> tuple[complex, complex]:
    """The roots of λ² + 2 half λ + ω² (growth: −growth² in place of ω²), the slower first."""
    if omega > abs(half):
        turning = math.sqrt((omega - half) * (omega + half))
        return complex(-half, turning), complex(-half, -turning)
    root = math.hypot(half, growth) if growth else math.sqrt((abs(half) - omega) * (abs(half) + omega))
    fast = half + math.copysign(root, half)
    if not fast:
        return 0j, 0j
    return complex((growth * growth - omega * omega) / fast), complex(-fast)


def square_root(x: Fraction) -> float:
    """√x of a Fraction, correctly rounded but for a last unit."""
    shift = 2 * ((130 - x.numerator.bit_length() + x.denominator.bit_length()) // 2)
    up, down = max(shift, 0), max(-shift, 0)
    root = Fraction(math.isqrt((x.numerator << up) // (x.denominator << down)))
    return float(root * Fraction(2) ** (-shift // 2))


def pair(slow: complex, fast: complex, shape: np.ndarray, momentum: np.ndarray, force: np.ndarray) -> ModalBlock:
    """The block of one oscillator with the poles `slow`, `fast`: (x, ẋ − λ₁x) with B = (λ₁ 1; 0 λ₂).

    δ = shape · x; momentum: the row that gives x of the coordinates; force: the row that gives ẍ of the forces.
    """
    zero = np.zeros_like(shape)
    return ModalBlock(X=np.array([shape, zero]).T, B=np.array([[slow, 1], [0, fast]]),
                 P=np.array([momentum, -slow * momentum]), R=np.array([zero, momentum]), W=np.array([zero, force]))


def one_degree(m: float, c: float, k: float) -> ModalBlock:
    """The one block of one degree of freedom; without inertia c ẋ + k x = f."""
    if not m:
        one = np.ones((1, 1))
        return ModalBlock(X=one, B=np.array([[-k / c]]), P=one, R=np.zeros((1, 1)), W=one / c)
    return pair(*poles(m, c, k), np.ones(1), np.ones(1), np.array([1 / m]))
