"""The mistakes that a problem knows: those of its file, and those of the catalogue that concern it."""

from collections.abc import Collection, Iterator, Sequence
from typing import TYPE_CHECKING

from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic, SpecError
from vibcli.base.spelling import nearest
from vibcli.homework.document import parameters_of
from vibcli.homework.mistakes import MISTAKES
from vibcli.homework.mistakes.known import KnownMistake, of_catalogue
from vibcli.homework.wording import name_in_words
from vibcli.language.document.nodes import Mapping, Scalar
from vibcli.language.given_values import giver, number_and_unit

if TYPE_CHECKING:
    from vibcli.homework.document import SceneDocument
    from vibcli.homework.keys import AnswerKey
    from vibcli.language.given_values import GivenValue
    from vibcli.reader.variants import VariantRules
    from vibcli.results.problem import Problem

OF_FILE = "file"


def mistakes_of(problem: "Problem", rules: "VariantRules", document: "SceneDocument",
                keys: "Sequence[AnswerKey]", names: Collection[str] | None = None) -> list[KnownMistake]:
    """The KnownMistakes of a problem; document: that of the scene; names: of those that are wanted, where not all are.
    SpecError where one of the file is no scene, or none of the catalogue."""
    for name, part in rules.mistakes.items():
        if isinstance(part, Scalar) and name.replace(" ", "_") not in MISTAKES:
            said = f"there is no known mistake {quoted(name)} to be switched off"
            raise SpecError([Diagnostic(rules.mistakes.place(name), said,
                                        nearest(name, [one.replace("_", " ") for one in MISTAKES]))])
    catalogue = of_catalogue(problem, document.root, [key.asked for key in keys], document.settings, names)
    own = list(_of_file(problem, rules, document, keys, names))
    return own + [one._replace(of=one.of and name_in_words(problem.spec, one.of)) for one in catalogue
                  if not {one.name, one.name.partition(" (")[0]} & set(rules.mistakes)]


def own_values(mistake: KnownMistake, rules: "VariantRules") -> "dict[str, GivenValue]":
    """{varied parameter: its value} of those to which a mistake of the file gives a value of its own, the same in all
    variants; SpecError where that is no number."""
    part = rules.mistakes.get(mistake.name)
    if mistake.problem is None or not isinstance(part, Mapping):
        return {}
    varied = {name for axis in rules.axes for name in axis}
    return {name: _number(mistake, name) for name in sorted(parameters_of(part) & varied)}


def held_at(rules: "VariantRules", values: "dict[str, GivenValue]") -> "VariantRules":
    """The same grid, in which some parameters have one value at all places."""
    return rules._replace(axes=[{name: [values[name]] * len(given) if name in values else given
                                 for name, given in axis.items()} for axis in rules.axes])


def _number(mistake: KnownMistake, name: str) -> "GivenValue":
    value = mistake.problem.spec.parameters[name]["value"]
    found = number_and_unit(value)
    if found is None:
        raise SpecError([Diagnostic(value.where, f"{quoted(name)} is varied, and the mistake {quoted(mistake.name)} "
                                    "gives it no number", "write what is wrong where it is used")])
    number, unit = found
    return giver(unit, name)(number)


def _of_file(problem: "Problem", rules: "VariantRules", document: "SceneDocument", keys: "Sequence[AnswerKey]",
             names: Collection[str] | None) -> Iterator[KnownMistake]:
    for name, part in rules.mistakes.items():
        if isinstance(part, Scalar) or (names is not None and name not in names):
            continue
        spec = document.changed(part, f" (in the mistake {quoted(name)})")
        instead = {answer.asked.text: answer.expected for answer in spec.answers}
        asked = [key.text for key in keys]
        for answer in spec.answers:
            if answer.asked.text not in asked:
                raise SpecError([Diagnostic(answer.asked.where, f"{quoted(answer.asked.text)} is not asked (in the "
                                            f"mistake {quoted(name)})", f"asked are {', '.join(asked)}")])
        scene = problem.with_spec(spec) if set(part.entries) - {"answers"} else None
        known = KnownMistake(name, OF_FILE, name, scene, instead)
        own_values(known, rules)        # refused before anything is solved
        yield known
