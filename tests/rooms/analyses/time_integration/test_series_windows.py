"""Long smooth motions go by compiled Taylor series where heyoka is installed; without it, and where these cannot go on,
by other ways to the same answer."""

import sys
from fractions import Fraction

import numpy as np
import pytest
from support.motions import DOUBLE, FOUR_BAR, PENDULUM, problem

from vibcli.analyses.time_integration import series_windows
from vibcli.analyses.time_integration.known_motion import known_motion
from vibcli.analyses.time_integration.series_windows import SeriesWindows
from vibcli.base.errors import PhysicsError
from vibcli.bench.trajectories import AT_100
from vibcli.mechanics.compiled_series import is_installed, solved

NEEDED = pytest.mark.skipif(not is_installed(), reason="heyoka is not installed: pip install 'vibcli[heyoka]'")
START = {"p": 0.3, "r": 0.5}
DRIVEN = """
parameters: {m: 2 kg, M: 3 kg, k: 80 N/m, l: 1 m, L: 0.7 m, e: 2.5}
gravity: 9.81 m/s^2
bodies:
  cart: {mass: M, at: [0, 0], slide: x}
  bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
springs: {s: {law: k*d*(1 + tanh(d/l) + exp(-d^2/l^2)*sqrt(1 + d^2/l^2) + atan(d/l)^2), between: [[-1 m, 0], cart]}}
dampers: {d: {c: 0.3 N*s/m, between: [[-1 m, 0], cart]}}
forces: {f: {at: cart, force: [3 N*sin(2 rad/s*t)*2^e, 0 N]}}
"""
RUBBING = """
parameters: {m: 1.15 kg, k: 215 N/m, F: 3.55 N, u: 5 mm/s}
bodies: {b: {mass: m, at: [0, 0], slide: x}}
springs: {s: {k: k, between: [[-1 m, 0], b]}}
dampers: {f: {law: F*tanh(v/u), between: [[-1 m, 0], b]}}
"""             # of what turns the friction round a step before shows less than a float holds
SINGULAR = """
parameters: {m: 1 kg, l: 1 m, F: 1 N}
bodies: {b: {mass: m, at: [l, 0], slide: x}}
forces: {f: {at: b, force: [-F/(1 + x/l), 0 N]}}
"""
STIFF = """
parameters: {m: 1 kg, k: 1e6 N/m, c: 2e4 N*s/m, n: 1 N/m^3, l: 9 N/m}
bodies: {a: {mass: m, at: [0, 0], slide: x}, b: {mass: m, at: [0, 1 m], slide: y}}
springs: {s: {k: k, between: [[-1 m, 0], a]}, h: {law: l*d + n*d^3, between: [a, b]}}
dampers: {d: {c: c, between: [[-1 m, 0], a]}}
"""


@pytest.fixture
def followed(monkeypatch):
    """[1 for each solution that went by series, however short it is]."""
    found, follow = [], SeriesWindows.follow

    def counting(self, march, limit):
        found.append(1)
        follow(self, march, limit)

    monkeypatch.setattr(series_windows, "PAYS", 1.0)
    monkeypatch.setattr(SeriesWindows, "follow", counting)
    return found


def ends(text, until, start, accuracy=None):
    found = known_motion(problem(text).configuration, until, start, accuracy)
    return found, np.concatenate([row[:, 0] for row in found.at([until])[:2]])


@NEEDED
def test_a_double_pendulum_comes_to_where_series_of_26_digits_do(followed):
    found, state = ends(DOUBLE, 100.0, START)
    assert len(followed) == 2 and not found.coarse and found.end == 100.0
    assert np.abs(state - AT_100).max() < 1e-13
    assert np.abs(state - AT_100).max() <= found.shared.largest <= 1e-12


@NEEDED
def test_every_window_obeys_the_equations(followed, monkeypatch):
    monkeypatch.setattr(series_windows, "AT_ONCE", 100)
    found, _ = ends(DOUBLE, 20.0, START)
    t = np.linspace(0.1, 19.9, 2001)
    q, v, a = found.at(t)
    assert np.abs(a - found.system.accelerations(t, q, v)).max() < 1e-11
    assert np.abs(found.at(t + 1e-4)[0] - found.at(t - 1e-4)[0] - 2e-4 * v).max() < 1e-9


@pytest.mark.sweep
@NEEDED
@pytest.mark.parametrize("text, start", [(DRIVEN, {"x": 0.5, "phi": 1.0}), (PENDULUM, {"phi": 3.0}),
                                         (RUBBING, {"x": 0.0515})], ids=["functions", "wide", "rubbing"])
def test_other_ways_come_to_the_same_place(followed, monkeypatch, text, start):
    one, state = ends(text, 20.0, start)
    assert len(followed) == 2
    monkeypatch.setattr(series_windows, "is_installed", lambda: False)
    other, plain = ends(text, 20.0, start)
    assert len(followed) == 2
    assert np.abs(state - plain).max() <= 8 * (one.shared.of_state(20.0) + other.shared.of_state(20.0))


@NEEDED
def test_where_forces_have_no_value_it_is_refused_as_ever(followed):
    with pytest.raises(PhysicsError, match="cannot be followed"):
        known_motion(problem(SINGULAR).configuration, 9.0, {"x": 1.0})
    assert followed


@pytest.mark.sweep
@NEEDED
def test_what_is_stiff_goes_on_by_collocation(followed):
    found, _ = ends(STIFF, 20.0, {"x": 0.0, "y": 0.5})
    assert followed and max(window.length for window in found.windows) > 0.1


@pytest.mark.sweep
def test_it_is_chosen_by_how_much_there_is_to_do(monkeypatch):
    counts = []

    def refusing(self, march, limit):
        counts.append(limit - march.t)
        self.given_up = True

    monkeypatch.setattr(series_windows, "is_installed", lambda: True)
    monkeypatch.setattr(SeriesWindows, "follow", refusing)
    known_motion(problem(DOUBLE).configuration, 20.0, START)
    assert not counts                   # some hundred radians of two coordinates
    monkeypatch.setattr(series_windows, "PAYS", 0.01 * series_windows.PAYS)
    known_motion(problem(DOUBLE).configuration, 20.0, START)
    assert len(counts) == 2
    known_motion(problem(FOUR_BAR).configuration, 1.0, {"alpha": 0.3})
    assert len(counts) == 2             # loops are closed by collocation


@pytest.mark.parametrize("missing", [True, False])
def test_without_the_engine_other_ways_go_on(monkeypatch, missing):
    monkeypatch.setitem(sys.modules, "heyoka", None)
    monkeypatch.setattr(series_windows, "PAYS", 1.0)
    if not missing:     # found, but broken
        monkeypatch.setattr(series_windows, "is_installed", lambda: True)
    found, _ = ends(PENDULUM, 5.0, {"phi": 1.0})
    assert found.end == 5.0 and len(found.windows) > 1


def test_elimination_is_exact_on_exact_numbers():
    M = {(0, 0): Fraction(4), (0, 1): Fraction(1), (1, 1): Fraction(3), (1, 2): Fraction(-1), (2, 2): Fraction(2)}
    full, h = np.zeros((3, 3)), [Fraction(1), Fraction(-2), Fraction(5)]
    for (i, j), value in M.items():
        full[i, j] = full[j, i] = value
    assert np.allclose([float(one) for one in solved(M, h)], -np.linalg.solve(full, np.array(h, float)), rtol=1e-15)
