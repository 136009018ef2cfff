"""Extremes of members whose loads begin long after they would have been looked at: none is missed."""

from pathlib import Path

import numpy as np
import pytest
from mpmath import mp
from support.modes_found_once import modes_found_once  # noqa: F401

import vibcli
from vibcli.analyses.excitation.load_times import load_times
from vibcli.base.errors import PhysicsError

pytestmark = pytest.mark.usefixtures("modes_found_once")
TRIALS = Path(__file__).parents[2] / "trials"
TIP = "points: {tip: {body: b, at: 2 m}}\nforces: {f: {at: tip, force: 10 N*%s}}\n"
BAR = "bars: {b: {length: 2 m, EA: 4 MN, mass_per_length: 3 kg/m, left: clamped}}\n" + TIP
BEAM = "beams: {b: {length: 2 m, EI: 4 kN*m^2, mass_per_length: 3 kg/m, left: clamped}}\n" + TIP
DAMPED = BEAM.replace("left: clamped", "left: clamped, right: {c: 3 N*s/m}")
PLANE = BEAM.replace("{length: 2 m,", "{from: [0, 0], to: [2 m, 0], EA: 4 MN,").replace("10 N*%s", "[0 N, 10 N*%s]")


@pytest.mark.sweep
@pytest.mark.parametrize("scene", [BEAM, DAMPED, PLANE])
def test_a_load_that_begins_late(scene):
    late, early = (vibcli.loads(scene % load)["max(b.u(2 m))"] for load in ("step(t - 50 s)", "step(t)"))
    assert late.value == pytest.approx(early.value, rel=1e-3) and early.value > 1.2e-2


@pytest.mark.sweep
def test_waves_of_a_load_that_begins_late():
    assert vibcli.loads(BAR % "step(t - 0.5 s)")["max(b.u(2 m))"].value == pytest.approx(1e-5, rel=1e-12)


PENDULUM = """\
parameters: {L: 1 m, m: 1 kg, g: 9.81 m/s^2}
gravity: g
bodies: {bob: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi}}}
forces: {f: {at: bob, force: [1 N*%s, 0 N]}}
motion: full
"""


@pytest.mark.parametrize(("load", "most"), [
    ("step(t - 100 s)", 2 * np.arctan(1 / 9.81)),                           # F sin φ = m g (1 − cos φ)
    ("sin(0.05 rad/s*t)", np.arctan(1 / 9.81) * (1 + 0.05 / np.sqrt(9.81))),      # at rest beside a free vibration
    ("(1 - exp(-t/(40 s)))", np.arctan(1 / 9.81) * (1 + 1 / 40 / np.sqrt(9.81)))])
def test_full_equations_under_loads_that_are_late_or_slow(load, most):
    """A pendulum that is pushed aside, looked at as long as what pushes it."""
    assert vibcli.loads(PENDULUM % load)["max(phi)"].value == pytest.approx(most, rel=3e-3)


def test_full_equations_under_loads_that_are_too_slow_are_not_followed():
    scene = vibcli.loads(PENDULUM % "sin(1e-5 rad/s*t)")
    with pytest.raises(PhysicsError, match=r"would be followed up to t = 1.257e\+06 s, 6.26e\+04 times as long"):
        scene["max(phi)"]
    assert scene["phi(10 s)"].value == pytest.approx(np.arctan(1e-4 / 9.81), rel=5e-3)
    assert vibcli.loads(PENDULUM % "sin(1e-5 rad/s*t)" + "find: [{response: {until: 30 s}}]\n")["max(phi)"].value > 0


def test_of_what_has_no_form_that_is_told_which_is_within_it():
    scene = vibcli.loads(PENDULUM % "(sin(t^2/(1 s^2)) + sqrt(2 + step(t - 7 s)*cos(3 rad/s*t)))")._problem
    found = load_times(scene.scene, {"L": 1.0, "m": 1.0, "g": 9.81}, scene.work)
    assert found.last == 7 and found.speeds == [3.0] and found.fading == 0


def test_a_place_that_loops_give_is_no_function_of_the_time_alone():
    scene = vibcli.load(TRIALS / "crank_driven_from_far.yaml")._problem
    assert load_times(scene.scene, scene.numeric.floats, scene.work).speeds == [3.0]


@pytest.mark.sweep
def test_a_load_that_begins_late_leaves_phases_as_old_as_they_are():
    """A mode that swings 230,000 times before a load of 1e-9 N sets in: then, too, its phase is a million roundings."""
    scene = vibcli.loads("""
        parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}
        beams: {b: {length: L, EI: EI, mass_per_length: mu, left: pinned, right: pinned}}
        points: {mid: {body: b, at: 0.3*L}}
        forces: {f: {at: mid, force: 1e-9 N*(1 - cos(3 rad/s*(t - 3000 s)))*step(t - 3000 s)}}
        initial: {b.u: 1 m*sin(7*pi*x/L)}
        """)
    with mp.workdps(30):
        for t in (3000.001, 3000.5, 3010.0):
            found = scene[f"b.u(0.31*L)({t!r} s)"]
            true = mp.sin(7 * mp.pi * mp.mpf(0.31)) * mp.cos((7 * mp.pi) ** 2 * mp.mpf(t))
            assert abs(found.value - true) <= found.error + 1e-11 <= 5e-9


FALLING = """\
parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}
beams: {b: {length: L, EI: EI, mass_per_length: mu%s}}
points: {p: {body: b, at: 0.3*L}}
forces: {f: {at: p, force: 1 N*(%s)}}
damping: {modal: 2 %%}
"""


@pytest.mark.sweep
@pytest.mark.parametrize("h", ["1e-6", "1e-10"])
def test_a_short_push_leaves_little_of_two_steps(h):
    """η̈ + 2ζω η̇ + ω² η = φ (F(t) − F(t − h)) to 40 digits."""
    scene = vibcli.loads(FALLING % (", left: pinned, right: pinned", f"step(t) - step(t - {h} s)"))
    found, zeta = scene["b.u(0.41*L)(0.37 s)"], 0.02
    with mp.workdps(40):
        def after(omega, tau):
            turn = omega * mp.sqrt(1 - mp.mpf(zeta)**2)
            return (1 - mp.exp(-zeta * omega * tau) * (mp.cos(turn * tau) + zeta * omega / turn * mp.sin(turn * tau))
                    ) / omega**2

        zeta, t = mp.mpf(2) / 100, mp.mpf(37) / 100
        true = sum(2 * mp.sin(n * mp.pi * mp.mpf(3) / 10) * mp.sin(n * mp.pi * mp.mpf(41) / 100) * (
            after((n * mp.pi)**2, t) - after((n * mp.pi)**2, t - mp.mpf(h))) for n in range(1, 40))
        assert abs(found.value - true) <= found.error <= 1e-16


@pytest.mark.sweep
def test_a_beam_that_is_pushed_away_and_back_lies_where_it_lay():
    """Pushes 1, −1, −1, 1 of 100.1 s bring 10,020 m back to nothing."""
    pushes = "step(t) - 2*step(t - 100.1 s) + 2*step(t - 300.3 s) - step(t - 400.4 s)"
    found = vibcli.loads(FALLING % ("", pushes))["b.u(0.5*L)(6006 s)"]
    assert abs(found.value) <= found.error <= 1e-8
