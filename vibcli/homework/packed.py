"""Variants as they go from process to process: in parts of plain tuples, which become variants when they are asked for.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from typing import Any

from vibcli.homework.bands import Band
from vibcli.homework.gates import Wrong
from vibcli.homework.keys import KeyValue
from vibcli.homework.variants import ProblemVariant


class PackedVariants(Sequence[ProblemVariant]):
    """The accepted variants of parts: [(place, plain keys)] of each; values(number of the part, place): {parameter: its
    value}."""

    def __init__(self, parts: Sequence[Sequence[Any]], values: Callable[[int, Any], dict[str, Any]]):
        self._parts, self._values_at = parts, values

    def __len__(self) -> int:
        return sum(map(len, self._parts))

    def __getitem__(self, number: Any) -> Any:
        return self._unpacked[number]

    def __iter__(self) -> Iterator[ProblemVariant]:
        return iter(self._unpacked)

    @cached_property
    def _unpacked(self) -> list[ProblemVariant]:
        return [ProblemVariant(place, self._values_at(number, place), tuple(map(unpacked, keys)))
                for number, part in enumerate(self._parts) for place, keys in part]


def packed(key: Any) -> Any:
    """A key that is a number as a plain tuple, any other as it is."""
    if not isinstance(key, KeyValue):
        return key
    return (*key[:2], tuple(key.band), [tuple(one) for one in key.wrong])


def unpacked(plain: Any) -> Any:
    """The key that was packed so."""
    if type(plain) is not tuple:
        return plain
    value, error, band, wrong = plain
    return KeyValue(value, error, Band(*band), tuple(map(Wrong._make, wrong)))
