"""A scene at many values of its parameters, with one derivation for all between which nothing in its drawing turns.

The values are a grid, one axis a parameter. At the corners of its blocks the scene is drawn anew; where all corners of
a block have the same expressions, those within share them, and their modes are found by arrays. What arrays do not
settle, and what lies between unlike corners, is found as a scene by itself.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise, product
from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.language.reader import Expression
from vibcli.symbolic.expression_graph import fingerprint

if TYPE_CHECKING:
    from fractions import Fraction

    import numpy as np

    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.results.problem import Problem

CORNERS = 9, 4, 3          # along each axis of one, two, more of them
ALIKE = 1e-12               # relative: of frequencies found by arrays and by themselves at a corner
SMOOTH = {"sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp", "log", "power"}

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
                yield place, base.sharing(self._exact(place), known)
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
        """{place: (Problem whose expressions it shares, its natural modes and damped ones, None where not found)}."""
        if self.problem.spec.choices:
            return {}
        found: dict = {}
        for base, corners, places in self._groups():
            modes = self._modes(base, corners, places)
            found |= {place: (base, modes.get(place, (None, None))) for place in places}
        return found

    def _groups(self):
        """[(Problem, corners, places)] of the blocks whose corners all have the same expressions."""
        count = CORNERS[min(len(self.axes), len(CORNERS)) - 1]
        cuts = [_corners(len(axis), count) for axis in self.axes]
        groups: dict = {}
        for block in product(*(list(pairwise(cut)) or [(0, 0)] for cut in cuts)):
            corners = list(product(*block))
            structure = self._structure(corners[0])
            if structure is None or any(self._structure(corner) != structure for corner in corners):
                continue
            base = self._drawn[corners[0]]
            found = groups.setdefault(structure, (base, {}, {}))
            found[1].update(dict.fromkeys(corners))
            found[2].update(dict.fromkeys(product(*(range(low, high + 1) for low, high in block))))
        return groups.values()

    def _structure(self, place):
        """What tells the expressions of a corner apart; None where there are none."""
        if place not in self._structures:
            problem = self.alone(place)
            try:
                self._structures[place] = None if isinstance(problem, Exception) else _structure(problem)
            except (SpecError, PhysicsError, ArithmeticError):
                self._structures[place] = None
        return self._structures[place]

    def _modes(self, base, corners, places) -> "dict[Place, tuple[list[Mode], list[DampedMode] | None]]":
        """The natural and damped modes of places, those that arrays settle."""
        import numpy as np

        form, free = _form(base), self._free(corners)
        if form is None or free is None:
            return {}
        from vibcli.analyses.modal.stacked_damped import StackedDamped
        from vibcli.analyses.modal.stacked_modes import StackedModes
        from vibcli.mechanics.stacked_matrices import stacked_matrices

        exact = {name: np.array([float(axis[place[k]].exact) for place in places])
                 for k, (name, axis) in enumerate(zip(self.names, self.axes, strict=True))}
        matrices = stacked_matrices(form, _all_values(base, exact), len(places))
        stacked, linear = StackedModes(matrices, free), base.system.is_linear
        damped = StackedDamped(matrices, stacked)
        found = {}
        for number, place in enumerate(places):
            balanced = matrices.balanced[number]
            if stacked.settled[number] and (balanced or linear):
                modes = stacked.modes(number)
                if balanced or all(mode.omega for mode in modes):       # it rests somewhere
                    found[place] = modes, damped.modes(number) if damped.settled[number] else None
        return found if all(self._agrees(corner, found) for corner in corners) else {}

    def _free(self, corners):
        """Has the scene one mode without frequency at all corners? None where it has more, or not everywhere."""
        counts = set()
        for corner in corners:
            try:
                counts.add(sum(mode.rigid for mode in self._drawn[corner].modal.modes))
            except PhysicsError:
                return None
        return bool(*counts) if counts in ({0}, {1}) else None

    def _agrees(self, corner, found):
        """Has a corner, solved by itself, the modes that arrays found?"""
        if corner not in found:
            return True
        modal, (natural, damped) = self._drawn[corner].modal, found[corner]
        try:
            return _same(modal.modes, natural, _rate) and (damped is None or _same(modal.damped, damped, _eigenvalue))
        except PhysicsError:
            return False


def _same(modes, found, value):
    return modes is not None and len(modes) == len(found) and all(
        one.kind == other.kind and abs(value(one) - value(other)) <= ALIKE * abs(value(one))
        for one, other in zip(modes, found, strict=True))


def _eigenvalue(mode):
    return mode.eigenvalue


def _rate(mode):
    return mode.omega if mode.growth_rate is None else mode.growth_rate


def _corners(length, count):
    """So many places from 0 to length − 1, evenly."""
    return sorted({round(k * (length - 1) / (count - 1)) for k in range(count)})


def _structure(problem):
    """The expressions of a scene and of its linearisation as they are told apart between tables."""
    scene, form = problem.scene, problem.system.linearisation
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


def _form(problem):
    """The Linearisation that holds for all values of a scene whose natural modes arrays may find; None of others."""
    system, scene = problem.system, problem.scene
    table, loops, given = scene.table, scene.loops, problem.spec.get("damping")
    if not scene.q or scene.pieces or scene.laws or loops is not None or given is not None or system.named_start or (
            table.called - SMOOTH or table.functions or table.records or problem.numeric.has_free_symbols):
        return None
    try:
        form = system.linearisation_at_reference
    except PhysicsError:
        return None
    return None if any(form.G.values()) or any(form.drag.values()) else form


def _all_values(problem, exact: "Mapping[str, np.ndarray]") -> "dict[str, Any]":
    """{parameter: number, or array of numbers where it hangs on these}."""
    from vibcli.symbolic.array_arithmetic import Arrays

    given = {name: float(value) for name, value in problem.numeric.given.items()}
    return {**problem.scene.parameters.values(Arrays, {**given, **exact}), problem.scene.time.name: 0.0}
