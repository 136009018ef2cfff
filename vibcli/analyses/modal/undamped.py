"""Undamped free vibration: natural frequencies and mode shapes of M q̈ + K q = 0.

The eigenvalues are enclosed rigorously in fixed-point arithmetic (undamped_certified.py); those of larger systems
(method.py) are found in floats from the factors √k ∇s and √w ∇s with a bound of their rounding (undamped_large.py),
where that is too wide with one by residuals in twice the digits (undamped_residuals.py).
"""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.method import ENCLOSED, IN_DIGITS, IN_FLOATS, choose
from vibcli.analyses.modal.mode_numbers import Digits, NearestFloats, beyond, in_units
from vibcli.analyses.modal.rigid_body_modes import rank
from vibcli.analyses.modal.scaling import Scaling, mechanism, scaling
from vibcli.base.errors import Inertless
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.precision import working_bits

if TYPE_CHECKING:
    from fractions import Fraction
    from typing import TypeVar

    from vibcli.analyses.modal.undamped_certified import EnclosedEigenvalues
    from vibcli.analyses.modal.undamped_large import Approximate
    from vibcli.mechanics.factored_system import FactoredSystem

    T = TypeVar("T")

ENOUGH = 5e-13
BETTERED = 500      # coordinates whose residuals are found in twice the digits
EXACT = -math.inf
EVALUATED = -51.0
ESCALATE = 1e-13
DIGITS = 60
OSCILLATION = "oscillation"


class Mode(NamedTuple):
    """One mode, q = Re(shape e^{λt}), λ = growth_rate + i omega, with shapeᴴ M shape = 1.

    omega: 0 exactly if rigid, None where nothing oscillates (divergence); growth_rate: Re λ, None where it is zero;
    both in flutter. error: bound of the relative error of each. direction: shape but for one factor, its bits
    independent of units. motion: with members the NaturalFrequency it was made of, which knows what they do between
    their nodes; else None.
    """

    index: int  # type: ignore[assignment]
    omega: Any
    growth_rate: Any
    shape: Any
    direction: Any
    error: Any
    motion: Any = None

    @property
    def rigid(self) -> bool:
        """Does it move without a force?"""
        return not self.omega and self.growth_rate is None

    @property
    def kind(self) -> str:
        """rigid, oscillation, decay, flutter or divergence."""
        return kind(self.growth_rate, self.omega)


def kind(growth: float | None, omega: float | None) -> str:
    """What a motion e^{(growth + i omega)t} is called; either number may be None for zero."""
    if growth and growth > 0:
        return "flutter" if omega else "divergence"
    return OSCILLATION if omega else "decay" if growth else "rigid"


def undamped(elements: Any, precise: "Callable[..., FactoredSystem] | None" = None,
             digits: int | None = None) -> list[Mode]:
    """The modes by ascending ω²: unstable, then rigid, then the others, each with its relative error bound.

    `precise(dps)` evaluates the same elements to dps digits and is called where floats do not decide;
    without it the floats are taken for exact. `digits`: this many correct digits, and numbers of mpmath.
    """
    return within_floats(_undamped, elements, precise, digits)


def within_floats(solve: "Callable[..., T]", *data: Any) -> "T":
    """What solves for modes; the refusal of those that floats cannot hold."""
    try:
        with np.errstate(all="ignore"):
            return solve(*data)
    except OverflowError:
        raise beyond() from None


def _undamped(elements: "FactoredSystem", precise: "Callable[..., FactoredSystem] | None",
              digits: int | None) -> list[Mode]:
    scale, zeros = prepared(elements)
    arithmetic = choose(elements, digits).arithmetic
    if arithmetic == IN_DIGITS:
        return undamped_digits(elements, scale, zeros, precise, digits)
    if arithmetic != ENCLOSED:
        answer = _in_floats(elements, scale, zeros, precise, arithmetic == IN_FLOATS)
        if arithmetic == IN_FLOATS or answer.errors.max() <= ENOUGH:
            return many_modes(answer, scale)
    return modes(certain(elements, scale, zeros, precise), scale, NearestFloats)


def _in_floats(elements: "FactoredSystem", scale: Scaling, zeros: int, precise: "Callable[..., FactoredSystem]",
               many: bool) -> "Approximate":
    """The modes in floats; with bounds by their residuals where those of the method are too wide."""
    from vibcli.analyses.modal.undamped_large import approximate
    from vibcli.numerics.factored_svd import ENOUGH_WHEN_MANY

    answer = approximate(elements, scale, zeros)
    if elements.n > BETTERED or answer.errors.max() <= (ENOUGH_WHEN_MANY if many else ENOUGH):
        return answer
    from vibcli.analyses.modal.undamped_residuals import bettered

    found = bettered(elements, scale, zeros, answer, 0.0 if precise is None else 2.0**EVALUATED)
    return answer if found is None or found.errors.max() > answer.errors.max() else found


