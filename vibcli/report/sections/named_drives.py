"""Displacements in time that have symbols of their own, u₁ = h·sin(π·t/t₁)·(step(t) − step(t − t₁)), where energies are
long: their products and squares are then those of u₁."""

import re
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.contents import without_contents
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

LONG = 1000         # signs of an energy as it is printed, beyond which displacements have symbols


class NamedDrives:
    """The energies of a scene with symbols for its displacements in time; `stands`: [(symbol, what it stands for)]."""

    def __init__(self, problem: "Problem", letter: str) -> None:
        self._problem = problem
        self._opened = problem.symbolic.configuration.with_inputs.scene
        self._names: dict[Any, Any] = {}
        self._values: dict[Any, Any] = {}
        self.stands: list[tuple[Node, Node]] = []
        for symbol, opening in self._opened.inputs.items():
            if opening.node is not None and opening.load is None and opening.spread is None:
                self._name(symbol, opening.node, f"{letter}{len(self.stands) + 1}")
            else:
                self._names[symbol] = self._values[symbol] = self._opened.table.zero      # a unit load
        table = self._opened.table
        for legs in list(table.legs):
            table.legs[tuple(substitute(legs, self._names))] = None

    def _name(self, symbol: "Node", node: "Node", name: str) -> None:
        opened, i = self._opened, self._opened.q.index(symbol)
        for at, mark in ((symbol, ""), (opened.v[i], "'"), (opened.a[i], "''")):
            self._names[at], self._values[at] = opened.table.variable(name + mark), node
            node = opened.rate(node)
        self.stands.append((self._names[symbol], self._values[symbol]))

    def energy(self, key: str) -> "Node":
        """T, V or Φ: with the symbols where these have the value of the engine's at states of motion."""
        from vibcli.mechanics.energies import dissipation, textbook_energies

        mine = [textbook_energies(self._opened)[key]]
        if key == "Phi":
            mine.append(without_contents(dissipation(self._opened)))
        return self._named(min(mine, key=letters), self._problem.symbolic.energies[key])

    def equation(self, i: int) -> "Node":
        """The equation of motion of a coordinate with the symbols, as it comes from the energies; multiplied out where
        that is shorter."""
        from vibcli.mechanics.energies import kinetic
        from vibcli.mechanics.lagrange import equation_of

        mine = without_contents(equation_of(self._opened, i, textbook(kinetic(self._opened))))
        return self._named(min((mine, textbook(mine)), key=letters), self._problem.symbolic.equations.full[i])

    def drive(self, i: int, whole: "Node") -> "list[tuple[Node, Node]] | None":
        """[(factor, symbol)] of what drives a coordinate in small oscillations; None where that is not `whole`, the
        engine's, or not told in letters."""
        from vibcli.mechanics.lagrange import equation_of
        from vibcli.report.steps.agreement import same_in_motion

        try:
            opened, at_rest = self._opened, self._problem.symbolic.equilibrium_position
        except PhysicsError:        # where it rests is known in numbers alone
            return None
        slopes = gradient(equation_of(opened, i))
        rest = zip(map(opened.symbol, at_rest), copied(list(at_rest.values()), opened.table), strict=True)
        place = dict.fromkeys((*opened.q, *opened.v, *opened.a, opened.time), opened.table.zero) | dict(rest)
        moving = [symbol for symbol, name in self._names.items() if symbol in slopes and not name.is_zero]
        factors = [textbook(-node) for node in substitute([slopes[symbol] for symbol in moving], place)]
        terms = [factor * self._values[symbol] for factor, symbol in zip(factors, moving, strict=True)]
        if set(opened.a[len(at_rest):]) & set(slopes) or not same_in_motion(self._problem, terms, [whole]):
            return None
        driven = [(factor, self._names[symbol]) for factor, symbol in zip(factors, moving, strict=True)
                  if not factor.is_zero]
        table = self._problem.scene.table
        return [(copied([factor], table)[0], copied([name], table)[0]) for factor, name in driven]

    def _named(self, mine: "Node", whole: "Node") -> "Node":
        """An expression with the symbols; the engine's where they do not have the same value at states of motion."""
        from vibcli.report.steps.agreement import same_in_motion

        if not same_in_motion(self._problem, substitute([mine], self._values), [whole]):
            return whole
        return substitute([mine], self._names)[0]


def _letter(problem: "Problem") -> str | None:
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
