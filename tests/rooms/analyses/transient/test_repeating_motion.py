"""Motions that periodic loads repeat along what nothing holds, or beside free vibrations at a harmonic that no load
drives: one motion in all that is asked of it, against Fourier's series."""

import math

import numpy as np
import pytest
from mpmath import mp
from support.scenes import problem
from support.signals import signal_of

import vibcli
from vibcli.analyses.transient import steady_state
from vibcli.results.precise_signals import precise_signal

SERIES = 4001       # harmonics; those behind them are less than 1e-10 of the first
LOOSE = """
title: What nothing holds
bodies:
  a: {mass: 2 kg, slide: x}
  b: {mass: 3 kg, slide: y}
  c: {mass: 1 kg, slide: z}
"""
FORCES = """
forces:
  f: {at: a, force: 5 N*square(4 rad/s*t)}
  g: {at: b, force: 2 N*square(4 rad/s*t)}
"""
SCENES = {
    "resisted": ("dampers: {d: {c: 3 N*s/m, between: [ground, a]}}", [(0, None, 3)], []),
    "not resisted": ("", [], []),
    "as many as there are": ("dampers: {d: {c: 3 N*s/m, between: [a, b]}}\nsprings: {s: {k: 60 N/m, between: [b, c]}}",
                             [(0, 1, 3)], [(1, 2, 60)]),
    "at the second harmonic": ("springs: {s: {k: 128 N/m, between: [ground, a]}}", [], [(0, None, 128)]),
}


def _matrix(ties):
    found = np.zeros((3, 3))
    for i, j, size in ties:
        row = np.array([int(k == i) - int(k == j) for k in range(3)])
        found += size * np.outer(row, row)
    return found


def _series(dampers, springs, times):
    """Of x, y, z at instants, and their root mean squares."""
    n = np.arange(1, SERIES, 2)
    s = 4j * n[:, None, None]
    forces = np.array([5, 2, 0]) * 4 / (math.pi * 1j * n[:, None])
    Q = np.linalg.solve(s**2 * np.diag([2, 3, 1]) + s * _matrix(dampers) + _matrix(springs), forces[..., None])[..., 0]
    return [(Q * np.exp(4j * n[:, None] * t)).real.sum(0) for t in times], np.sqrt((abs(Q) ** 2 / 2).sum(0))


@pytest.mark.sweep
@pytest.mark.parametrize("name", SCENES)
def test_one_motion_in_all_that_is_asked_of_it(name):
    more, dampers, springs = SCENES[name]
    scene = vibcli.loads(LOOSE + more + FORCES)
    (early, late), rms = _series(dampers, springs, (0.3, 0.7))
    later_by = 0.7 + math.pi / 2
    for i, q in enumerate("xy"):
        found = {asked: scene[asked].value for asked in (
            f"steady({q})(0.3 s)", f"steady({q})(0.7 s)", f"rms(steady({q}))", f"mean(steady({q}))", f"mean({q}^2)",
            f"max(steady({q}))", f"min(steady({q}))", f"steady({q})({later_by!r} s)")}
        first, second, root, mean, square, top, bottom, again = found.values()
        assert [first, second, again, root, mean, square] == pytest.approx(
            [early[i], late[i], late[i], rms[i], 0, rms[i] ** 2], abs=2e-10)
        assert top == pytest.approx(-bottom, abs=1e-13)     # a half-wave later everything is turned round
        assert max(abs(first), abs(second), root) <= top + 1e-13


@pytest.mark.parametrize("more", [more for more, *_ in SCENES.values()])
def test_more_digits_are_of_the_same_motion(more):
    signal = signal_of(problem(LOOSE + more + FORCES), "steady(x)")
    with mp.workdps(30):
        precise = precise_signal(signal.source).at(mp.mpf("0.3")).read(0)[0]
    assert abs(precise - float(signal.values(np.array([0.3]))[0])) <= signal.error(0.3) < 1e-12


def test_bodies_that_move_freely_one_and_together():
    """Three eigenvalues 0, two of them of one motion, in blocks that are found apart."""
    scene = vibcli.loads("""
bodies:
  a: {mass: 2.57 kg, slide: w}
  b: {mass: 1.38 kg, slide: x}
  c: {mass: 2.6 kg, slide: y}
  d: {mass: 1.38 kg, slide: z}
springs: {s: {k: 93 N/m, between: [a, b]}, t: {k: 64 N/m, between: [b, c]}}
dampers: {e: {c: 2.94 N*s/m, between: [b, c]}, f: {c: 1.65 N*s/m, between: [c, d]}}
forces: {g: {at: a, force: 3 N*step(t)}}
""")
    total, apart = 2.57 + 1.38 + 2.6 + 1.38, 1e3
    momentum = sum(m * scene[f"{q}'({apart} s)"].value for m, q in ((2.57, "w"), (1.38, "x"), (2.6, "y"), (1.38, "z")))
    assert momentum == pytest.approx(3 * apart, rel=1e-12)
    assert scene[f"z''({apart} s)"].value == pytest.approx(3 / total, rel=1e-9)


def test_a_load_with_a_mean_drives_away_what_nothing_holds():
    scene = vibcli.loads(LOOSE + "forces: {f: {at: a, force: 5 N*(1 + square(4 rad/s*t))}}")
    with pytest.raises(vibcli.PhysicsError, match="a constant force drives a motion that nothing holds"):
        scene["max(steady(x))"]


def test_a_mean_over_many_waves_is_put_together_from_parts(monkeypatch):
    """Of a step each half period, as long as its vibration lasts and longer."""
    text = ("bodies: {b: {mass: 1 kg, slide: x}}\nsprings: {s: {k: 1e6 N/m, between: [ground, b]}}\n"
            "dampers: {d: {c: 100 N*s/m, between: [ground, b]}}\n"
            "forces: {F: {at: b, force: 1 N*square(2*pi*%s rad/s*t)}}\n")
    whole = [vibcli.loads(text % rate)["rms(x)"].value for rate in ("1", "3")]
    monkeypatch.setattr(steady_state, "BATCH", 1000)
    assert [vibcli.loads(text % rate)["rms(x)"].value for rate in ("1", "3")] == pytest.approx(whole, rel=1e-14)


def test_a_mean_over_billions_of_waves_is_refused():
    """As many as a mode of 1e10 rad/s makes in a period of 1000 s."""
    scene = vibcli.loads("bodies: {b: {mass: 1 kg, slide: x}}\nsprings: {s: {k: 1e20 N/m, between: [ground, b]}}\n"
                         "dampers: {d: {c: 1e9 N*s/m, between: [ground, b]}}\n"
                         "forces: {F: {at: b, force: 1 N*square(0.006 rad/s*t)}}\n")
    with pytest.raises(vibcli.PhysicsError, match="the mean of its square is not found"):
        scene["rms(x)"]
