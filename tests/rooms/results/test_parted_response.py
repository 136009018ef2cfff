"""Beams that stretch, and bars beside beams: what moves along by travelling waves, what moves across by modes."""

import pytest
from support.scenes import problem

from vibcli import loads
from vibcli.language.signals_of_places import with_places
from vibcli.results.damped_modal_response import DampedModalResponse
from vibcli.results.modal_response import ModalResponse
from vibcli.symbolic.parser import parse

BEAM = """
parameters: {L: 1 m, EI: 100 N*m^2, EA: 1e6 N, mu: 1 kg/m, F: 10 N, P: 3 N}
beams:
  b: {from: [0, 0], to: PLACE, EI: EI, EA: EA, mass_per_length: mu, left: clamped}
points: {tip: {body: b, at: L}}
forces: {push: {at: tip, force: FORCE}}
find: [{response: {of: [b.force(0 m)], until: 20 ms}}]
"""
ALONG = {"level": ("[L, 0]", "['F*step(t)', 'P*step(t)']", "tip.x"),
         "upright": ("[0, L]", "['P*step(t)', 'F*step(t)']", "tip.y")}


def stretched(tau):
    """u(L)·EA/(F L) of a clamped bar after a step at its end, τ = c t/L: between 0 and 2 along straight lines."""
    tau %= 4
    return tau if tau < 2 else 4 - tau


@pytest.mark.sweep
@pytest.mark.parametrize("way", ALONG)
def test_a_beam_stretches_by_waves(way):
    place, force, signal = ALONG[way]
    model = loads(BEAM.replace("PLACE", place).replace("FORCE", force))
    for tau in (0.1, 1.5, 2.5, 3.7, 17.3):
        found = model[f"{signal}({tau!r} ms)"]
        assert found.value == pytest.approx(1e-5 * stretched(tau), rel=1e-13)
        assert abs(found.value - 1e-5 * stretched(tau)) <= found.error < 1e-12 * 2e-5
    assert model[f"max({signal})"].value == pytest.approx(2e-5, rel=1e-14)


@pytest.mark.sweep
def test_the_force_within_it_leaps():
    model = loads(BEAM.replace("PLACE", "[L, 0]").replace("FORCE", "['F*step(t)', 'P*step(t)']"))
    assert [model[f"b.force(0 m)({t} ms)"].value for t in (0.9, 1.1, 2.9, 3.1)] == pytest.approx([0, 20, 20, 0])
    assert model["max(b.force(L/2))"].value == pytest.approx(20)


@pytest.mark.sweep
def test_what_mixes_both_is_their_sum():
    model = loads(BEAM.replace("PLACE", "[L, 0]").replace("FORCE", "['F*step(t)', 'P*step(t)']"))
    across = model["tip.y(5.5 ms)"]
    both = model["(2*tip.x + tip.y)(5.5 ms)"]
    assert both.value == pytest.approx(2e-5 * stretched(5.5) + across.value, abs=1e-12)
    assert both.error <= 2 * across.error


@pytest.mark.sweep
def test_parts_whose_fronts_are_many_are_found_by_modes_and_at_instants_by_waves(monkeypatch):
    monkeypatch.setattr(ModalResponse, "limit", 4096)       # more of them say it more closely
    text = BEAM[:BEAM.index("find")].replace("PLACE", "[L, 0]").replace("FORCE", "['F*step(t)', 'P*step(t)']")
    model = loads(text)
    assert model["tip.x(2.5 ms)"].value == pytest.approx(1.5e-5, rel=1e-13)
    top = model["max(tip.x)"]
    assert abs(top.value - 2e-5) <= top.error


@pytest.mark.sweep
def test_a_bar_beside_a_beam_goes_by_waves():
    model = loads("""
parameters: {L: 1 m, EA: 1e6 N, mu: 1 kg/m, EI: 100 N*m^2, F: 10 N}
bars: {rod: {length: L, EA: EA, mass_per_length: mu, left: clamped}}
beams: {wing: {length: L, EI: EI, mass_per_length: mu, left: clamped}}
points: {tip: {body: rod, at: L}, end: {body: wing, at: L}}
forces: {pull: {at: tip, force: F*step(t)}, push: {at: end, force: F*step(t)}}
find: [{response: {of: [rod.force(0 m)], until: 20 ms}}]
""")
    assert model["rod.u(L)(2.5 ms)"].value == pytest.approx(1.5e-5, rel=1e-13)
    assert model["rod.force(0 m)(1.1 ms)"].value == pytest.approx(20)
    assert model["wing.u(L)(5 ms)"].value == pytest.approx(1.195713196037678e-3, rel=1e-7)


@pytest.mark.sweep
def test_a_beam_with_a_damper_has_the_bound_that_it_has_without_a_shaft_beside_it(monkeypatch):
    """Each by its own modes, of which few are enough to see that."""
    monkeypatch.setattr(DampedModalResponse, "most", 128)
    monkeypatch.setattr(DampedModalResponse, "limit", 0)
    beam, shaft = """
parameters: {L: 1 m}
beams: {wing: {length: L, EI: 300 N*m^2, mass_per_length: 1 kg/m, left: pinned, right: pinned}}
bodies: {b: {mass: 1 kg, slide: y}WHEEL}
points: {mid: {body: wing, at: L/2}}
dampers: {d: {c: 3 N*s/m, between: [mid, b]}BRAKE}
forces: {f: {body: wing, per_length: 3 N/m*sin(pi*x/L)*cos(5 rad/s*t), from: 0.2*L, to: L}}
""", """
shafts: {s: {length: L, GIo: 300 N*m^2, inertia_per_length: 1 kg*m, left: clamped, right: {clamped: e}}}
"""
    alone = loads(beam.replace("WHEEL", "").replace("BRAKE", ""))
    both = loads(beam.replace("WHEEL", ", e: {inertia: 1 kg*m^2, turn: phi}").replace(
        "BRAKE", ", t: {torsion: 1 N*m*s, between: [ground, e]}") + shaft)
    one, two = (model["wing.u(L/2)(0.7 s)"] for model in (alone, both))
    assert two.value == pytest.approx(one.value, rel=1e-8) and two.error <= 2 * one.error < 1e-6 * abs(one.value)


@pytest.mark.sweep
def test_each_part_with_dampers_goes_by_its_own_modes_where_none_goes_by_waves(monkeypatch):
    """A beam with a damper beside a shaft with drag, whose many modes between its own would leave it no bound."""
    monkeypatch.setattr(DampedModalResponse, "most", 128)
    scene = problem("""
parameters: {L: 1 m}
shafts: {s: {length: L, GIo: 300 N*m^2, inertia_per_length: 1 kg*m, drag: 0.1 N*s, left: clamped}}
beams: {wing: {length: L, EI: 300 N*m^2, mass_per_length: 1 kg/m, left: pinned, right: pinned}}
bodies: {b: {mass: 1 kg, slide: y}}
points: {mid: {body: wing, at: L/2}}
dampers: {d: {c: 3 N*s/m, between: [mid, b]}}
forces: {f: {at: mid, force: 3 N*sin(5 rad/s*t)}}
""")
    assert scene.response.estimated
    found = scene.response.signal(with_places(parse("wing.u(L/2) + s.phi(L)*1 m"), scene.spec.members))
    assert found.error(0.1) <= 1e-6 * abs(found.values([0.1])[0])
