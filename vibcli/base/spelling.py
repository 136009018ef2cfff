"""The valid word that is most like one that is not: hints of messages."""

from collections.abc import Collection, Mapping
from typing import Any

MOST_COMPARED = 500    # words: comparing takes some microseconds each


def near(word: str, words: Collection[str] | Mapping[str, Any]) -> str | None:
    """The one of `words` that is most like `word`, None where none is."""
    from difflib import get_close_matches

    same = [w for w in words if w and w.lower() == word.lower()]
    found = same or (get_close_matches(word, [w for w in words if w], 1, 0.6) if len(words) <= MOST_COMPARED else ())
    return found[0] if found else None


def nearest(word: str, words: Collection[str] | Mapping[str, Any]) -> str | None:
    """A hint naming the nearest valid word, or all of them where none is near."""
    found = near(word, words)
    if found:
        return f"did you mean '{found}'?"
    words = sorted(w for w in words if w)
    return "valid here: " + ", ".join(words) if words and len(words) <= 40 else None
