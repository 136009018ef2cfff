"""The degree of the forces on the bounds, and what it tells of equilibria that a search has missed.

Degrees are compared with dense ones (signs at both ends, windings around a square, solid angles of a cube's surface)
of gradients written by hand, and with the indices of potentials whose equilibria are all known.
"""

import random
from functools import cache
from itertools import product
from math import pi

import numpy as np
import pytest
from support.scenes import scene_of_potential, value

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.equilibrium import all_equilibria, indices, multistart
from vibcli.mechanics.equilibrium.completeness import ForceBounds
from vibcli.mechanics.equilibrium.degree import degree
from vibcli.report.document import Report
from vibcli.report.formats.text import section_lines, shown
from vibcli.report.keys import data
from vibcli.report.sections.equilibria import SEARCH

SIDE, SIZE = 48, 2.0


def asked(made):
    """The degree of the forces of a scene on its bounds."""
    found = made.equilibria
    low, high = ([pair[i] for pair in found.bounds.values()] for i in (0, 1))
    found.forces.learn_periods()
    return indices.within_limit(found.forces, "the degree", 2500,
                                lambda: degree(ForceBounds(found.forces), np.array(low), np.array(high)))


@pytest.fixture
def blind(monkeypatch):
    """Searches that look at the drawn position alone, and no proof."""
    monkeypatch.setattr(all_equilibria, "_search", lambda forces, found, first: None)
    monkeypatch.setattr(all_equilibria, "proved", lambda forces, found: False)
    monkeypatch.setattr(all_equilibria, "compared", lambda forces, found: None)


def hills(draw, names):
    """(V, its gradient) of a bowl, or saddle, with hills and hollows."""
    axes = [draw.choice([0.2, 0.3, -0.3]) for _ in names]
    tops = [(draw.choice([-2, -1, 1, 2]), [round(draw.uniform(-1.5, 1.5), 2) for _ in names])
            for _ in range(draw.randint(1, 2))]
    V = " + ".join(f"({a})*{x}^2" for a, x in zip(axes, names, strict=True))
    for height, top in tops:
        V += f" + ({height})/(1 + " + " + ".join(f"({x} - ({c}))^2" for x, c in zip(names, top, strict=True)) + ")"

    def slope(points):
        total = 2 * np.array(axes) * points
        for height, top in tops:
            away = points - np.array(top)
            total = total - 2 * height * away / (1 + (away**2).sum(axis=-1, keepdims=True)) ** 2
        return total
    return V, slope


def dense(slope, n):
    """The degree of a gradient on the cube from −SIZE to SIZE, by looking at many points of its boundary."""
    if n == 1:
        return int(np.sign(slope(np.array([SIZE]))[0]) - np.sign(slope(np.array([-SIZE]))[0])) // 2
    line = np.linspace(-SIZE, SIZE, 40 * SIDE if n == 2 else SIDE)
    if n == 2:
        ends = [(line, -SIZE), (SIZE, line), (line[::-1], SIZE), (-SIZE, line[::-1])]
        round_ = np.concatenate([np.stack(np.broadcast_arrays(*pair), axis=-1) for pair in ends])
        angles = np.unwrap(np.arctan2(*slope(round_).T[::-1]))
        return round((angles[-1] - angles[0]) / (2 * pi))
    total, grid = 0.0, np.stack(np.meshgrid(line, line, indexing="ij"), axis=-1)
    for axis, end in product(range(3), (-SIZE, SIZE)):
        points = np.empty((SIDE, SIDE, 3))
        points[..., axis], points[..., (axis + 1) % 3], points[..., (axis + 2) % 3] = end, grid[..., 0], grid[..., 1]
        way = slope(points)
        way = way / np.linalg.norm(way, axis=-1, keepdims=True)
        a, b, c, d = way[:-1, :-1], way[1:, :-1], way[1:, 1:], way[:-1, 1:]
        total += np.sign(end) * (_solid(a, b, c) + _solid(a, c, d))
    return round(total / (4 * pi))


def _solid(a, b, c):
    """The solid angles of spherical triangles (Van Oosterom & Strackee 1983)."""
    top = np.einsum("...i,...i", a, np.cross(b, c))
    below = 1 + sum(np.einsum("...i,...i", u, v) for u, v in ((a, b), (b, c), (c, a)))
    return float(2 * np.arctan2(top, below).sum())


@pytest.mark.sweep
@pytest.mark.parametrize("n", [1, 2, 3])
def test_degrees_are_the_dense_ones(n, blind):
    proved = []
    for seed in range(5):
        draw = random.Random(f"hills {n} {seed}")
        V, slope = hills(draw, "xyz"[:n])
        found = asked(scene_of_potential(V, "xyz"[:n], SIZE))
        assert found in (None, dense(slope, n)), seed
        proved.append(found)
    assert sum(found is not None for found in proved) >= 3


