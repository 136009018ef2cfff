"""Frequencies of random members, attachments and oscillators, counted against dense finite elements:

    python tests/fuzz/members_counted.py COUNT SEED

prints what is missed or spurious, what is beyond its bound (against 25 digits, of every fiftieth), and the time.
"""

import sys
from pathlib import Path
from statistics import median
from time import process_time

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from support.random_members import random_members, squares_by_finite_elements

from vibcli.analyses.continuous.mode_source import NaturalModes

MODES, EVERY = 6, 50
MESHES = 20, 10, 6      # elements a piece; fine ones lose digits where stiffnesses are far apart


def square(mode):
    """z = ω², negative where it grows."""
    return 0.0 if mode.rigid else mode.omega**2 if mode.growth_rate is None else -(mode.growth_rate**2)


def agreeing(found, system):
    """Are there as many as some mesh has, each close to its own?"""
    for parts in MESHES:
        meshed = squares_by_finite_elements(system, MODES, parts)
        if (np.abs(found - meshed) <= 0.04 * np.abs(meshed) + 1e-6 * meshed[-1]).all():
            return True
    return False


def ratios(system, modes):
    """error/bound of each mode that is not rigid."""
    sharp = NaturalModes(system, digits=25).numbered(1, MODES)
    return [abs(float(square(mode) / square(other) - 1)) / (2 * mode.error)
            for mode, other in zip(modes, sharp, strict=True) if not mode.rigid]


def main(count, seed):
    """Prints what disagrees."""
    wrong, found, beyond, took = 0, 0, [], 0.0
    for number in range(seed, seed + count):
        system = random_members(number)
        begun = process_time()
        modes = NaturalModes(system).numbered(1, MODES)
        took += process_time() - begun
        found += len(modes)
        if not agreeing(np.array([square(mode) for mode in modes]), system):
            wrong += 1
            print(f"seed {number}: {[square(mode) for mode in modes]}")
        if number % EVERY == 0:
            beyond += ratios(system, modes)
    print(f"{count} systems, {found} frequencies: {wrong} systems with missed or spurious ones; error/bound at most "
          f"{max(beyond, default=0):.2g}, median {median(beyond or [0]):.2g}; {took / count * 1e3:.0f} ms a system")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
