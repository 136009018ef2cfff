"""Whether matrices hang on the time is looked at where the time stands in what they are made of, and nowhere else."""

from fractions import Fraction

import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.mechanics import autonomous
from vibcli.mechanics.inputs_outputs import base_excitation

PENDULUM = """
parameters: {m: 2 kg, L: 0.5 m, X: 1 cm, W: 5 rad/s, g: 9.81 m/s^2}
gravity: g
bodies:
  pivot: {at: [0, 0], slide: PLACE}
  bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: pivot, by: phi}}
"""
FORCED = """
parameters: {m: 2 kg, k: 40 N/m, F: 3 N, W: 5 rad/s}
bodies: {a: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, a]}}
forces: {f: {at: a, force: F*sin(W*t)}}
"""


@pytest.fixture
def looked(monkeypatch):
    """The times at which matrices were evaluated."""
    found, whole = [], autonomous.matrices_at

    def matrices_at(form, values):
        found.append(values.get("t"))
        return whole(form, values)

    for module in (autonomous, base_excitation):
        monkeypatch.setattr(module, "matrices_at", matrices_at)
    return found


def omega(scene):
    """The first natural frequency."""
    return float(scene.modal.modes[0].omega)


def test_a_load_in_time_leaves_the_matrices_alone(looked):
    scene = problem(FORCED)
    assert omega(scene) == pytest.approx(20**0.5)
    assert scene.configuration.with_inputs.turning == set()
    assert looked == []


def test_what_drives_a_scene_as_drawn_is_found_once_for_all_values(monkeypatch):
    found, whole = [], autonomous.excitation
    monkeypatch.setattr(autonomous, "excitation", lambda *given: found.append(whole(*given)) or found[-1])
    scene = problem(FORCED.replace("F: 3 N", "F: {unit: N}"))
    drives = [scene.sharing({"F": Fraction(newtons)}).symbolic.excitation for newtons in (2, 3, 4)]
    assert len(found) == 1 and drives == found * 3
    assert problem(FORCED).symbolic.excitation.keys() == {0} and len(found) == 2


def test_a_pivot_that_is_shaken_upwards_is_looked_at_and_refused(looked):
    scene = problem(PENDULUM.replace("slide: PLACE", "move: [0, X*sin(W*t), 0]"))
    with pytest.raises(PhysicsError, match="the stiffness of 'phi' depends on the time"):
        omega(scene)
    assert len(looked) >= 2


def test_one_that_is_shaken_to_the_side_is_looked_at_and_answered(looked):
    scene = problem(PENDULUM.replace("PLACE", "X*sin(W*t)"))
    assert omega(scene) == pytest.approx((9.81 / 0.5) ** 0.5)


def test_what_a_turning_disc_carries_has_a_rest_in_turns_counted_from_it():
    """ω = Ω √(R/r): told in a turn counted from the disc; in one from the ground the reason says that it is the
    coordinate, and the hint how to measure."""
    scene = """
parameters: {R: 0.2 m, r: 0.05 m, Om: 30 rad/s}
COORDINATES
bodies:
  disc: {mass: 5 kg, inertia: 1 kg*m^2, at: [0, 0], pin: {at: [0, 0], by: Om*t}}
  bob: {mass: 0.3 kg, at: [R + r, 0], pin: {at: [R, 0], carrier: disc, by: TURN}}
"""
    with pytest.raises(PhysicsError, match="in this coordinate there are no natural frequencies") as found:
        omega(problem(scene.replace("COORDINATES", "").replace("TURN", "phi")))
    assert "by: phi + Omega*t" in found.value.hint
    turned = problem(scene.replace("COORDINATES", "coordinates: [phi]").replace("TURN", "phi + Om*t"))
    assert omega(turned) == pytest.approx(60)
