"""What vibcli finds, with the bound that it states."""

from collections.abc import Iterator

from vibcli.evidence.subject import Attempt, Subject

NAME = "vibcli"


def attempts(subject: Subject) -> Iterator[Attempt]:
    """One, without a setting."""
    yield Attempt(NAME, "", lambda _: subject.ours())
