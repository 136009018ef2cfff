"""Keys that stay in letters: expressions, energies and equations, equal where the comparison of `check` says so."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import isclose, log2, pi
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.check.instances import Instances
from vibcli.check.verdicts import expected_node, verdicts_of
from vibcli.homework.gates import Wrong
from vibcli.homework.in_letters import answer_of, expression_of, put_in, text_in_letters, text_of_node
from vibcli.homework.keys import AnswerKey, si_unit
from vibcli.notation.scene_language import language
from vibcli.quantities.quantity import EQUATION, OF_STATE, declared, kind_of
from vibcli.reader.sections.answer import Answer
from vibcli.report.blocks import maths
from vibcli.symbolic.normal_form import is_zero
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.homework.bands import KeyBand
    from vibcli.homework.mistakes.known import KnownMistake
    from vibcli.language.reader import Expression
    from vibcli.report.blocks import Maths
    from vibcli.results.problem import Problem

EXACT = "exact"
IN_LETTERS = "Expressions are written in letters and exact numbers, with * / ^ sqrt( ), each product with its *."
AS_EQUATION = "An equation is written as left = right, with x' and x'' for the derivatives of x by the time."
POWERS_OF_PI = ("", "*pi", "/pi")


class FormulaValue(NamedTuple):
    """The key of a variant that stays in letters, in the language of scenes; what mistakes give, likewise."""

    text: str
    wrong: tuple[Wrong, ...]

    @property
    def value(self) -> None:
        """It is no number."""
        return None

    @property
    def band(self) -> None:
        """It is exact."""
        return None

    @property
    def figures(self) -> str:
        """To how many an answer is asked."""
        return EXACT

    @property
    def spread(self) -> str:
        """How far an answer may be off."""
        return "–"

    @property
    def written(self) -> str:
        return self.text

    @property
    def hidden(self) -> tuple[str, ...]:
        """Texts that no sheet may tell."""
        return self.text,

    def said(self, value: str) -> str:
        """What a mistake makes of it."""
        return value

    def data(self) -> dict[str, Any]:
        """What a manifest keeps of it."""
        return {"formula": self.text, "mistakes": [{"name": one.mistake, "formula": one.value} for one in self.wrong]}


class FormulaKey(AnswerKey):
    """What is asked of a scene in which letters are left: found as a text in the language of scenes."""

    __slots__ = ()

    @property
    def in_letters(self) -> bool:
        """Answers are compared in a scene."""
        return True

    @property
    def form(self) -> str:
        """How an answer is written, in a sentence."""
        tree = self.asked.tree
        return AS_EQUATION if isinstance(tree, QuantityRef) and declared(tree).kind == EQUATION else IN_LETTERS

    def printed(self, problem: "Problem", written: str) -> "Maths":
        """The key, or what a mistake makes of it, as it is set in print."""
        side, equals, right = written.partition(" = ")
        return maths(expected_node(problem, expression_of(side)), equals + right)

    def found(self, problem: "Problem") -> str:
        """What a scene answers."""
        return text_in_letters(problem, self.asked)

    def hangs_on(self, problem: "Problem", name: str, moved: "Problem | None") -> bool:
        """Does it change with a parameter, or does the letter stand in it?"""
        if moved is not None:
            return self.found(problem) != self.found(moved)
        names = answer_of(self.found(problem), problem.spec, self.asked).parts.names
        return name in {one for one, *_ in names}

    def mistaken(self, mistake: "KnownMistake", scene: "Problem", found: str) -> str | None:
        """What a mistake gives, None where it does not concern it or is not found in letters."""
        try:
            if mistake.reading is not None:
                return self._misread(mistake, scene, found)
            instead = mistake.instead.get(self.text)
            if instead is None:
                return None if mistake.problem is None else self.found(scene)
            if instead.tree.kind == "equation":
                return text_of_node(scene, put_in(scene, expected_node(scene, instead)), self.asked)
            return text_in_letters(scene, instead)
        except (SpecError, PhysicsError):
            return None

    def _misread(self, mistake: "KnownMistake", scene: "Problem", found: str) -> str | None:
        """That of reading: a factor and a power of the right expression; None where it is neither."""
        if kind_of(scene.spec, self.asked.tree) in OF_STATE:
            return None
        head = self.asked.tree.head if isinstance(self.asked.tree, QuantityRef) else ""
        unit = si_unit(scene.spec, self.asked)
        one, two, three = (mistake.reading(x, head, unit) for x in (1.0, 2.0, 3.0))
        if not one or two is None or three is None or two / one <= 0:
            return None
        power, factor = round(log2(two / one)), _factor(one)
        if factor is None or not isclose(three, one * 3.0**power, rel_tol=1e-12):
            return None
        text = f"{factor}*({found})^({power})"
        return language(expected_node(scene, answer_of(text, scene.spec, self.asked)))

    def equal(self, problem: "Problem", found: str, wrong: Sequence[str],
              instances: Instances | None = None) -> list[bool]:
        """Does each of what mistakes give equal the key? RuntimeError, a fault of ours, where this is not what numbers
        in place of the letters give."""
        agree = self.agree(problem, [found, *wrong], instances)
        if not agree[0]:
            raise self._differs(found)
        return agree[1:]

    def is_mistaken_so(self, problem: "Problem", one: FormulaValue, wrong: str, again: str) -> bool:
        """Is what a mistake gives, as a key has it, what it gives again?"""
        first, second = (expected_node(problem, answer_of(text, problem.spec, self.asked)) for text in (wrong, again))
        return wrong == again or is_zero(first - second)

    def settled(self, hangs_on: "KeyBand", found: str, wrong: tuple[Wrong, ...],
                equal: list[bool]) -> tuple[FormulaValue, str | None]:
        """(the key, which mistake leads to it or None)."""
        same = next((one.mistake for one, is_same in zip(wrong, equal, strict=True) if is_same), None)
        return FormulaValue(found, wrong), same and f"'{same}' gives {self.text} itself"

    def require_same(self, fresh: "Problem", one: FormulaValue, at: str) -> None:
        """RuntimeError, a fault of ours, where numbers in place of the letters of a scene read anew give another key;
        at: the values in words."""
        if not self.agree(fresh, [one.text])[0]:
            raise self._differs(f"{one.text} at {at}")

    def agree(self, problem: "Problem", texts: Sequence[str], instances: Instances | None = None) -> list[bool]:
        """Does each text equal what is asked?"""
        return agreements(problem, [(self.asked, answer_of(text, problem.spec, self.asked)) for text in texts],
                          instances)

    def _differs(self, found: str) -> RuntimeError:
        return RuntimeError(f"two ways to {self.text} differ: numbers in place of the letters do not give {found}")


def agreements(problem: "Problem", pairs: "Iterable[tuple[Expression, Expression]]",
               instances: Instances | None = None) -> list[bool]:
    """Does each expected expression equal what is asked, as `check` compares them? Sure alone counts."""
    answers = [Answer(asked, expected, None) for asked, expected in pairs]
    return [one.agrees is True for one in verdicts_of(problem, answers, instances=instances)]


def _factor(number: float) -> str | None:
    """A factor as text, a fraction beside a power of π; None of another."""
    for power, text in zip((0, 1, -1), POWERS_OF_PI, strict=True):
        found = Fraction(number / pi**power).limit_denominator(1000)
        if found and isclose(float(found) * pi**power, number, rel_tol=1e-14):
            return f"({found}){text}"
    return None
