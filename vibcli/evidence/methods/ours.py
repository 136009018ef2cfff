"""The program's own answer, with the bound that it states."""

from collections.abc import Iterator
from functools import partial

from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject

NAME, ACCURACIES = "vibcli", (1e-3, 1e-6, 1e-12)


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """As it is without a setting; of motions that are integrated also less and more accurately."""
    yield MethodRun(NAME, "", lambda _: subject.ours())
    if subject.kind == "full motion" and subject.problem.spec.motion == "full":
        for accuracy in ACCURACIES:
            yield MethodRun(NAME, f"{accuracy:.0e}", partial(_accurately, subject, accuracy))


def _accurately(subject: Subject, accuracy: float, _: Deadline) -> MethodAnswer:
    return subject.ours(accuracy)
