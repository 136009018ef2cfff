"""What a check found of a file, as data that processes exchange and the cache keeps."""

from collections.abc import Sequence
from typing import Any

from vibcli.base.errors import Diagnostic, Remark, Where
from vibcli.base.named_tuple import NamedTuple
from vibcli.base.rules import DOUBTFUL, FAULT


class Trouble(NamedTuple):
    """One thing that keeps a file, or answers of it, from being checked, by its rule; place: its file, line, column and
    width, a width of 0 being the file as a whole, None where there is none; source: the text of its line, None where it
    has none; of_answers: do answers tell it too?"""

    rule: str
    message: str
    hint: str | None
    place: tuple[str, int, int, int] | None
    source: str | None = None
    of_answers: bool = False

    @property
    def diagnostic(self) -> Diagnostic:
        """As it is printed."""
        kind = Remark if self.rule == DOUBTFUL else Diagnostic
        return kind(None if self.place is None else Where(*self.place), self.message, self.hint)


class CheckedAnswer(NamedTuple):
    """One answer: data, the keys of --json; rule: what is wrong, '' where it agrees; place (line, column, width) of
    what is expected; name, with its case; said: what there is to say of it; estimated: is its error an estimate?"""

    data: dict[str, Any]
    rule: str
    place: tuple[int, int, int]
    name: str
    said: str
    estimated: bool


class CheckedFile(NamedTuple):
    """What is known of a file that was checked: its exit code, could it not be checked? its answers and troubles; the
    fault of ours that kept it from being checked; was it in the cache? seconds that it took."""

    file: str
    code: int
    failed: bool
    answers: Sequence[CheckedAnswer] = ()
    troubles: Sequence[Trouble] = ()
    fault: str = ""
    cached: bool = False
    seconds: float = 0.0

    @property
    def failures(self) -> int:
        """How many answers do not agree, 1 at least where the file could not be checked."""
        return max(sum(bool(one.rule) for one in self.answers), int(self.failed))


class Finding(NamedTuple):
    """What the forms for other programs tell: rule, message, file, line, column (0 of a file as a whole), width; the
    name of the answer, '' of what is no answer."""

    rule: str
    message: str
    file: str
    line: int
    column: int
    width: int
    name: str = ""


def findings(found: CheckedFile) -> list[Finding]:
    """All that is wrong with a file, in the order in which it is told."""
    told = [Finding(FAULT, found.fault, found.file, 1, 0, 0)] if found.fault else []
    for trouble in found.troubles:
        if not trouble.of_answers:
            file, line, column, width = trouble.place or (found.file, 1, 1, 0)
            message = trouble.message + (f" (hint: {trouble.hint})" if trouble.hint else "")
            told.append(Finding(trouble.rule, message, file, line, column if width else 0, width))
    return told + [Finding(one.rule, f"{one.name}: {one.said}", found.file, *one.place, one.name)
                   for one in found.answers if one.rule]
