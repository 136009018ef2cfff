"""Units meant by words that stand where one is due and are none: kgs, Nm, hours, t."""

from vibcli.base.units import UNITS


def unit_meant(word: str) -> str:
    """The unit, or product of units, that a word most likely stands for; None where it is like none."""
    from difflib import get_close_matches

    one = word.removesuffix("s")
    if len(word) > 2 and one in UNITS:
        return one
    split = [f"{word[:i]}*{word[i:]}" for i in range(1, len(word)) if word[:i] in UNITS and word[i:] in UNITS]
    if word in TAKEN:
        return TAKEN[word]
    found = split or spelt_otherwise(word) or get_close_matches(word, UNITS, 1)
    return found[0] if found else None


def spelt_otherwise(word: str) -> list[str]:
    """The units that a word is when it is written in other letters, or in full: KN, seconds."""
    one = word.removesuffix("s").lower()
    return [unit for unit in UNITS if unit.lower() == word.lower()] or ([_SPELT[one]] if one in _SPELT else [])


TAKEN = {"t": "tonne", "d": "day"}     # what books write so is the time and a deflection here
_SPELT = {"meter": "m", "metre": "m", "centimeter": "cm", "millimeter": "mm", "kilogram": "kg", "gram": "g",
          "second": "s", "sec": "s", "minute": "min", "newton": "N", "kilonewton": "kN", "joule": "J", "pascal": "Pa",
          "hertz": "Hz", "degree": "deg", "radian": "rad", "percent": "%", "inch": "in", "foot": "ft", "feet": "ft",
          "pound": "lb", "ounce": "oz", "yard": "yd", "mile": "mi", "hour": "h", "hr": "h", "kph": "km/h",
          "kmh": "km/h", "kmph": "km/h", "revolution": "rev", "turn": "rev", "ton": "tonne", "watt": "W",
          "horsepower": "hp"}
