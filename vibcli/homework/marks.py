"""Marks: answers of students against the keys of a manifest, each with the mistake that it shows."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.base.spelling import nearest
from vibcli.homework import MISSING, RIGHT, UNREADABLE, WRONG
from vibcli.homework.given_answers import GivenAnswer, read_answer, without_name
from vibcli.homework.reasons import of_number
from vibcli.notation.as_printed import as_printed
from vibcli.notation.numbers import figure

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator

    from vibcli.homework.handout import Handout
    from vibcli.results.problem import Problem

CYCLES, RADIANS = "Hz", "rad"       # are read as numbers of the unit that is asked: one for the other is a mistake
DIGITS = 3, 6, 10, 17   # as many as tell what is off from what is allowed
COARSE = 0.01           # of an answer: half of its last figure, beyond which it tells nothing


class AnswerMark(NamedTuple):
    """The mark of one answer: whose, for which problem and quantity; the answer as written; points of how many; the
    verdict; the mistake that it shows, '' of none; what to say, which tells no key; of a number how far it is from its
    key, how far it may be, and the unit of both."""

    student: str
    problem: str
    quantity: str
    answer: str
    points: float
    of: float
    verdict: str
    mistake: str = ""
    said: str = ""
    off: float | None = None
    band: float | None = None
    unit: str = ""

    @property
    def far(self) -> str:
        """How far a wrong number lies from its key, and how far it may, in words; '' of others."""
        if self.off is None or self.band is None or abs(self.off) <= self.band:
            return ""
        texts = [(figure(abs(self.off), digits=digits), figure(self.band, digits=digits)) for digits in DIGITS]
        off, band = next((pair for pair in texts if pair[0] != pair[1]), texts[-1])
        return f"off by {'−' if self.off < 0 else '+'}{off} {as_printed(self.unit)}".rstrip() + f", allowed ± {band}"


class Marker:
    """Marks by a manifest."""

    def __init__(self, manifest: Mapping[str, Any]):
        self._problems = {one["name"]: one for one in manifest["problems"]}
        self._keys = {(one["name"], variant["variant"]): variant["keys"] for one in manifest["problems"]
                      for variant in one["variants"]}
        self._handouts: dict[str, Handout] = {}
        self._sheets = {student["id"]: {one["problem"]: one["variant"] for one in student["sheets"]}
                        for student in manifest["students"]}

    def sheet(self, student: str) -> dict[str, int]:
        """{problem: variant} of a student; ValueError where there is none."""
        if student not in self._sheets:
            raise _unknown(f"the manifest has no student '{student}'", student, self._sheets)
        return self._sheets[student]

    def problem(self, student: str, name: str | None) -> str:
        """The name of a problem of a student's sheet, the only one where none is named; ValueError likewise."""
        sheet = self.sheet(student)
        if name is None and len(sheet) > 1:
            raise ValueError(f"the sheet of {student} has several problems: say which of {', '.join(sheet)}")
        found = next(iter(sheet)) if name is None else name
        if found not in sheet:
            raise _unknown(f"the sheet of {student} has no problem '{found}'", found, sheet)
        return found

    def quantity(self, problem: str, text: str) -> str:
        """The text of a quantity that a problem asks, blanks apart; ValueError where it asks none such."""
        asked = [key["quantity"] for key in self._keys[next(pair for pair in self._keys if pair[0] == problem)]]
        plain: dict[str, str] = {"".join(one.split()): one for one in asked}
        if "".join(text.split()) not in plain:
            raise _unknown(f"'{problem}' does not ask for '{text.strip()}'", text.strip(), asked)
        return plain["".join(text.split())]

    def marks(self, student: str, problem: str, answers: Mapping[str, str]) -> "Iterator[AnswerMark]":
        """The AnswerMark of each quantity that a problem asks; answers: {quantity: text}."""
        variant = self.sheet(student)[problem]
        for key in self._keys[problem, variant]:
            text = answers.get(key["quantity"], "").strip()
            read = self._marked(problem, variant, key, without_name(text, key["quantity"]).strip())
            yield AnswerMark(student, problem, key["quantity"], text, *read)

    def _marked(self, problem: str, variant: int, key: Mapping[str, Any], text: str) -> tuple[Any, ...]:
        """What an AnswerMark has behind the answer, the last three of a number alone."""
        most = key["points"]
        if not text:
            return 0.0, most, MISSING
        if "value" in key:
            return self._number_marked(problem, key, text)
        from vibcli.homework.marked_expressions import marked

        verdict, mistake, said = marked(self._scene(problem, variant), key, text)
        return most * (verdict == RIGHT), most, verdict, mistake, said or self._sentence(problem, mistake)

    def _number_marked(self, problem: str, key: Mapping[str, Any], text: str) -> tuple[Any, ...]:
        given, most = read_answer(text, key["unit"]), key["points"]
        if given.value is None:
            return 0.0, most, UNREADABLE, "", given.reason
        verdict, mistake, said = judged(given, text, key)
        far = given.value - key["value"], key["band"], key["unit"]
        return most * (verdict == RIGHT), most, verdict, mistake, said or self._sentence(problem, mistake), *far

    def _sentence(self, problem: str, mistake: str) -> str:
        found: str = self._problems[problem]["mistakes"].get(mistake, "")
        return found

    def _scene(self, name: str, variant: int) -> "Problem":
        """The scene of a variant, read anew from what is printed, once."""
        from vibcli.homework.handed_out import handout_of

        if name not in self._handouts:
            self._handouts[name] = handout_of(self._problems[name])
        return self._handouts[name].problem(variant - 1)


