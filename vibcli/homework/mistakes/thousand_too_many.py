"""A prefix of a thousandth for the unit itself: mm for m."""

from vibcli.homework.mistakes.mistake import UNPREFIXED, CommonMistake


def _wrong(value: float, head: str, unit: str) -> float | None:
    return 1e3 * value if unit not in UNPREFIXED else None


MISTAKE = CommonMistake("this is a thousand times too much: mind the prefix of the unit", reading=_wrong)
