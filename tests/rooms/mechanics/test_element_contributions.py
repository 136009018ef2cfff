"""The forms of T, V and Φ that elements own add up to M, K and the symmetric part of C, in driven scenes too."""

from pathlib import Path

import mpmath
import pytest
from support.scenes import kept_problem_of

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.element_contributions import owned_forms

FILES = sorted((Path(__file__).parents[3] / "problems").glob("*/*.yaml"))
DRIVEN = ("rods_on_shaken_pivot", "paddle_on_turning_hub", "torsiograph_on_a_shaft", "two_parcels_on_belt",
          "unround_shaft", "platforms_under_a_shaken_frame")


def summed(parts, n):
    """The matrix of {name: (rows with weights, {(i, j): entry})}."""
    total = [[mpmath.mpf(0)] * n for _ in range(n)]
    for rows, matrix in parts.values():
        for weight, row in rows:
            for i, x in row.items():
                for j, y in row.items():
                    total[i][j] += weight * x * y
        for (i, j), entry in matrix.items():
            total[i][j] += entry
    return total


def assert_adds_up(found):
    with mpmath.workdps(30):
        owned = owned_forms(found.configuration)
    M, C, _, K = found.configuration.linear_system.matrices()
    n = len(found.scene.coordinates)
    C = {(i, j): (C.get((i, j), 0.0) + C.get((j, i), 0.0)) / 2 for pair in C for i, j in (pair, pair[::-1])}
    for parts, matrix in ((owned.kinetic, M), (owned.potential, K), (owned.dissipation, C)):
        size, total = max((abs(x) for x in matrix.values()), default=0.0), summed(parts, n)
        for i in range(n):
            for j in range(n):
                assert float(total[i][j]) == pytest.approx(matrix.get((i, j), 0.0), rel=1e-12, abs=1e-12 * size)


@pytest.mark.parametrize("name", DRIVEN)
def test_of_driven_scenes(name):
    path, = [path for path in FILES if path.stem == name]
    assert_adds_up(kept_problem_of(path))


@pytest.mark.sweep
def test_of_all_problems():
    count = 0
    for path in FILES:
        found = kept_problem_of(path)
        if found.numeric.has_free_symbols or found.spec.choices or found.scene.pieces or found.scene.held:
            continue
        try:
            found.configuration.linear_system  # noqa: B018
        except PhysicsError:
            continue
        assert_adds_up(found)
        count += 1
    assert count > 100
