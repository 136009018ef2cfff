"""The fonts that come with Matplotlib, read without it: which letters each has, and how far these advance.

OpenType 1.9, tables `cmap` (format 12: groups of code points that follow one another), `hhea` and `hmtx`.
"""

import os
import sys
from array import array
from bisect import bisect_right
from functools import cache
from importlib.util import find_spec
from struct import unpack_from
from typing import Any

from vibcli.base.named_tuple import NamedTuple

UNICODE_TO_GLYPHS = 12      # the format of that part of `cmap` which reaches beyond 16 bits


class Font(NamedTuple):
    """groups: (first, last, glyph of the first) of the code points, one after another; advances: of the glyphs, in
    parts of 1/`units` of the size."""

    units: int
    groups: "array[int]"
    firsts: "array[int]"
    advances: "array[int]"

    def glyph(self, letter: str) -> int:
        """The number of the glyph of a letter, 0 where the font has none."""
        place = 3 * (bisect_right(self.firsts, ord(letter)) - 1)
        if place < 0 or ord(letter) > self.groups[place + 1]:
            return 0
        return self.groups[place + 2] + ord(letter) - self.groups[place]

    def advance(self, letter: str) -> float:
        """How far a letter moves the pen, as part of the size."""
        return self.advances[self.glyph(letter)] / self.units


@cache
def font(file: str) -> Font:
    """The Font of a file."""
    with open(path(file), "rb") as stream:
        data = stream.read()
    tables = {data[at:at + 4]: unpack_from(">I", data, at + 8)[0] for at in range(12, 12 + 16 * _short(data, 4), 16)}
    groups = _groups(data, tables[b"cmap"])
    count = _short(data, tables[b"hhea"] + 34)
    # Glyphs beyond the last record advance as that does; these fonts have one record, of two numbers, for each.
    advances = _numbers("H", data, tables[b"hmtx"], 2 * count)[::2]
    return Font(_short(data, tables[b"head"] + 18), groups, groups[::3], advances)


def path(file: str) -> str:
    """Where a font of Matplotlib lies."""
    found = os.path.join(os.path.dirname(find_spec("matplotlib").origin), "mpl-data", "fonts", "ttf", file)
    if not os.path.exists(found):       # a distribution keeps its data elsewhere
        from vibcli.plots.picture import library

        found = os.path.join(library().get_data_path(), "fonts", "ttf", file)
    return found


def _groups(data: bytes, cmap: int) -> Any:
    for at in range(cmap + 4, cmap + 4 + 8 * _short(data, cmap + 2), 8):
        part = cmap + unpack_from(">I", data, at + 4)[0]
        if _short(data, part) == UNICODE_TO_GLYPHS:
            return _numbers("I", data, part + 16, 3 * unpack_from(">I", data, part + 12)[0])
    raise ValueError("this font tells of no letters beyond 16 bits")


def _short(data: bytes, at: int) -> int:
    found: int = unpack_from(">H", data, at)[0]
    return found


def _numbers(kind: str, data: bytes, at: int, count: int) -> Any:
    found = array(kind)
    found.frombytes(data[at:at + count * found.itemsize])
    if sys.byteorder == "little":
        found.byteswap()
    return found
