"""What the geometry of a spring adds to the coefficients of the restoring force: `stiffness_correction[s, x^3]`."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.quantities.index_kinds import HIGHEST
from vibcli.quantities.products import powers_in
from vibcli.quantities.quantity import Declaration, measured, unit

if TYPE_CHECKING:
    from vibcli.language.spec import Spec
    from vibcli.mechanics.spring_shares import SpringShares
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef


def _asked(problem: "Problem", tree: "QuantityRef") -> tuple[tuple[int, ...], int]:
    """(powers of all coordinates in V, that of the first one named): the force along it is ∂V/∂x."""
    from vibcli.base.errors import PhysicsError
    from vibcli.mechanics.expansion import require_expandable

    coordinates = list(problem.scene.coordinates)
    require_expandable(problem.scene.resting)
    found = {name: n for (name, _), n in powers_in(problem.spec, tree.indices[1], HIGHEST).items()}
    for name in found:
        if name not in coordinates:
            raise PhysicsError(f"'{name}' follows from the other coordinates by the constraints: forces are expanded "
                               "by those", "ask for " + " or ".join(f"'{other}'" for other in coordinates[:3]))
    first = next(iter(found))
    found[first] += 1
    return tuple(found.get(name, 0) for name in coordinates), found[first]


def _shares(problem: "Problem", tree: "QuantityRef") -> "tuple[SpringShares, tuple[int, ...], int]":
    """(SpringShares, the powers, that of the first coordinate)."""
    from vibcli.mechanics.expansion import within
    from vibcli.mechanics.spring_shares import shares_in_numbers

    powers, n = _asked(problem, tree)
    found = shares_in_numbers(problem.configuration, tree.indices[0], within(powers), sum(powers), problem.digits,
                              unit(problem))
    return found, powers, n


def _value(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, float]:
    found, powers, n = _shares(problem, tree)
    return measured(found.geometric[powers] * n if powers in found.geometric else 0.0,
                    10.0**-problem.digits if problem.digits else 0.0)


def _in_letters(problem: "Problem", tree: "QuantityRef") -> "Node":
    from vibcli.mechanics.expansion import within
    from vibcli.mechanics.spring_shares import shares_in_letters
    from vibcli.symbolic.normal_form import textbook

    powers, n = _asked(problem, tree)
    found = shares_in_letters(problem.symbolic, tree.indices[0], within(powers), sum(powers)).geometric
    return textbook(found[powers] * n) if powers in found else problem.scene.table.zero


def _dimension(spec: "Spec", tree: "QuantityRef") -> Any:
    """Force, of an angle moment, over the product."""
    powers = powers_in(spec, tree.indices[1], HIGHEST)
    found = units.times(units.ENERGY, spec.dimensions.of(next(iter(powers))[0]), -1)
    for (name, _), n in powers.items():
        found = units.times(found, spec.dimensions.of(name), -n)
    return found


def _size(problem: "Problem", tree: "QuantityRef") -> float:
    """What its parts add up from."""
    from vibcli.symbolic.running_errors import number_in

    found, powers, n = _shares(problem, tree)
    return float(sum(n * abs(number_in(part[powers])) for part in found if powers in part))


QUANTITIES = {
    "stiffness_correction": Declaration(
        "what the geometry of a spring adds to the factor of a power of a coordinate in the restoring force along it, "
        "about the equilibrium, over what the spring would give were its deflection proportional to it: N/l to that of "
        "x and (k − N/l)/(2l²) to that of x^3 where it is square to the motion, l long, under the tension N; of a "
        "product, as x*y^2, in the force along its first coordinate",
        None, _value, ("spring", "product"), dimension=_dimension, size=_size, symbolic=_in_letters, several=True),
}
