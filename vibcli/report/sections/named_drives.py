"""Displacements in time that have symbols of their own, u₁ = h·sin(π·t/t₁)·(step(t) − step(t − t₁)), where energies are
long: their products and squares are then those of u₁."""

import re
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.derivatives import gradient, substitute

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

LONG = 1000         # signs of an energy as it is printed, beyond which displacements have symbols


class NamedDrives:
    """The energies of a scene with symbols for its displacements in time; `stands`: [(symbol, what it stands for)]."""

    def __init__(self, problem: "Problem", letter: str):
        self._problem = problem
        self._opened = problem.symbolic.configuration.with_inputs.scene
        self._names: dict[Any, Any] = {}
        self._values: dict[Any, Any] = {}
        self.stands: list[tuple[Node, Node]] = []
        for symbol, opening in self._opened.inputs.items():
            if opening.node is not None and opening.load is None and opening.spread is None:
                self._name(symbol, opening.node, f"{letter}{len(self.stands) + 1}")

    def _name(self, symbol, node, name):
        scene, i = self._problem.scene, self._opened.q.index(symbol)
        place, speed = (self._opened.table.variable(name + mark) for mark in ("", "'"))
        self._names |= {symbol: place, self._opened.v[i]: speed}
        self._values |= {symbol: node, self._opened.v[i]: scene.rate(node)}
        self.stands.append((place, node))

    def energy(self, key: str) -> "Node":
        """T, V or Φ: with the symbols where these have the value of the engine's at states of motion."""
        from vibcli.mechanics.energies import textbook_energies
        from vibcli.report.steps.small import agree_in_motion, samples_of

        problem = self._problem
        whole, mine = problem.symbolic.energies[key], textbook_energies(self._opened)[key]
        put_in = substitute([mine], self._values)
        if not agree_in_motion(problem.scene, samples_of(problem, {}), put_in, [whole]):
            return whole
        return substitute([mine], self._names)[0]


def _letter(problem):
    """One that no name of the scene has with a number; None where all are taken."""
    taken = {*problem.spec.parameters, *problem.scene.coordinates}
    free = (one for one in ("u", "s", "w", "xi") if not any(re.fullmatch(rf"{one}\d+", name) for name in taken))
    return next(free, None)


def named_drives(problem: "Problem") -> NamedDrives | None:
    """Those of a scene one of whose energies is long for displacements in time; None of others."""
    from vibcli.notation.plain import plain

    if not problem.scene.timed or problem.scene.loops is not None or problem.system.sticking is not None:
        return None
    driven = [node for node in problem.symbolic.energies.values() if problem.scene.time in gradient(node)]
    if not any(len(plain(node)) > LONG for node in driven):
        return None
    letter = _letter(problem)
    try:
        found = NamedDrives(problem, letter) if letter is not None else None
    except PhysicsError:
        return None
    return found if found is not None and found.stands else None
