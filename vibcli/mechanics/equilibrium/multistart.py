"""All zeros of the forces of several coordinates within a box, by Newton's method from many starts.

First plain Newton from the drawn position, the corners and middles of the box and points of Halton's sequence, until
N starts that met w zeros leave less than half a zero to be expected elsewhere: w(N − 1)/(N − w − 2) < w + ½ (Boender &
Rinnooy Kan 1987, Math. Programming 37, 59). Then deflated Newton from some of them until nothing new turns up.
"""

from collections.abc import Iterator, Sequence
from itertools import islice, product
from typing import TYPE_CHECKING

import numpy as np

from vibcli.mechanics.equilibrium.newton import zero_from
from vibcli.numerics.halton import halton

if TYPE_CHECKING:
    from vibcli.mechanics.equilibrium.distinct_roots import Found
    from vibcli.mechanics.equilibrium.scaled_forces import Forces

LEAST, GRID, DEFLATED, AVOIDED, START = 50, 4, 8, 20, 20


def search(forces: "Forces", found: "Found", first: Sequence[np.ndarray]) -> None:
    """Adds the zeros within the box of `found` to it; `first`: places to start from before all others."""
    starts = _starts(forces, found.box, first)
    tried = _plain(forces, found, starts)
    while _deflated(forces, found, tried):
        tried = _plain(forces, found, starts)


def _plain(forces: "Forces", found: "Found", starts: Iterator[np.ndarray]) -> list[np.ndarray]:
    """Plain Newton from further starts until few zeros are left to be expected; the starts."""
    tried, least = [], LEAST * len(forces.names)
    while True:
        z = next(starts)
        tried.append(z)
        place = zero_from(forces, z, found.box)
        if place is not None:
            found.meet(place)
        w = found.count
        if len(tried) >= least and (found.met >= 2 * w * w + 3 * w + 2 if w else len(tried) >= 4 * least):
            return tried


def _deflated(forces: "Forces", found: "Found", starts: list[np.ndarray]) -> bool:
    """Deflated Newton from every so many of these starts; True if it found a new zero."""
    before = found.count
    for z in starts[::max(1, len(starts) // (DEFLATED * len(forces.names)))]:
        avoided = [*found.isolated]
        for _ in range(AVOIDED):
            place = zero_from(forces, z, found.box, avoided)
            if place is None or (not found.add(place) and found.holds(place)):
                break
            avoided.append(place)
    return found.count > before


def _starts(forces: "Forces", box: Sequence[np.ndarray], first: Sequence[np.ndarray]) -> Iterator[np.ndarray]:
    yield from first
    low, high = box
    if len(low) <= GRID:
        parts = [(0.0, 0.5) if periodic else (0.0, 0.5, 1.0) for periodic in forces.periodic]
        for fractions in product(*parts):
            yield low + np.array(fractions) * (high - low)
    for fractions in halton(len(low), START):
        yield low + np.array(fractions) * (high - low)


def spread(n: int, most: int) -> Iterator[np.ndarray]:
    """So many points of Halton's sequence in the unit cube of n dimensions, its first few left out."""
    return map(np.array, islice(halton(n, START), most))
