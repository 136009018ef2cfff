"""Measured functions of the time: columns of numbers in a file beside the scene, straight between the samples."""

import math
import re
from bisect import bisect_right
from pathlib import Path

from . import jets, words

NEAR = 1e-13                    # [s]

class Record:
    """Zero before its first sample and after its last one; at a sample what begins there, or what ends (`side` −1)."""

    def __init__(self, times, values):
        self.times, self.values, self.side = times, values, 1

    def _piece(self, x):
        """(where it begins, the value there, the slope)."""
        i = bisect_right(self.times, jets.real(x) + self.side * NEAR) - 1
        if i < 0 or i == len(self.times) - 1:
            return 0.0, 0.0, 0.0
        span = self.times[i + 1] - self.times[i]
        return self.times[i], self.values[i], (self.values[i + 1] - self.values[i]) / span

    def __call__(self, x):
        begin, value, slope = self._piece(x)
        return value + slope * (x - begin)

    def rate(self, x):
        return self._piece(x)[2]


def read(entry, folder):
    """The Record of an entry of `records`."""
    entry = entry if isinstance(entry, dict) else {"file": entry}
    lines = [re.split(r"[,;\s]+", line.strip()) for line in
             Path(folder, entry["file"]).read_text("utf-8").splitlines() if line.strip() and line[0] != "#"]
    heads = lines.pop(0) if re.match("[A-Za-z]", lines[0][0]) else []

    def column(key, otherwise):
        name = entry.get(key, otherwise)
        i = heads.index(name) if name in heads else int(name) - 1
        return [float(line[i]) for line in lines]

    if "every" in entry:
        every = _size(entry["every"])
        return Record([i * every for i in range(len(lines))], _in(entry, column("value", "1")))
    unit = _size("1 " + entry.get("time_unit", "s"))
    return Record([unit * t for t in column("time", "1")], _in(entry, column("value", "2")))


def _in(entry, values):
    """Values in the unit of a record."""
    unit = _size("1 " + entry["unit"]) if "unit" in entry else 1.0
    return [unit * value for value in values]


def _size(text):
    return words.value(words.read(text), {}, lambda above, below, pi: above / below * math.pi**pi)
