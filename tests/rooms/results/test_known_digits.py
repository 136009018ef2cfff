"""Numbers of which no digit is known are refused with the reason, whatever asks for them; right zeros are told."""

import numpy as np
import pytest
from support.modes_found_once import modes_found_once  # noqa: F401
from support.scenes import problem

from vibcli.api.reports import require_certified
from vibcli.api.values import given_expression, quantity_asked
from vibcli.base.errors import NoDigit, PhysicsError
from vibcli.check.verdicts import check
from vibcli.language.signals_of_places import with_places
from vibcli.quantities.expression import bounded, measure
from vibcli.report.sections.motion_data import response_data
from vibcli.report.sections.requested_signals import signals_asked
from vibcli.report.sections.response import unknown_at, value_at
from vibcli.report.sections.sampled_series import sampled
from vibcli.report.wanted import Wanted
from vibcli.results.escalation import value_of_signal
from vibcli.results.internal_forces import forces_in_time
from vibcli.results.known_digits import require_digit
from vibcli.results.modal_signals import ModalSignal
from vibcli.symbolic.parser import parse

ARM = """\
parameters: {L: 1.2 m, EI: 2400 N*m^2, mu: 3 kg/m}
beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: LEFT, right: RIGHT}}
points: {mid: {body: arm, at: L/2}, tip: {body: arm, at: L}}
forces: {f: {at: AT, force: 10 N*step(t)}}
damping: {modal: 1 %}
find: [{response: {until: 0.1 s, of: [arm.u(L), arm.u''(0.4*L)]}}]
"""
EARLY = "1e-9 s"        # where forces and accelerations after a step have next to no bound
TWO = """\
bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}}
springs: {s: {between: [ground, a], k: 100 N/m}, t: {between: [a, b], k: 50 N/m}, u: {between: [b, ground], k: 100 N/m}}
initial: {x: 1 cm, y: 1 cm}
"""
pytestmark = pytest.mark.usefixtures("modes_found_once")


def cantilever(more=""):
    return problem(ARM.replace("LEFT", "clamped").replace("RIGHT", "free").replace("AT", "tip") + more)


def signal(scene, text):
    return scene.response.signal(with_places(parse(text), scene.spec.members))


def at(text):
    from fractions import Fraction

    return (text, Fraction(text.partition(" ")[0]))


@pytest.mark.parametrize("value, error, size, known", [
    (1.0, 0.5, 1.0, True), (1.0, 2.0, 3.0, True), (1e-3, 0.2, 1.0, True), (0.0, 0.0, 0.0, True), (0.0, 1e-9, 1.0, True),
    (-0.197, 3e8, 12.0, False), (1.0, np.inf, 5.0, False), (2.0, 2.0, 2.0, False), (1.0, np.nan, 2.0, False)])
def test_a_bound_is_measured_by_what_the_value_is_one_of(value, error, size, known):
    if known:
        require_digit(value, error, size, "ask")
    else:
        with pytest.raises(NoDigit, match="no digit of this value is known"):
            require_digit(value, error, size, "ask")


@pytest.mark.sweep
def test_texts_data_answers_and_the_python_door_say_why_a_value_is_not_known(monkeypatch):
    scene = cantilever(f"answers: {{arm.u''(0.4*L)({EARLY}): 3 m/s^2}}\n")
    small, fast = signals_asked(scene)
    instant = at(EARLY)
    bound = fast.signal.read_at(1e-9).error(1e-9)
    assert bound > 100 * np.abs(fast.signal.values(np.linspace(1e-3, 0.1, 65))).max()
    with pytest.raises(NoDigit, match="it may be off by"):
        value_at(fast, instant[1])
    assert "not known: no digit of this value is known: it may be off by" in unknown_at(fast, instant[1])
    assert unknown_at(small, instant[1]) is None
    verdict, = check(scene)
    assert not verdict.agrees and verdict.remark.startswith("not known: no digit")
    with pytest.raises(NoDigit):
        measure(scene, scene.spec.answers[0].asked.tree)
    small, fast = (given_expression(text, "the signal") for text in ("arm.u(L)", "arm.u''(0.4*L)"))
    found = response_data(scene, Wanted((small,), at=(instant,)))["signals"][0]["at"][0]
    assert found["no_bound"] is None and found["value"] is not None
    monkeypatch.setattr(ModalSignal, "error_of_extreme", lambda *_: 1e-6)
    monkeypatch.setattr(ModalSignal, "extreme", lambda *_: (0.02, 5.0))
    monkeypatch.setattr(ModalSignal, "error_of_time", lambda *_: 1e-6)
    found, = response_data(scene, Wanted((fast,), at=(instant,)))["signals"]
    assert found["at"][0]["value"] is found["at"][0]["error"] is None
    assert "not known: no digit of this value is known: it may be off by" in found["at"][0]["no_bound"]
    assert found["max"] == 5.0 and found["no_bound"] is None
    with pytest.raises(PhysicsError, match="under 'Values' stands 'not known': no digit of what is asked there is"):
        require_certified(scene, ["response"], wanted=Wanted((fast,), at=(instant,)))


