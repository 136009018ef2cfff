"""Known mistakes of a file: scenes with a part changed, and wrong values by other quantities."""

from typing import TYPE_CHECKING, NamedTuple

from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic, SpecError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.homework.document import SceneDocument
    from vibcli.homework.keys import AnswerKey
    from vibcli.language.reader import Expression
    from vibcli.reader.variants import VariantRules
    from vibcli.results.problem import Problem


class KnownMistake(NamedTuple):
    """A mistake: its name; the scene as it takes it, None where it changes nothing of it; {what is asked: the wrong
    expression that it gives instead}."""

    name: str
    problem: "Problem | None"
    instead: "dict[str, Expression]"

    def concerns(self, key: "AnswerKey") -> bool:
        """Does it change the value of a key?"""
        return self.problem is not None or key.text in self.instead

    def value(self, problem: "Problem", key: "AnswerKey") -> float:
        """What it gives for a key in a scene."""
        return key.value(problem, self.instead.get(key.text))[0]


def mistakes_of(problem: "Problem", rules: "VariantRules", document: "SceneDocument",
                keys: "Sequence[AnswerKey]") -> list[KnownMistake]:
    """The KnownMistakes that a file names; document: that of the scene. SpecError where one is no scene."""
    found = []
    for name, part in rules.mistakes.items():
        spec = document.changed(part, f" (in the mistake {quoted(name)})")
        instead = {answer.asked.text: answer.expected for answer in spec.answers}
        for text, expected in instead.items():
            if text not in [key.text for key in keys]:
                raise SpecError([Diagnostic(expected.where, f"{quoted(text)} is not asked (in the mistake "
                                            f"{quoted(name)})", f"asked are {', '.join(key.text for key in keys)}")])
        changed = problem.with_spec(spec) if set(part.entries) - {"answers"} else None
        found.append(KnownMistake(name, changed, instead))
    return found
