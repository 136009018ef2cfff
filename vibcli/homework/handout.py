"""A problem as it is handed out: its accepted variants, its figure, and each variant read anew for who gets it."""

from collections.abc import Collection, Iterator
from functools import cache, cached_property
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.homework.asked_keys import key_of
from vibcli.homework.leaks import comments_of
from vibcli.homework.told import told
from vibcli.homework.variants import ProblemVariant, SolvedVariants, read_anew
from vibcli.homework.worked_variants import WorkedVariants
from vibcli.report.blocks import Picture
from vibcli.report.document import Report
from vibcli.report.sections.steps import section_of

if TYPE_CHECKING:
    from vibcli.homework.course import CourseProblem
    from vibcli.homework.document import SceneDocument
    from vibcli.homework.keys import AnswerKey
    from vibcli.reader.variants import VariantRules
    from vibcli.report.blocks import Section
    from vibcli.results.problem import Problem


class Handout:
    """A problem of a course. base: the scene as the file has it; variants: {number from 0: ProblemVariant}, of those
    that were handed out where it is known by a manifest; sentences: {mistake: what the student is told}; document,
    text: those of its file; accepted: how many variants it has; ranges: (least, largest) of each key, as told."""

    def __init__(self, course: "CourseProblem", base: "Problem", keys: "list[AnswerKey]",
                 variants: dict[int, ProblemVariant], sentences: dict[str, str], document: "SceneDocument", text: str,
                 accepted: int, ranges: list[tuple[str, str]]):
        self.course, self.base, self.keys, self.variants, self.sentences = course, base, keys, variants, sentences
        self.document, self.text, self.accepted, self.ranges = document, text, accepted, ranges
        self._read: dict[int, Problem] = {}

    @classmethod
    def of(cls, course: "CourseProblem", found: SolvedVariants, document: "SceneDocument", text: str) -> "Handout":
        """That of a problem that was solved."""
        sentences = {one.name: one.told for one in found.mistakes}
        ranges = [("–", "–") if one.first.value is None else (one.low.written, one.high.written)
                  for one in found.summaries]
        return cls(course, found.problem, found.keys, dict(enumerate(found.accepted)), sentences, document, text,
                   len(found.accepted), ranges)

    @classmethod
    def read(cls, course: "CourseProblem", variants: dict[int, ProblemVariant], sentences: dict[str, str],
             document: "SceneDocument", text: str, accepted: int, ranges: list[tuple[str, str]],
             patience: int = 1) -> "Handout":
        """That of a problem that is read from its document."""
        base = document.problem(patience)
        keys = [key_of(base.spec, asked) for asked in base.spec.get("variants").ask]
        return cls(course, base, keys, variants, sentences, document, text, accepted, ranges)

    def __reduce__(self) -> Any:
        return self.read, (self.course, self.variants, self.sentences, self.document, self.text, self.accepted,
                           self.ranges, self.base.work.patience)

    def only(self, numbers: Collection[int]) -> "Handout":
        """That of some of its variants."""
        some = {number: self.variants[number] for number in sorted(numbers)}
        return Handout(self.course, self.base, self.keys, some, self.sentences, self.document, self.text, self.accepted,
                       self.ranges)

    @property
    def name(self) -> str:
        return self.course.name

    @property
    def rules(self) -> "VariantRules":
        found: VariantRules = self.base.spec.get("variants")
        return found

    @property
    def title(self) -> str:
        found: str = self.base.spec.get("title") or self.name
        return found

    @cached_property
    def points(self) -> list[float]:
        """Those of each key: as the problem says, or their shares of what the set gives."""
        own = [key.points for key in self.keys]
        return [float(one) if self.course.points is None else self.course.points * one / sum(own) for one in own]

    @property
    def by_hand(self) -> list[str]:
        """The quantities that are no numbers."""
        found = next(iter(self.variants.values()))
        return [key.text for key, one in zip(self.keys, found.keys, strict=True) if one.value is None]

    @cached_property
    def comments(self) -> list[str]:
        """What its file says behind #, which is for nobody but who wrote it."""
        return comments_of(self.text)

    @cached_property
    def told(self) -> set[str]:
        """The parameters that the question quotes or the figure letters."""
        return told(self.base)

    @cached_property
    def figure(self) -> "list[Section]":
        """The figure in letters, which is the same for all variants."""
        report = Report(self.base, pictures=True)
        report.add("schematic")
        return [section._replace(title="Figure", blocks=tuple(map(_drawn_once, section.blocks)))
                for section in report.sections]

    @cached_property
    def worked(self) -> WorkedVariants:
        """The lines of the worked solutions of its variants."""
        return WorkedVariants(self.document)

    def problem(self, number: int) -> "Problem":
        """The Problem of a variant, read anew from what is printed, once; its mistakes that change the scene were
        solved anew with the variants of the gate, and are one by one with these."""
        if number not in self._read:
            self._read[number] = read_anew(self.document, self.keys, self.variants[number], number)
        return self._read[number]

    def solution(self, number: int) -> "Iterator[Section]":
        """The worked solution of a variant, line by line; where a scene has none, what `solve` tells of it."""
        problem, told = self.problem(number), ("given", "chosen")
        try:
            steps = section_of(self.worked.lines(self.variants[number].values))
        except PhysicsError:
            told, steps = SOLUTION, ()
        report = Report(problem)
        for name in told:
            report.add(name)
        yield from (*report.sections, *steps)

    def data(self, number: int) -> dict[str, Any]:
        """What a manifest keeps of a variant: its values, keys, bands and mistakes."""
        variant = self.variants[number]
        keys = [{"quantity": key.text, "unit": key.unit, "points": points, **one.data()}
                for key, points, one in zip(self.keys, self.points, variant.keys, strict=True)]
        return {"variant": number + 1, "values": {name: value.text for name, value in variant.values.items()},
                "keys": keys}


def _drawn_once(block: object) -> object:
    """A picture whose bytes are made once, however many sheets show it."""
    return block._replace(draw=cache(block.draw), caption="not to scale") if isinstance(block, Picture) else block


SOLUTION = ("given", "chosen", "coordinates", "equilibrium", "energies", "equations", "matrices", "frequencies",
            "damping", "modes", "kept_up")
