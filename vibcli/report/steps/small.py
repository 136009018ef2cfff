"""The functions s(q) of a scene about its rest by powers of the deviations ξ, each coefficient simplified and held
against what it came from:

    s = s₀ + Σ aᵢ ξᵢ + ½ Σ bᵢⱼ ξᵢ ξⱼ + …
"""

from collections.abc import Mapping, Sequence
from random import Random
from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.base.errors import NotInLetters
from vibcli.language.parameter_samples import sample_values
from vibcli.mechanics.linearise import row_of, slopes_of
from vibcli.symbolic.common_denominator import shorter
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.rationals import HALF, ONE

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

ALIKE = 1e-9            # relative: of an expression and its simpler form at values of the letters
LEFT = 1e-7             # relative: of forces at rest, whose place may be known in numbers
SAMPLES, STATES = (60, 61, 62), 3


class Small(NamedTuple):
    """A function about rest: its value there, {i: aᵢ} and {(i, j): bᵢⱼ}, zeros left out; drive: what of it is a
    function of the time, counted from t = 0."""

    at_rest: Any
    slopes: "dict[int, Node]"
    second: "dict[tuple[int, int], Node]"
    drive: Any


class AboutRest:
    """A problem about its rest. place: {symbol: node} of all coordinates and the time; values: {letter: float} of the
    letters of places that are known in numbers alone; samples: values of the parameters at which expressions are held
    against each other."""

    def __init__(self, problem: "Problem", place: "Mapping[Node, Node]", values: Mapping[str, float]):
        self.problem, self.scene, self.table = problem, problem.scene, problem.scene.table
        self.place = {**place, **dict.fromkeys((*self.scene.v, *self.scene.a), self.table.zero)}
        self._known = dict(values)
        self._numbers = None if problem.numeric.has_free_symbols else {**problem.numeric.floats, **self._known}
        self._index = {q: i for i, q in enumerate(self.scene.q)}
        self.samples = [self._numbers] if self._numbers is not None else [
            self.scene.parameters.values(Floats, sample_values(self.scene.parameters.free, attempt))
            for attempt in SAMPLES]

    def small(self, s: "Node") -> Small:
        """A function of the coordinates about rest."""
        row = row_of(s, self._index)
        second = slopes_of(row, self._index)
        return Small(self.rest(s), self._entries(row), self._entries(second), self._drive(s))

    def _drive(self, s):
        """s(q₀, t) − s(q₀, 0)."""
        if self.scene.time not in gradient(s):
            return self.table.zero
        still = {symbol: node for symbol, node in self.place.items() if symbol is not self.scene.time}
        return textbook(substitute([s], still)[0] - self.rest(s))

    def _entries(self, found):
        entries = {key: self.rest(node) for key, node in found.items()}
        return {key: node for key, node in entries.items() if not node.is_zero}

    def rest(self, node: "Node") -> "Node":
        """An expression at rest, in its simplest form."""
        return self.tidy(substitute([node], self.place)[0])

    def tidy(self, node: "Node") -> "Node":
        """The simplest form of an expression without coordinates; itself where the simpler one is not the same."""
        found = textbook(node)
        if is_zero(found):
            return self.table.zero
        shortened = shorter(found)
        best = shortened if letters(shortened) < letters(found) else found
        return best if self.same(best, node) else node

    def same(self, one: "Node", other: "Node") -> bool:
        """Are two expressions of the parameters equal at values of these?"""
        for values in self.samples:
            a, b = evaluate([one, other], Floats, values)
            if not abs(a - b) <= ALIKE * max(abs(a), abs(b)):
                return False
        return True

    def cancel(self, nodes: "Sequence[Node]") -> bool:
        """Is the sum of expressions of the parameters zero but for rounding?"""
        for values in self.samples:
            terms = evaluate(nodes, Floats, values)
            if not abs(sum(terms)) <= LEFT * sum(map(abs, terms)):
                return False
        return True

    def agree_in_motion(self, one: "Sequence[Node]", other: "Sequence[Node]") -> bool:
        """Have two lists of terms, functions of the motion and the time, the same sum at states of motion?"""
        scene, draw = self.scene, Random("states")
        for values in self.samples * STATES:
            state = {node.name: draw.uniform(-1, 1) for node in (*scene.q, *scene.v, *scene.a)}
            found = [evaluate(list(terms), Floats, {**values, **state, scene.time.name: t})
                     for t in [draw.uniform(0, 3)] for terms in (one, other)]
            if not abs(sum(found[0]) - sum(found[1])) <= LEFT * sum(abs(x) for terms in found for x in terms):
                return False
        return True

    def letter(self, name: str) -> "Node":
        """The symbol of a new letter."""
        return self.table.parameter(name)

    def numbers(self) -> dict[str, float]:
        """{letter: number} of the parameters, empty where they have none."""
        return dict(self._numbers or {})

    def value(self, node: "Node") -> float | None:
        """The number of an expression of parameters; None where they have none."""
        return None if self._numbers is None else evaluate([node], Floats, self._numbers)[0]

    def first(self, small: Small, symbols: "Sequence[Node]") -> "Node":
        """Σ aᵢ xᵢ."""
        return self.table.sum(*((a * symbols[i], ONE) for i, a in small.slopes.items()))

    def moves(self, small: Small) -> "Node":
        """Σ aᵢ qᵢ and what drives it."""
        return self.first(small, self.scene.q) + small.drive

    def rate(self, small: Small) -> "Node":
        """Its rate, to the first order."""
        return self.first(small, self.scene.v) + self.scene.rate(small.drive)

    def half_squares(self, parts: "Sequence[tuple[Node, Small]]", rates: bool) -> "Node":
        """½ Σ w s² of what moves, or of its rates: multiplied out where nothing is driven."""
        if all(small.drive.is_zero for _, small in parts):
            return self.squared(self.sum_of_squares(parts), self.scene.v if rates else self.scene.q)
        of = self.rate if rates else self.moves
        return self.table.total([weight * of(small) ** 2 / 2 for weight, small in parts])

    def bent(self, small: Small) -> "Node":
        """½ Σ bᵢⱼ qᵢ qⱼ."""
        q = self.scene.q
        return self.table.sum(*((b * q[i] * q[j], HALF) for (i, j), b in small.second.items()))

    def squared(self, entries: "Mapping[tuple[int, int], Node]", symbols: "Sequence[Node]") -> "Node":
        """½ Σ mᵢⱼ xᵢ xⱼ."""
        return self.table.sum(*((m * symbols[i] * symbols[j], HALF) for (i, j), m in entries.items()))

    def sum_of_squares(self, parts: "Sequence[tuple[Node, Small]]") -> "dict[tuple[int, int], Node]":
        """{(i, j): Σ w aᵢ aⱼ}."""
        found: dict = {}
        for weight, small in parts:
            for i, a in small.slopes.items():
                for j, b in small.slopes.items():
                    found.setdefault((i, j), []).append(weight * a * b)
        entries = {pair: self.tidy(self.table.total(nodes)) for pair, nodes in found.items()}
        return {pair: node for pair, node in entries.items() if not node.is_zero}


def about_rest(problem: "Problem") -> "tuple[AboutRest, dict[str, str]]":
    """(the problem about its rest, {coordinate: the letter of its place at rest}, where that is known in numbers
    alone)."""
    scene, symbolic = problem.scene, problem.symbolic
    if symbolic.balanced_as_drawn:
        return AboutRest(problem, scene.drawn_position, {}), {}
    try:
        named = symbolic.equilibrium_position
    except NotInLetters:
        if problem.numeric.has_free_symbols:
            raise
        values = problem.configuration.equilibrium.values
        taken = {*problem.spec.parameters, *problem.spec.coordinates}
        moving = {q.name: q for q in scene.q} | {name: node for name, node in scene.dependent.items()
                                                 if scene.loops is not None and name in scene.loops.names}
        letter = {name: next(x for x in (f"{name}0", f"{name}_0", f"{name}_rest") if x not in taken) for name in moving}
        symbols = {node: scene.table.parameter(letter[name], positive=False) for name, node in moving.items()}
        return AboutRest(problem, {**scene.drawn_position, **symbols},
                         {letter[name]: values[name] for name in moving}), letter
    return AboutRest(problem, {**scene.drawn_position, **{q: named[q.name] for q in scene.q}}, {}), {}
