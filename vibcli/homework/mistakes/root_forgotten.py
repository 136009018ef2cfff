"""The square of a frequency."""

from vibcli.homework.mistakes.mistake import RATES, CommonMistake


def _wrong(value: float, head: str, unit: str) -> float | None:
    return value**2 if head in RATES else None


MISTAKE = CommonMistake("this is ω²: the root is missing", reading=_wrong)
