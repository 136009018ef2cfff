"""Equilibrium and element data to any number of digits, by Newton's method in mpmath from the float solution."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    import mpmath

    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.equilibrium.equilibrium import Equilibrium
    from vibcli.mechanics.factored_system import FactoredSystem
    from vibcli.mechanics.numeric_linearisation import Numbers
    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.symbolic.node import Node

ROUNDED, NOTHING, FALLEN, VANISHED = 40, 1e-20, 1e-10, 1e-6
GUARD = 30      # digits beyond those asked: near a bifurcation a singular K takes up many of them


def system_to(configuration: "Configuration", digits: int) -> "FactoredSystem":
    """FactoredSystem of mpmath numbers, good to `digits` digits."""
    import mpmath

    with mpmath.workdps(digits + GUARD):
        arithmetic = multiprecision()
        values = configuration.numeric.values(arithmetic)
        place = place_to(configuration, values, arithmetic)
        return in_numbers(configuration.reference_form, arithmetic, values | place,
                          configuration.numeric.rational).elements


def place_to(configuration: "Configuration", values: "Mapping[str, mpmath.mpf]",
             arithmetic: Any) -> "dict[str, mpmath.mpf]":
    """{coordinate: number} of the equilibrium at the working precision; of a linear scene in floats, where it is of no
    matter."""
    if configuration.equilibrium.drawn:
        return in_its_place(configuration.scene.resting.drawn, values, arithmetic)
    if configuration.system.is_linear:
        return configuration.equilibrium.values
    return equilibrium_to(configuration.numeric, configuration.equilibrium, values, arithmetic)


def in_its_place(drawn: "Mapping[Node, Node]", values: "Mapping[str, mpmath.mpf]",
                 arithmetic: Any) -> "dict[str, mpmath.mpf]":
    """{coordinate: number} as drawn; `drawn`: {symbol: expression}."""
    return dict(zip((q.name for q in drawn), evaluate(list(drawn.values()), arithmetic, values), strict=True))


def rest_to(configuration: "Configuration", digits: int) -> "tuple[Any, dict[str, mpmath.mpf]]":
    """(arithmetic, {symbol: number}) of everything at rest in the equilibrium, at t = 0, good to `digits` digits."""
    import mpmath

    with mpmath.workdps(digits + GUARD):
        arithmetic = multiprecision()
        values, zero = configuration.numeric.values(arithmetic), mpmath.mpf(0)
        if configuration.equilibrium.jumps is not None:
            place = configuration.equilibrium.jumps.precisely(arithmetic, values)
        elif not configuration.equilibrium.drawn and configuration.system.is_linear:
            place = equilibrium_to(configuration.numeric, configuration.equilibrium, values, arithmetic)
        else:
            place = place_to(configuration, values, arithmetic)
        still = {v.name: zero for v in configuration.scene.v}
        return arithmetic, {**values, configuration.scene.time.name: zero, **place, **still}


class Degenerate(PhysicsError):
    """K is singular in the equilibrium: Newton's method finds no more digits of it. position: {coordinate: number}, the
    best that is known, where it is a multiple zero."""

    def __init__(self, position: "Mapping[str, mpmath.mpf] | None" = None) -> None:
        self.position = position
        super().__init__("the equilibrium is degenerate (its stiffness is singular): no more digits of it are found",
                         "leave --digits out")


def equilibrium_to(numeric: "NumericSystem", near: "Equilibrium", values: "Mapping[str, mpmath.mpf]",
                   arithmetic: Any) -> "dict[str, mpmath.mpf]":
    """{coordinate: mpf} in the Equilibrium `near`, at the working precision, dependent coordinates included.

    Towards a multiple zero Newton's method crawls, its residual falling by a factor; where there is none it stays.
    """
    import mpmath

    if near.degenerate:
        raise Degenerate
    names, loops, form = numeric.scene.coordinates, numeric.scene.resting.loops, numeric.system.linearisation
    position = {name: mpmath.mpf(value) for name, value in near.values.items()}
    left, step = [], None
    for _ in range(60):
        if loops is not None:
            found = loops.refined({**values, numeric.scene.time.name: mpmath.mpf(0), **position}, arithmetic)
            position = {name: found[name] for name in position}
        numbers = in_numbers(form, arithmetic, {**values, **position})
        left.append(max(map(abs, numbers.residual), default=mpmath.mpf(0)))
        before, step = step, _newton_step(numbers, mpmath)
        if any(mpmath.im(change) for change in step):       # beyond an end of what is real
            break
        for name, change in zip(names, step, strict=True):
            position[name] += change
        if max(map(abs, step)) <= mpmath.eps * 10 ** (GUARD - 3) * (1 + max(map(abs, position.values()))):
            return position
    if left[-1] <= FALLEN * left[0] and not any(map(mpmath.im, step)):
        ratio = max(map(abs, step)) / max(map(abs, before))     # the steps are a geometric series
        raise Degenerate({**position, **{name: position[name] + change * ratio / (1 - ratio)
                                         for name, change in zip(names, step, strict=True)}})
    place = ", ".join(f"{name} = {near.values[name]:.6g}" for name in names)
    drawn = {name: mpmath.mpf(value) for name, value in numeric.drawn_floats.items()}
    if left[0] <= VANISHED * max(in_numbers(form, arithmetic, {**values, **drawn}).residual_size):
        raise PhysicsError(f"near {place} the forces all but vanish, but no equilibrium is found there",
                           "change the data by a little, or start elsewhere with `equilibrium:`")
    raise PhysicsError(f"the search for the equilibrium ends near {place}, where the forces change without bound, and "
                       "none is found there", "add the spring or support that carries the load, or start elsewhere "
                       "with `equilibrium:`")


def rests(numeric: "NumericSystem", position: Mapping[str, float]) -> bool:
    """Do all forces vanish in a position ({coordinate: float}), to more digits than floats have?"""
    import mpmath

    with mpmath.workdps(ROUNDED + GUARD):
        arithmetic = multiprecision()
        values = numeric.values(arithmetic) | {name: mpmath.mpf(x) for name, x in position.items()}
        numbers = in_numbers(numeric.system.linearisation, arithmetic, values)
        largest = max((abs(x) for x in numbers.elements.stiffness().values()), default=0)
        return all(abs(force) <= NOTHING**2 * (1 + largest) for force in numbers.residual)


def _newton_step(numbers: "Numbers", mpmath: Any) -> "list[mpmath.mpf]":
    """−K⁻¹ r; coordinates that nothing holds, and those tied by K to no force that is left, stay where they are."""
    n = numbers.elements.n
    K = numbers.elements.stiffness()
    moved = {i for i in range(n) if numbers.residual[i]}
    for _ in range(n):
        moved |= {j for i in moved for j in range(n) if K.get((i, j)) or K.get((j, i))}
    held = [i for i in sorted(moved) if any(K.get((i, j)) for j in range(n))]
    step = [mpmath.mpf(0)] * n
    if held:
        block = mpmath.matrix([[K.get((i, j), 0) for j in held] for i in held])
        try:
            found = mpmath.lu_solve(block, mpmath.matrix([-numbers.residual[i] for i in held]))
        except ZeroDivisionError:
            raise Degenerate from None
        for i, value in zip(held, found, strict=True):
            step[i] = value
    return step


def require_inertia(numeric: "NumericSystem", elements: Any) -> None:
    """PhysicsError where the inertia along a coordinate vanishes in equilibrium, though not as drawn."""
    from vibcli.symbolic.evaluation import Floats

    drawn = in_numbers(numeric.system.linearisation_at_reference, Floats, numeric.floats).elements.matrices()[0]
    here = elements.matrices()[0]
    for i, name in enumerate(numeric.scene.coordinates):
        if abs(here.get((i, i), 0)) < NOTHING * abs(drawn.get((i, i), 0)):
            raise PhysicsError(f"nothing that has a mass moves with '{name}' in the equilibrium: it is a dead centre",
                               "give the bodies their inertia, or start elsewhere with `equilibrium:`")


def rounded_system(configuration: "Configuration") -> "FactoredSystem":
    """The element data at an equilibrium that was searched for, each number correctly rounded.

    What falls with the digits is rounding of what cancels, and zero.
    """
    exact = system_to(configuration, ROUNDED)
    largest = max((abs(x) for x in exact.K_size.values()), default=0)
    if any(abs(x) < NOTHING * largest for x in exact.K.values()) or all(abs(x) < NOTHING for x in exact.K.values()):
        sharper = system_to(configuration, 2 * ROUNDED)
        exact = exact.with_parts(K={pair: x for pair, x in exact.K.items()
                                    if abs(sharper.K.get(pair, 0)) > NOTHING * abs(x)})
    return exact.each(float).with_parts(K_size={pair: abs(float(x)) for pair, x in exact.K.items()})
