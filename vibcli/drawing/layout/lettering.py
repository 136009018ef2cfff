"""Names and expressions as runs of letters, and their measures: quantities slanted, indices lowered.

The fonts come with Matplotlib: STIX, and DejaVu for letters that it lacks; what neither has is shown as □.
"""

from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import groupby
from typing import Any

from vibcli.drawing.canvas.primitives import LetterRuns, Run
from vibcli.drawing.layout.fonts import font
from vibcli.notation.names import GREEK, factors_of, split_name

SIZE, SMALL, LOWER, RAISE = 11.5, 0.72, -0.22, 0.38
ASCENT, DESCENT = 0.70, 0.22
FONTS = {True: ("STIXGeneralItalic.ttf", "DejaVuSerif-Italic.ttf"), False: ("STIXGeneral.ttf", "DejaVuSans.ttf")}
LOW, DEEP = set("acemnorsuvwxz"), set("gjpqyfQJ(),;/|")     # letters without a head, and with a foot
SLACK, CLEAR = 0.6, 0.7
MISSING, LONGEST, GAP = "□", 90, 0.13
BESIDE = 0.05       # of the size: behind each run
_OPEN, _INDEX, _CLOSE = "\ue000", "\ue001", "\ue002"
DOTS = {"'": "\u0307", "''": "\u0308"}      # of a rate: one or two above the letter
ABOVE = {"\u0307": "\u02d9", "\u0308": "\u00a8"}       # the same, standing alone at the height of x
HIGHER, LEANING, SMALL_GREEK = 0.19, 0.03, set("αγεηικμνοπρστυφχψω")    # parts of the size; letters without a head
RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻"
_HIGH = str.maketrans(RAISED, "0123456789−")


def named(name: str, size: float = SIZE) -> tuple[Run, ...]:
    """The runs of a name: φ₁ of phi1, a word as it is."""
    return runs(marked(name), size)


def marked(name: str) -> str:
    """A name with marks about it and before its index."""
    if factors := factors_of(name):
        return "".join(map(marked, factors))
    letter, rest, primes = split_name(name)
    return f"{_OPEN}{GREEK.get(letter, letter)}{DOTS.get(primes, primes)}{_INDEX}{rest.removeprefix('_')}{_CLOSE}"


def words(text: str, size: float = SIZE) -> tuple[Run, ...]:
    """The runs of plain words."""
    return (Run(_printable(text[:LONGEST], False), False, size),)


def runs(text: str, size: float = SIZE) -> tuple[Run, ...]:
    """The runs of a text in which names are marked."""
    head, *marked = text.split(_OPEN)
    found = list(_plain(head, size))
    for part in marked:
        name, _, rest = part.partition(_INDEX)
        index, _, rest = rest.partition(_CLOSE)
        if name:
            found.append(Run(_printable(name, True), True, size))
        if index:
            found.append(Run(_printable(index, not index.isdigit()), not index.isdigit(), SMALL * size, LOWER * size))
        found += _plain(rest, size)
    return tuple(found)


def _plain(text: str, size: float) -> Iterator[Run]:
    """The runs of what is no name: powers raised."""
    for raised, part in groupby(text, RAISED.__contains__):
        letters = "".join(part)
        yield (Run(letters.translate(_HIGH), False, SMALL * size, RAISE * size) if raised else
               Run(_printable(letters, False), False, size))


def set_apart(run: Run) -> Iterator[tuple[str, float, float]]:
    """(letters, points from the left end, rise) of a run, its dots above their letter: fonts without the two in one set
    them into a tall letter."""
    letter, dots = run.text[:-1], run.text[-1:]
    if dots not in ABOVE:
        yield run.text, 0.0, run.rise
        return
    tall = letter not in LOW and letter not in SMALL_GREEK
    middle = (_advance(letter, run.slanted, run.size) - _advance(ABOVE[dots], run.slanted, run.size)) / 2
    yield letter, 0.0, run.rise
    yield ABOVE[dots], middle + LEANING * run.size * (1 + tall), run.rise + HIGHER * run.size * tall


def letters(runs: Sequence[Run]) -> str:
    return "".join(run.text for run in runs)


def width(runs: Sequence[Run]) -> float:
    return sum(_advance(run.text, run.slanted, run.size) for run in runs)


def text(runs: Any, left: float, bottom: float, role: str = "ink") -> LetterRuns:
    """A Text with the lower left corner of its box."""
    low = min(run.rise - DESCENT * run.size for run in runs)
    high = max(run.rise + ASCENT * run.size for run in runs)
    box = left, bottom, left + width(runs), bottom + high - low
    return LetterRuns((left, bottom - low), tuple(runs), box, role)


def size(runs: Sequence[Run]) -> tuple[float, float]:
    """(width, height) of the box of runs."""
    box = text(runs, 0.0, 0.0).box
    return box[2], box[3]


def slack(runs: Sequence[Run]) -> tuple[float, float]:
    """Points by which lines may come into the box of runs from below and from above, where its letters are small; those
    that they are to stay away, negative, where letters fill it."""
    small = all(run.rise <= 0 and set(run.text) <= LOW for run in runs)
    flat = len(runs) == 1 and runs[0].text.isascii() and not set(runs[0].text) & DEEP
    return SLACK if flat else -CLEAR, SLACK if small else -CLEAR


@lru_cache(4096)
def file_of(letters: str, slanted: bool) -> str:
    """The first font that has all of some letters."""
    for file in FONTS[slanted]:
        if all(font(file).glyph(letter) for letter in letters):
            return file
    return FONTS[slanted][-1]


def _printable(letters: str, slanted: bool) -> str:
    files = FONTS[slanted]
    return "".join(letter if letter.isprintable() and any(
        font(file).glyph(letter) for file in files) else MISSING for letter in letters)


@lru_cache(4096)
def _advance(letters: str, slanted: bool, size: float) -> float:
    if not letters.strip():
        return GAP * size * len(letters)
    if letters[-1] in ABOVE:
        letters = letters[:-1]
    found = font(file_of(letters, slanted))
    return size * (sum(map(found.advance, letters)) + BESIDE)
