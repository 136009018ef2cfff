"""A scene at many values of its parameters, with one derivation for all between which nothing in its drawing turns.

The values are a grid, one axis a parameter. At the corners of its blocks the scene is drawn anew; where all corners of
a block have the same expressions, those within share them, and their equilibria and modes are found by arrays. What
arrays do not settle, and what lies between unlike corners, is found as a scene by itself.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise, product
from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.language.reader import Expression
from vibcli.symbolic.expression_graph import fingerprint

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.mechanics.linearisation import Linearisation
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene

CORNERS = 9, 4, 3          # along each axis of one, two, more of them

Place = tuple[int, ...]


class GivenValue(NamedTuple):
    """A value of a parameter: as it would stand in the file, and in SI units, the next float of what is irrational."""

    expression: Expression
    exact: "Fraction"


class Variants:
    """The Problems of a grid, axes {name: values}; `settle(problem)` gives values to what it chooses."""

    def __init__(self, problem: "Problem", axes: Mapping[str, Sequence[GivenValue]],
                 settle: "Callable[[Problem], Problem]" = lambda problem: problem):
        self.problem, self.names, self.axes, self._settle = problem, list(axes), list(axes.values()), settle
        self._drawn: dict[Place, Any] = {}
        self._structures: dict[Place, tuple | None] = {}

    def __iter__(self) -> "Iterator[tuple[Place, Problem | SpecError | PhysicsError]]":
        """(its place on each axis, its Problem or why there is none), in the order of the axes."""
        shared = self._shared()
        for place in product(*(range(len(axis)) for axis in self.axes)):
            if place in shared and place not in self._drawn:
                base, known = shared[place]
                yield place, base.sharing(self._exact(place), *known)
            else:
                yield place, self.alone(place)

    def at(self, values: Mapping[str, GivenValue]) -> "Problem | SpecError | PhysicsError":
        """The Problem of values that the grid need not have, drawn by itself, or why there is none."""
        return self._by_itself([values[name] for name in self.names])

    def alone(self, place: Place) -> "Problem | SpecError | PhysicsError":
        """The Problem of a place, drawn by itself, or why there is none."""
        if place not in self._drawn:
            self._drawn[place] = self._by_itself([axis[i] for axis, i in zip(self.axes, place, strict=True)])
        return self._drawn[place]

    def _by_itself(self, values):
        spec, parameters = self.problem.spec, dict(self.problem.spec.parameters)
        for name, value in zip(self.names, values, strict=True):
            parameters[name] = parameters[name].with_values({**parameters[name], "value": value.expression})
        try:
            found = self.problem.with_spec(spec.with_parameters(parameters))
            found.draw()
            return self._settle(found)
        except (SpecError, PhysicsError) as error:
            return error

    def _exact(self, place):
        return {name: axis[i].exact for name, axis, i in zip(self.names, self.axes, place, strict=True)}

    def _shared(self):
        """{place: (Problem whose expressions it shares, what of it is known)}."""
        if self.problem.spec.choices:
            return {}
        from vibcli.results.shared_solutions import shared_solutions

        found: dict = {}
        for base, blocks, places in self._groups():
            corners = {corner: self._drawn[corner] for block in blocks for corner in product(*block)}
            known = shared_solutions(base, corners, blocks, {place: self._exact(place) for place in places})
            found |= {place: (base, known.get(place, ())) for place in places}
        return found

    def _groups(self):
        """[(Problem, blocks, places)] of the blocks, ((low, high) on each axis), whose corners all have the same
        expressions."""
        count = CORNERS[min(len(self.axes), len(CORNERS)) - 1]
        cuts = [_corners(len(axis), count) for axis in self.axes]
        groups: dict = {}
        for block in product(*(list(pairwise(cut)) or [(0, 0)] for cut in cuts)):
            corners = list(product(*block))
            structure = self._structure(corners[0])
            if structure is None or any(self._structure(corner) != structure for corner in corners):
                continue
            base = self._drawn[corners[0]]
            found = groups.setdefault(structure, (base, [], {}))
            found[1].append(block)
            found[2].update(dict.fromkeys(product(*(range(low, high + 1) for low, high in block))))
        return groups.values()

    def _structure(self, place):
        """What tells the expressions of a corner apart; None where there are none."""
        if place not in self._structures:
            problem = self.alone(place)
            try:
                self._structures[place] = None if isinstance(problem, Exception) else structure(
                    problem.scene, problem.system.linearisation)
            except (SpecError, PhysicsError, ArithmeticError):
                self._structures[place] = None
        return self._structures[place]


def _corners(length, count):
    """So many places from 0 to length − 1, evenly."""
    return sorted({round(k * (length - 1) / (count - 1)) for k in range(count)})


def structure(scene: "Scene", form: "Linearisation") -> tuple:
    """The expressions of a scene and of its linearisation as they are told apart between tables."""
    loops = scene.loops
    nodes = [*scene.contents.nodes, *scene.drawn.values(), *scene.dependent.values(), *scene.driven.values(),
             *(() if loops is None else (*loops.conditions, *loops.slopes)), *_listed(form)]
    keys = ([[list(row) for _, row in rows] for rows in (form.inertias, form.springs, form.dampers)],
            [(list(second), list(row)) for _, second, row in form.curved],
            [list(entries) for entries in (form.M, form.C, form.G, form.drag, *form.K, *form.residual)])
    return fingerprint(nodes), repr(keys), tuple(scene.coordinates), tuple(scene.table.functions)


def _listed(form):
    from vibcli.mechanics.linearisation import nodes_of

    return nodes_of(form)
