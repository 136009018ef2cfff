"""All variants of a problem: every candidate solved once, passed through the gates, and held against a second way."""

import re
from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.check.instances import Instances
from vibcli.homework.asked_keys import key_of
from vibcli.homework.bands import KeyBand
from vibcli.homework.candidates import candidates
from vibcli.homework.fresh_mistakes import require_same_mistakes
from vibcli.homework.gates import Wrong, unreadable
from vibcli.homework.grid_answers import GridAnswers
from vibcli.homework.key_summary import KeySummary, summaries
from vibcli.homework.keys import AnswerKey
from vibcli.homework.leaks import numbers_in
from vibcli.homework.mistakes.known import KnownMistake
from vibcli.homework.printed import with_printed
from vibcli.homework.problem_mistakes import held_at, mistakes_of, own_values
from vibcli.homework.routes import hold_against_closed_forms
from vibcli.homework.solved import SOLVED, Rejected, solve_candidates
from vibcli.homework.told import untold
from vibcli.homework.unsolved import unsolved
from vibcli.language.given_values import GivenValue, number_and_unit
from vibcli.reader.read import QUOTE
from vibcli.reader.sections.variants import GATES
from vibcli.results.variants import with_given

if TYPE_CHECKING:
    import numpy as np

    from vibcli.homework.document import SceneDocument
    from vibcli.homework.solved import Candidate
    from vibcli.language.spec import Spec
    from vibcli.reader.variants import VariantRules
    from vibcli.results.problem import Problem
    from vibcli.results.variants import Place

REREAD = 20                 # variants that are held against the scene read anew


class ProblemVariant(NamedTuple):
    """place in the grid; values: {parameter: what the sheet says}, printed ones among them; keys: what each is, what it
    allows and what mistakes give."""

    place: "Place"
    values: dict[str, GivenValue]
    keys: tuple[Any, ...]


class SolvedVariants(NamedTuple):
    """What is known of all candidates, in the order of the grid. same: (mistake, quantity) of mistakes that lead to the
    key in every variant, which are left out; reread: how many were held against the scene read anew; closed: {quantity:
    how many candidates its closed form was held against}; summed: the KeySummary of each key, where parts have told
    it."""

    problem: "Problem"
    rules: "VariantRules"
    keys: list[AnswerKey]
    mistakes: list[KnownMistake]
    accepted: Sequence[ProblemVariant]
    rejected: list[Rejected]
    same: list[tuple[str, str]]
    reread: int
    closed: dict[str, int]
    summed: list[KeySummary] | None = None

    @property
    def summaries(self) -> list[KeySummary]:
        """The KeySummary of each key."""
        return summaries(self.accepted) if self.summed is None else self.summed

    @property
    def counts(self) -> dict[str, int]:
        """{gate: how many candidates it rejected}, in the order of the gates."""
        return {gate: sum(one.gate == gate for one in self.rejected) for gate in (SOLVED, *GATES)}

    @property
    def unsolved(self) -> list[tuple[str, str]]:
        """(mistake, why) of those that give nothing in any variant, which are left out."""
        return unsolved(self)

    @property
    def advice(self) -> str:
        """Where no variant is left: how many each gate took, that which took most first, and which values come
        nearest."""
        taken = sorted(((count, gate) for gate, count in self.counts.items() if count), key=lambda pair: -pair[0])
        (count, gate), *others = taken
        those = [one for one in self.rejected if one.gate == gate]
        more = "".join(f", '{other}' {its}" for its, other in others)
        found = f"'{gate}' took {count} of {len(self.rejected)}{more}; for example: {those[0].reason}"
        return found + (f"; {nearer}" if gate == "require" and (nearer := _nearer(self.rules, those)) else "")


def _nearer(rules: "VariantRules", those: list[Rejected]) -> str | None:
    """Of which parameter smaller or larger values miss a comparison by less, in words; None where that is not seen."""
    best, words = 0.0, None
    for number, axis in enumerate(rules.axes):
        low, high = ([one.missed for one in those if one.place[number] == end]
                     for end in (0, len(next(iter(axis.values()))) - 1))
        if low and high and abs(slope := sum(high) / len(high) - sum(low) / len(low)) > best:
            best, words = abs(slope), f"{'smaller' if slope > 0 else 'larger'} values of {next(iter(axis))} come nearer"
    return words


