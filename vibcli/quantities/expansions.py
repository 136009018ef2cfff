"""Coefficients of the energies expanded about the equilibrium: `V[x^2]`, `V[x^2*y^2]`, `T[x^2*x'^2]`."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.quantities.index_kinds import HIGHEST
from vibcli.quantities.products import powers_in
from vibcli.quantities.quantity import Declaration, measured, unit

if TYPE_CHECKING:
    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef


def _asked(problem: "Problem", tree: "QuantityRef") -> "tuple[list[Node], tuple[int, ...]]":
    """(variables, powers) of the product asked for."""
    from vibcli.base.errors import PhysicsError
    from vibcli.mechanics.expansion import require_expandable

    scene = problem.scene
    require_expandable(scene.resting)
    found = powers_in(problem.spec, tree.indices[0], HIGHEST)
    for name, _ in found:
        if name not in scene.coordinates:
            raise PhysicsError(f"'{name}' follows from the other coordinates by the constraints: energies are expanded "
                               "by those", "ask for " + " or ".join(f"'{other}'" for other in scene.coordinates[:3]))
    return [scene.symbol(*each) for each in found], tuple(found.values())


def _value(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[float, float]:
    from vibcli.mechanics.expansion import in_numbers, within

    variables, powers = _asked(problem, tree)
    found = in_numbers(problem.configuration, tree.head, variables, within(powers), sum(powers), problem.digits,
                       unit(problem))
    return measured(found.get(powers, 0.0), 10.0**-problem.digits if problem.digits else 0.0)


def _in_letters(problem: "Problem", tree: "QuantityRef") -> "Node":
    from vibcli.mechanics.expansion import in_letters, within

    variables, powers = _asked(problem, tree)
    found = in_letters(problem.symbolic, tree.head, variables, within(powers), sum(powers))
    return found.get(powers, problem.scene.table.zero)


def _dimension(spec: "Spec", tree: "QuantityRef") -> Any:
    """Energy over the product."""
    found = units.ENERGY
    for (name, primes), n in powers_in(spec, tree.indices[0], HIGHEST).items():
        found = units.times(units.times(found, spec.dimensions.of(name), -n), units.TIME, n * primes)
    return found


def _size(problem: "Problem", tree: "QuantityRef") -> float:
    """The sum of what its terms contribute, which is what is rounded."""
    from vibcli.mechanics.expansion import sizes, within

    variables, powers = _asked(problem, tree)
    return sizes(problem.configuration, tree.head, variables, within(powers), sum(powers)).get(powers, 0.0)


def _of(what: str, sample: str, kind: str) -> Declaration:
    return Declaration(f"factor of a product, such as {sample}, in the {what} energy expanded by the deviations of the "
                       "coordinates from equilibrium" + ("; loads are left out of it, so that V[x] balances them"
                                                         if kind == "product" else ""),
                       None, _value, (kind,), dimension=_dimension, size=_size, symbolic=_in_letters, several=True)


QUANTITIES = {"V[]": _of("potential", "½k of ½kx²", "product"),
              "T[]": _of("kinetic", "x²ẋ²", "product with rates")}