def judged(given: GivenAnswer, text: str, key: Mapping[str, Any]) -> tuple[str, str, str]:
    """(verdict, the mistake that it shows or '', where it shows none why it is wrong) of a number that was read from a
    text."""
    value, right, band = given.value, key["value"], key["band"]
    unit = f"in {key['unit']}" if key["unit"] else "without a unit"
    other = f"the number is right {unit}, but {given.unit} is written"
    if is_within(value, right, band):
        is_other = _counts(given.unit) | _counts(key["unit"]) == {CYCLES, RADIANS}
        return (WRONG, "", other) if is_other else (RIGHT, "", "")
    half = given.half if given.half <= COARSE * abs(value) else 0.0
    if is_within(value, right, half):
        return WRONG, "", f"right as far as it goes, but {key['figures']} figures are asked"
    if (mistake := mistake_near(value, half, key)) is not None:
        return WRONG, mistake, ""
    if given.unit and is_within(read_answer(text, given.unit).value, right, band):
        return WRONG, "", other
    return WRONG, "", of_number(value, right, band)


def _counts(unit: str) -> set[str]:
    """What a unit of frequency counts: nothing where it does not say so, as 1/s."""
    return {what for what in (CYCLES, RADIANS) if what in unit}


def _unknown(message: str, word: str, words: "Collection[str]") -> ValueError:
    """A ValueError with the word that was meant, where one is near."""
    hint = nearest(word, words)
    return ValueError(f"{message}; {hint}" if hint else message)


def is_within(value: float, key: float, band: float) -> bool:
    """Does an answer lie in the band of a key? Its edges count, but for rounding."""
    return abs(value - key) <= reach(key, band)


def reach(key: float, band: float) -> float:
    """How far a band reaches, with what rounding may do to its edges."""
    return band * (1 + 1e-12) + 1e-15 * abs(key)


def mistake_near(value: float, half: float, key: Mapping[str, Any]) -> str | None:
    """The name of the mistake to which an answer comes nearest, by the band of the key or half of its own last figure;
    None where it comes to none."""
    near: list[tuple[float, int, str]] = []
    for number, one in enumerate(key["mistakes"]):
        width = key["band"] * abs(one["value"] / key["value"]) if key["value"] else key["band"]
        if is_within(value, one["value"], max(width, half)):
            near.append((abs(value - one["value"]), number, one["name"]))
    return min(near)[2] if near else None


def total(marks: Sequence[AnswerMark]) -> tuple[float, float]:
    """(points, of how many)."""
    return sum(one.points for one in marks), sum(one.of for one in marks)

