"""Events of a motion hold what happens: an impulse is listed where it changes a velocity, and changes it to 1e-15."""

import math

import numpy as np
import pytest
from support.motions import problem

from vibcli.analyses.time_integration.integrate import simulate
from vibcli.base.errors import PhysicsError

CARRIED = """
motion: full
parameters: {{Y: 0.1 m, w: {{value: 3 rad/s, unused: allowed}}}}
bodies:
  cart: {{mass: 3 kg, at: [0, 0], slide: {{along: [1, 0], by: "Y*({})"}}}}
  b: {{mass: 1 kg, at: [0.4 m, 0], slide: {{along: [1, 0], by: x, carrier: cart}}}}
springs: {{s: {{k: 90 N/m, between: [cart, b]}}}}
"""
TURNED = """
motion: full
gravity: 9.81 m/s^2
parameters: {{Y: 0.1, w: {{value: 3 rad/s, unused: allowed}}}}
bodies:
  arm: {{shape: rod, mass: 3 kg, from: [0, 0], to: [1 m, 0], pin: {{at: [0, 0], by: "Y*({})"}}}}
  bead: {{mass: 1 kg, at: [0.4 m, 0], slide: {{by: x, carrier: arm}}}}
springs: {{s: {{k: 90 N/m, between: [[0, 0], bead]}}}}
initial: {{x: 0}}
"""
PUSHED = """
motion: full
parameters: {{P: 2 N*s, w: {{value: 3 rad/s, unused: allowed}}}}
bodies: {{b: {{mass: 1 kg, slide: x}}}}
springs: {{s: {{k: 90 N/m, between: [ground, b]}}}}
forces: {{f: {{at: b, force: "P*({})"}}}}
"""
SMOOTH = ["step(t - 0.3 s)*(1 - cos(w*(t - 0.3 s)))", "(w*ramp(t - 0.3 s))^2", "(w*ramp(t - 0.3 s))^3",
          "step(t - 0.3 s)*sin(w*(t - 0.3 s))^2", "step(t - 0.3 s)*((w*t)^2 - 2*w^2*0.3 s*t + (w*0.3 s)^2)",
          "sin(w*t)^2*step(t - pi/w)", "(1 - cos(w*t))*step(2*pi/w - t)", "(1 - cos(w*t))*(step(t) - step(t - 2*pi/w))",
          "0*square(w*t)", "0*step(t - 0.3 s)", "abs(sin(w*t))^3"]
NOTHING = ["0*impulse(t - 0.3 s)", "impulse(t - 0.3 s)*sin(w*(t - 0.3 s))",
           "impulse(t - 0.3 s)*(1 - cos(w*(t - 0.3 s)))", "impulse(t - 0.3 s)*step(t - 0.4 s)",
           "impulse(t - 0.3 s)*step(0.2 s - t)", "(2 - 2)*impulse(t - 0.3 s)",
           "impulse(t - pi/w)*sin(w*t)", "impulse(t + 0.3 s)", "(w*t - w*0.3 s)^2*impulse(t - 0.3 s)"]
STRIKES = {"step(t - 0.3 s)*sin(w*(t - 0.3 s))": 0.3, "w*ramp(t - 0.3 s)": 0.3, "sin(w*t)*step(t - pi/w)": math.pi / 3,
           "(1 - exp(-w*(t - 0.3 s)))*step(t - 0.3 s)": 0.3}


def events(text, until=2.5):
    one = problem(text)
    return simulate(one.configuration, until, initial=one.initial.given).events


@pytest.mark.parametrize("drive", SMOOTH)
@pytest.mark.parametrize("scene", [CARRIED, TURNED], ids=["carried", "turned"])
def test_a_drive_that_begins_smoothly_strikes_nothing(scene, drive):
    assert events(scene.format(drive)) == ()


@pytest.mark.parametrize("force", NOTHING)
def test_an_impulse_times_nothing_is_none(force):
    one = problem(PUSHED.format(force))
    found = simulate(one.configuration, 2.5, initial=one.initial.given)
    assert found.events == () and not found.at(np.linspace(0, 2.5, 40))[1].any()


@pytest.mark.parametrize("drive", STRIKES)
def test_a_drive_that_begins_with_a_speed_strikes(drive):
    found, = events(CARRIED.format(drive), 2.0)
    assert (found.kind, found.time) == ("impulse", pytest.approx(STRIKES[drive], rel=1e-15))


@pytest.mark.parametrize(("factor", "value"), [("cos(w*t)", math.cos(0.9)), ("exp(-2*w*t)", math.exp(-1.8)),
                                               ("step(t - 0.3 s)", 1.0), ("(w*t)^3", 0.729)])
def test_an_impulse_counts_with_its_factor_at_its_instant(factor, value):
    one = problem(PUSHED.format(f"impulse(t - 0.3 s)*{factor}"))
    t = np.linspace(0.31, 2.0, 30)
    x = simulate(one.configuration, 2.0, initial=one.initial.given).at(t)[0][0]
    assert x == pytest.approx(2 * value / math.sqrt(90) * np.sin(math.sqrt(90) * (t - 0.3)), rel=1e-12, abs=1e-14)


def test_energies_that_are_not_defined_where_a_drive_jumps_are_said_to_be_so():
    with pytest.raises(PhysicsError, match="are not defined at an instant at which a function of the time in it jumps"):
        events(CARRIED.format("sin(w*t)*square(w*t)"))
