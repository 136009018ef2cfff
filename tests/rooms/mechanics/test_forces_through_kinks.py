"""Forces of supports, ropes, links and contacts along motions in which forces bend or jump, against Newton's and
Euler's laws written by hand for each body with the accelerations of the motion, at events just after them."""

import numpy as np
import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.switching import _balancing
from vibcli.symbolic.parser import parse

G, END = 9.81, 3.0
DRAWN = """
parameters: {R: 8 N}
gravity: 9.81 m/s^2
bodies:
  block: {mass: 4 kg, at: [0, 0], slide: x}
  weight: {mass: 3 kg, at: [2 m, -1 m], slide: {along: [0, -1], by: y}}
constraints: {cord: {rope: [block, {over: [2 m, 0]}, weight]}}
springs: {s: {k: 60 N/m, between: [[-2 m, 0], block]}}
motion: full
initial: {x: 0}
"""
LEVER = """
gravity: 9.81 m/s^2
points: {O: [0, 0], P: {body: rod, at: [0, -0.8 m]}}
bodies: {rod: {shape: rod, mass: 2 kg, from: O, to: [0, -1.2 m], pin: {at: O, by: phi}}}
motion: full
initial: {phi: 0.9, "phi'": 0.5 rad/s}
"""
KNEE = """
gravity: 9.81 m/s^2
coordinates: {phi: , psi: }
points: {C: {body: a, at: [0.5 m, -0.5 m]}, D: {body: b, at: [0.9 m, -0.4 m]}}
bodies:
  a: {mass: 1.5 kg, at: [0.3 m, -0.6 m], inertia: 0.05 kg*m^2, pin: {at: [0, 0], by: phi}}
  b: {mass: 1.5 kg, at: [1.2 m, -0.4 m], inertia: 0.04 kg*m^2, pin: {at: [1.4 m, 0], by: psi}}
constraints: {bar: {link: [C, D]}}
motion: full
initial: {phi: 0.3}
"""
FRICTIONS = ("dampers: {rub: {friction: R, between: [[-2 m, 0], block]}}",
             "dampers: {rub: {law: R*sign(v), between: [[-2 m, 0], block]}}",
             "forces: {rub: {at: block, force: [-R*sign(x'), 0]}}",
             "forces: {rub: {at: block, force: [R*(1 - 2*step(x')), 0]}}")
STOPS = ("springs: {stop: {k: 900 N/m, gap: 5 cm, acts: compression, between: [P, [0.9 m, -0.8 m]]}}",
         "springs: {stop: {law: (900 N/m^2)*d*abs(d), between: [P, [0.9 m, -0.8 m]]}}")
RUBS = ("dampers: {rub: {friction: 1.5 N*m, torsion: true, between: [ground, b]}}",
        "forces: {rub: {body: b, moment: -(1.5 N*m)*sign(psi')}}")


def motion(text, more):
    """(signal → its values at many instants, those of all events among them; the Trajectory)."""
    one = problem(f"{text}{more}\nfind: [{{response: {{until: {END} s}}}}]\n")
    trajectory = one.response.trajectory()
    times = np.sort([*np.random.default_rng(3).uniform(0, END, 40), 0.0, *(event.time for event in trajectory.events)])
    return (lambda signal: one.response.signal(parse(signal)).values(times)), trajectory


@pytest.mark.parametrize("friction", FRICTIONS)
def test_rope_over_a_peg_draws_a_block_with_friction(friction):
    value, trajectory = motion(DRAWN, friction)
    assert {event.kind for event in trajectory.events} >= {"switches", "sticks"}
    tension, speed = value("cord.force"), value("x'")
    assert tension == pytest.approx(3 * (G - value("y''")), abs=1e-9)
    assert value("block.reaction.y") == pytest.approx(4 * G, abs=1e-9)
    rubbed = tension - 60 * value("x") - 4 * value("x''")
    moving = abs(speed) > 1e-6
    assert moving.sum() > 20 and (~moving).sum() > 5
    assert rubbed[moving] == pytest.approx(8 * np.sign(speed[moving]), abs=1e-8)
    assert (abs(rubbed) <= 8 + 1e-8).all()


