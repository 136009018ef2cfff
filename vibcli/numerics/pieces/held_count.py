"""How many natural frequencies a piece has below ω with both its ends held: J₀ of Wittrick & Williams (1971)."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.numerics.pieces.flattening import flattened
from vibcli.numerics.pieces.parity import parity_functions
from vibcli.numerics.pieces.scaled_functions import even_functions
from vibcli.numerics.pieces.uniform import fourth_order

if TYPE_CHECKING:
    from vibcli.numerics.pieces.arithmetic import Arithmetic
    from vibcli.numerics.pieces.piece import Piece


def held_count(piece: "Piece", omega: Any) -> np.ndarray:
    """J₀(ω), integers (…): eigenvalues ω_i² < ω² with all end values 0, unstable ones (buckled, ω_i² < 0) among them.

    Of numbers and arrays that broadcast to (…), drag left out; μ > 0. It turns by one exactly where a sign does of
    which d has its pole, so that count and d agree also where rounding moves the pole: no count is off by more than
    what a relative change of ω by a few roundings explains. How far a pole is: |d| / |∂d/∂κ| of stiffness_and_slope
    (in norms) tends to the distance of κ to it.
    """
    flat = flattened(piece, piece.undamped_reaction(omega))

    def uniform(one: "Piece", kappa: np.ndarray) -> np.ndarray:
        if flat.order == 2:
            return _second_order(one.length, one.tension, kappa, flat.numbers)
        return _fourth_order(one.length, one.bending, one.tension, kappa, flat.numbers)

    def graded(one: "Piece", kappa: np.ndarray) -> np.ndarray:
        from vibcli.numerics.pieces.graded import graded_count

        return graded_count(one, kappa, flat.numbers)

    return flat.filled((), uniform, graded).astype(int)


def _second_order(length: np.ndarray, tension: np.ndarray, kappa: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
    """Evenly held where C(z) = cos h = 0, oddly where S(z) = sin h/h = 0, z = −h²."""
    half = length / 2
    z = kappa * half * half / tension
    f = even_functions(z, numbers)
    turns = _turns(-z, numbers)
    return np.where(z < 0, _nearest(turns, f.c, numbers) + _nearest(turns - 1 / 2, f.s, numbers), 0)


def _fourth_order(length: np.ndarray, bending: np.ndarray, tension: np.ndarray, kappa: np.ndarray,
                  numbers: "Arithmetic") -> np.ndarray:
    """For κ < 0 the roots are α² ≥ 0 and −β² and d (σ) has one zero each for β/π in (m − ½, m), ((m, m + ½)); below
    these a stiff foundation is buckled only by compression."""
    half = length / 2
    nu, chi = tension * half * half / bending, kappa * half**4 / bending
    count = np.zeros(chi.shape, int)
    waves = chi < 0
    if waves.any():
        f = parity_functions(nu[waves], chi[waves], numbers, False)
        turns = _turns(_wave(nu[waves], chi[waves], numbers), numbers)
        count[waves] = _nearest(turns - 1 / 4, f.d, numbers) + _nearest(turns - 3 / 4, f.sigma, numbers)
    buckled = ~waves & (-nu > 2 * numbers.real(numbers.sqrt(np.where(waves, 0 * chi, chi))))
    if buckled.any():
        count[buckled] = _halved(*(value[buckled] for value in (length, bending, tension, kappa)), numbers)
    return count


def _wave(nu: np.ndarray, chi: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
    """β² > 0 of the root −β² where χ < 0, without cancellation."""
    root = numbers.real(numbers.sqrt(nu * nu / 4 - chi))
    safe = np.where(nu > 0, root + nu / 2, root + abs(nu))
    found: np.ndarray = np.where(nu > 0, -chi / safe, root - nu / 2)
    return found


def _halved(length: np.ndarray, bending: np.ndarray, tension: np.ndarray, kappa: np.ndarray,
            numbers: "Arithmetic") -> np.ndarray:
    """J₀(l) = 2 J₀(l/2) and the negative stiffnesses of the middle, where halves of one length meet; Euler's beam
    between clamps does not buckle for −N l² < 4π² B."""
    if not (-tension * length * length > 36 * bending).any():
        return np.zeros(length.shape, int)
    d = fourth_order(length / 2, bending, tension, kappa, numbers, False)[:, 0]
    middle = (d[..., 0, 0] < 0).astype(int) + (d[..., 1, 1] < 0)
    found: np.ndarray = 2 * _halved(length / 2, bending, tension, kappa, numbers) + middle
    return found


def _turns(square: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
    """√square/π, 0 where square is negative."""
    found: np.ndarray = numbers.real(numbers.sqrt(np.where(square > 0, square, 0 * square))) / numbers.pi
    return found


def _nearest(turns: np.ndarray, sign: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
    """The whole number nearest to turns that is even where sign > 0, odd elsewhere."""
    odd = np.where(sign > 0, 0, 1)
    found: np.ndarray = 2 * numbers.whole((turns - odd) / 2) + odd
    return found