def solve_variants(problem: "Problem", document: "SceneDocument",
                   left_out: "Collection[tuple[str, str]] | None" = None) -> SolvedVariants:
    """The SolvedVariants of a scene that has VariantRules; document: its own; left_out: (mistake, quantity) that are
    left out, unless given those that lead to the key in every variant. SpecError where its mistakes are no scenes, or
    its own values do not fulfil what it requires."""
    rules = problem.spec.get("variants")
    keys = [key_of(problem.spec, one) for one in rules.ask]
    mistakes = mistakes_of(problem, rules, document, keys)
    solved, rejected, base, scene_at = solve_candidates(problem, rules, keys,
                                                        [one for one in mistakes if one.problem is None])
    bands = _bands(base, keys, solved)
    _look(problem, rules, keys, base, bands, solved, rejected)
    alone = "routes" in rules.without or base is None
    closed = {} if alone else hold_against_closed_forms(keys, base, solved, scene_at)
    _model_mistakes(problem, rules, keys, mistakes, solved)
    equal = _equal(keys, solved)
    same = set(left_out) if left_out is not None else set.intersection(*equal.values()) if equal else set()
    accepted = _accept(keys, mistakes, bands, solved, equal, same, rejected, "apart" in rules.without)
    in_order = [(mistake.name, key.text) for mistake in mistakes for key in keys if (mistake.name, key.text) in same]
    rejected.sort(key=lambda one: one.place)
    reread = 0 if "routes" in rules.without else _reread(document, keys, accepted)
    return SolvedVariants(problem, rules, keys, mistakes, accepted, rejected, in_order, reread, closed)


def _bands(base: "Problem | None", keys: list[AnswerKey],
           solved: "dict[Place, Candidate]") -> "dict[Place, list[KeyBand]]":
    """{place: the KeyBand of each key}."""
    if base is None or not solved:
        return {}
    shares: list[np.ndarray | None] = [None] * len(keys)
    if not base.numeric.has_free_symbols:
        from vibcli.homework.rounding import shares_of

        shares = shares_of(base, keys, [one.values for one in solved.values()])
    return {place: [KeyBand(key.rtol, None if share is None else tuple(map(tuple, share[:, :, i].tolist())))
                    for key, share in zip(keys, shares, strict=True)] for i, place in enumerate(solved)}


def _look(problem: "Problem", rules: "VariantRules", keys: list[AnswerKey], base: "Problem | None",
          bands: "dict[Place, list[KeyBand]]", solved: "dict[Place, Candidate]", rejected: list[Rejected]) -> None:
    """Take out of what is solved what cannot be read, or is told nowhere."""
    told = [] if base is None or "told" in rules.without else untold(base, keys)
    given = _given(problem.spec)
    for place, one in list(solved.items()):
        gate, reason = _of_keys(rules, keys, bands[place], one, told, given)
        if gate is not None:
            rejected.append(Rejected(place, solved.pop(place).values, gate, reason))


def _given(spec: "Spec") -> dict[str, tuple[float, str | None]]:
    """{what it is: (number, unit)} of the parameters of a file, and of the numbers in the words of its question."""
    written = {name: number_and_unit(record["value"]) for name, record in spec.parameters.items() if "value" in record}
    numbers = {name: (float(found[0]), found[1]) for name, found in written.items() if found is not None}
    return numbers | {f"number {said} of the question": (value, None)
                      for value, _, said in numbers_in(re.sub(QUOTE, " ", spec.get("question", "")))}


def _of_keys(rules: "VariantRules", keys: list[AnswerKey], bands: list[KeyBand], one: "Candidate", told: list[str],
             given: dict[str, tuple[float, str | None]]) -> tuple[str | None, str | None]:
    """(gate, reason) of what keys with values fail; (None, None) of nothing. told: parameters that are not told; given:
    {what it is: (number, unit)} of what all sheets tell."""
    numbers = {**given, **{name: (float(value.number), value.unit) for name, value in one.values.items()}}
    if "readable" not in rules.without and (reason := _unreadable(keys, bands, one, numbers)) is not None:
        return "readable", reason
    return ("told", f"neither question nor figure tells {', '.join(told)}") if told else (None, None)


def _model_mistakes(problem: "Problem", rules: "VariantRules", keys: list[AnswerKey], mistakes: list[KnownMistake],
                    solved: "dict[Place, Candidate]") -> None:
    """Add to what is solved what mistakes give that change the scene."""
    for mistake in mistakes:
        if mistake.problem is not None:
            concerns = [mistake.concerns(key.asked, key.unit) for key in keys]
            answers = _answers(problem, rules, mistake, solved)
            for place, one in solved.items():
                one.wrong[mistake.name] = answers.mistaken(place, keys, mistake, concerns, one.found)


