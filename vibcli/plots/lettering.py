"""Texts of a page by their measured size: broken into lines, cut off, put where nothing is yet."""

MOST_LINES = 3
_MOST_LETTERS = 600      # more than any of these lines can show: what lies beyond is not measured


def measured(artist, text, renderer):
    """Width in pixels that a text would have."""
    artist.set_text(text)
    return artist.get_window_extent(renderer).width


def fitted(artist, text, limit, renderer, across=True):
    """Set the text, its end cut off as … where it is longer than `limit` pixels (of height where not across)."""
    text = text[:_MOST_LETTERS]

    def length(end):
        artist.set_text(text if end == len(text) else text[:end].rstrip() + "…")
        extent = artist.get_window_extent(renderer)
        return extent.width if across else extent.height

    if length(len(text)) <= limit:
        return artist
    low, high = 0, len(text) - 1
    while low < high:
        middle = (low + high + 1) // 2
        low, high = (middle, high) if length(middle) <= limit else (low, middle - 1)
    length(low)
    return artist


def wrapped(artist, text, limit, renderer):
    """Set the text in lines of at most `limit` pixels, a few of them at most."""
    lines, rest = [], text[:_MOST_LETTERS].split(" ")
    while rest and len(lines) < MOST_LINES - 1:
        n = _words(artist, rest, limit, renderer)
        lines.append(fitted(artist, " ".join(rest[:n]), limit, renderer).get_text())
        rest = rest[n:]
    if rest:
        lines.append(fitted(artist, " ".join(rest), limit, renderer).get_text())
    artist.set_text("\n".join(lines))
    return artist


def _words(artist, words, limit, renderer):
    """How many words fit into a line, at least one."""
    if measured(artist, " ".join(words), renderer) <= limit:
        return len(words)
    low, high = 1, len(words) - 1
    while low < high:
        middle = (low + high + 1) // 2
        fits = measured(artist, " ".join(words[:middle]), renderer) <= limit
        low, high = (middle, high) if fits else (low, middle - 1)
    return max(low, 1)
