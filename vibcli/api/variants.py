"""Variants of a scene as homework, for Python."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import Diagnostic, SpecError, Where
from vibcli.base.named_tuple import NamedTuple
from vibcli.homework.document import SceneDocument
from vibcli.homework.parts import solve_in_parts

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from vibcli.api.source import SceneSource
    from vibcli.homework.variants import ProblemVariant
    from vibcli.language.given_values import GivenValue
    from vibcli.results.problem import Problem


class HomeworkVariant(NamedTuple):
    """values: {parameter: its value as it is printed}; keys: {quantity: its value in the unit asked, or an expression
    or equation as text}; bands: {quantity: how far a right answer may be off, of coefficients relative, None where it
    is exact}; mistakes: {quantity: {mistake: what it gives}}."""

    values: dict[str, str]
    keys: dict[str, float | str]
    bands: dict[str, float | None]
    mistakes: dict[str, dict[str, float | str]]


class HomeworkVariants(NamedTuple):
    """accepted: the variants that pass all gates; counts: {gate: how many candidates failed it first}; units:
    {quantity: in which unit it is asked, '' of none}; rejected: [(values, gate, reason)] of the other candidates."""

    accepted: list[HomeworkVariant]
    counts: dict[str, int]
    units: dict[str, str]
    rejected: list[tuple[dict[str, str], str, str]]


def variants_of(problem: "Problem", source: "SceneSource", case: str | None,
                settings: dict[str, Any], executor: "Executor | None" = None) -> HomeworkVariants:
    """The HomeworkVariants of a scene, solved by the executor where one is given; SpecError where it says nothing of
    variants."""
    if problem.spec.get("variants") is None or source.node is None:
        raise SpecError([Diagnostic(Where(source.file, 1, 1, 0), "this scene says nothing of variants",
                                    "give values under variants: parameters")])
    found = solve_in_parts(problem, SceneDocument.of(source.node, source.file, case, settings), executor)
    texts = [key.text for key in found.keys]
    rejected = [(_texts(one.values), one.gate, one.reason) for one in found.rejected]
    return HomeworkVariants([_variant(texts, one) for one in found.accepted], found.counts,
                            {key.text: key.unit for key in found.keys}, rejected)


def _variant(texts: list[str], one: "ProblemVariant") -> HomeworkVariant:
    keys, bands, mistakes = {}, {}, {}
    for text, key in zip(texts, one.keys, strict=True):
        is_number = key.value is not None
        keys[text] = key.value if is_number else key.written
        bands[text] = None if key.band is None else key.band.width
        mistakes[text] = {wrong.mistake: wrong.value if is_number else key.said(wrong.value) for wrong in key.wrong}
    return HomeworkVariant(_texts(one.values), keys, bands, mistakes)


def _texts(values: "dict[str, GivenValue]") -> dict[str, str]:
    return {name: value.text for name, value in values.items()}