@pytest.mark.sweep
@pytest.mark.parametrize("stop", STOPS)
def test_pin_of_a_rod_that_meets_a_stop(stop):
    value, trajectory = motion(LEVER, stop)
    assert trajectory.events
    place = np.array([value("P.x"), value("P.y") - 0.8])
    way = np.array([[0.9], [-0.8]]) - place
    pulled = value("stop.force") * way / np.hypot(*way)
    assert value("O.reaction.x") == pytest.approx(2 * value("rod.x''") - pulled[0], abs=1e-8)
    assert value("O.reaction.y") == pytest.approx(2 * (value("rod.y''") + G) - pulled[1], abs=1e-8)


@pytest.mark.sweep
@pytest.mark.parametrize("rub", RUBS)
def test_link_of_a_loop_with_friction_in_a_hinge(rub):
    value, trajectory = motion(KNEE, rub)
    assert {event.kind for event in trajectory.events} & {"sticks", "switches"}
    C = np.array([value("C.x") + 0.5, value("C.y") - 0.5])
    D = np.array([value("D.x") + 0.9, value("D.y") - 0.4])
    u = (D - C) / np.hypot(*(D - C))
    arm = C[0] * u[1] - C[1] * u[0]
    about = (0.05 + 1.5 * 0.45) * value("phi''") + 1.5 * G * (value("a.x") + 0.3)       # about the pin of a
    assert value("bar.force") * arm == pytest.approx(about, abs=1e-8)
    assert value("a.reaction.x") == pytest.approx(1.5 * value("a.x''") - value("bar.force") * u[0], abs=1e-8)


def test_the_largest_force_counts_both_sides_of_a_jump():
    one = problem(f"{DRAWN}{FRICTIONS[0]}\nfind: [{{response: {{until: {END} s}}}}]\n")
    signal = one.response.signal(parse("cord.force"))
    instant, largest = signal.extreme(0.0, END, 1)
    assert instant == pytest.approx(one.response.trajectory().events[0].time, rel=1e-12)
    back = signal.values(np.array([instant * (1 - 1e-9), instant * (1 + 1e-9)]))
    assert largest == pytest.approx(back[0], rel=1e-6) and back[1] < 0.9 * back[0]


def test_friction_that_two_share_in_any_proportion_is_refused():
    """Both blocks stick: which of the two supports the load is not known, and so is the force in the link."""
    text = DRAWN.replace("block: {mass: 4 kg, at: [0, 0], slide: x}",
                         "block: {mass: 4 kg, at: [0, 0], slide: x}\n  other: {mass: 1 kg, at: [-1 m, 0], slide: u}")
    text = text.replace("constraints: {", "constraints: {bar: {link: [other, block]}, ")
    rubs = ("dampers: {one: {friction: R, between: [[-2 m, 0], block]}, "
            "two: {friction: 5*R, between: [[-3 m, 0], other]}}")
    value, _ = motion(text, rubs)
    with pytest.raises(PhysicsError, match="statics alone does not fix"):
        value("bar.force")


def test_frictions_that_hold_the_same_thing_share_what_they_hold():
    """By their sizes: each then has the same part of its bound, whatever rounding makes of a matrix without inverse."""
    for noise in (0.0, 1e-16, -1e-16):
        slope = np.array([[[2.0, 6.0], [2.0, 6.0 + 6 * noise]]])
        sigma, = _balancing(slope, np.array([[4.0, 4.0]]))
        assert sigma == pytest.approx([0.5, 0.5], rel=1e-12)
    assert _balancing(np.array([[[2.0, 1.0], [1.0, 3.0]]]), np.array([[5.0, 5.0]]))[0] == pytest.approx([2.0, 1.0])
    with pytest.raises(np.linalg.LinAlgError):
        _balancing(np.array([[[2.0, 6.0], [2.0, 6.0]]]), np.array([[4.0, 5.0]]))
