"""How the frequency of a family of several degrees of freedom begins to hang on the amplitude.

With ξ = a φ cos θ + a² (u₀ + u₂ cos 2θ) + …, θ = ωt, φᵀMφ = 1, the mean of L = T − V over a period is stationary
(Whitham 1974, 14; the order a² of the method of Lindstedt and Poincaré), T and V expanded about the equilibrium:

    F₀ = (λ ∂T₃/∂ξ − ∂V₃/∂ξ)/2        F₂ = (2λ ∂T₃/∂ξ̇ − λ ∂T₃/∂ξ − ∂V₃/∂ξ)/4        at ξ = ξ̇ = φ, λ = ωᵢ²
    G = F₀ᵀK⁻¹F₀/2 + F₂ᵀ(K − 4λM)⁻¹F₂ − 3V₄(φ)/8 + λT₄(φ, φ)/8        ω ≈ ωᵢ (1 + κA²)        κ = −4G/(λφₓ²)

for the amplitude A ≈ |φₓ| a of a coordinate x. Other modes with the frequency ωᵢ, 2ωᵢ or 3ωᵢ forbid it.
"""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.nonlinear.free_equations import SAME
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.expansion import in_numbers
from vibcli.symbolic.evaluation import Floats
from vibcli.symbolic.running_errors import UNIT, Rounded, RunningErrors, error_in, number_in

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.analyses.nonlinear.free_equations import FreeEquations
    from vibcli.mechanics.configuration import Configuration

ORDER = 4
RESONANCES = (1, 2, 3)      # of which order others may not have the frequency
NEAR = 0.1                  # relative: so near an internal resonance is told
STILL = 1e-9                # of the largest share of a coordinate in a mode: less does not move
SAFE = 2.0                  # bounds of the first order in small errors
ARITHMETIC = RunningErrors(Floats)


