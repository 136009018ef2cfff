"""Words one after the other, as a sentence lists them."""

from collections.abc import Mapping, Sequence
from typing import Any


def listed(words: Mapping[str, Any] | Sequence[str], last_word: str = "and") -> str:
    """a, b and c."""
    *first, last = words
    return f"{', '.join(first)} {last_word} {last}" if first else last
