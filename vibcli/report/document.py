"""The report about one problem: sections of blocks, each computed when it is added, and only if it was asked for.

A section is a generator of the same name in the file that sections.SECTIONS gives; blocks.py tells how one is written.
"""

import re
from collections.abc import Iterator, Sequence
from functools import cached_property
from importlib import import_module
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.notation.names import NAMED
from vibcli.reader.read import QUOTE
from vibcli.report.blocks import Document, Name, Section, explained, maths
from vibcli.report.sections import SECTIONS
from vibcli.report.wanted import Wanted
from vibcli.symbolic.parser import plain_name

if TYPE_CHECKING:
    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem

EVERYTHING = ("given", "chosen", "coordinates", "equilibrium", "virtual_work", "energies", "equations", "matrices",
              "accelerations", "frequency_equation", "frequencies", "damping", "modes", "free_motion", "kept_up")

# sections of formulas, in which the numbers of the file keep their units; of modes they tell none beside members
MEASURED = {"equilibrium", "reactions", "virtual_work", "energies", "equations", "matrices"}
OF_MODES = {"frequencies", "damping", "modes"}

NO_BREAK = "\N{NO-BREAK SPACE}"        # between a number and its unit


class Report:
    """Sections about one problem, `pictures` with pictures. `roots`: {sum: symbol} of the lengths that have a symbol
    so far."""

    refusal: PhysicsError

    def __init__(self, problem: "Problem", normalise: str = "first", pictures: bool = False,
                 wanted: Wanted | None = None) -> None:
        self.problem, self.normalise, self.pictures = problem, normalise, pictures
        self.sections, self.roots, self.refusal = [], {}, None
        self.wanted = wanted or Wanted()

    def add(self, name: Any) -> None:
        """Add a section; where the scene has no such answer the first refusal is kept, and the others are found."""
        if name == "chosen" and self.problem.choice is None:
            return
        write = getattr(import_module(f"vibcli.report.sections.{SECTIONS[name][0]}"), name)
        measured = name in MEASURED or (name in OF_MODES and not self.problem.scene.pieces)
        problem = self.measured if measured else self.problem
        try:
            for found in write(problem, self):
                self.sections.append(explained(found))
        except PhysicsError as error:
            self.refusal = self.refusal or error
        if "measured" in vars(self) and self.measured is not self.problem:
            self.problem.costs.update({**self.measured.costs, **self.problem.costs})

    @cached_property
    def measured(self) -> "Problem":
        """The problem in whose formulas the numbers of the file keep their units."""
        if not self.problem.scene.table.hidden:
            return self.problem
        from vibcli.report.measured import with_units

        return with_units(self.problem)

    def tells(self, title: str) -> bool:
        """Is there a section of this title?"""
        return any(section.title == title for section in self.sections)

    def append(self, sections: Sequence[Section]) -> None:
        """Add sections that are written."""
        self.sections.extend(sections)

    def without_refusal(self) -> PhysicsError:
        """The refusal, which is said elsewhere and counts no longer."""
        found, self.refusal = self.refusal, None
        return found

    def document(self, case: str | None = None, question: bool = True) -> Document:
        """All of it under the title of the scene; with its question and source where that is asked for."""
        spec, told = self.problem.spec, question and not case
        return Document(title_of(spec, case), (told and spec.get("source")) or None,
                        tuple(_quoting(spec, spec.get("question") or "")) if told else (), tuple(self.sections))


def title_of(spec: "Spec", case: str | None) -> str:
    title = spec.get("title") or spec.file
    return f"{title} — case {case}" if case else title


def _quoting(spec: "Spec", text: str) -> Iterator[Any]:
    """The words of a question, its quoted parameters as their values, on one line with their units, or symbols."""
    from vibcli.report.sections.parameters import as_given

    words = re.split(QUOTE, text)
    for i, part in enumerate(words):
        if i % 2 == 0:
            part = re.sub(r"\s+", " ", part)
            part = part.lstrip() if i == 0 else part
            part = part.rstrip() if i == len(words) - 1 else part
            yield from _with_symbols(part, (*spec.parameters, *spec.coordinates))
            continue
        record = spec.parameters[plain_name(part)]
        known = "value" in record and plain_name(part) not in spec.choices
        found = as_given(record["value"], frozenset(spec.parameters)) if known else maths(Name(plain_name(part)))
        yield found.replace(" ", NO_BREAK) if isinstance(found, str) else found


def _with_symbols(text: str, names: tuple[str, ...]) -> Iterator[str]:
    """Words with the names of the scene that have symbols, as phi1 and k2, by these; powers and products in print."""
    from vibcli.notation.plain import plain

    words = ""
    for i, word in enumerate(NAMED.split(text)):
        if i % 2 and word.rstrip("'") in names and plain.symbol(word) != word:
            yield from filter(None, (_in_print(words), maths(Name(word))))
            words = ""
        else:
            words += word
    yield from filter(None, (_in_print(words),))


def _in_print(words: str) -> str:
    from vibcli.notation.numbers import NEGATIVE
    from vibcli.notation.typed_values import SUPERSCRIPT

    words = re.sub(r"\bpi\b", "π", words)
    words = re.sub(r"\^(-?\d+)(?!\d|\.\d|/\d)", lambda found: found[1].translate(SUPERSCRIPT), words)
    return re.sub(r"(?<=\w)\*(?=\w)", "·", NEGATIVE.sub("−", words)).replace("sqrt(", "√(")
