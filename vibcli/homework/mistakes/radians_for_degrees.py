"""Radians for degrees."""

from math import pi

from vibcli.homework.mistakes.mistake import CommonMistake


def _wrong(value: float, head: str, unit: str) -> float | None:
    return value * pi / 180 if unit == "deg" else None


MISTAKE = CommonMistake("this is in radians, and degrees are asked", reading=_wrong)
