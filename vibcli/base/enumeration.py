"""Words as a sentence counts them and lists them."""

from collections.abc import Mapping, Sequence
from typing import Any


def listed(words: Mapping[str, Any] | Sequence[str], last_word: str = "and") -> str:
    """a, b and c."""
    *first, last = words
    return f"{', '.join(first)} {last_word} {last}" if first else last


def amount(number: int, what: str) -> str:
    """1 file, 2 files."""
    return f"{number} {what}" + "s" * (number != 1)