def _answers(problem: "Problem", rules: "VariantRules", mistake: KnownMistake,
             solved: "dict[Place, Candidate]") -> GridAnswers:
    """The GridAnswers of the scenes that a mistake takes for the right ones, of all candidates that are solved."""
    own = own_values(mistake, rules)
    if not problem.spec.choices:
        return GridAnswers.of(candidates(mistake.problem, held_at(rules, own), lambda one: with_printed(one, rules),
                                         solved))

    def scene_at(place: "Place") -> "Problem | SpecError | PhysicsError":
        try:
            return with_printed(with_given(mistake.problem, {**solved[place].values, **own}), rules)
        except (SpecError, PhysicsError) as error:
            return error

    return GridAnswers(scene_at)


def _equal(keys: list[AnswerKey], solved: "dict[Place, Candidate]") -> "dict[Place, set[tuple[str, str]]]":
    """{place: the (mistake, quantity) that lead to the key itself}."""
    found = {}
    for place, one in solved.items():
        found[place] = here = set()
        instances = None if one.problem is None else Instances(one.problem)
        for i, key in enumerate(keys):
            given = {name: values[i] for name, values in one.wrong.items() if values[i] is not None}
            flags = key.equal(one.problem, one.found[i], list(given.values()), instances)
            here.update((name, key.text) for name, flag in zip(given, flags, strict=True) if flag)
    return found


def _unreadable(keys: list[AnswerKey], bands: list[KeyBand], one: "Candidate",
                numbers: dict[str, tuple[float, str | None]]) -> str | None:
    """Why keys that are numbers can not be asked for; None where they can."""
    known = [i for i, found in enumerate(one.found) if isinstance(found, tuple)]
    return unreadable([keys[i] for i in known], [bands[i] for i in known], [one.found[i] for i in known], numbers)


def _accept(keys: list[AnswerKey], mistakes: list[KnownMistake], bands: "dict[Place, list[KeyBand]]",
            solved: "dict[Place, Candidate]", equal: "dict[Place, set[tuple[str, str]]]", same: set[tuple[str, str]],
            rejected: list[Rejected], all_pass: bool) -> list[ProblemVariant]:
    """The Variants that pass the gate of mistakes."""
    accepted, texts = [], [key.text for key in keys]
    told = [[mistake.name for mistake in mistakes if (mistake.name, text) not in same] for text in texts]
    for place, one in solved.items():
        values, reason, leads = [], None, equal[place]
        for i, (key, found, text) in enumerate(zip(keys, one.found, texts, strict=True)):
            given = tuple(Wrong(name, value) for name in told[i] if (value := one.wrong[name][i]) is not None)
            flags = [(each.mistake, text) in leads for each in given]
            value, why = key.settled(bands[place][i], found, given, flags)
            reason = reason or why
            values.append(value)
        if reason and not all_pass:
            rejected.append(Rejected(place, one.values, "apart", reason))
        else:
            accepted.append(ProblemVariant(place, one.values, tuple(values)))
    return accepted


def _reread(document: "SceneDocument", keys: Sequence[AnswerKey], accepted: Sequence[ProblemVariant]) -> int:
    """Hold some variants, keys and mistakes, against the scene read anew from the values that are printed;
    RuntimeError, a fault of ours, where one differs."""
    step = max(1, len(accepted) // REREAD)
    chosen = accepted[::step][:REREAD]
    for variant in chosen:
        read_anew(document, keys, variant)
    return len(chosen)


def read_anew(document: "SceneDocument", keys: Sequence[AnswerKey], variant: ProblemVariant,
              turn: int | None = None) -> "Problem":
    """The Problem of a variant, read anew from what is printed; RuntimeError, a fault of ours, where a key, or what
    a mistake makes of it, is not what was found. turn: which one of the mistakes that change the scene is solved, all
    unless it is given."""
    fresh = document.anew(variant.values)
    at = ", ".join(one.text for one in variant.values.values())
    for key, one in zip(keys, variant.keys, strict=True):
        key.require_same(fresh, one, at)
    if variant.place:       # what mistakes made of it when a manifest was written is not what they may make of it today
        require_same_mistakes(document, fresh, keys, variant, at, turn)
    return fresh
