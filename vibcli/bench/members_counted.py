"""Frequencies of random members, attachments and oscillators, counted against dense finite elements: what is missed or
spurious, and how near errors come to their bounds, against 25 digits.

    python -m vibcli.bench.members_counted COUNT SEED

counts others than the table, as 10,000 in ten minutes of the processor, and prints what disagrees.
"""

import math
import sys
from statistics import median
from time import process_time
from typing import TYPE_CHECKING, NamedTuple

from vibcli.bench.rows import Timing

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    import numpy as np

    from vibcli.analyses.modal.undamped import Mode
    from vibcli.bench.random_members import RowOfMembers
    from vibcli.results.problem import Problem

SYSTEMS = 250           # of the table: a quarter of a minute
MODES, EVERY, DIGITS = 6, 50, 25        # of each system; every how many its bounds are looked at, by so many
MESHES = 20, 10, 6      # elements a piece; fine ones lose digits where stiffnesses are far apart
HIGHER, NOISE = 0.04, 1e-6      # by which ω² of meshes is off, as a part and of the last


class CountedSystems(NamedTuple):
    """wrong: seeds whose frequencies disagree; ratios: error/bound of those looked at; seconds of ours and of all
    meshes."""

    wrong: list[int]
    ratios: list[float]
    ours: float
    meshes: float


def rows(runs: int) -> "Iterator[Timing]":
    """The count of random systems."""
    found = counted(SYSTEMS, 0)
    yield Timing(f"{SYSTEMS:,} random systems of members, with missed or spurious frequencies", len(found.wrong), "", 0,
                 absolute=True)
    yield Timing("  largest error/bound of a frequency", max(found.ratios), "", 1.0, absolute=True)
    yield Timing(f"  {MODES} frequencies of one", found.ours / SYSTEMS * 1e3, "ms", None, "finite elements of one",
                 found.meshes / SYSTEMS * 1e3)


def counted(count: int, seed: int) -> CountedSystems:
    """The CountedSystems of so many systems from a seed on."""
    from vibcli.api.source import problem_of, text_source
    from vibcli.bench.random_members import random_row, scene

    wrong, ratios, ours, meshes = [], [], 0.0, 0.0
    for number in range(seed, seed + count):
        row = random_row(number)
        problem = problem_of(text_source(scene(row)))
        _ = problem.configuration.linear_system
        begun = process_time()
        modes = problem.modal.modes.first(MODES)
        found = process_time()
        if not agree([_square(mode) for mode in modes], row):
            wrong.append(number)
        ours, meshes = ours + found - begun, meshes + process_time() - found
        if number % EVERY == 0:
            ratios += _ratios(problem, modes)
    return CountedSystems(wrong, ratios, ours, meshes)


def agree(found: "list[float] | np.ndarray", row: "RowOfMembers") -> bool:
    """Are these ω² as many as some mesh has, each close to its own?"""
    import numpy as np

    from vibcli.bench.random_members import squares_by_finite_elements

    for parts in MESHES:
        meshed = squares_by_finite_elements(row, len(found), parts)
        if (np.abs(found - meshed) <= HIGHER * np.abs(meshed) + NOISE * meshed[-1]).all():
            return True
    return False


def _ratios(problem: "Problem", modes: "Sequence[Mode]") -> list[float]:
    """error/bound of each mode that is not rigid, the error to some digits: one found in more is rounded once, and may
    come to its bound."""
    from mpmath import mpf, workdps

    sharp = problem.modal.modes_to(DIGITS).first(MODES)
    with workdps(DIGITS):
        return [float(abs(mpf(_rate(mode)) / _rate(other) - 1)) / mode.error
                for mode, other in zip(modes, sharp, strict=True) if not mode.rigid]


def _rate(mode: "Mode") -> float:
    """ω, or that at which it grows."""
    rate: float = mode.omega if mode.growth_rate is None else mode.growth_rate
    return rate


def _square(mode: "Mode") -> float:
    """ω², negative where it grows."""
    return 0.0 if mode.rigid else math.copysign(_rate(mode) ** 2, 1 if mode.growth_rate is None else -1)


def main(count: int, seed: int) -> None:
    """Prints what disagrees, and how near errors come to their bounds."""
    found = counted(count, seed)
    print(f"{count} systems: {len(found.wrong)} with missed or spurious frequencies {found.wrong}; error/bound at most "
          f"{max(found.ratios, default=0):.4g}, median {median(found.ratios or [0]):.2g}; "
          f"{found.ours / count * 1e3:.0f} ms a system, {found.meshes / count * 1e3:.0f} of finite elements")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
