"""A large grid of variants in parts: each is solved by itself, here or by an executor, and what they find is put
together in the order of the grid. The parts are the same however many workers there are, and so is all that they find.
"""

from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from itertools import islice, product
from math import ceil
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.homework.asked_keys import key_of
from vibcli.homework.candidates import sampled
from vibcli.homework.key_summary import KeySummary, joined, summaries
from vibcli.homework.packed import PackedVariants, packed
from vibcli.homework.problem_mistakes import mistakes_of
from vibcli.homework.solved import Rejected, own_scene
from vibcli.homework.variants import SolvedVariants, solve_variants

if TYPE_CHECKING:
    from concurrent.futures import Future

    from vibcli.base.work import Task
    from vibcli.homework.document import SceneDocument
    from vibcli.homework.keys import AnswerKey
    from vibcli.homework.mistakes.known import KnownMistake
    from vibcli.language.given_values import GivenValue
    from vibcli.reader.variants import VariantRules
    from vibcli.results.problem import Problem
    from vibcli.results.variants import Place

SIZE = 10_000       # places in a part, at most


class SolvedPart(NamedTuple):
    """What is found of a part. values: {place: those printed} where they are not those of the grid; accepted: (place,
    packed keys); rejected: (place, gate, reason, by how much missed); same: (mistake, quantity) that lead to the key in
    all of its variants, None where it has none; keys: the KeySummary of each, none without variants."""

    values: "dict[Place, Any]"
    accepted: "list[tuple[Place, tuple[Any, ...]]]"
    rejected: "list[tuple[Place, str, str, float]]"
    same: frozenset[tuple[str, str]] | None
    reread: int
    closed: dict[str, int]
    keys: list[KeySummary]


class BegunVariants(NamedTuple):
    """A grid whose parts are under way: tasks, what the executor gives for them, None where there is none."""

    problem: "Problem"
    document: "SceneDocument"
    tasks: "list[PartTask]"
    executor: Executor | None
    pending: "list[Future[SolvedPart]]"

    def solved(self) -> SolvedVariants:
        """The SolvedVariants, when all parts are done."""
        if self.executor is None and len(self.tasks) == 1:
            return solve_variants(self.problem, self.document)
        rules = self.problem.spec.get("variants")
        keys = [key_of(self.problem.spec, one) for one in rules.ask]
        mistakes = mistakes_of(self.problem, rules, self.document, keys)
        with self.problem.work.task("the variants") as task:
            found = list(self._results(self.tasks, self.pending, task))
            told = [one.same for one in found if one.same is not None]
            same = frozenset.intersection(*told) if told else frozenset()
            again = [i for i, one in enumerate(found) if one.same not in (None, same)]
            tasks = [self.tasks[i]._replace(left_out=same) for i in again]
            for i, one in zip(again, self._results(tasks, _submitted(tasks, self.executor), task), strict=True):
                found[i] = one
        return _together(self.problem, rules, keys, mistakes, found, same)

    def _results(self, tasks: "list[PartTask]", pending: "list[Future[SolvedPart]]",
                 task: "Task") -> Iterator[SolvedPart]:
        each = map(_solve_part, tasks) if self.executor is None else (one.result() for one in pending)
        for number, one in enumerate(each, 1):
            task.step(number / len(tasks))
            yield one


class PartTask(NamedTuple):
    """So many places from a number on, in the order of the grid; left_out: the (mistake, quantity) that are, those of
    the part itself where that is None."""

    document: "SceneDocument"
    patience: int
    start: int
    size: int
    left_out: frozenset[tuple[str, str]] | None = None


def begin_variants(problem: "Problem", document: "SceneDocument", executor: Executor | None = None,
                   size: int = SIZE) -> BegunVariants:
    """The variants of a scene that has VariantRules, whose parts the executor solves, where one is given; document: its
    own; size: places in a part, at most: all have as many, and are even in number, so that two workers end together.
    SpecError where its own values do not fulfil what it requires."""
    rules = problem.spec.get("variants")
    count = _count(rules)
    if count > size:
        size = count if own_scene(problem, rules) is None else even_size(count, size)
    tasks = [PartTask(document, problem.work.patience, start, size) for start in range(0, count, size)]
    return BegunVariants(problem, document, tasks, executor, _submitted(tasks, executor))


def even_size(count: int, size: int) -> int:
    """At most so many, of which an even number of parts make up a count."""
    return ceil(count / (2 * ceil(count / (2 * size))))


def solve_in_parts(problem: "Problem", document: "SceneDocument", executor: Executor | None = None,
                   size: int = SIZE) -> SolvedVariants:
    """The SolvedVariants of a scene that has VariantRules, likewise. SpecError where its mistakes are no scenes."""
    return begin_variants(problem, document, executor, size).solved()


def _submitted(tasks: list[PartTask], executor: Executor | None) -> "list[Future[SolvedPart]]":
    return [] if executor is None else [executor.submit(_solve_part, one) for one in tasks]


def _count(rules: "VariantRules") -> int:
    return rules.candidates if rules.sample is None else min(rules.sample, rules.candidates)


def _solve_part(task: PartTask) -> SolvedPart:
    problem = task.document.problem(task.patience)
    rules = problem.spec.get("variants")
    rules = rules._replace(places=_places(rules, task.start, task.size))
    part = problem.with_spec(problem.spec.with_sections(variants=rules))
    found = solve_variants(part, task.document, task.left_out)
    values = {one.place: one.values for one in found.accepted} | {one.place: one.values for one in found.rejected}
    apart = any(one.gate == "apart" for one in found.rejected)
    known = frozenset(found.same) if found.accepted or apart else None
    return SolvedPart(values if problem.spec.choices else {},
                      [(one.place, tuple(map(packed, one.keys))) for one in found.accepted],
                      [(one.place, one.gate, one.reason, one.missed) for one in found.rejected], known, found.reread,
                      found.closed, summaries(found.accepted))


def _places(rules: "VariantRules", start: int, size: int) -> "list[Place]":
    """So many from a number on, in the order of the grid."""
    wanted: Sequence[Any] | None = sampled(rules)
    lengths = [range(len(next(iter(axis.values())))) for axis in rules.axes]
    return list(islice(product(*lengths) if wanted is None else wanted, start, start + size))


def _together(problem: "Problem", rules: "VariantRules", keys: "list[AnswerKey]", mistakes: "list[KnownMistake]",
              found: list[SolvedPart], same: frozenset[tuple[str, str]]) -> SolvedVariants:
    def values(number: int, place: "Place") -> "dict[str, GivenValue]":
        return found[number].values.get(place) or {name: given[i] for axis, i in zip(rules.axes, place, strict=True)
                                                   for name, given in axis.items()}

    accepted = PackedVariants([part.accepted for part in found], values)
    rejected = [Rejected(place, values(number, place), gate, reason, missed) for number, part in enumerate(found)
                for place, gate, reason, missed in part.rejected]
    in_order = [(mistake.name, key.text) for mistake in mistakes for key in keys if (mistake.name, key.text) in same]
    closed: dict[str, int] = {}
    for part in found:
        for text, count in part.closed.items():
            closed[text] = closed.get(text, 0) + count
    return SolvedVariants(problem, rules, keys, mistakes, accepted, rejected, in_order,
                          sum(part.reread for part in found), closed,
                          joined(part.keys for part in found if part.keys))
