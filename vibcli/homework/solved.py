"""Candidates with their solutions: those of which there is a scene with answers, of the kind that is required."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import Diagnostic, PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.homework.candidates import candidates
from vibcli.homework.gates import failed, missed_by
from vibcli.homework.grid_answers import GridAnswers
from vibcli.homework.printed import with_printed
from vibcli.homework.regime import Regime, regime
from vibcli.language.given_values import GivenValue, giver, number_and_unit
from vibcli.quantities.expression import value_of

if TYPE_CHECKING:
    from vibcli.homework.keys import AnswerKey
    from vibcli.homework.mistakes.known import KnownMistake
    from vibcli.reader.variants import VariantRules
    from vibcli.results.problem import Problem
    from vibcli.results.variants import Place

SOLVED = "solved"           # the gate before all others: is there such a scene, and has it such an answer?


class Rejected(NamedTuple):
    """A candidate that did not pass: its place and values, the first gate that it failed, why, and by how much a
    comparison is missed, relative to its sides."""

    place: "Place"
    values: dict[str, GivenValue]
    gate: str
    reason: str
    missed: float = 0.0


class Candidate(NamedTuple):
    """A candidate with a solution: its scene where keys are in letters; what the sheet says; what is found of each key;
    wrong: {mistake: what it gives for each, None where it does not concern it or has no solution}."""

    problem: "Problem | None"
    values: dict[str, GivenValue]
    found: list[Any]
    wrong: dict[str, tuple[Any, ...]]


class SolvedCandidates(NamedTuple):
    """{place: Candidate} of those that are solved; the others; the scene of the file with its numbers, or that of the
    first of them, None where there is none; scene_at(place): that of a place, drawn anew."""

    candidates: "dict[Place, Candidate]"
    rejected: list[Rejected]
    base: "Problem | None"
    scene_at: "Callable[[Place], Any]"


def solve_candidates(problem: "Problem", rules: "VariantRules", keys: "Sequence[AnswerKey]",
                     slips: "Sequence[KnownMistake]") -> SolvedCandidates:
    """Those that fulfil what is required and are of the kind of the scene itself; SpecError where this does not fulfil
    it. slips: the mistakes that are made in the scene as it is."""
    own = own_scene(problem, rules)
    kind: Regime | None = None if own is None else own[1]
    found: dict[Place, Candidate] = {}
    rejected: list[Rejected] = []
    base = None if own is None else own[0]
    concerned = [(slip, [slip.concerns(key.asked, key.unit) for key in keys]) for slip in slips]
    variants = candidates(problem, rules, lambda one: with_printed(one, rules))
    count = rules.candidates if rules.sample is None else min(rules.sample, rules.candidates)
    answers = GridAnswers.of(variants)
    with problem.work.task("the variants") as task:
        for number, place in enumerate(variants.places, 1):
            task.step(number / count)
            values = variants.values_at(place)
            one = _candidate(problem, rules, keys, kind, answers, place, values, concerned)
            if not isinstance(one, Candidate):
                rejected.append(Rejected(place, values, *one))
            else:
                kind = kind or answers.regime(place, counts_rests(problem))
                base = base or answers.scene(place)
                found[place] = one
    return SolvedCandidates(found, rejected, base, variants.alone)


def counts_rests(problem: "Problem") -> bool:
    """Are its equilibria counted, as all of them are asked for?"""
    find = problem.spec.get("find")
    return find is not None and find.search is not None


def own_scene(problem: "Problem", rules: "VariantRules") -> "tuple[Problem, Regime] | None":
    """The scene with the values of its file, and its Regime; None where it has letters. SpecError where it does not
    fulfil what its variants have to."""
    if (problem.numeric.has_free_symbols and not problem.spec.choices) or any(
            "value" not in problem.spec.parameters[name] for axis in rules.axes for name in axis):
        return None
    found = with_printed(problem, rules)
    if "require" not in rules.without and (one := failed(partial(value_of, found), rules.require)) is not None:
        raise SpecError([Diagnostic(one.where, "the values of the file do not fulfil this", "give the scene itself "
                                    "values that a variant may have")])
    return found, regime(found, counts_rests(problem))


def _candidate(problem: "Problem", rules: "VariantRules", keys: "Sequence[AnswerKey]", kind: Regime | None,
               answers: GridAnswers, place: "Place", values: dict[str, GivenValue],
               slips: "Sequence[tuple[KnownMistake, list[bool]]]") -> Candidate | tuple[str, str, float]:
    """The Candidate; (gate, reason, by how much) of what it fails before its keys are looked at."""
    value = partial(answers.value_of, place)
    try:
        if "require" not in rules.without and (one := failed(value, rules.require)) is not None:
            return "require", f"not {one.text}", missed_by(value, one)
        if kind is not None and "regime" not in rules.without:
            its = answers.regime(place, kind.rests is not None)
            if its != kind:
                return "regime", kind.told(its), 0.0
        found = [answers.found(place, key) for key in keys]
        kept = answers.scene(place) if any(key.in_letters for key in keys) else None
        wrong = {slip.name: answers.mistaken(place, keys, slip, concerns, found) for slip, concerns in slips}
        printed = _printed(problem, answers.scene(place)) if problem.spec.choices else {}
        return Candidate(kept, {**values, **printed}, found, wrong)
    except SpecError as error:
        return SOLVED, error.diagnostics[0].message, 0.0
    except PhysicsError as error:
        return SOLVED, error.message, 0.0


def _printed(problem: "Problem", found: "Problem") -> dict[str, GivenValue]:
    """{chosen parameter: its value as printed}, of a scene that was solved again with these."""
    return {name: giver(unit, name)(number) for name in problem.spec.choices if name not in found.spec.choices
            for number, unit in [number_and_unit(found.spec.parameters[name]["value"])]}
