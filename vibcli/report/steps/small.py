"""The functions s(q) of a scene about its rest by powers of the deviations ξ, each coefficient simplified and held
against what it came from:

    s = s₀ + Σ aᵢ ξᵢ + ½ Σ bᵢⱼ ξᵢ ξⱼ + …
"""

from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import cached_property
from typing import TYPE_CHECKING, Any, cast

from vibcli.mechanics.linearise import row_of, slopes_of
from vibcli.report.steps.agreement import LEFT, agree_in_motion, same, samples_of, tidy
from vibcli.report.steps.lettered import LetteredCoefficients, is_long
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import root_of_square, textbook
from vibcli.symbolic.radicals import without_bars
from vibcli.symbolic.rationals import HALF, ONE

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

ROUNDING = 1e-13        # relative: of a sum that is zero where a search found the place


class Small:
    """A function s about rest, each part found where it is first asked for: so no coefficient has a letter that no
    line needs."""

    def __init__(self, about: "AboutRest", s: "Node") -> None:
        self._about, self.s, self.still = about, s, about.undriven.get(s, s)

    @cached_property
    def at_rest(self) -> "Node":
        """Its value there."""
        return self._about.rest(self.still)

    @cached_property
    def slopes(self) -> "dict[int, Node]":
        """{i: aᵢ}, zeros left out."""
        return self._about.entries(self._row)

    @cached_property
    def second(self) -> "dict[tuple[int, int], Node]":
        """{(i, j): bᵢⱼ}, zeros left out."""
        return self._about.entries(self._bends)

    @cached_property
    def bends(self) -> bool:
        """Has it a term of the second order?"""
        return any(not self._about.rest(node, named=False).is_zero for node in self._bends.values())

    @cached_property
    def drive(self) -> "Node":
        """What of it is a function of the time, counted from where nothing is driven to and fro."""
        return self._about.driven(self.s, self.still)

    @cached_property
    def _row(self) -> "dict[int, Node]":
        return row_of(self.still, self._about.index)

    @cached_property
    def _bends(self) -> "dict[tuple[int, int], Node]":
        return slopes_of(self._row, self._about.index)