def prepared(elements: Any, dragged: bool = False) -> tuple[Scaling, int | None]:
    """The powers of two that scale the data, and the number of rigid modes or None where K has to tell.

    `dragged`: massless coordinates may be held by dampers alone.
    """
    scale = scaling(elements)
    if not dragged:
        check_ties(elements)
    zeros = elements.n - rank(elements.n, *spring_rows(elements)) if factored(elements) else None
    if not dragged and len(elements.massless) == elements.n:
        raise mechanism(_loose(elements)) if zeros else Inertless()
    return scale, zeros


def _loose(elements: "FactoredSystem") -> int:
    """The first coordinate that moves where no spring resists."""
    known = spring_rows(elements)[0]
    return next(i for i in range(elements.n) if rank(elements.n, [*known, {i: 1.0}]) > rank(elements.n, known))


def certain(elements: Any, scale: Scaling, zeros: int | None,
            precise: "Callable[..., FactoredSystem] | None") -> "EnclosedEigenvalues":
    """Enclosed eigenvalues of the floats, or of more digits where their rounding shows."""
    from vibcli.analyses.modal.undamped_certified import enclosed

    answer = enclosed(elements, scale, zeros)
    if precise is None:
        if elements.K_size:
            answer.add_data_error(elements, scale, EXACT)
        return answer
    answer.add_data_error(elements, scale, EVALUATED)
    if not answer.settled(ESCALATE):
        exact = precise(DIGITS)
        answer = enclosed(exact, scale, zeros)
        answer.add_data_error(exact, scale, decimal(DIGITS))
    return answer


def undamped_digits(elements: Any, scale: Scaling, zeros: int | None, precise: "Callable[[int], FactoredSystem]",
                    digits: int) -> list[Mode]:
    """The modes to `digits` correct digits, in numbers of mpmath."""
    from vibcli.analyses.modal.undamped_certified import enclosed

    goal = working_bits(digits)
    if precise is None:
        return modes(enclosed(elements, scale, zeros, goal), scale, Digits)
    for guard in (30, 90, 270):
        exact = precise(digits + guard)
        answer = enclosed(exact, scale, zeros, goal)
        answer.add_data_error(exact, scale, decimal(digits + guard))
        if (answer.errors() <= -digits * math.log2(10)).all():
            break
    return modes(answer, scale, Digits)


def decimal(dps: int) -> float:
    """log2 of the rounding of numbers evaluated to dps digits."""
    return (2 - dps) * math.log2(10)


def factored(elements: Any) -> bool:
    """Whether all stiffness is Σ k ∇s ∇sᵀ with k >= 0."""
    return not any(elements.K.values()) and all(k >= 0 for k, _ in elements.springs)


def spring_rows(elements: Any) -> "tuple[list[dict[int, float]], list[dict[int, Fraction]] | None]":
    """The rows of springs that have stiffness: as floats, and as Fractions or None."""
    kept = [i for i, (k, _) in enumerate(elements.springs) if k]
    exact = elements.rational_rows
    return [elements.springs[i][1] for i in kept], None if exact is None else [exact[i] for i in kept]


def check_ties(elements: Any) -> None:
    """Refuses a coordinate with neither inertia nor stiffness."""
    tied = {i for k, row in elements.springs if k for i, x in row.items() if x}
    tied.update(i for (i, j), x in elements.K.items() if x)
    for i in elements.massless:
        if i not in tied:
            raise mechanism(i)


def modes(answer: "EnclosedEigenvalues", scale: Scaling, numbers: type[Any]) -> list[Mode]:
    """Mode objects of enclosed eigenvalues, in floats or mpmath's numbers."""
    bits = answer.bits
    powers = bits - np.broadcast_to(np.array(scale.coordinates)[:, None], answer.shapes.shape)
    direction = numbers.array(answer.shapes, powers)
    shapes = answer.shapes
    if scale.mass % 2:
        shapes = shapes * math.isqrt(1 << (2 * bits - 1)) >> bits
    full = numbers.array(shapes, powers + scale.mass // 2)
    errors = answer.errors()
    values = [0 if zero else int(x) for x, zero in zip(answer.values, answer.zero, strict=True)]
    out = []
    for place, i in enumerate(sorted(range(len(values)), key=values.__getitem__), 1):
        rate = numbers.number(math.isqrt(abs(values[i]) << bits), bits - scale.time)
        rates = (None, rate) if values[i] < 0 else (rate, None)
        error = numbers.error(errors[i]) if values[i] else 0.0
        out.append(Mode(place, *rates, full[:, i], direction[:, i], error))
    return out


def many_modes(answer: "Approximate", scale: Scaling) -> list[Mode]:
    """Mode objects of approximate eigenvalues in floats."""
    (direction, full), out = in_units(answer.shapes, scale), []
    for place, i in enumerate(np.argsort(answer.values, kind="stable").tolist(), 1):
        value = float(answer.values[i])
        rate = math.ldexp(math.sqrt(abs(value)), scale.time)
        rates = (None, rate) if value < 0 else (rate, None)
        out.append(Mode(place, *rates, full[:, i], direction[:, i], float(answer.errors[i])))
    return out
