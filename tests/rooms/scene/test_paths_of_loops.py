"""Loops that are driven, closed at many instants at once: as one after the other, up to where they no longer close."""

import numpy as np
import pytest
from support.scenes import problem

CRANK = """
parameters: {w: 3 rad/s, r: RADIUS, L: 0.7 m}
points: {P: {body: crank, at: [r, 0]}, E: {body: rod, at: [r + L, 0]}}
bodies:
  crank: {inertia: 0.02 kg*m^2, at: [0, 0], pin: w*t}
  rod: {shape: rod, mass: 0.5 kg, from: [r, 0], to: [r + L, 0], pin: {at: P, by: psi}}
  piston: {mass: 1 kg, at: [r + L, 0], slide: x}
constraints: {c: {join: [E, piston]}}
"""


def driven(radius):
    """(the Loops, a closed position at t = 0, (ψ, x) at instants)."""
    found, r = problem(CRANK.replace("RADIUS", f"{radius} m")), radius
    start = {**found.numeric.floats, **found.numeric.drawn_floats, "t": 0.0}

    def exact(t):
        out = np.arcsin(r / 0.7 * np.sin(3 * t))
        return {"psi": -out, "x": r * np.cos(3 * t) + 0.7 * np.cos(out) - r - 0.7}

    loops = found.scene.loops
    return loops, loops.followed(start, start), exact


@pytest.mark.parametrize("step", [1e-3, 0.05, 0.3])
def test_a_crank_that_turns_over(step):
    loops, start, exact = driven(0.3)
    times = np.arange(0.0, 200 * step, step)
    found, true = loops.through(start, {"t": times}), exact(times)
    for name, values in zip(loops.names, found, strict=True):
        assert np.abs(values - true[name]).max() < 1e-14
    one = start
    for t, z in zip(times[:40], found.T, strict=False):
        one = loops.followed(one, {**one, "t": float(t)})
        assert z == pytest.approx([one[name] for name in loops.names], abs=1e-15)


def test_positions_end_where_the_loop_no_longer_closes():
    """Where the rod stands across the way of the piston: sin wt = L/r."""
    loops, start, exact = driven(0.9)
    times, last = np.linspace(0.0, 1.0, 400), np.arcsin(0.7 / 0.9) / 3
    found, count = loops.through(start, {"t": times}), int((times < last).sum())
    assert count - 2 <= found.shape[1] <= count
    true = exact(times[:found.shape[1]])
    for name, values in zip(loops.names, found, strict=True):
        assert np.abs(values - true[name]).max() < 1e-12


@pytest.mark.parametrize("excess", [1e-2, 1e-4])
def test_no_step_leads_over_places_that_do_not_close(excess):
    """Beyond sin wt = L/r the crank would come down again; a rod that is not shorter passes there."""
    late = 0.5 * np.pi / 3 + 0.4
    loops, start, _ = driven(0.7 * (1 + excess))
    assert loops.followed(start, {**start, "t": late}) is None
    assert loops.through(start, {"t": np.array([late])}).shape[1] == 0
    loops, start, exact = driven(0.7 * (1 - excess))
    found = loops.followed(start, {**start, "t": late})
    assert [found[name] for name in loops.names] == pytest.approx(
        [exact(late)[name] for name in loops.names], abs=1e-12)


def test_many_turns_in_one_step():
    loops, start, exact = driven(0.3)
    found = loops.followed(start, {**start, "t": 100.3})
    assert [found[name] for name in loops.names] == pytest.approx(
        [exact(100.3)[name] for name in loops.names], abs=1e-12)
