"""Degrees for radians."""

from math import pi

from vibcli.homework.mistakes.mistake import CommonMistake


def _wrong(value: float, head: str, unit: str) -> float | None:
    return value * 180 / pi if unit == "rad" else None


MISTAKE = CommonMistake("this is in degrees, and radians are asked", reading=_wrong)
