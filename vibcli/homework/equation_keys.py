"""Keys that are equations with numbers: equal up to a factor, each coefficient in its band."""

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.check.verdicts import expected_node, verdicts_of
from vibcli.homework.bands import FIGURES, WIDEST, Band
from vibcli.homework.formula_keys import AS_EQUATION
from vibcli.homework.gates import BOUND, Wrong
from vibcli.homework.in_letters import answer_of, put_in
from vibcli.homework.keys import ROUTES, AnswerKey
from vibcli.homework.terms import OF_NUMBERS, alike, terms, terms_of
from vibcli.notation.as_printed import as_printed
from vibcli.notation.numbers import in_figures, plainly
from vibcli.notation.plain import plain
from vibcli.reader.sections.answer import Answer

if TYPE_CHECKING:
    from vibcli.homework.bands import KeyBand
    from vibcli.homework.mistakes.known import KnownMistake
    from vibcli.homework.terms import Terms
    from vibcli.results.problem import Problem


class EquationValue(NamedTuple):
    """The key of a variant that is an equation: its terms, within which relative Band each coefficient may lie, what
    mistakes give, likewise terms."""

    terms: "Terms"
    band: Band
    wrong: tuple[Wrong, ...]

    @property
    def value(self) -> None:
        """It is no number."""
        return None

    @property
    def written(self) -> str:
        return self.said(self.terms)

    @property
    def figures(self) -> str:
        """To how many its coefficients are asked."""
        return str(self.band.figures)

    @property
    def spread(self) -> str:
        """How far each coefficient may be off."""
        return f"± {plainly(100 * self.band.width)} % each"

    @property
    def hidden(self) -> tuple[str, ...]:
        """Texts that no sheet may tell."""
        return self.written,

    def said(self, value: "Terms") -> str:
        """An equation with its coefficients to the figures that are asked."""
        return equation_text(value, lambda number: in_figures(number, self.band.figures))

    def data(self) -> dict[str, Any]:
        """What a manifest keeps of it."""
        return {"terms": self.terms, "figures": self.band.figures, "band": self.band.width,
                "mistakes": [{"name": one.mistake, "terms": one.value} for one in self.wrong]}


class EquationKey(AnswerKey):
    """An equation that is asked of a scene with numbers: found as its terms."""

    __slots__ = ()

    @property
    def form(self) -> str:
        """How an answer is written, in a sentence."""
        return AS_EQUATION

    def printed(self, problem: "Problem", written: str) -> str:
        """The key, or what a mistake makes of it, as it is set in print."""
        moving = re.sub(r"\b[^\W\d]\w*'+", lambda found: plain.symbol(found[0]), written)
        return as_printed(moving, (*problem.scene.coordinates, *problem.spec.parameters))

    def found(self, problem: "Problem") -> "Terms":
        """What a scene answers."""
        return terms_of(problem, self.asked)

    def hangs_on(self, problem: "Problem", name: str, moved: "Problem | None") -> bool:
        """Does it change with a parameter, which has another value in the scene `moved`?"""
        return moved is None or not alike(self.found(problem), self.found(moved), ROUTES)

    def mistaken(self, mistake: "KnownMistake", scene: "Problem", found: "Terms") -> "Terms | None":
        """What a mistake gives, None where it does not concern it."""
        instead = mistake.instead.get(self.text)
        try:
            if instead is not None:
                return terms(scene, put_in(scene, expected_node(scene, instead)))
            return None if mistake.problem is None else self.found(scene)
        except (SpecError, PhysicsError):
            return None

    def equal(self, problem: "Problem", found: "Terms", wrong: "Sequence[Terms]", instances: Any = None) -> list[bool]:
        """Does each of what mistakes give equal the key?"""
        return [alike(found, one, ROUTES) for one in wrong]

    def is_mistaken_so(self, problem: "Problem", one: EquationValue, wrong: "Terms", again: "Terms") -> bool:
        """Is what a mistake gives, as a key has it, what it gives again, within a tenth of the bands?"""
        return alike(wrong, again, BOUND * one.band.width)

    def settled(self, hangs_on: "KeyBand", found: "Terms", wrong: tuple[Wrong, ...],
                equal: list[bool]) -> tuple[EquationValue, str | None]:
        """(the key with the fewest figures in which no mistake leads into its bands, None), or why there is none."""
        reason = None
        for figures in FIGURES:
            band = hangs_on.band(1.0, figures)
            if band.width > WIDEST:
                return EquationValue(found, band, wrong), f"the band of {self.text} is wider than {WIDEST:.0%}"
            near = next((one.mistake for one in wrong if alike(found, one.value, 2 * band.width)), None)
            reason = near and f"'{near}' gives {self.text} within its bands"
            if near is None or self.rtol is not None:
                break
        return EquationValue(found, band, wrong), reason

    def require_same(self, fresh: "Problem", one: EquationValue, at: str) -> None:
        """RuntimeError, a fault of ours, where a scene read anew does not give the key, or `check` does not agree; at:
        the values in words."""
        written = answer_of(equation_text(one.terms, repr), fresh.spec, self.asked)
        verdict, = verdicts_of(fresh, [Answer(self.asked, written, None)])
        if not verdict.agrees or not alike(one.terms, self.found(fresh), ROUTES):
            raise RuntimeError(f"two ways to {self.text} differ, at {at}")


def equation_text(terms: "Terms", number: Any) -> str:
    """The equation of terms in the language of scenes, its coefficients written by `number`."""
    parts = []
    for text, coefficient in terms.items():
        size = number(abs(coefficient)) + (f"*{text}" if text != OF_NUMBERS else "")
        parts.append((" - " if coefficient < 0 else " + ") + size)
    joined = "".join(parts) or "0"
    return (joined[3:] if joined.startswith(" + ") else "-" + joined[3:] if parts else joined) + " = 0"
