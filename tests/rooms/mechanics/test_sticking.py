"""Dry friction while it sticks: its force is what equilibrium needs, not ± its size in motion."""

import random

import numpy as np
import pytest
from support.scenes import problem

from vibcli.mechanics.lagrange import equation_of


def blocks(draw):
    """Blocks in a row on springs, with friction on the ground and on one another, shaken."""
    n = draw.randint(1, 3)
    lines = ["parameters: {k: 60 N/m, w: 5 rad/s}", "bodies:"]
    lines += [f"  b{i}: {{mass: {draw.uniform(0.5, 3):.3f} kg, slide: x{i}}}" for i in range(n)]
    ends = [("ground", "b0"), *((f"b{i}", f"b{i + 1}") for i in range(n - 1)), ("ground", f"b{n - 1}")][:n + 1]
    lines += ["springs:", *(f"  s{i}: {{k: k, between: [{a}, {b}]}}" for i, (a, b) in enumerate(ends[:n]))]
    lines += ["dampers:"]
    for i in range(n):
        size = draw.uniform(1, 6)
        more = f", breakaway: {size * draw.uniform(1, 1.5):.3f} N" if draw.random() < 0.5 else ""
        lines.append(f"  d{i}: {{friction: {size:.3f} N{more}, between: [{ends[i][0]}, {ends[i][1]}]}}")
    lines += ["forces:", f"  p: {{at: b{n - 1}, force: '({draw.uniform(3, 12):.3f} N)*sin(w*t)'}}",
              "  r: {at: b0, force: '(4 N)*min(t/(0.7 s), 1)'}"]
    start = ", ".join(f"x{i}: {draw.uniform(-0.2, 0.2):.3f} m" for i in range(n))
    return problem("\n".join([*lines, f"initial: {{{start}}}", "motion: full",
                              "find: [{response: {until: 3 s}}]"])), n


@pytest.mark.sweep
@pytest.mark.parametrize("seed", range(8))
def test_the_equation_of_motion_holds_in_stick_and_slip(seed):
    """m ẍ + k … + Σ d.force − loads = 0 at every instant, sign ẋ being what the force of the element says."""
    found, n = blocks(random.Random(seed))
    motion, times = found.response, np.linspace(0.001, 2.999, 400)
    stuck = 0
    for i in range(n):
        values = motion.state_signal(equation_of(found.scene, i)).values(times)
        assert np.abs(values).max() < 1e-8
    for law in found.scene.laws:
        force = motion.state_signal(law.force(found.scene)).values(times)
        speed = motion.state_signal(found.scene.rate(law.s)).values(times)
        size = np.abs(force).max()
        held = np.abs(speed) < 1e-12
        assert (force * speed >= -1e-12 * size).all()
        stuck += np.sum(held & (np.abs(force) < 0.99 * size))
    assert stuck


def test_a_corner_of_the_load_lets_nothing_slip():
    """What sticks goes on to stick where the load has a corner, its speed being zero but for drift."""
    text = ("parameters: {m: 2 kg, R: 3 N, Rs: 6 N}\nbodies: {b: {mass: m, slide: x}}\n"
            "dampers: {d: {friction: R, breakaway: Rs, between: [ground, b]}}\nforces:\n"
            "  p: {at: b, force: 'LOAD'}\ninitial: {x: 0}\nmotion: full\nfind: [{response: {until: 3 s}}]\n")
    for load in ("(5 N)*min(t/(1 s), 1)", "(5 N)*(ramp(t/(1 s)) - ramp(t/(1 s) - 1))",
                 "(5 N)*(step(t - 0.3 s) - step(t - 1.2 s))", "(5 N)*square(4*t/(1 s))"):
        motion = problem(text.replace("LOAD", load)).response
        trajectory = motion.reaching(3.0)
        assert np.abs(trajectory.at(np.linspace(0, 3, 50))[0]).max() < 1e-12, load
        assert not [event for event in trajectory.events if event.kind == "slips"]
