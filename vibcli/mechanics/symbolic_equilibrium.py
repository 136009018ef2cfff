"""Equilibrium in letters of nonlinear scenes: coordinates that stay as drawn, and conditions with one unknown each.

The place that `equilibrium:` names is taken where all conditions vanish there. Else, of the solutions of a condition
that one is taken which the search in numbers reaches from the drawn position, or finds nearest to the place named, at
several sets of values of the letters. Where these lie in different regimes (a rotating pendulum hangs straight below
some speed) the position that depends on letters is preferred.
"""

import math
from collections.abc import Iterator, Sequence
from itertools import islice
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.parameter_samples import given_values
from vibcli.mechanics.linearisation import Linearisation, nodes_of, residual_terms
from vibcli.symbolic.angle_addition import opened, openings
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.equations.one_unknown import SymbolicSolution, solutions
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.symbolic.node import Node

ATTEMPTS, FAILURES, ENOUGH, LEAST, CLOSE = 16, 5, 4, 2, 1e-8


class SymbolicEquilibrium(NamedTuple):
    """values: {coordinate symbol: expression}; calls: {sin q or cos q: expression} of those that are angles; reached:
    modes at random values of the letters that reach this equilibrium; named: is it the place that `equilibrium:`
    names?"""

    values: "dict[Node, Node]"
    calls: "dict[Node, Node]"
    reached: "list[ModalAnalysis]"
    named: bool = False

    def with_solution(self, q: Any, solution: SymbolicSolution, reached: Any) -> "SymbolicEquilibrium":
        """The same with one coordinate more; `reached`: those that still reach it."""
        calls = {} if solution.sine is None else {
            q.table.call("sin", q): solution.sine, q.table.call("cos", q): solution.cosine}
        return SymbolicEquilibrium({**self.values, q: solution.value}, {**self.calls, **calls}, reached)

    def at(self, nodes: "Sequence[Node]") -> "list[Node]":
        """The nodes with what is known put in."""
        for q in self.values:
            nodes = opened(nodes, q)
        return substitute(nodes, {**self.values, **self.calls})

    def position(self, form: Linearisation) -> "dict[Node, Node]":
        """{node: expression} of what a Linearisation holds of the coordinates."""
        nodes = nodes_of(form)
        sums = {call: node for q in self.values for call, node in openings(nodes, q).items()}
        return {**dict(zip(sums, self.at(list(sums.values())), strict=True)), **self.values, **self.calls}


def symbolic_equilibrium(symbolic: "SymbolicSystem") -> SymbolicEquilibrium | None:
    """The SymbolicEquilibrium of a nonlinear scene, None where it is not found."""
    scene, tried, start = symbolic.scene, _Tried(symbolic), symbolic.start
    reached = tried.first(LEAST) if scene.loops is None else []
    if len(reached) < LEAST:
        return None
    if start is not None and all(map(_at_start, tried.first(ENOUGH))):
        return SymbolicEquilibrium({q: start[q] for q in scene.q}, {}, tried.first(ENOUGH), named=True)
    found = SymbolicEquilibrium({q: scene.drawn[q] for q in scene.q if _stays(reached, q.name)}, {}, reached)
    conditions = [scene.table.total(terms) for terms in residual_terms(symbolic.system.linearisation)]
    while len(found.values) < len(scene.q):
        open_ones = [q for q in scene.q if q not in found.values]
        step = _step([textbook(node) for node in found.at(conditions)], open_ones, tried)
        if step is None:
            return None
        found = found.with_solution(*step)
        tried.keep(found.reached)
    scene.table.resample(found.reached[0].numeric.floats)
    return found


class _Tried:
    """Modes at random values of the letters, found when they are asked for; each about a stable equilibrium, unless
    `equilibrium:` names a place."""

    def __init__(self, symbolic: "SymbolicSystem") -> None:
        self.symbolic, self.known, self.left = symbolic, [], iter(range(ATTEMPTS))
        self.free = [name for name in symbolic.scene.parameters.free if name not in symbolic.numeric.given]

    def __iter__(self) -> Iterator[Any]:
        symbolic, named = self.symbolic, self.symbolic.system.named_start
        yield from self.known
        for attempt in self.left:
            if attempt >= FAILURES and not self.known:
                return
            values = given_values(symbolic.scene.parameters, symbolic.scene.sample, self.free, attempt)
            candidate = symbolic.modal_of(symbolic.configuration.with_values(values))
            try:
                if not named and any(mode.growth_rate is not None for mode in candidate.modes.shown()):
                    continue
                candidate.configuration.equilibrium  # noqa: B018
            except (SpecError, PhysicsError):
                continue
            self.known.append(candidate)
            yield candidate

    def first(self, count: int) -> list[Any]:
        return list(islice(self, count))

    def keep(self, those: Sequence[Any]) -> None:
        """Only these from now on."""
        self.known, self.left = list(those), iter(())


def _stays(tried: "Sequence[ModalAnalysis]", name: str) -> bool:
    return all(abs(modal.configuration.equilibrium.values[name] - modal.numeric.drawn_floats[name])
               <= CLOSE * modal.numeric.size_along(name) for modal in tried)


def _at_start(modal: "ModalAnalysis") -> bool:
    return all(abs(way) <= CLOSE * modal.numeric.size_along(name)
               for name, way in modal.configuration.equilibrium.from_start.items())


def _step(conditions: "Sequence[Node]", unknowns: "Sequence[Node]",
          tried: _Tried) -> "tuple[Node, SymbolicSolution, list[ModalAnalysis]] | None":
    """(coordinate, Solution, those tried that reach it) from a condition with one unknown; None where there is none."""
    for node in conditions:
        inside = [q for q in unknowns if node.mask & q.mask]
        if len(inside) == 1:
            q, = inside
            found = _chosen(solutions(node, q, [modal.numeric.floats for modal in tried.first(1)]), q, tried)
            if found is not None:
                return q, *found
    return None


def _chosen(candidates: Sequence[SymbolicSolution], q: "Node",
            tried: _Tried) -> "tuple[SymbolicSolution, list[ModalAnalysis]] | None":
    """(Solution, those tried that reach it): the first that enough of them reach, one with letters if possible; one
    without, and one for one sign of the unknown, only where all reach it."""
    reached, count = [[] for _ in candidates], 0
    for modal in tried if candidates else ():
        count += 1
        for solution, those in zip(candidates, reached, strict=True):
            if _reached(modal, q, solution):
                those.append(modal)
                if len(those) == ENOUGH and _has_letters(solution.value) and not (solution.one_sided and tried.free):
                    return solution, those
    ranked = [(one, those) for one, those in zip(candidates, reached, strict=True) if len(those) >= (
        LEAST if _has_letters(one.value) and not one.one_sided else max(count, LEAST))]
    return max(ranked, key=lambda pair: (_has_letters(pair[0].value), len(pair[1])), default=None)


def _reached(modal: "ModalAnalysis", q: "Node", solution: SymbolicSolution) -> bool:
    wanted, at = modal.configuration.equilibrium.values[q.name], modal.numeric.floats
    value, *turned = evaluate([part for part in (solution.value, solution.sine, solution.cosine) if part is not None],
                              Floats, at)
    if turned and not max(abs(turned[0] - math.sin(value)), abs(turned[1] - math.cos(value))) <= CLOSE:
        return False
    return bool(abs(value - wanted) <= CLOSE * max(modal.numeric.size_along(q.name), abs(wanted)))


def _has_letters(node: "Node") -> bool:
    return any(part.op == "symbol" for part in reachable([node]))