@pytest.mark.sweep
@pytest.mark.parametrize("n", [2, 4])
def test_degrees_are_sums_of_indices(n, blind):
    """V = Σ Pᵢ(uᵢ) with P′ = (u − a)(u − b)(u − c), or (u − a)(u − b): the u are triangular in the coordinates."""
    names, proved = "xyzwuv"[:n], 0
    for seed in range(3):
        draw, total, parts = random.Random(f"grid {n} {seed}"), 1, []
        for i, x in enumerate(names):
            u = x + "".join(f" + ({draw.choice([-1, 1])}/8)*{other}" for other in names[:i][-1:])
            roots = sorted(draw.sample([-0.6, -0.3, 0.1, 0.4, 0.7], draw.choice([1, 2, 3])))
            total *= len(roots) % 2
            a, b, c = [*roots, 0, 0][:3]
            parts.append({1: f"({u} - ({a}))^2", 2: f"({u})^3/3 - ({a + b})*({u})^2/2 + ({a * b})*({u})",
                          3: f"({u})^4/4 - ({a + b + c})*({u})^3/3 + ({a * b + a * c + b * c})*({u})^2/2 "
                             f"- ({a * b * c})*({u})"}[len(roots)])
        found = asked(scene_of_potential(" + ".join(parts), names, SIZE))
        assert found in (None, total)
        proved += found is not None
    assert proved >= 1


@pytest.mark.parametrize("V, names, within, expected", [
    ("-3*cos(x) - 2*cos(y) - cos(z) + cos(x - y)/4 + sin(2*y - z)/5", "xyz", None, 0),
    ("-3*cos(x) - cos(y) + z^2 + z*sin(x - y)", "xyz", {"z": 2}, 0), ("x*cos(y)", "xy", {"x": 1}, None),
    ("x^2 + y^2 + log(2 - x)", "xy", 3, None), ("x^2 + y^2 + 1/(7 - x - y)", "xy", 3, 1),
    ("x^2 + y^2 + 1/(5 - x - y)", "xy", 3, None), ("sqrt(x^2 + y^2)", "xy", 1, None),
    ("abs(x) + y^2", "xy", 1, None), ("x^3/3 - x*y^2", "xy", 1, None), ("x^2 - y^2", "xy", 1, -1),
    ("x^2 + y^2 + z^2 + w^2 - u^2 + v^2 + x*y/3 + sin(z + u)/4", "xyzwuv", 1, -1), ("x^2 - 4*x + y^2", "xy", 1, 0),
    ("x^2 - 2*x + y^2", "xy", 1, None), ("cos(x) - x/3 + y^2", "xy", {"y": 1}, 0)])
def test_degrees_and_what_has_none(V, names, within, expected, blind):
    """Angles that go round; poles, ends and jumps of the forces; −2, which no affine map has; a zero on the bounds."""
    assert asked(scene_of_potential(V, names, within)) == expected


@pytest.fixture
def short(monkeypatch):
    """Searches from fewer places."""
    monkeypatch.setattr(multistart, "LEAST", 8)
    monkeypatch.setattr(multistart, "DEFLATED", 2)


def wells():
    return scene_of_potential("x^4/4 - x^2/2 + y^2 + z^2 + w^2 + (x + 2*y)/9 + z*w/5 + x*y/7", "xyzw", 2)


def hanging():
    return scene_of_potential("-3*cos(x) - 2*cos(y) + cos(x - y)/4 + z^2 + z*sin(x)/4 + w^2", "xyzw", {"z": 2, "w": 2})


@cache
def searched(made):
    """A scene with what a search of which nothing is lost has found, `short` for all who ask."""
    scene = made()
    assert scene.equilibria
    return scene


def dropping(monkeypatch, number):
    """Searches that lose one of what they find."""
    search = all_equilibria._search

    def lost(forces, found, first):
        search(forces, found, first)
        found.isolated.sort(key=lambda place: tuple(place.z.round(6)))
        del found.isolated[number]
    monkeypatch.setattr(all_equilibria, "_search", lost)


@pytest.mark.sweep
@pytest.mark.parametrize("made", [wells, hanging])
def test_what_was_missed_is_found_by_its_index(made, monkeypatch, short):
    every = [item.equilibrium.values for item in searched(made).equilibria.items]
    dropping(monkeypatch, 1)
    found = made().equilibria
    assert found.indices.agree and not found.complete and len(every) > 2
    assert [item.equilibrium.values for item in found.items] == [pytest.approx(values, abs=1e-12) for values in every]


@pytest.mark.sweep
def test_what_is_missing_is_said(monkeypatch, short):
    """Where it is not found after all; the list is given, their number refused."""
    dropping(monkeypatch, 1)
    monkeypatch.setattr(indices, "look_for", lambda forces, found, index: False)
    scene = wells()
    report = Report(scene)
    report.add("equilibria")
    said = " ".join(shown(section_lines(report.sections)).split())
    assert "at least one more exists: the indices of these sum to 2, but the forces on the bounds have the degree 1" \
        in said
    assert data([SEARCH], scene)["search"] == {
        "bounds": {name: [-2.0, 2.0] for name in "xyzw"}, "complete": False, "cut": False, "indices": 2, "degree": 1}
    with pytest.raises(PhysicsError, match="more equilibria exist than the 2"):
        value(scene, "equilibria")


@pytest.mark.sweep
def test_indices_that_agree_are_no_proof(short):
    found = searched(wells)
    assert found.equilibria.indices == (1, 1) and not found.equilibria.complete
    assert value(found, "equilibria") == len(found.equilibria.items) == 3


@pytest.mark.sweep
@pytest.mark.parametrize("V", ["x^4 + y^2 + z^2 + w^2", "abs(x) + y^2 + z^2 + w^2", "(x^2 + y^2 - 1)^2 + z^2 + w^2"])
def test_without_an_index_nothing_is_said(V, short):
    """Multiple zeros, kinks, circles."""
    assert scene_of_potential(V, "xyzw", 2).equilibria.indices is None
