"""The quadratic forms of T, V and Φ about the equilibrium, each part under the name of the element it came from.

V has for each spring ½ k (∇s·q)², and with ½ V′ qᵀ∇²s q what its tension V′ = N + k s in equilibrium adds; the weights
add ½ f qᵀ∇²s q. Such geometric parts may be negative.
"""

from collections.abc import Mapping, Sequence
from itertools import compress
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.factored_system import WeightedRow
from vibcli.mechanics.high_precision import place_to
from vibcli.scene.piece_terms import PieceSpring
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.linearisation import Linearisation
    from vibcli.mechanics.system import MechanicalSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

WEIGHTS, WRITTEN = "the weights", "written out"
DRIVEN = "loads and driven motion"      # forces that follow what moves, and the inertia of what is driven

Parts = dict[str, tuple[list[WeightedRow], dict[tuple[int, int], Any]]]


class Owned:
    """kinetic, potential, dissipation: {name: (rows with weights, {(i, j): entry})}, in numbers of mpmath."""

    __slots__ = ("dissipation", "kinetic", "potential")

    def __init__(self) -> None:
        self.kinetic: Parts = {}
        self.potential: Parts = {}
        self.dissipation: Parts = {}


def owned_forms(configuration: "Configuration") -> Owned:
    """The Owned forms of a system in equilibrium, at the working precision of mpmath."""
    scene, form = configuration.scene.vibrating, configuration.reference_form
    elastic, dampers = scene.at_still("springs"), scene.at_still("dampers")
    springs, bent = [term for term in elastic if not isinstance(term, PieceSpring)], _bent(scene, elastic)
    springs, bent = _steady(configuration.system, springs, bent)
    pairs = ((scene.inertias, form.inertias), (springs, form.springs), (dampers, form.dampers), (bent, form.curved))
    if any(len(terms) != len(rows) for terms, rows in pairs):
        raise PhysicsError("energies are not told apart where bodies, springs or loads move with what is driven",
                           "ask for omega[i] and mode[i][q] alone")
    number = _numbers(configuration, form)
    found = Owned()
    for parts, terms, rows in ((found.kinetic, scene.inertias, form.inertias),
                               (found.potential, springs, form.springs),
                               (found.dissipation, dampers, form.dampers)):
        for term, row in zip(terms, rows, strict=True):
            _part(parts, term.owner)[0].append((number[row[0]], {i: number[node] for i, node in row[1].items()}))
    for name, (force, curvature, _) in zip(bent, form.curved, strict=True):
        _enter(found.potential, name, {pair: number[force] * number[node] for pair, node in curvature.items()})
    rest = WRITTEN if any(configuration.spec.get(key) for key in ("energies", "matrices")) else DRIVEN
    for parts, matrices in ((found.kinetic, [form.M]), (found.potential, form.K), (found.dissipation, [form.C])):
        for matrix in matrices:
            _enter(parts, rest, {pair: number[node] for pair, node in matrix.items()})
    if configuration.spec.get("damping") is not None:
        import mpmath

        more = configuration.given_damping(mpmath.mp.dps)
        found.dissipation["damping"] = list(more.dampers), more.C
    return found


def _bent(scene: "Scene", springs: Sequence[Any]) -> list[str]:
    return [f"tension of {term.owner}" for term in springs] + [WEIGHTS] * len(scene.weights) + [
        f"load {term.owner}" for term in scene.loads_at_still()]


def _steady(system: "MechanicalSystem", springs: "list[Any]", bent: list[str]) -> "tuple[list[Any], list[str]]":
    """(springs, names of what is curved) whose rows are steady: what others add to K is told as DRIVEN, as is what
    inertia and dampers that are driven add."""
    scene, whole = system.scene.vibrating, system.time_dependent_linearisation
    bent = bent + [DRIVEN] * (len(whole.curved) - len(bent))
    if not scene.timed:
        return springs, bent
    still = [not any(node.mask & scene.time.mask for node in (weight, *row.values())) for weight, row in whole.springs]
    known = [not any(node.mask & scene.time.mask for node in (*row.values(), *curvature.values()))
             for _, curvature, row in whole.curved]
    return list(compress(springs, still)), list(compress(bent, known))


def _numbers(configuration: "Configuration", form: "Linearisation") -> "dict[Node, Any]":
    """{expression: number} of all that the form is made of."""
    nodes = [node for rows in (form.inertias, form.springs, form.dampers) for weight, row in rows
             for node in (weight, *row.values())]
    nodes += [node for force, curvature, _ in form.curved for node in (force, *curvature.values())]
    nodes += [node for matrix in (form.M, form.C, *form.K) for node in matrix.values()]
    arithmetic = multiprecision()
    values = configuration.numeric.values(arithmetic)
    values |= place_to(configuration, values, arithmetic)
    return dict(zip(nodes, evaluate(nodes, arithmetic, values), strict=True))


def _part(parts: Parts, name: str) -> tuple[list[WeightedRow], dict[tuple[int, int], Any]]:
    return parts.setdefault(name, ([], {}))


def _enter(parts: Parts, name: str, entries: Mapping[tuple[int, int], Any]) -> None:
    """Add a matrix to a part."""
    if any(entries.values()):
        matrix = _part(parts, name)[1]
        for pair, entry in entries.items():
            matrix[pair] = matrix.get(pair, 0) + entry
