"""The gates of a variant with its keys: each gives the reason for which it is rejected, None where it passes."""

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from operator import ge, gt, le, lt
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.homework.bands import FIGURES, WIDEST, Band, KeyBand
from vibcli.language.given_values import unit_of_text
from vibcli.notation.numbers import figure, in_figures, plainly

if TYPE_CHECKING:
    from vibcli.homework.keys import AnswerKey
    from vibcli.language.reader import Expression
    from vibcli.reader.sections.variants import Requirement

HOLDS = {"<": lt, "<=": le, ">": gt, ">=": ge}
LEAST, MOST = 1e-3, 1e5     # of a key in its unit
BOUND = 0.1                 # of a band: the most that is not known of a key
SAME = 1e-9                 # relative: a mistake that leads to the key itself


class Wrong(NamedTuple):
    """What a mistake gives for a key: its name and the value in the unit of the key, None where it has none; of what is
    no number its terms, or its text."""

    mistake: str
    value: Any


def failed(value: "Callable[[Expression], tuple[float, float]]",
           require: "Sequence[Requirement]") -> "Requirement | None":
    """The first comparison that is not fulfilled; value(expression): (value, relative error bound)."""
    return next((one for one in require if not HOLDS[one.sign](value(one.left)[0], value(one.right)[0])), None)


def missed_by(value: "Callable[[Expression], tuple[float, float]]", one: "Requirement") -> float:
    """By how much the sides of a comparison differ, relative to them."""
    left, right = value(one.left)[0], value(one.right)[0]
    return abs(left - right) / (abs(left) + abs(right))


def unreadable(keys: "Sequence[AnswerKey]", bands: Sequence[KeyBand], found: Sequence[tuple[float, float]],
               given: "Mapping[str, tuple[float, str | None]]") -> str | None:
    """Why keys, (value, error bound) of each, can not be asked for: their size, or what is given or asked beside them;
    given: {what it is: (number, unit)} that the sheet tells, in whatever unit; None of a number in words."""
    for key, hangs_on, (value, error) in zip(keys, bands, found, strict=True):
        if not LEAST <= abs(value) <= MOST:
            return f"{key.text} is {figure(value)} {key.unit}".rstrip() + ": write it in another unit"
        width = hangs_on.width(value, FIGURES[0])
        if error > BOUND * width:
            return f"{key.text} is known to {plainly(error)} {key.unit} only"
        size = abs(value)
        for name, (number, unit) in given.items():
            told, factor = abs(number), _ratio(unit, key.unit)
            if abs(told - size) <= width or (factor and abs(told * factor - size) <= width):
                return f"{key.text} is the given {name}"
    for i, (key, (value, _)) in enumerate(zip(keys, found, strict=True)):
        for other, (its, _) in zip(keys[:i], found, strict=False):
            if other.unit == key.unit and abs(its - value) <= bands[i].width(value, FIGURES[0]):
                return f"{key.text} is {other.text}"
    return None


@lru_cache(maxsize=1000)
def _ratio(unit: str | None, other: str) -> float:
    """What one of a unit is in another; 0 where that is told already, or measures something else."""
    if unit is None or unit == other:
        return 0.0
    its, own = (unit_of_text(text) if text else None for text in (unit, other))
    if (its.dimension if its else {}) != (own.dimension if own else {}):
        return 0.0
    return (its.in_si(1) if its else 1.0) / (own.in_si(1) if own else 1.0)


def told_apart(key: "AnswerKey", hangs_on: KeyBand, value: float,
               wrong: Sequence[Wrong]) -> tuple[Band, str | None]:
    """(Band with the fewest figures that is not too wide and into which no mistake leads, None), or the last one and
    why there is none."""
    for figures in FIGURES:
        found, near = hangs_on.band(value, figures), None
        if found.width > WIDEST * abs(value):
            if key.rtol is not None:
                break
            continue
        near = next((one for one in wrong if one.value is not None and _meet(hangs_on, value, found, one.value)), None)
        if near is None:
            return found, None
        if key.rtol is not None:
            break
    if near is None:
        return found, f"the band of {key.text} is {plainly(100 * found.width / abs(value))} % of it"
    return found, (f"'{near.mistake}' gives {in_figures(near.value, found.figures)} for the "
                   f"{in_figures(value, found.figures)} {key.unit}".rstrip() + f" of {key.text}")


def _meet(hangs_on: KeyBand, value: float, found: Band, wrong: float) -> bool:
    """Does the band of a mistake, rounded likewise, meet that of the key?"""
    apart = abs(wrong - value) - found.width
    return apart <= hangs_on.most(found.figures) * abs(wrong) and apart <= hangs_on.width(wrong, found.figures)


def is_same(value: float, wrong: float) -> bool:
    """Does a mistake lead to the key itself?"""
    return abs(wrong - value) <= SAME * abs(value)
