"""The model of an exported question, from which every format is written: a variant, what is asked of it and told."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from hashlib import blake2b
from math import lcm
from string import ascii_lowercase
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.homework.exports.setting import AsSet, SetInMathML, SetInTeX, html, running
from vibcli.homework.exports.told import ToldBand, bands_told
from vibcli.homework.roster import Student
from vibcli.homework.sheets import student_sheet
from vibcli.homework.wording import quantity_in_words
from vibcli.report.blocks import Picture

if TYPE_CHECKING:
    from vibcli.homework.course import Course
    from vibcli.homework.handout import Handout
    from vibcli.homework.keys import AnswerKey
    from vibcli.report.blocks import Maths, Section

NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_.-]{0,63}")
BY_HAND = "by-hand"
MADE = re.compile(rf".*-{BY_HAND}|q_.*-[0-9a-f]{{8}}", re.IGNORECASE | re.DOTALL)    # names that are given here


class ExportedKey(NamedTuple):
    """What is asked: the letter by which the question names it, how `grade` calls the quantity, what it is in words,
    its unit, the figures that are asked, points, how an answer is written; the right answer as printed for who marks.
    Of a number its value and the ToldBands, else None and none."""

    letter: str
    quantity: str
    about: str
    unit: str
    figures: str
    points: float
    form: str
    answer: "tuple[str | Maths, ...] | AsSet"
    value: float | None
    told: tuple[ToldBand, ...]


class ExportedQuestion(NamedTuple):
    """A variant of a problem, or what of it is marked by hand. item: a name that no other question has, the same when
    it is exported again; group: that of the questions of which a student gets one; problem: its plain name; question:
    words and Maths; given: the values; described: what the figure shows, in words; files: {name: bytes} that it comes
    with; said: {mistake: what the student is told}."""

    item: str
    group: str
    problem: str
    variant: int
    title: str
    by_hand: bool
    question: "tuple[str | Maths, ...] | AsSet"
    given: "tuple[Section, ...] | AsSet"
    figure: Picture | None
    described: str
    files: Mapping[str, bytes]
    keys: tuple[ExportedKey, ...]
    said: Mapping[str, str]
    solution: "tuple[Section, ...] | AsSet"

    @property
    def points(self) -> float:
        return sum(key.points for key in self.keys)

    def as_set(self, settings: Sequence[SetInTeX | SetInMathML]) -> "ExportedQuestion":
        """All but the figure as HTML of some settings; the solution in TeX alone, as others do not show it."""
        def each(write: Callable[..., str], blocks: object,
                 those: Sequence[SetInTeX | SetInMathML] = settings) -> AsSet:
            return AsSet({type(setting): write(blocks, setting) for setting in those})

        in_tex = [setting for setting in settings if isinstance(setting, SetInTeX)]
        keys = tuple(key._replace(answer=each(running, key.answer)) for key in self.keys)
        return self._replace(question=each(running, self.question), given=each(html, self.given), figure=None,
                             keys=keys, solution=each(html, self.solution, in_tex))


def item_of(problem: str, number: int) -> str:
    """The name of a variant, numbered from 0, by which a system and `grade` know it."""
    return f"{plain_name(problem)}-{number + 1}"


def plain_name(name: str) -> str:
    """A name of a problem as all systems take it: letters, digits, _ . and - of ASCII, a letter first. None is the name
    of what is marked by hand of another problem, nor one that was made for another."""
    if NAME.fullmatch(name) and not MADE.fullmatch(name):
        return name
    cleaned = re.sub(r"[^A-Za-z0-9_.-]+", "_", name)[:40]
    return f"q_{cleaned}-{blake2b(name.encode(), digest_size=4).hexdigest()}"


def require_own_names(names: Sequence[str]) -> None:
    """PhysicsError where two problems would have one name in a package, or two that differ in capitals alone."""
    seen: dict[str, str] = {}
    for name in names:
        other = seen.setdefault(plain_name(name).casefold(), name)
        if other != name:
            raise PhysicsError(f"'{other}' and '{name}' would have one name in packages, {plain_name(name)}",
                               "give one of the files another name")


def questions_of(course: "Course", handout: "Handout", number: int) -> Iterator[ExportedQuestion]:
    """What is asked of a variant that a system marks, and what is marked by hand, each where there is any."""
    sheet = student_sheet(course, Student("-"), [(handout, number)])[1]
    *given, _ = sheet.sections[len(handout.figure):]
    problem, data = handout.problem(number), handout.data(number)["keys"]
    keys = [ExportedKey(ascii_lowercase[i], key.text, _about(handout, key), key.unit, one.figures, points, key.form,
                        (key.printed(problem, one.written),), one.value,
                        () if one.value is None else tuple(bands_told(data[i])))
            for i, (key, points, one) in enumerate(zip(handout.keys, handout.points, handout.variants[number].keys,
                                                       strict=True))]
    item, name = item_of(handout.name, number), plain_name(handout.name)
    solution, picture = tuple(handout.solution(number)), picture_of(handout)
    for by_hand in (False, True):
        own = tuple(key for key in keys if (key.value is None) == by_hand)
        if own:
            end = f"-{BY_HAND}" if by_hand else ""
            yield ExportedQuestion(item + end, name + end, name, number + 1, handout.title, by_hand, sheet.question,
                                   tuple(given), picture, _described(picture),
                                   handout.document.files, own, handout.sentences, solution)


def _about(handout: "Handout", key: "AnswerKey") -> str:
    """What is asked, in words, with what `grade` calls it where they do not tell all."""
    words, alone = quantity_in_words(handout.base.spec, key.asked.tree, key.text)
    return words if alone else f"{words}, {key.text}"


def picture_of(handout: "Handout") -> Picture | None:
    """The figure of a problem."""
    return next((block for section in handout.figure for block in section.blocks if isinstance(block, Picture)), None)


def _described(picture: Picture | None) -> str:
    return f"{picture.caption}: {picture.about}" if picture is not None else ""


def told(name: str, said: Mapping[str, str]) -> str:
    """What a student is told of a mistake: its name, and its sentence where that says more."""
    sentence = said.get(name, "")
    return name if sentence in ("", name) else f"{name}: {sentence}"


def whole_weights(points: Sequence[float]) -> list[int]:
    """Whole numbers in the ratio of points, the points themselves where they are whole."""
    exact = [Fraction(one).limit_denominator(1000) for one in points]
    scale = lcm(*(one.denominator for one in exact))
    return [int(one * scale) for one in exact]