@pytest.mark.sweep
def test_samples_are_blank_where_no_digit_is_known(monkeypatch):
    scene = cantilever()
    one = signals_asked(scene)[0].signal
    monkeypatch.setattr(type(one), "error", lambda self, t: 1.0 if t < 0.02 else 1e-9)
    found, *_ = sampled(scene, Wanted(points=501))
    assert np.isnan(found.values[found.times < 0.02]).all() and np.isfinite(found.values[found.times > 0.025]).all()
    monkeypatch.setattr(type(one), "error", lambda self, t: 1.0)
    with pytest.raises(NoDigit, match="off by 1"):
        sampled(scene, Wanted(points=501))


@pytest.mark.sweep
def test_what_symmetry_keeps_at_zero_is_told_and_so_is_a_passage():
    held = problem(ARM.replace("LEFT", "pinned").replace("RIGHT", "pinned").replace("AT", "mid"))
    slope = signal(held, "arm.slope(L/2)")
    value, error = value_of_signal(slope, 0.05)
    assert abs(value) <= error < 1e-3 * abs(signal(held, "arm.slope(L/4)").values(np.array([0.05]))[0])
    moving = signal(held, "arm.u(L/3)")
    t = moving.zeros(0.0, 0.1)[1]
    assert abs(moving.values(np.array([t]))[0]) < moving.error(t)
    value_of_signal(moving, t)


def test_lumped_signals_follow_the_same_rule():
    scene = problem(TWO)
    apart, moving = (scene.response.signal(parse(text)) for text in ("y - x", "x"))
    assert value_of_signal(apart, 1.0)[0] == 0
    moving.source = ()          # so that no more digits are found
    assert moving.error(1e20) > 0.01
    with pytest.raises(NoDigit, match=r"nothing it is one of is larger than 0\.01"):
        value_of_signal(moving, 1e20)


@pytest.mark.sweep
def test_an_extreme_of_which_no_digit_is_known_is_refused(monkeypatch):
    scene = cantilever("answers: {max(arm.u(L)): 1 mm}\n")
    one = signals_asked(scene)[0].signal
    monkeypatch.setattr(type(one), "error_of_extreme", lambda *_: 3e8)
    with pytest.raises(NoDigit, match="off by 3e8"):
        one.bounded_extreme(0.0, 0.1, 1)
    assert check(scene)[0].remark.startswith("not known")


@pytest.mark.sweep
def test_a_diagram_of_forces_of_which_no_digit_is_known_is_refused(monkeypatch):
    scene = cantilever()
    monkeypatch.setattr(ModalSignal, "error", lambda self, t: 3e8 if self.reads.places and 3 in [
        place.along for place in self.reads.places] else 1e-9)
    forces, told = forces_in_time(scene, 0.05)
    assert [force.part for force in forces] == ["moment"]
    assert any("the shear of arm is not found: no digit of this value is known" in one for one in told)


@pytest.mark.sweep
def test_values_of_what_dies_out_beyond_floats_are_read_by_fewer_modes():
    fast = signals_asked(cantilever())[1].signal
    assert fast.read_at(1e-7).modal.count >= fast.modal.count


def test_a_number_that_is_found_as_zero_may_be_off_by_its_bound(monkeypatch):
    """It was taken to be exact."""
    scene = cantilever()
    monkeypatch.setattr("vibcli.results.known_digits.size_of", lambda signal, t: 1.0)
    monkeypatch.setattr(ModalSignal, "values", lambda self, times: np.zeros(len(times)))
    monkeypatch.setattr(ModalSignal, "error", lambda self, t: 1e-9)
    assert bounded(scene, quantity_asked(scene.spec, "arm.u(L)(0.01 s)")) == (0.0, 1e-9)
