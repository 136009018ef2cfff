"""The candidates of a problem: the places of its grid of values, or so many of them, the same ones everywhere."""

from collections.abc import Iterable
from hashlib import blake2b
from typing import TYPE_CHECKING

from vibcli.homework.variants_in_letters import VariantsInLetters
from vibcli.reader.variants import stays_in_letters
from vibcli.results.variants import Place, Variants

if TYPE_CHECKING:
    from collections.abc import Callable

    from vibcli.reader.variants import VariantRules
    from vibcli.results.problem import Problem


def candidates(problem: "Problem", rules: "VariantRules", settle: "Callable[[Problem], Problem]",
               places: Iterable[Place] | None = None) -> Variants:
    """The Variants of a scene over the grid of its rules, or at some places of it."""
    wanted = sampled(rules) if places is None else list(places)
    if not problem.spec.choices and stays_in_letters(problem.spec, rules.axes):
        return VariantsInLetters(problem, rules.axes, settle, wanted)
    return Variants(problem, rules.axes, settle, wanted)


def sampled(rules: "VariantRules") -> list[Place] | None:
    """The places that the rules name, or so many as `sample` says, in their order, None where that is all: drawn by a
    hash of the values alone."""
    if rules.places is not None:
        return rules.places
    lengths = [len(next(iter(axis.values()))) for axis in rules.axes]
    if rules.sample is None or rules.sample >= rules.candidates:
        return None
    seed = repr([[(name, [value.expression.text for value in values]) for name, values in axis.items()]
                 for axis in rules.axes]).encode()
    seed, found, count = blake2b(seed).digest(), set(), 0
    while len(found) < rules.sample:
        found.add(int.from_bytes(blake2b(seed + count.to_bytes(8, "big")).digest(), "big") % rules.candidates)
        count += 1
    return [_place(number, lengths) for number in sorted(found)]


def _place(number: int, lengths: list[int]) -> Place:
    """The place with this number, the last axis going first."""
    place = []
    for length in reversed(lengths):
        number, i = divmod(number, length)
        place.append(i)
    return tuple(reversed(place))
