"""Numbers on a sheet that by chance are keys of it, of the same problem or another: who would get them gets another
variant."""

import re
import unicodedata
from typing import TYPE_CHECKING

from vibcli.homework.leaks import numbers_in
from vibcli.reader.read import QUOTE

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from vibcli.homework.handout import Handout

Told = tuple[tuple[float, float], ...]


class Coincidences:
    """What sheets tell of variants, each looked at once."""

    def __init__(self) -> None:
        self._known: dict[tuple[str, int], tuple[Told, tuple[float, ...]]] = {}

    def found(self, words: str, taken: "Iterable[tuple[Handout, int]]", handout: "Handout", number: int) -> bool:
        """Would a sheet with these words and problems tell a key of a variant, or this one a key of its own or of
        theirs?"""
        told, keys = self._variant(handout, number)
        if _meet(_numbers(words), keys) or _meet(told, keys):
            return True
        return any(_meet(theirs, keys) or _meet(told, their_keys)
                   for theirs, their_keys in (self._variant(*one) for one in taken))

    def _variant(self, handout: "Handout", number: int) -> tuple[Told, tuple[float, ...]]:
        """(the numbers that a sheet tells of a variant, its keys)."""
        if (handout.name, number) not in self._known:
            spec, variant = handout.base.spec, handout.variants[number]
            given = {name: record["value"].text for name, record in spec.parameters.items() if "value" in record}
            given |= {name: value.text for name, value in variant.values.items()}
            words = re.sub(QUOTE, " ", f"{handout.title} {spec.get('question', '')}")
            self._known[handout.name, number] = _numbers(f"{words} {' ; '.join(given.values())}"), tuple(
                key.value for key in variant.keys if key.value is not None)
        return self._known[handout.name, number]


def _numbers(text: str) -> Told:
    return tuple((value, half) for value, half, _ in numbers_in(unicodedata.normalize("NFKC", text)))


def _meet(told: Told, keys: "Sequence[float]") -> bool:
    return any(abs(abs(value) - abs(key)) <= half for value, half in told for key in keys)
