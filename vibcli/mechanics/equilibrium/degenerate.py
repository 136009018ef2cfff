"""The system about one equilibrium of a list, degenerate ones included.

Where K is singular at an equilibrium that was searched for — a multiple zero of the forces, a line of equilibria —
Newton's method gives no more digits than floats have. The stiffness then counts as known to BLUR of what is typical of
the scene, and what is below that as zero.
"""

from collections.abc import Mapping
from math import sqrt
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import Kinked, PhysicsError
from vibcli.mechanics.equilibrium.energy_descent import EnergyDescent
from vibcli.mechanics.equilibrium.equilibrium import Equilibrium, relative_residual
from vibcli.mechanics.high_precision import GUARD, NOTHING, ROUNDED, Degenerate, equilibrium_to
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.evaluation import Floats, multiprecision

if TYPE_CHECKING:
    import mpmath

    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.equilibrium.all_equilibria import Item
    from vibcli.mechanics.equilibrium.scaled_forces import Forces
    from vibcli.mechanics.factored_system import FactoredSystem
    from vibcli.mechanics.numeric_system import NumericSystem

BLUR, ALONG = 1e-6, 1e-9           # at a multiple zero; on a line of equilibria
UNSETTLED, NEAR = 1e-9, 0.1        # of the figure: a step that is no rounding; how far a place may move
TINY = 1e-5                        # of the figure: a displacement of which floats may know less than is printed
BALANCED = 20 * 2.0**-52           # of the terms of a force: what rounding leaves of it
LIMIT = 1e-9                       # at a limit of stability, which is solved for with its null vector
UNIT = 2.0**53                     # a stiffness counts as known to 2⁻⁵³ of its K_size


def about(configuration: "Configuration", item: "Item", forces: "Forces") -> "Configuration":
    """The Configuration about the equilibrium of an Item of all those of some Forces."""
    found = configuration.about(item.equilibrium)
    if item.equilibrium.drawn or configuration.system.is_linear:
        return found
    if any(name in forces.names for direction in item.free for name in direction):
        return _blurred(found, forces, ALONG)
    try:
        found.linear_system  # noqa: B018
    except PhysicsError:        # it is raised again where the modes are asked for
        return _blurred(found, forces, BLUR) if item.singular else found
    return found


def settled_alone(numeric: "NumericSystem", found: Equilibrium,
                  position: "Mapping[str, Any] | None") -> "tuple[Equilibrium, FactoredSystem]":
    """(Equilibrium, its linear system in floats) of one that is degenerate; `position`: a better one, or None."""
    if position is not None and numeric.scene.loops is None:
        found = found._replace(values={name: float(value) for name, value in position.items()})
    from vibcli.mechanics.equilibrium.families import freedom, learnt

    forces = learnt(numeric)
    return found, blurred(numeric, found, forces, ALONG if freedom(found, forces) else BLUR)


def sharpened(numeric: "NumericSystem", found: Equilibrium) -> Equilibrium:
    """The Equilibrium `found`, its place refined where Newton's method would still move it: near a multiple zero the
    forces are rounding long before the place is known. So is a displacement that is tiny beside the figure, the
    difference of lengths of which floats know few digits, and a place where more than rounding is left of the forces.
    """
    search = EnergyDescent(numeric, found.values)
    vector = search.vector(found.values)
    tiny = any(0 < x < TINY for x in abs(vector / search.scale))
    try:
        settled = max(abs(search.newton(search.at(vector))), default=0.0) <= UNSETTLED
        if settled and not tiny and found.residual <= BALANCED:
            return found
        position, degenerate = _to_more_digits(numeric, found)
    except Kinked:
        raise
    except PhysicsError:
        return found
    found = found._replace(degenerate=degenerate and not settled)
    if position is not None and max(abs((search.vector(position) - vector) / search.scale)) <= NEAR:
        found = found._replace(values={
            name: float(value) if abs(value) > NOTHING * numeric.size_along(name) else 0.0
            for name, value in position.items()})
        found = found._replace(residual=search.relative(search.at(search.vector(found.values))))
    return found


def _to_more_digits(numeric: "NumericSystem", found: Equilibrium) -> "tuple[Mapping[str, mpmath.mpf] | None, bool]":
    """({coordinate: number} of the equilibrium or None where nothing better is known, is it degenerate?)."""
    import mpmath

    with mpmath.workdps(ROUNDED + GUARD):
        arithmetic = multiprecision()
        try:
            return equilibrium_to(numeric, found, numeric.values(arithmetic), arithmetic), False
        except Degenerate as degenerate:
            return degenerate.position, True
        except ZeroDivisionError:
            place = ", ".join(f"{name} = {x:.6g}" for name, x in found.values.items())
            raise Kinked(f"the scene rests near {place}, where the slope of a force is infinite: no small oscillations "
                         "are about it", "follow the motion with motion: full") from None


def at_limit(configuration: "Configuration", position: Any, felt: Any) -> "Configuration":
    """The Configuration in an equilibrium ({coordinate: float}) whose K is singular but for rounding; felt: what counts
    as stiff along each coordinate."""
    numeric = configuration.numeric
    numbers = in_numbers(numeric.system.linearisation, Floats,
                         {**numeric.floats, numeric.scene.time.name: 0.0, **position})
    sizes = {(i, j): sqrt(a * b) for i, a in enumerate(felt) for j, b in enumerate(felt)}
    known = {pair: UNIT * LIMIT * size for pair, size in sizes.items()}
    K = {pair: x for pair, x in numbers.elements.stiffness().items() if abs(x) > LIMIT * sizes[pair]}
    return configuration.about(Equilibrium(position, False, relative_residual(numbers)),
                               numbers.elements.with_parts(springs=(), K=K, K_size=known), final=True)


def _blurred(configuration: "Configuration", forces: "Forces", blur: float) -> "Configuration":
    """The Configuration with a linear system in floats, where its equilibrium has no more digits."""
    found = configuration.equilibrium
    return configuration.about(found, blurred(configuration.numeric, found, forces, blur), final=True)


def blurred(numeric: "NumericSystem", found: Equilibrium, forces: "Forces", blur: float) -> "FactoredSystem":
    """The linear system in floats about an Equilibrium whose K is known to a part `blur` of what is typical."""
    exact = in_numbers(numeric.system.linearisation, Floats, {**numeric.floats, **found.values}).elements
    felt = dict(zip(forces.rows, forces.D, strict=True))
    size = {(i, j): UNIT * blur * forces.E / (a * b) for i, a in felt.items() for j, b in felt.items()}
    return exact.with_parts(springs=(), K=exact.stiffness(), K_size=size)
