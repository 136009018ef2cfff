"""What the free part of a motion changes by where segments of a load meet, by unit loads and their waves."""

from math import comb
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.disturbances import ROUNDING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.excitation.forcing import Segment


class Changes:
    """Sums by keys, those of blows real, without what is only rounded."""

    def __init__(self) -> None:
        self._terms: dict[tuple[int, complex, int], list[complex]] = {}

    def add(self, key: tuple[int, complex, int], size: complex) -> None:
        """To the sum of a key."""
        self._terms.setdefault(key, []).append(complex(size))

    def kept(self) -> dict[tuple[int, complex, int], complex]:
        """{key: sum}."""
        sums = {key: sum(terms) if key[-1] >= 0 else sum(terms).real + 0j for key, terms in self._terms.items()}
        return {key: c for key, c in sums.items() if abs(c) > ROUNDING * max(map(abs, self._terms[key]))}


def changes(segments: "Sequence[Segment]", number: int) -> Changes:
    """Those at the start of one: (channel, exponent, power) of waves, of blows power −1."""
    found, segment = Changes(), segments[number]
    for wave in segment.waves:
        found.add((wave.channel, complex(wave.exponent), wave.power), -wave.coefficient)
    for channel, size in segment.impulses:
        found.add((channel, 0j, -1), size)
    tau = segment.start - segments[number - 1].start
    for wave in segments[number - 1].waves if number else ():
        s = complex(wave.exponent)
        for i in range(wave.power + 1):
            found.add((wave.channel, s, i), comb(wave.power, i) * tau ** (wave.power - i) * np.exp(s * tau)
                      * wave.coefficient)
    return found
