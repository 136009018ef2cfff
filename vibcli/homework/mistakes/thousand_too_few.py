"""The unit itself for one with a prefix of a thousandth: m for mm."""

from vibcli.homework.mistakes.mistake import UNPREFIXED, CommonMistake


def _wrong(value: float, head: str, unit: str) -> float | None:
    return value / 1e3 if unit not in UNPREFIXED else None


MISTAKE = CommonMistake("this is a thousandth of it: mind the prefix of the unit", reading=_wrong)
