"""A period for a frequency: T = 1/f = 2π/ω."""

from math import tau

from vibcli.homework.mistakes.mistake import FREQUENCIES, RATES, CommonMistake


def _wrong(value: float, head: str, unit: str) -> float | None:
    if head in RATES and value:
        return tau / value
    return 1 / value if head in FREQUENCIES and value else None


MISTAKE = CommonMistake("this is the period, the reciprocal of the frequency", reading=_wrong)
