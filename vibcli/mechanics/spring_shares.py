"""What of the potential energy of a spring its material makes, and what its geometry, by the deviations ξ from
equilibrium (Kovacić & Radomirović 2018, 9.4 and 9.5). With its deflection δ = δ₁ + δ₂ + …, δᵢ of order i in
ξ, and the force N + k δ + β δ² + γ δ³ about the equilibrium,

    V = N δ + k δ²/2 + β δ³/3 + γ δ⁴/4        of the material: N δ₁ + k δ₁²/2 + β δ₁³/3 + γ δ₁⁴/4

and the rest is of the geometry.
"""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.expansion import Powers, cleared, expanded_by, side_in_letters, symbols_of
from vibcli.scene.laws import Law
from vibcli.symbolic.evaluation import Floats
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.running_errors import RunningErrors
from vibcli.symbolic.truncated_polynomials import NodeArithmetic, Polynomial, Polynomials, sign

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.scene.energy_terms import Spring
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class SpringShares(NamedTuple):
    """{powers of the coordinates: coefficient of V} of each."""

    material: dict[Powers, Any]
    geometric: dict[Powers, Any]


class Expanded(NamedTuple):
    """How a scene is expanded: the numbers of an arithmetic, {name: value} of everything at rest, the sign of a
    number, and which powers of all coordinates are kept up to an order."""

    arithmetic: Any
    values: dict[str, Any]
    side: Callable[[Any], int | None]
    keep: Callable[[Powers], bool]
    order: int


def shares_in_numbers(configuration: "Configuration", name: str, keep: Callable[[Powers], bool], order: int,
                      digits: int | None = None, unit: float = 2.0**-52) -> SpringShares:
    """Those of a spring about the equilibrium, each with its bound; zero where only rounding is left."""
    if digits is None:
        arithmetic, values = configuration.bounded_rest
    else:
        inner, values = configuration.precise_rest(digits)
        arithmetic = RunningErrors(inner, unit)
    found = _shares(configuration.scene.resting, name, Expanded(arithmetic, values, sign, keep, order))
    material, geometric = ({powers: cleared(c, arithmetic) for powers, c in part.items()} for part in found)
    return SpringShares(material, geometric)


def shares_in_letters(symbolic: "SymbolicSystem", name: str, keep: Callable[[Powers], bool], order: int
                      ) -> SpringShares:
    """The same in letters, about an equilibrium that is known in letters; else PhysicsError."""
    scene, place = symbolic.scene.resting, symbolic.equilibrium_position
    term = _term(scene, name)
    nodes = [term.potential(scene), _of_deflection(scene, term)[0]]
    values = {**symbols_of(nodes), **place, scene.time.name: scene.table.zero}
    arithmetic = NodeArithmetic(scene.table, list(Floats.functions))
    found = _shares(scene, name, Expanded(arithmetic, values, side_in_letters, keep, order))
    shown = [{powers: textbook(c) for powers, c in part.items()} for part in found]
    material, geometric = ({powers: c for powers, c in part.items() if not is_zero(c)} for part in shown)
    return SpringShares(material, geometric)


def _term(scene: "Scene", name: str) -> "Law | Spring":
    found: list[Law | Spring] = scene.terms_of(name, "springs", "laws")
    if not found:
        raise PhysicsError(f"'{name}' has no energy in this scene", "ask of a spring between what moves")
    if len(found) == 1:
        return found[0]
    length = scene.table.sqrt(scene.table.total(term.s * term.s for term in found))     # without free length: ½ k ℓ²
    return found[0]._replace(s=length)


def _shares(scene: "Scene", name: str, how: Expanded) -> tuple[dict[Powers, Any], dict[Powers, Any]]:
    term = _term(scene, name)
    whole, s = _expanded(scene, [term.potential(scene), term.s], how, scene.q, how.keep)
    material, minus = _of_the_first_order(scene, term, s, how), how.arithmetic.number(-1)
    geometric = dict(whole)
    for powers, c in material.items():
        geometric[powers] = geometric[powers] + c * minus if powers in geometric else c * minus
    return _moving(material), _moving(geometric)


def _moving(terms: Mapping[Powers, Any]) -> dict[Powers, Any]:
    return {powers: c for powers, c in terms.items() if any(powers)}


def _expanded(scene: "Scene", nodes: "list[Node]", how: Expanded, variables: "list[Node]", keep: Callable[..., bool],
              values: Mapping[str, Any] | None = None) -> list[dict[Powers, Any]]:
    return expanded_by(scene, "V", nodes, how.arithmetic, values or how.values, variables, keep, how.order, how.side)


def _of_the_first_order(scene: "Scene", term: "Law | Spring", s: Mapping[Powers, Any],
                        how: Expanded) -> dict[Powers, Any]:
    """Its energy as a function of the deflection, of that of the first order."""
    none, zero = (0,) * len(scene.q), how.arithmetic.number(0)
    energy, x = _of_deflection(scene, term)
    along = {**how.values, x.name: s.get(none, zero)}
    series, = _expanded(scene, [energy], how, [x], lambda powers: powers[0] <= how.order, along)
    ring = Polynomials(how.arithmetic, len(scene.q), how.keep, how.order, how.side)
    first = Polynomial(ring, {powers: c for powers, c in s.items() if sum(powers) == 1})
    found = ring.number(0)
    for n in range(how.order, 0, -1):
        found = (found + ring.still(series.get((n,), zero))) * first
    return dict(found.terms)


def _of_deflection(scene: "Scene", term: "Law | Spring") -> "tuple[Node, Node]":
    """(V, x): its energy as a function of its deflection x."""
    if isinstance(term, Law):
        return term.integral, term.x
    x = scene.table.variable("the deflection")
    return term._replace(s=x).potential(scene), x