class QuadraticForm(NamedTuple):
    """A symmetric matrix and bounds of the errors of its entries."""

    value: np.ndarray
    error: np.ndarray

    def __add__(self, other: "QuadraticForm") -> "QuadraticForm":
        return QuadraticForm(self.value + other.value, self.error + other.error)

    def scaled(self, factor: Rounded) -> "QuadraticForm":
        """factor·matrix."""
        c, e = number_in(factor), error_in(factor)
        return QuadraticForm(c * self.value, abs(c) * self.error + e * (np.abs(self.value) + self.error))

    def between(self, left: np.ndarray, right: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(leftᵀ matrix right, bound of its error) of exact matrices."""
        rounding = (2 * len(self.value) + 2) * UNIT * np.abs(self.value)
        return left.T @ self.value @ right, np.abs(left.T) @ (self.error + rounding) @ np.abs(right)


class _Mode(NamedTuple):
    """λ and φ with bounds, all modes as they are known, M and K."""

    square: Rounded
    shape: list[Rounded]
    shapes: np.ndarray
    M: QuadraticForm
    K: QuadraticForm


def kappa_of_mode(configuration: "Configuration", equations: "FreeEquations", number: int, coordinate: int) -> Rounded:
    """κ of the family of a mode for the amplitude of a coordinate, both counted from 0, with the bound of its error;
    PhysicsError at internal resonances."""
    _require_apart(equations.omegas, number)
    scene = configuration.scene.resting
    n, variables = equations.n, [*scene.q, *scene.v]
    V = in_numbers(configuration, "V with loads", scene.q, lambda powers: sum(powers) <= ORDER, ORDER)
    T = in_numbers(configuration, "T", variables, lambda powers: sum(powers) <= ORDER and sum(powers[n:]) <= 2, ORDER)
    T = {powers: c for powers, c in T.items() if sum(powers[n:]) == 2}
    mode = _mode(equations, number, _form({powers[n:]: c for powers, c in T.items() if sum(powers) == 2}, n),
                 _form({powers: c for powers, c in V.items() if sum(powers) == 2}, n))
    _require_movement(mode, equations, number, coordinate)
    share = mode.square * mode.shape[coordinate] * mode.shape[coordinate]
    found: Rounded = ARITHMETIC.power(share, -1) * _quartic(mode, V, T) * -4.0
    return found


def near_resonance(equations: "FreeEquations", number: int) -> tuple[int, int] | None:
    """(mode counted from 0, k) of another mode with about k times the frequency, k = 1, 2, 3; None where there is none.
    Odd forces do not double a frequency."""
    return next(((m, times) for m, times, apart in _ratios(equations.omegas, number)
                 if apart < NEAR and not (times == 2 and equations.odd)), None)


def _ratios(omegas: np.ndarray, number: int) -> list[tuple[int, int, float]]:
    """(mode, k, how far its frequency is from k times that of a mode, relative)."""
    return [(m, times, abs(omega / omegas[number] / times - 1)) for m, omega in enumerate(omegas) if m != number
            for times in RESONANCES]


def _require_apart(omegas: np.ndarray, number: int) -> None:
    for m, times, apart in _ratios(omegas, number):
        if apart < SAME:
            told = "the same frequency as" if times == 1 else f"{times} times the frequency of"
            raise PhysicsError(f"internal resonance 1:{times}: mode {m + 1} has {told} mode {number + 1}, so that they "
                               "may exchange energy at the smallest amplitudes: κ is not found there",
                               "change a parameter a little, or ask about another mode")


def _require_movement(mode: _Mode, equations: "FreeEquations", number: int, coordinate: int) -> None:
    known, most = mode.shape[coordinate], np.abs(equations.shapes[coordinate]).max()
    if abs(number_in(known)) <= max(STILL * most, error_in(known)):
        raise PhysicsError(f"this coordinate does not move in small motions of mode {number + 1}",
                           "ask for the amplitude of one that moves in it, or for another family")


def _form(terms: "Mapping[tuple[int, ...], Rounded]", n: int) -> QuadraticForm:
    """The matrix A of ½ xᵀA x."""
    value, error = np.zeros((n, n)), np.zeros((n, n))
    for powers, c in terms.items():
        i, j = [k for k, p in enumerate(powers) for _ in range(p)]
        times = 2 if i == j else 1
        value[i, j] = value[j, i] = times * number_in(c)
        error[i, j] = error[j, i] = times * error_in(c)
    return QuadraticForm(value, error)


def _mode(equations: "FreeEquations", number: int, M: QuadraticForm, K: QuadraticForm) -> _Mode:
    """With bounds to first order in the errors of M and K."""
    shapes = equations.shapes / np.sqrt(np.diag(M.between(equations.shapes, equations.shapes)[0]))
    phi = shapes[:, [number]]
    square = (K.between(phi, phi)[0] / M.between(phi, phi)[0])[0, 0]
    left, bound = (K + M.scaled(Rounded(-square, 0.0))).between(shapes, phi)
    left = np.abs(left[:, 0]) + bound[:, 0]
    apart = np.abs(equations.omegas**2 - square)
    apart[number] = np.inf
    mixed = left / apart
    unit, bound = M.between(phi, phi)
    mixed[number] = 0.5 * (abs(unit[0, 0] - 1) + bound[0, 0])
    errors = SAFE * np.abs(shapes) @ mixed
    return _Mode(Rounded(square, SAFE * left[number] + UNIT * square),
                 [Rounded(float(x), float(e)) for x, e in zip(phi[:, 0], errors, strict=True)], shapes, M, K)


def _quartic(mode: _Mode, V: dict[tuple[int, ...], Rounded], T: dict[tuple[int, ...], Rounded]) -> Any:
    """G."""
    n, twice = len(mode.shape), [*mode.shape, *mode.shape]
    cubic, quartic = ([{powers: c for powers, c in energy.items() if sum(powers) == order} for energy in (V, T)]
                      for order in (3, 4))
    by_V, by_T = _slopes(cubic[0], mode.shape), [mode.square * x for x in _slopes(cubic[1], twice)]
    still = [(t + v * -1.0) * 0.5 for v, t in zip(by_V, by_T[:n], strict=True)]
    double = [(rate * 2.0 + (t + v) * -1.0) * 0.25 for v, t, rate in zip(by_V, by_T[:n], by_T[n:], strict=True)]
    moved = mode.K + mode.M.scaled(mode.square * -4.0)
    return (_answer(mode.K, still, mode.shapes) * 0.5 + _answer(moved, double, mode.shapes)
            + _value(quartic[0], mode.shape) * -0.375 + mode.square * _value(quartic[1], twice) * 0.125)


def _answer(form: QuadraticForm, force: list[Rounded], shapes: np.ndarray) -> Rounded:
    """Fᵀ A⁻¹ F, A being nearly diagonal in the modes: what it is not is in the bound."""
    value, bound = form.between(shapes, shapes)
    diagonal = np.diag(value)
    parts = [_sum(f * float(x) for f, x in zip(force, shape, strict=True)) for shape in shapes.T]
    moves = np.array([abs(number_in(part)) + error_in(part) for part in parts]) / np.abs(diagonal)
    missed = np.abs(value - np.diag(diagonal)) + bound
    total = _sum(part * part * ARITHMETIC.power(float(d), -1) for part, d in zip(parts, diagonal, strict=True))
    return total + Rounded(0.0, SAFE * float(moves @ missed @ moves))


def _slopes(terms: "Mapping[tuple[int, ...], Rounded]", at: list[Rounded]) -> list[Any]:
    """The derivatives of a polynomial."""
    return [_sum(_monomial(c, powers, at, i) * float(powers[i]) for powers, c in terms.items() if powers[i])
            for i in range(len(at))]


def _value(terms: "Mapping[tuple[int, ...], Rounded]", at: list[Rounded]) -> Any:
    return _sum(_monomial(c, powers, at) for powers, c in terms.items())


def _monomial(c: Rounded, powers: tuple[int, ...], at: Sequence[Rounded], less: int | None = None) -> Rounded:
    """c Π xᵖ, one factor of number `less` left out."""
    for i, (x, p) in enumerate(zip(at, powers, strict=True)):
        for _ in range(p - (i == less)):
            c = c * x
    return c


def _sum(parts: Iterator[Any]) -> Rounded:
    return sum(parts, Rounded(0.0, 0.0))
