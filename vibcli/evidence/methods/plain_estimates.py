"""Estimates of natural frequencies by their textbook formulas in floats."""

from collections.abc import Iterator

from vibcli.evidence.subject import MethodAnswer, MethodRun, Subject


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """One, without a setting."""
    yield MethodRun("assembled matrices", "", lambda _: MethodAnswer([float(subject.data())]))
