"""The full equations of motion as expressions: M(q, t) q̈ + h(q, q̇, t) + Σ λ ∂G/∂q = 0, G(q, t) = 0.

From the scalar functions s(q, t) of the scene, with s̈ = Σ sⱼ q̈ⱼ + b:

    M = Σ w ∇s ∇sᵀ        h = Σ w b ∇s + ∂V/∂q + ∂Φ/∂q̇ − Q        G̈ = Σ Gⱼ q̈ⱼ + γ = 0
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.energies import dissipation, potential
from vibcli.mechanics.lagrange import gyroscopic
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SIMPLIFIED = 4          # coordinates up to which a shorter form of each entry is looked for


class Dynamics(NamedTuple):
    """M: {(i, j): node}, i ≤ j; h: a node for each coordinate; slopes {(k, i): ∂Gₖ/∂qᵢ}, bends γₖ, gaps Gₖ and their
    rates; names: of the constraints."""

    M: "dict[tuple[int, int], Node]"
    h: "list[Node]"
    names: list[str]
    gaps: "list[Node]"
    rates: "list[Node]"
    slopes: "dict[tuple[int, int], Node]"
    bends: "list[Node]"

    def nodes(self) -> "list[Node]":
        """All expressions that the accelerations are made of."""
        return [*self.M.values(), *self.h, *self.slopes.values(), *self.bends]

    def made_of(self, nodes: "Sequence[Node]") -> "Dynamics":
        """The same with other expressions in the places of `nodes`."""
        rest = iter(nodes)
        return self._replace(M={pair: next(rest) for pair in self.M}, h=[next(rest) for _ in self.h],
                             slopes={pair: next(rest) for pair in self.slopes}, bends=[next(rest) for _ in self.bends])


def dynamics(scene: "Scene", redundant: Sequence[Any] = (), undamped: bool = False) -> Dynamics:
    """The Dynamics of a scene; `redundant`: names of constraints which follow from the others; undamped: Φ is left
    out."""
    M, h = _from_terms(scene, undamped)
    if len(scene.q) <= SIMPLIFIED and not scene.laws:
        shorter = {pair: textbook(node) for pair, node in M.items()}, [textbook(node) for node in h]
        M, h = min((M, h), shorter, key=lambda form: len(reachable([*form[0].values(), *form[1]])))
    ties = [] if scene.dependent else [tie for tie in scene.constraints if tie.name not in redundant]
    number = {q: i for i, q in enumerate(scene.q)}
    gaps = [tie.node for tie in ties]
    rates = [scene.rate(node) for node in gaps]
    slopes = {(k, number[q]): slope for k, node in enumerate(gaps) for q, slope in gradient(node).items()
              if q in number}
    return Dynamics({pair: node for pair, node in M.items() if not node.is_zero}, h, [tie.name for tie in ties], gaps,
                    rates, slopes, [drift(scene, node) for node in rates])


def drift(scene: "Scene", rate: "Node") -> "Node":
    """d(rate)/dt without accelerations: Σ (∂rate/∂q) q̇ + ∂rate/∂t."""
    slopes = gradient(rate)
    return scene.table.total(slopes[x] * scene.speeds[x] for x in (*scene.q, scene.time) if x in slopes)


def _from_terms(scene: "Scene", undamped: bool) -> "tuple[dict[tuple[int, int], Node], list[Node]]":
    number = {q: i for i, q in enumerate(scene.q)}
    entries, forces = {}, [[] for _ in scene.q]
    for term in scene.inertias:
        row = [(number[q], slope) for q, slope in gradient(term.s).items() if q in number]
        bend = drift(scene, scene.rate(term.s))
        for i, x in row:
            forces[i].append(term.weight * x * bend)
            for j, y in row:
                if i <= j:
                    entries.setdefault((i, j), []).append(term.weight * x * y)
    _written_out(scene, entries, forces)
    zero = scene.table.zero
    V, Phi = potential(scene), zero if undamped else dissipation(scene)
    for i, (q, v) in enumerate(zip(scene.q, scene.v, strict=True)):
        forces[i] += [gradient(V).get(q, zero), gradient(Phi).get(v, zero), gyroscopic(scene, i)]
        forces[i] += [-(term.weight * gradient(term.s)[q]) for term in scene.forces if q in gradient(term.s)]
    table = scene.table
    return ({pair: table.total(nodes) for pair, nodes in entries.items()},
            [table.total(nodes) for nodes in forces])


def _written_out(scene: "Scene", entries: "dict[tuple[int, int], list[Node]]", forces: "list[list[Node]]") -> None:
    """Adds what the kinetic energy of `energies` and a mass matrix contribute."""
    T, speeds = scene.energies["T"], {v: i for i, v in enumerate(scene.v)}
    for i, (q, v) in enumerate(zip(scene.q, scene.v, strict=True)):
        momentum = gradient(T).get(v, scene.table.zero)
        forces[i] += [drift(scene, momentum), -gradient(T).get(q, scene.table.zero)]
        for w, second in gradient(momentum).items():
            if w in speeds and i <= speeds[w]:
                entries.setdefault((i, speeds[w]), []).append(second)
    for i, row in enumerate(scene.matrices.get("M", ())):
        for j in range(i, len(row)):
            entries.setdefault((i, j), []).append((row[j] + scene.matrices["M"][j][i]) / 2)
