"""Names of a scene within words, as phi1 and k2, by the symbols that formulas have for them."""

import re
from collections.abc import Collection

NAMED = re.compile(r"(?<![\w.\[])((?<!')[^\W\d]\w*'*|(?<=')[^\W\d]\w*)(?![\w\[(]|\.\w)")  # in quotes it has no primes


def with_symbols(words: str, names: Collection[str]) -> str:
    """The words with φ₁ for phi1 where that is one of the names."""
    from vibcli.notation.plain import plain

    return NAMED.sub(lambda found: plain.symbol(found[1]) if found[1].rstrip("'") in names else found[1], words)
