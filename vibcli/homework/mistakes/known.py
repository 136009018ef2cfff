"""Mistakes of the catalogue as far as they concern a scene and what is asked of it."""

from collections.abc import Callable, Collection, Iterator, Sequence
from importlib import import_module
from itertools import islice
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError, Where
from vibcli.base.named_tuple import NamedTuple
from vibcli.homework.mistakes import FORMULA, MISTAKES, MODEL, READING
from vibcli.homework.mistakes.changed import changed
from vibcli.homework.mistakes.mistake import CommonMistake
from vibcli.language.document.nodes import Mapping, Scalar
from vibcli.language.reader import Expression, Reader
from vibcli.reader.answer_check import check_question
from vibcli.reader.read import read_changed
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.homework.mistakes.mistake import Part
    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem

MOST = 30_000       # scenes with a mistake of the model that are solved, times their coordinates squared


class KnownMistake(NamedTuple):
    """A mistake: its name; its kind, as in the face, or of a file; its sentence; the scene as it takes it, None where
    it changes nothing of it; {what is asked: the wrong expression that it gives instead}; the number that it makes of a
    right one, (value, head, unit) ↦ number or None, where it is one of reading; of: the part of the scene that it
    concerns, '' where it is no one part."""

    name: str
    kind: str
    sentence: str
    problem: "Problem | None" = None
    instead: "dict[str, Expression]" = {}
    reading: "Callable[[float, str, str], float | None] | None" = None
    of: str = ""

    @property
    def told(self) -> str:
        """What the student is told."""
        return f"{self.of}: {self.sentence}" if self.of else self.sentence

    def concerns(self, asked: Expression, unit: str) -> bool:
        """May it give something else for what is asked in a unit?"""
        if self.reading is not None:
            return self.reading(1.0, _head(asked), unit) is not None
        return self.problem is not None or asked.text in self.instead

    def wrong(self, asked: Expression, unit: str, right: float,
              value: Callable[[Expression], float]) -> float | None:
        """What it gives for what is asked, None where it does not concern it; right: the right value in a unit; value:
        that of any expression in the scene that it takes for the right one, in the same unit."""
        if self.reading is not None:
            return self.reading(right, _head(asked), unit)
        instead = self.instead.get(asked.text)
        if instead is None and self.problem is None:
            return None
        return value(instead or asked)


def _head(asked: Expression) -> str:
    return asked.tree.head if isinstance(asked.tree, QuantityRef) else ""


def by_kind(kind: str) -> dict[str, CommonMistake]:
    """{name: CommonMistake} of a kind."""
    return {name: import_module(f"vibcli.homework.mistakes.{name}").MISTAKE
            for name, (its, _) in MISTAKES.items() if its == kind}


def of_catalogue(problem: "Problem", root: "Mapping | None", asked: Sequence[Expression],
                 settings: dict[str, tuple[Any, Any]] | None = None, names: Collection[str] | None = None
                 ) -> Iterator[KnownMistake]:
    """The mistakes that concern a scene; root: its document, None where it is not at hand: then those of the model are
    left out; settings: {parameter: (tree, text)} that replace values of it; names: of those of the model that are
    wanted, where not all are: of all only the first, the fewer the more coordinates the scene has."""
    for name, one in by_kind(READING).items():
        yield KnownMistake(_words(name), READING, one.sentence, reading=one.reading)
    for name, one in by_kind(FORMULA).items():
        if one.single and len(problem.scene.q) != 1:
            continue
        if one.reading is not None:
            yield KnownMistake(_words(name), FORMULA, one.sentence, reading=one.reading)
        elif instead := _formulas(problem.spec, one, asked):
            yield KnownMistake(_words(name), FORMULA, one.sentence, instead=instead)
    if root is None:
        return
    most = MOST * problem.work.patience // max(1, len(problem.scene.coordinates))**2
    for name, one, concerns, part in islice(_ways(problem, names), most if names is None else None):
        scene = _scene(problem, root, settings, part)
        if scene is not None:
            yield KnownMistake(_words(name, concerns), MODEL, one.sentence, scene, of=concerns)


def _words(name: str, concerns: str = "") -> str:
    return name.replace("_", " ") + (f" ({concerns})" if concerns else "")


def _formulas(spec: "Spec", one: CommonMistake, asked: Sequence[Expression]) -> dict[str, Expression]:
    """{what is asked: the wrong expression} of those that a formula concerns."""
    found = {}
    for expression in asked:
        tree = expression.tree
        text = one.formula(tree) if isinstance(tree, QuantityRef) else None
        if text is not None:
            reader = Reader(members=spec.members)
            scalar = Scalar(text, Where("mistake", 1, 1, len(text)))
            wrong = check_question(spec, reader, Expression(scalar, reader.at_places(parse(text))))
            if not reader.diagnostics:
                found[expression.text] = wrong
    return found


def _ways(problem: "Problem", names: Collection[str] | None) -> "Iterator[tuple[str, CommonMistake, str, Part]]":
    """(name, mistake, what it concerns, the part of the scene as it takes it) of each way to make one of the model."""
    for name, one in by_kind(MODEL).items():
        if names is not None and all(wanted.partition(" (")[0] != _words(name) for wanted in names):
            continue
        try:
            ways = list(one.model(problem))
        except (SpecError, PhysicsError):
            continue
        for concerns, part in ways:
            if names is None or _words(name, concerns) in names:
                yield name, one, concerns, part


def _scene(problem: "Problem", root: Mapping, settings: dict[str, tuple[Any, Any]] | None,
           part: "Part") -> "Problem | None":
    """The scene with a part as a mistake takes it, None where it is none."""
    try:
        spec = read_changed(*changed(root, part), problem.spec.file, "", settings, True, problem.spec)
        found = problem.with_spec(spec)
        found.draw()
    except (SpecError, PhysicsError):
        return None
    return found
