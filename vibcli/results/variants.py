"""A scene at many values of its parameters, with one derivation for all between which nothing in its drawing turns.

The values are a grid, one axis a parameter. At the corners of its blocks the scene is drawn anew; where all corners of
a block have the same expressions, those within share them, and their equilibria and modes are found by arrays. A block
whose corners are unlike is halved. What arrays do not settle is found as a scene by itself.
"""

from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, ValuesView
from functools import cached_property
from itertools import product
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.language.given_values import GivenValue
from vibcli.symbolic.expression_graph import fingerprint

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.mechanics.linearisation import Linearisation
    from vibcli.results.problem import Problem
    from vibcli.results.shared_solutions import SharedSolutions
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

CORNERS = 9, 4, 3, 2       # along each axis of one, two, three, more of them
LARGE = 8                  # corners of a block that is looked at in the middle too

Place = tuple[int, ...]
Block = tuple[tuple[int, int], ...]        # (low, high) on each axis


class Variants:
    """The Problems of a grid: each of `axes` gives the values of parameters that go together, {name: values}; `places`:
    those of the grid that are wanted, all unless given; `settle(problem)` gives values to what it chooses."""

    def __init__(self, problem: "Problem", axes: Sequence[Mapping[str, Sequence[GivenValue]]],
                 settle: "Callable[[Problem], Problem]" = lambda problem: problem,
                 places: Sequence[Place] | None = None) -> None:
        self.problem, self.axes, self._settle, self._wanted = problem, list(axes), settle, places
        self.lengths = [len(next(iter(axis.values()))) for axis in self.axes]
        self._drawn: dict[Place, Any] = {}
        self._structures: dict[Place, tuple[Any, ...] | None] = {}

    @property
    def places(self) -> Iterable[Place]:
        """The places that are wanted, in the order of the axes unless they were given."""
        return product(*map(range, self.lengths)) if self._wanted is None else self._wanted

    def __iter__(self) -> "Iterator[tuple[Place, Problem | SpecError | PhysicsError]]":
        """(its place on each axis, its Problem or why there is none)."""
        for place in self.places:
            yield place, self.scene(place)

    def scene(self, place: Place) -> "Problem | SpecError | PhysicsError":
        """The Problem of a place, which shares what it can, or why there is none."""
        group = self._shared.get(place)
        if group is None or place in self._drawn:
            return self.alone(place)
        base, solutions = self.groups[group]
        known = None if solutions is None else solutions.at(place)
        return base.sharing(self._exact(place)) if known is None else base.sharing(self._exact(place), *known)

    def values_at(self, place: Place) -> dict[str, GivenValue]:
        """{parameter: its value} at a place."""
        return {name: values[i] for axis, i in zip(self.axes, place, strict=True) for name, values in axis.items()}

    def at(self, values: Mapping[str, GivenValue]) -> "Problem | SpecError | PhysicsError":
        """The Problem of values that the grid need not have, drawn by itself, or why there is none."""
        try:
            found = with_given(self.problem, values)
            found.draw()
            return self._settle(found)
        except (SpecError, PhysicsError) as error:
            return error

    def alone(self, place: Place) -> "Problem | SpecError | PhysicsError":
        """The Problem of a place, drawn by itself, or why there is none."""
        if place not in self._drawn:
            self._drawn[place] = self.at(self.values_at(place))
        found: Problem | SpecError | PhysicsError = self._drawn[place]
        return found

    def is_drawn(self, place: Place) -> bool:
        """Was it drawn by itself?"""
        return place in self._drawn

    def _exact(self, place: Place) -> "dict[str, Fraction]":
        return {name: value.exact for name, value in self.values_at(place).items()}

    @property
    def groups(self) -> "list[tuple[Problem, SharedSolutions | None]]":
        """(a Problem whose expressions places share, what arrays find of these)."""
        return self._solved[0]

    @property
    def _shared(self) -> dict[Place, int]:
        """{place: number of its group}."""
        return self._solved[1]

    @cached_property
    def _solved(self) -> "tuple[list[tuple[Problem, SharedSolutions | None]], dict[Place, int]]":
        if self.problem.spec.choices or self._has_letters:
            return [], {}
        from vibcli.results.shared_solutions import shared_solutions

        groups: list[tuple[Problem, SharedSolutions | None]] = []
        numbers: dict[Place, int] = {}
        for base, blocks, places in self._groups():
            corners = {corner: self._drawn[corner] for block in blocks for corner in product(*block)}
            known = shared_solutions(base, corners, blocks, {place: self._exact(place) for place in places})
            numbers |= dict.fromkeys(places, len(groups))
            groups.append((base, known))
        return groups, numbers

    @property
    def _has_letters(self) -> bool:
        """Are there parameters that no place gives a value?"""
        given = {name for axis in self.axes for name in axis} | self.problem.numeric.given.keys()
        return any("value" not in record and name not in given
                   for name, record in self.problem.spec.parameters.items())

    def _groups(self) -> ValuesView[Any]:
        """[(Problem, blocks, places)] of the blocks, ((low, high) on each axis), that have the same expressions."""
        count = CORNERS[min(len(self.axes), len(CORNERS)) - 1]
        cuts = [_corners(length, count) for length in self.lengths]
        groups: dict[Any, Any] = {}
        for whole, all_of in self._by_block(cuts).items():
            for block, places in self._alike(whole, all_of):
                corner = next(product(*block))
                found = groups.setdefault(self._structure(corner), (self._drawn[corner], [], {}))
                found[1].append(block)
                found[2].update(dict.fromkeys((*product(*block), *places)))
        return groups.values()

    def _alike(self, block: Block,
               places: list[Place]) -> Iterator[tuple[Block, list[Place]]]:
        """(block, places in it) of the parts of a block that have the same expressions at their corners, in large ones
        in the middle too; halved where they turn."""
        corners = list(dict.fromkeys(product(*block)))
        if len(places) < len(corners):
            return              # sooner drawn by themselves
        middle = [tuple(sum(ends) // 2 for ends in block)] if len(corners) > LARGE else []
        structures = [self._structure(place) for place in (*corners, *middle)]
        if None not in structures and len(set(structures)) == 1:
            yield block, places
        elif len(places) > len(corners):
            _, _, axis = max((self._turns(axis, corners, block), high - low, axis)
                             for axis, (low, high) in enumerate(block))
            low, high = block[axis]
            cut = (low + high) // 2
            for part in ((low, cut), (cut + 1, high)):
                within = [place for place in places if part[0] <= place[axis] <= part[1]]
                if within:
                    yield from self._alike((*block[:axis], part, *block[axis + 1:]), within)

    def _turns(self, axis: int, corners: Sequence[Place], block: Block) -> int:
        """How many pairs of corners along an axis differ; −1 where it cannot be halved."""
        low, high = block[axis]
        if low == high:
            return -1
        return sum(self._structure(one) != self._structure((*one[:axis], high, *one[axis + 1:]))
                   for one in corners if one[axis] == low)

    def _by_block(self, cuts: Sequence[list[int]]) -> dict[Block, list[Place]]:
        """{block: places in it}."""
        found: dict[Block, list[Place]] = {}
        for place in self.places:
            found.setdefault(tuple(_block(i, cut) for i, cut in zip(place, cuts, strict=True)), []).append(place)
        return found

    def _structure(self, place: Place) -> tuple[Any, ...] | None:
        """What tells the expressions of a corner apart; None where there are none."""
        if place not in self._structures:
            problem = self.alone(place)
            try:
                self._structures[place] = None if isinstance(problem, Exception) else structure(
                    problem.scene, problem.system.linearisation)
            except (SpecError, PhysicsError, ArithmeticError):
                self._structures[place] = None
        return self._structures[place]


def with_given(problem: "Problem", values: Mapping[str, GivenValue]) -> "Problem":
    """The problem with values for parameters, which are chosen no longer."""
    spec = problem.spec
    parameters = dict(spec.parameters)
    for name, value in values.items():
        parameters[name] = parameters[name].with_values({**parameters[name], "value": value.expression})
    choices = {name: record for name, record in spec.choices.items() if name not in values}
    sections = {key: value for key, value in spec.sections.items() if key != "choose"}
    spec = spec._replace(sections=sections, get=sections.get).with_parameters(parameters)
    if choices:
        spec = spec.with_sections(choose=choices)
    return problem.with_spec(spec._replace(choices=choices))


def _block(i: int, cut: list[int]) -> tuple[int, int]:
    """(low, high) of the cuts between which a number lies."""
    above = min(max(bisect_right(cut, i), 1), len(cut) - 1)
    return (cut[above - 1], cut[above]) if above else (cut[0], cut[0])


def _corners(length: int, count: int) -> list[int]:
    """So many places from 0 to length − 1, evenly."""
    return sorted({round(k * (length - 1) / (count - 1)) for k in range(count)})


def structure(scene: "Scene", form: "Linearisation") -> tuple[Any, ...]:
    """The expressions of a scene and of its linearisation as they are told apart between tables."""
    loops = scene.loops
    nodes = [*scene.contents.nodes, *scene.drawn.values(), *scene.dependent.values(), *scene.driven.values(),
             *(() if loops is None else (*loops.conditions, *loops.slopes)), *_listed(form)]
    keys = ([[list(row) for _, row in rows] for rows in (form.inertias, form.springs, form.dampers)],
            [(list(second), list(row)) for _, second, row in form.curved],
            [list(matrix) for matrix in (form.M, form.C, form.G, form.drag, *form.K)] + list(map(list, form.residual)))
    return fingerprint(nodes), repr(keys), tuple(scene.coordinates), tuple(scene.table.functions)


def _listed(form: "Linearisation") -> "list[Node]":
    from vibcli.mechanics.linearisation import nodes_of

    return nodes_of(form)
