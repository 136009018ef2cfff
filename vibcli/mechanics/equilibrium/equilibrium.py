"""Equilibrium by virtual work, r(q) = 0, reached from the drawn position by descending the potential energy."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    import mpmath
    import numpy as np

    from vibcli.mechanics.equilibrium.energy_descent import EnergyDescent
    from vibcli.mechanics.equilibrium.rest_at_jumps import JumpsAtRest
    from vibcli.mechanics.numeric_linearisation import Numbers
    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.symbolic.running_errors import RunningErrors

EPSILON = 2.0**-52
LEAPING = "sign", "step"
STEPS = 300
ROUNDING = 20       # roundings that may be left of the forces


class Equilibrium(NamedTuple):
    """Coordinates in equilibrium (numbers by name), whether that is the drawn position, and the largest residual
    relative to the magnitudes of its terms and of K q, the largest that the search met; start: the position that
    `equilibrium:` names, whose nearest one it is, or None; degenerate: did Newton's method find K singular there?
    jumps: the JumpsAtRest of forces that jump there and bear what balance asks for, or None."""

    values: dict[str, float]
    drawn: bool
    residual: float
    steps: int = 0
    start: dict[str, float] | None = None
    degenerate: bool = False
    jumps: "JumpsAtRest | None" = None

    @property
    def from_start(self) -> dict[str, float] | None:
        """{coordinate: how far it lies from the start}, None where none is named."""
        return None if self.start is None else {name: self.values[name] - x for name, x in self.start.items()}


def relative_residual(numbers: "Numbers") -> float:
    return max((abs(r) / size for r, size in zip(numbers.residual, numbers.residual_size, strict=True) if size),
               default=0.0)


def is_balanced(numbers: "Numbers", terms: int = 8) -> bool:
    """Does the residual vanish but for the rounding of its terms?"""
    return relative_residual(numbers) <= 4 * terms * EPSILON


def find_equilibrium(numeric: "NumericSystem", start: Mapping[str, float]) -> Equilibrium:
    """The Equilibrium reached from `start` ({coordinate: float}); PhysicsError where V falls without bound."""
    from vibcli.mechanics.equilibrium.energy_descent import EnergyDescent
    from vibcli.mechanics.equilibrium.no_equilibrium import repelled, unbounded, unfinished

    search = EnergyDescent(numeric, start)
    q = search.vector(start)
    numbers = search.at(q)
    conservative = numeric.system.conservative
    step, size = (search.step, search.first_radius) if conservative else (search.drift, search.first_drift)
    steps = 0
    while not search.flat(numbers):
        search.forget()
        steps += 1
        if search.far(q):
            raise repelled(search, unbounded(search, q))
        if steps > STEPS and search.balanced(numbers):
            break       # there but for rounding
        if steps > STEPS:
            return _held(search, q, steps, unbounded(search, q) if conservative else unfinished(search, q, STEPS))
        q, numbers, size, moved = step(q, numbers, size)
        if not moved:
            break
    q, numbers = search.polished(q, numbers)
    if not search.balanced(numbers) or search.faded(numbers) or search.drowned(q, numbers) or (
            search.at_a_pole(q, numbers)):
        return _held(search, q, steps, unbounded(search, q))
    found = Equilibrium(search.here, False, search.relative(numbers), steps)
    unsure = search.in_doubt(numbers) or found.residual > ROUNDING * EPSILON
    return _in_digits(search, found) if unsure else found


def _along_a_valley(search: "EnergyDescent", q: "np.ndarray") -> dict[str, float] | None:
    """{coordinate: float} of the stable equilibrium to which Newton's method leads from where the descent has come to,
    in a valley that is bent and far steeper across than along; None where there is none."""
    if not search.numeric.system.conservative or not search.soft(search.at(q)):
        return None
    import mpmath

    from vibcli.mechanics.equilibrium.rest_in_digits import DIGITS, holds
    from vibcli.mechanics.high_precision import equilibrium_to
    from vibcli.mechanics.numeric_linearisation import in_numbers
    from vibcli.symbolic.evaluation import multiprecision

    with mpmath.workdps(DIGITS):
        arithmetic, found = multiprecision(), Equilibrium(search.here, False, 0.0)
        values = search.numeric.values(arithmetic)
        try:
            place = equilibrium_to(search.numeric, found, values, arithmetic)
        except (PhysicsError, ArithmeticError):      # a slope is infinite
            return None
        held = holds(in_numbers(search.numeric.system.statics, arithmetic, values | place))
    there = {name: float(x) for name, x in place.items()}
    return there if held and search.energy(search.vector(there)) <= search.energy(q) else None


def _in_digits(search: "EnergyDescent", found: Equilibrium) -> Equilibrium:
    """The same from more digits than floats have, as far as these tell it, and what these leave of the forces there."""
    import mpmath

    from vibcli.mechanics.equilibrium.rest_in_digits import DIGITS
    from vibcli.mechanics.numeric_linearisation import in_numbers
    from vibcli.symbolic.evaluation import multiprecision

    with mpmath.workdps(DIGITS):
        arithmetic = multiprecision()
        values = search.numeric.values(arithmetic)
        place = _place_in_digits(search, found, values, arithmetic)
        if place is None:
            return found
        rounded = {name: float(x) for name, x in place.items()}
        there = values | {name: mpmath.mpf(x) for name, x in rounded.items()}
        left = search.relative(in_numbers(search.numeric.system.statics, arithmetic, there))
        return found._replace(values=rounded, residual=float(left))


def _place_in_digits(search: "EnergyDescent", found: Equilibrium, values: "dict[str, mpmath.mpf]",
                     arithmetic: "RunningErrors") -> "dict[str, float | mpmath.mpf] | None":
    """{coordinate: mpf}, None where it is not found."""
    from vibcli.mechanics.equilibrium.rest_in_digits import rest_in_digits
    from vibcli.mechanics.high_precision import equilibrium_to

    if search.numeric.system.is_linear:
        return rest_in_digits(search.numeric)
    try:
        return equilibrium_to(search.numeric, found, values, arithmetic)
    except (PhysicsError, ArithmeticError):      # a slope is infinite
        return None


def _held(search: "EnergyDescent", q: "np.ndarray", steps: int, refusal: PhysicsError) -> Equilibrium:
    """The Equilibrium that more digits tell, or where forces jump, next to which a search ends; else the refusal."""
    from vibcli.mechanics.equilibrium.no_equilibrium import repelled

    if not search.scene.table.called.intersection(LEAPING):
        from vibcli.mechanics.equilibrium.rest_in_digits import rest_in_digits

        place = rest_in_digits(search.numeric) or _along_a_valley(search, q)
        if place is None:
            raise repelled(search, refusal)
        return Equilibrium(place, False, 0.0, steps)
    from vibcli.mechanics.equilibrium.rest_at_jumps import rest_at_jumps

    found = rest_at_jumps(search, q)
    if found is None:
        raise refusal
    return Equilibrium({name: found.values[name] for name in search.names}, False, 0.0, steps, jumps=found)
