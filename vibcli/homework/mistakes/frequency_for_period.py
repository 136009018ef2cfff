"""A frequency for a period: f = 1/T."""

from vibcli.homework.mistakes.mistake import PERIODS, CommonMistake


def _wrong(value: float, head: str, unit: str) -> float | None:
    return 1 / value if head in PERIODS and value else None


MISTAKE = CommonMistake("this is the frequency, the reciprocal of the period", reading=_wrong)
