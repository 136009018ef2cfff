"""Words one after the other, as a sentence lists them."""


def listed(words, last_word="and"):
    """a, b and c."""
    *first, last = words
    return f"{', '.join(first)} {last_word} {last}" if first else last
