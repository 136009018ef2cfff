"""How much each frequency and damping ratio changes with each parameter p: exact first derivatives.

    dω = φᴴ(K′ − ω²M′ + iωG′)φ / φᴴ(2ωM − iG)φ        dλ = −yᵀ(λ²M′ + λ(C + G)′ + K′)u / yᵀ(2λM + C + G)u

M′, C′, G′, K′ are derivatives at the equilibrium as it shifts with p (mechanics/perturbed.py); y is the left
eigenvector, u itself where there is no G (R. L. Fox & M. P. Kapoor, AIAA Journal 6 (1968) 2426). Frequencies that
coincide split: their derivatives, as p grows, are the eigenvalues of φᵀ(K′ − ω²M′)φ/2ω over all shapes φ of them.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.analyses.modal.modes_precise import SAME, WORKING, by_frequency, coinciding
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.inner_products import conjugate, inner, only
from vibcli.mechanics.parameter_derivatives import perturbed_system
from vibcli.symbolic.dual_numbers import Dual, slope

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.mechanics.factored_system import FactoredSystem

ROUNDING = 1e-25    # of a frequency
SIMPLE = 1e-10      # relative distance from the next eigenvalue below which one does not count as simple


class Sensitivities(NamedTuple):
    """Derivatives by each independent parameter, as floats.

    values: {parameter: number}; omega: {parameter: {index of a mode: ∂ω/∂p}}; damped: [DampedSensitivity], None where
    nothing damps; coinciding: lists of the indices of modes of one frequency; refused: {parameter: why there is none};
    remark: why the damped modes are missing, or None.
    """

    values: dict[str, Any]
    omega: dict[str, dict[int, Any]]
    damped: "list[DampedSensitivity] | None"
    remark: str | None
    coinciding: list[list[int]]
    refused: dict[str, str]


class DampedSensitivity(NamedTuple):
    """∂λ/∂p, ∂ζ/∂p of one damped mode, {parameter: number}; None of an eigenvalue that is not simple."""

    mode: Any
    eigenvalue: dict[str, Any] | None
    zeta: dict[str, Any] | None


def sensitivities(modal: "ModalAnalysis", _: Any) -> Sensitivities:
    """The Sensitivities of a system."""
    with mpmath.workdps(WORKING):
        modes, (damped, remark) = modal.sharp_modes, _damped_modes(modal)
        elements = modal.configuration.precise_system(WORKING)
        groups = [_Group(group, elements) for group in by_frequency(modes)]
        free = [mode.shape for mode in modes if mode.rigid]
        changes, refused = {}, {}
        for name in modal.spec.independent_parameters:
            try:
                changes[name] = only(perturbed_system(modal.configuration, name, free), lambda x: x.__class__ is Dual)
            except PhysicsError as error:
                refused[name] = error.message
            except ZeroDivisionError:
                refused[name] = f"the forces have no derivative by '{name}' at this value"
        values = {name: modal.numeric.floats[name] for name in (*changes, *refused)}
        omega = {name: _natural(groups, change, values[name]) for name, change in changes.items()}
        found = None if damped is None else _of_damped(damped, changes, elements, values)
    return Sensitivities(values, omega, found, remark, coinciding(modes), refused)


def _rounded(rate: mpmath.mpf, value: float, size: int | mpmath.mpf) -> float:
    """A rate of change as a float, exactly zero where it is only rounding."""
    return 0.0 if value and abs(rate * value) <= ROUNDING * abs(size) else float(rate)


class _Group:
    """Modes of one frequency, and φᴴ(2ωM − iG)φ of the first."""

    def __init__(self, modes: "Sequence[Mode]", elements: Any) -> None:
        self.modes, self.omega, self.turning = modes, modes[0].omega, any(elements.G.values())
        shape = modes[0].shape
        self.size = 2 * self.omega * inner(elements.inertias, elements.M, shape, shape)
        if self.turning:
            self.size -= 1j * inner((), elements.G, shape, shape)

    def rates(self, change: Any) -> list[mpmath.mpf]:
        """∂ω/∂p of the modes, ascending; None of gyroscopic modes that coincide."""
        shapes = [mode.shape for mode in self.modes]
        if not shapes[1:]:
            return [mpmath.re(self._entry(change, shapes[0], shapes[0]) / self.size)]
        if self.turning:
            return [None] * len(shapes)
        A = mpmath.matrix([[self._entry(change, a, b) / self.size for b in shapes] for a in shapes])
        return list(mpmath.eigsy(A, eigvals_only=True))

    def _entry(self, change: "FactoredSystem", y: "np.ndarray", x: "np.ndarray") -> mpmath.mpf:
        """yᴴ(K′ − ω²M′ + iωG′)x."""
        total = slope(inner(change.springs, change.K, y, x))
        total -= self.omega**2 * slope(inner(change.inertias, change.M, y, x))
        return total + 1j * self.omega * slope(inner((), change.G, y, x)) if self.turning else total


def _natural(groups: Sequence[_Group], change: "FactoredSystem", value: float) -> dict[int, float]:
    """{index of a mode: ∂ω/∂p}."""
    return {mode.index: None if rate is None else _rounded(rate, value, mode.omega)
            for group in groups for mode, rate in zip(group.modes, group.rates(change), strict=True)}


# damped


def _damped_modes(modal: "ModalAnalysis") -> "tuple[list[DampedMode] | None, str | None]":
    """(the damped modes or None, why there are none although something damps)."""
    if modal.damped is None:
        return None, None
    if modal.spec.get("damping") is not None:
        return None, "what `damping` gives is not differentiated"
    try:
        return modal.sharp_damped, None
    except PhysicsError as error:
        return None, error.message


def _of_damped(modes: "Sequence[DampedMode]", changes: "dict[str, FactoredSystem]", elements: "FactoredSystem",
               values: Mapping[str, float]) -> list[DampedSensitivity]:
    """A DampedSensitivity for each eigenvalue that is not zero."""
    moving = [mode for mode in modes if mode.omega]
    rates = {id(mode): _eigenvalue_rates(mode, changes, elements) for mode in moving if _is_simple(mode, moving)}
    found = []
    for mode in moving:
        pair = [other for other in moving if other.index == mode.index]
        if any(id(part) not in rates for part in pair):
            found.append(DampedSensitivity(mode, None, None))
            continue
        zeta = None if mode.zeta is None else {
            name: _rounded(_zeta_rate(pair, [rates[id(part)][name] for part in pair]), values[name], 1)
            for name in changes}
        eigenvalue = {name: complex(*(_rounded(part, values[name], mode.omega) for part in (rate.real, rate.imag)))
                      for name, rate in rates[id(mode)].items()}
        found.append(DampedSensitivity(mode, eigenvalue, zeta))
    return found


def _is_simple(mode: "DampedMode", modes: "Sequence[DampedMode]") -> bool:
    """Is no other eigenvalue next to this one: of the list, and the conjugate of itself?"""
    near = [other.eigenvalue for other in modes if other is not mode]
    near += [conjugate(mode.eigenvalue)] if mode.eigenvalue.imag else []
    return all(abs(other - mode.eigenvalue) > SIMPLE * abs(mode.eigenvalue) for other in near)


def _eigenvalue_rates(mode: "DampedMode", changes: "Mapping[str, FactoredSystem]",
                      elements: "FactoredSystem") -> dict[str, mpmath.mpc]:
    """{parameter: ∂λ/∂p}."""
    root, u = mode.eigenvalue, list(mode.shape)
    y = [conjugate(x) for x in (_left(root, elements) if any(elements.G.values()) else u)]
    size = 2 * root * inner(elements.inertias, elements.M, y, u) + inner(elements.dampers, elements.C, y, u)
    size += inner((), elements.G, y, u)
    found = {}
    for name, change in changes.items():
        total = root**2 * slope(inner(change.inertias, change.M, y, u)) + slope(inner(change.springs, change.K, y, u))
        total += root * slope(inner(change.dampers, change.C, y, u) + inner((), change.G, y, u))
        found[name] = -total / size
    return found


def _left(root: mpmath.mpc, elements: "FactoredSystem") -> list[mpmath.mpc]:
    """y with yᵀ(λ²M + λ(C + G) + K) = 0, by one step of inverse iteration next to λ."""
    M, C, G, K = elements.matrices()
    near = root * (1 + mpmath.mpf(SAME))
    D = mpmath.zeros(elements.n)
    for matrix, factor in ((M, near**2), (C, near), (G, near), (K, 1)):
        for (i, j), entry in matrix.items():
            D[j, i] += factor * entry
    return list(mpmath.lu_solve(D, mpmath.matrix([1 + mpmath.mpf(i) / 7 for i in range(elements.n)])))


def _zeta_rate(pair: "Sequence[DampedMode]", rates: list[mpmath.mpc]) -> mpmath.mpf:
    """∂ζ/∂p: ζ = −Re λ/|λ|, of the two real eigenvalues of one mode −(λ₁ + λ₂)/(2√(λ₁λ₂))."""
    roots = [mode.eigenvalue for mode in pair] * (3 - len(pair))
    rates = rates * (3 - len(pair))
    if len(pair) == 1:
        roots[1], rates[1] = conjugate(roots[1]), conjugate(rates[1])
    total, product = roots[0] + roots[1], roots[0] * roots[1]
    grown = (rates[0] * roots[1] + roots[0] * rates[1]).real
    omega = product.real ** 0.5
    return -(rates[0] + rates[1]).real / (2 * omega) + total.real * grown / (4 * omega**3)