class AboutRest:
    """A problem about its rest. place: {symbol: node} of all coordinates, the time and driven displacements; values:
    {letter: float} of the letters of places that are known in numbers alone; samples: values of the parameters at which
    expressions are held against each other; undriven: {s: the same as a function of driven displacements}."""

    order_of_speeds = " to the first order"

    def __init__(self, problem: "Problem", place: "Mapping[Node, Node]", values: Mapping[str, float],
                 sheet: WorkedSolution | None = None) -> None:
        self.problem, self.scene, self.table = problem, problem.scene.written, problem.scene.table
        scene, zero = self.scene, self.table.zero
        drives = scene.held_drives
        begun = substitute(list(drives.values()), {scene.time: zero})
        self.place = {**place, **dict.fromkeys((*scene.v, *scene.a), zero), **dict(zip(drives, begun, strict=True))}
        self.undriven = {one.s: other.s for kind, terms in scene.shaken.items()
                         for one, other in zip(getattr(scene, kind), terms, strict=True)}
        self._known, self._searched, self._keeps = dict(values), bool(values), False
        self._lettered = LetteredCoefficients(self, sheet, self._searched) if sheet is not None else None
        self.index = {q: i for i, q in enumerate(self.scene.q)}
        self.samples = samples_of(problem, self._known)

    def small(self, s: "Node") -> Small:
        """A function of the coordinates about rest."""
        return Small(self, s)

    def shifted(self, node: "Node") -> "Node":
        """A function of the coordinates with these counted from rest."""
        moved = {q: self.place[q] + q for q in self.scene.q if not self.place[q].is_zero and q in gradient(node)}
        moved |= {s: self.place[s] + s for s in self._in_loops if not self.place[s].is_zero}
        return textbook(substitute([node], moved)[0] if moved else node)

    @cached_property
    def _in_loops(self) -> "list[Node]":
        """What follows from the coordinates in closed loops."""
        loops, dependent = self.scene.loops, self.scene.dependent
        return [dependent[name] for name in (loops.names if loops is not None else ())]

    def driven(self, s: "Node", still: "Node") -> "Node":
        """s(q₀, t) less what it is there while nothing is driven to and fro."""
        if self.scene.time not in gradient(s):
            return self.table.zero
        place = {symbol: node for symbol, node in self.place.items() if symbol is not self.scene.time}
        return textbook(self._unrooted(substitute([s], place)[0]) - self.rest(still))

    def _begun(self, node: "Node") -> "Node":
        """The same with 0 and 1 for steps and ramps of instants that are known to be before or after their begin, and
        signs that are known."""
        known = {}
        for call in reachable([node]):
            if call.op == "call" and call.name in ("step", "ramp", "sign") and not call.args[0].mask:
                argument, = call.args
                value = self.value(argument)
                before, after = ((value or 0.0) < 0, (value or 0.0) > 0) if value is not None else map(
                    self.table.is_positive, (-argument, argument))
                if before or after:
                    low = -self.table.one if call.name == "sign" else self.table.zero
                    known[call] = low if before else argument if call.name == "ramp" else self.table.one
        return substitute([node], known)[0] if known else node

    def _unrooted(self, node: "Node") -> "Node":
        """A function of the time with H − u for √((H − u)²), where that is so while anything acts."""
        terms = node.args if node.op == "sum" else ((node, ONE),)
        for part, _ in terms:
            base = next((base for base, e in part.args if e == HALF and base.mask), None) if (
                part.op == "product") else None
            root = None if base is None else root_of_square(base)
            if root is not None:
                at_first = evaluate([root], Floats, {**self.samples[0], self.scene.time.name: 0.0})[0]
                straight = substitute([node], {self.table.power(base, HALF): root if at_first > 0 else -root})[0]
                node = straight if self.agree_in_motion([straight], [node]) else node
        return node

    def entries(self, found: "Mapping[Any, Node]") -> "dict[Any, Node]":
        """Those at rest that are not zero."""
        entries = {key: self.rest(node) for key, node in found.items()}
        return {key: node for key, node in entries.items() if not node.is_zero}

    def rest(self, node: "Node", named: bool = True) -> "Node":
        """An expression at rest, in its simplest form; where `named` a letter for a long one that has a number, at a
        place that a search found for one that is not short."""
        found = self._begun(substitute([node], self.place)[0])
        found = self.tidy(without_bars(self.tidy(without_bars(found, self.samples)), self.samples))
        return self._letter_for(found) if named and self.is_long(found) else found

    def is_long(self, node: "Node") -> bool:
        """Has an expression at rest a letter of its own, being long and having a number?"""
        return not self.problem.numeric.has_free_symbols and is_long(node, self._searched)

    def tension(self, node: "Node") -> "Node":
        """A force at rest, which has the letter of its element."""
        return self.rest(node, named=False)

    def _letter_for(self, node: "Node") -> "Node":
        """A letter for a number; zero for what rounding leaves at a searched place."""
        if self._lettered is None:
            return node
        return self.table.zero if self.is_rounding(node) else self._lettered.letter_for(node)

    def is_rounding(self, node: "Node") -> bool:
        """Is a sum at a searched place zero but for rounding?"""
        if not self._searched:
            return False
        terms = [part * c for part, c in node.args] if node.op == "sum" else [node]
        found = evaluate(terms, Floats, self.samples[0])
        return cast("bool", abs(sum(found)) <= ROUNDING * sum(map(abs, found)))

    @property
    def abbreviates(self) -> bool:
        """Have long coefficients letters of their own?"""
        return self._keeps or bool(self._lettered and self._lettered.known)

    def keep(self, letter: "Node", node: "Node") -> "Node":
        """What stands in the sums for a force or slope at rest, which has a letter: this where it is long, or was found
        by a search, else itself."""
        kept = self.know(letter, self.value(node))
        self._keeps |= not kept and self.is_long(node)
        return letter if kept or self.is_long(node) else node

    def know(self, letter: "Node", value: float | None) -> bool:
        """Give a letter its number; is the place of rest known in numbers alone, so that it stands in the sums?"""
        if value is not None:
            self._known[letter.name] = self.samples[0][letter.name] = value
        return self._searched

    def tidy(self, node: "Node") -> "Node":
        """The simplest form of an expression without coordinates; itself where the simpler one is not the same."""
        return tidy(node, self.samples)

    def same(self, one: "Node", other: "Node") -> bool:
        """Are two expressions of the parameters equal at values of these?"""
        return same(one, other, self.samples)

    def cancel(self, nodes: "Sequence[Node]", left: float = LEFT) -> bool:
        """Is the sum of expressions of the parameters zero but for rounding, of which so much is `left` at most?"""
        for values in self.samples:
            terms = evaluate(nodes, Floats, values)
            if not abs(sum(terms)) <= left * sum(map(abs, terms)):
                return False
        return True

    def agree_in_motion(self, one: "Sequence[Node]", other: "Sequence[Node]") -> bool:
        """Have two lists of terms, functions of the motion and the time, the same sum at states of motion?"""
        return agree_in_motion(self.scene, self.samples, one, other)

    def letter(self, name: str) -> "Node":
        """The symbol of a new letter."""
        return self.table.parameter(name)

    def numbers(self) -> dict[str, float]:
        """{letter: number} of those that have one."""
        numeric = self.problem.numeric
        known = self.scene.parameters.values(Floats) if numeric.has_free_symbols else numeric.floats
        return {**known, **self._known}

    def value(self, node: "Node") -> float | None:
        """The number of an expression of parameters; None where they have none."""
        return value_of(self.problem, node, self._known)

    def known_value(self, node: "Node") -> float | None:
        """The same of one whose letters all have numbers, although others may have none."""
        with suppress(KeyError):
            return cast("float | None", evaluate([node], Floats, self.numbers())[0])
        return None

    def square(self, speeds: "Sequence[Node]") -> "Node":
        """Σ vᵢ² of speeds to the first order, multiplied out where nothing is driven."""
        total = self.table.total([v ** 2 for v in speeds])
        return total if total.mask & self.scene.time.mask else textbook(total)

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
        found: dict[Any, Any] = {}
        for weight, small in parts:
            for i, a in small.slopes.items():
                for j, b in small.slopes.items():
                    found.setdefault((i, j), []).append(weight * a * b)
        entries = {pair: self.tidy(self.table.total(nodes)) for pair, nodes in found.items()}
        return {pair: node for pair, node in entries.items() if not node.is_zero}


def value_of(problem: "Problem", node: "Node", known: Mapping[str, float]) -> float | None:
    """The number of an expression of parameters and known letters; None where they have none."""
    if problem.numeric.has_free_symbols:
        return None
    return cast("float | None", evaluate([node], Floats, {**problem.numeric.floats, **known})[0])
