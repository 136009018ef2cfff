"""The program's own answer, with the bound that it states."""

from collections.abc import Iterator

from vibcli.evidence.subject import MethodRun, Subject


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """One, without a setting."""
    yield MethodRun("vibcli", "", lambda _: subject.ours())
