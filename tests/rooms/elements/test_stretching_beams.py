"""Beams in the plane that stretch: against finite elements of frames, bars and beams by themselves, their limits."""

from pathlib import Path

import numpy as np
import pytest
from support.plane_frames import frequencies, random_frame, scene_of
from support.scenes import problem

from vibcli.analyses.frequency_response.transfer_function import transfer
from vibcli.symbolic.syntax import NameRef

STRAIGHT = """
parameters: {{L: 1.2 m, EI: 300 N*m^2, EA: 30 kN, mu: 1.5 kg/m}}
beams:
  b: {{from: [0, 0], to: [0.8*L, 0.6*L], EI: EI, EA: EA, mass_per_length: mu, {ends}}}
"""
ALONG = {"free": "free", "clamped": "clamped", "pinned": "clamped", "guided": "clamped"}
PORTAL = """
parameters: {{H: 3 m, L: 4 m, EI: 4 MN*m^2, mu: 40 kg/m}}
bodies:
  A: {{mass: 0 kg, inertia: 0 kg*m^2, at: [0, H], move: [x, y, p]}}
  B: {{mass: 0 kg, inertia: 0 kg*m^2, at: [L, H], move: [x2, y2, p2]}}
beams:
  left: {{from: [0, 0], to: [0, H], EI: EI, {EA}mass_per_length: mu, left: clamped, right: {{clamped: A}}}}
  right: {{from: [L, 0], to: [L, H], EI: EI, {EA}mass_per_length: mu, left: clamped, right: {{clamped: B}}}}
  girder: {{from: [0, H], to: [L, H], EI: EI, {EA}mass_per_length: mu, left: {{clamped: A}}, right: {{clamped: B}}}}
"""


def squares(text, count):
    return np.array([float(mode.omega) for mode in problem(text).modal.modes.first(count)]) ** 2


@pytest.mark.parametrize("seed", range(8))
def test_random_frames_have_the_frequencies_of_finite_elements(seed):
    frame = random_frame(seed)
    found, fine = np.sqrt(squares(scene_of(frame), 10)), frequencies(frame, 10)
    moving = found > 1e-6 * found[-1]
    assert (fine[~moving] < 1e-4 * fine[-1]).all()
    ratio = fine[moving] / found[moving]
    assert (ratio > 1 - 1e-4).all() and (ratio < 1 + 6e-3).all()      # one missed or too many shifts all above it
    assert ratio[: len(ratio) // 2].max() < 1 + 1e-3


@pytest.mark.sweep
@pytest.mark.parametrize("left", ALONG)
@pytest.mark.parametrize("right", ALONG)
def test_frequencies_of_one_beam_are_those_of_a_bar_and_those_of_a_beam(left, right):
    found = squares(STRAIGHT.format(ends=f"left: {left}, right: {right}"), 12)
    text = """
parameters: {{L: 1.2 m, mu: 1.5 kg/m}}
{kind}: {{b: {{length: L, {stiff}, mass_per_length: mu, left: {left}, right: {right}}}}}
"""
    beam = squares(text.format(kind="beams", stiff="EI: 300 N*m^2", left=left, right=right), 12)
    bar = squares(text.format(kind="bars", stiff="EA: 30 kN", left=ALONG[left], right=ALONG[right]), 12)
    assert found == pytest.approx(np.sort([*beam, *bar])[:12], rel=1e-11, abs=1e-6)


@pytest.mark.sweep
def test_stiff_beams_keep_their_length():
    kept = squares(PORTAL.format(EA=""), 4)
    differences = [squares(PORTAL.format(EA=f"EA: {EA} N, "), 4) / kept - 1 for EA in ("1e13", "1e14")]
    assert (abs(differences[0]) < 1e-4).all()
    assert differences[1] == pytest.approx(differences[0] / 10, rel=1e-3, abs=1e-10)


def test_a_frame_that_hardly_bends_is_a_truss():
    truss = """
bodies: {{n: {{mass: 2 kg, inertia: 0.1 kg*m^2, at: [0 m, 1 m], {move}}}}}
{kind}:
  a: {{from: [-1 m, 0 m], to: [0 m, 1 m], {stiff}, left: {left}, right: {{pinned: n}}}}
  b: {{from: [1 m, 0 m], to: [0 m, 1 m], {stiff}, left: {left}, right: {{pinned: n}}}}
"""
    beams = squares(truss.format(kind="beams", stiff="EI: 1e-7 N*m^2, EA: 5 kN", left="pinned", move="move: [x, y, 0]"),
                    2)
    bars = squares(truss.format(kind="bars", stiff="EA: 5 kN", left="pinned", move="move: [x, y, 0]"), 2)
    assert beams == pytest.approx(bars, rel=1e-9)


def test_responses_are_reciprocal():
    text = PORTAL.format(EA="EA: 300 MN, ") + """
points: {q: {body: girder, at: 1 m}, r: {body: left, at: 2 m}}
forces: {f: {at: q, force: [0, P*cos(w*t)]}, g: {at: r, force: [P*cos(w*t), 0]}}
"""
    scene = problem(text.replace("parameters: {", "parameters: {P: 1 N, w: 50 rad/s, "))
    one, other = (transfer(scene.configuration, signal, driver, modal=scene.modal)
                  for signal, driver in (("r.x", "f"), ("q.y", "g")))
    omegas = np.linspace(20.0, 2000.0, 7)
    assert one.at(1j * omegas)[0] == pytest.approx(other.at(1j * omegas)[0], rel=1e-9)


@pytest.mark.sweep
def test_the_tension_of_a_beam_that_stretches_is_that_of_statics():
    column = """
parameters: {{L: 10 m, EI: 3e5 N*m^2, mu: 20 kg/m, g: 9.81 m/s^2, M: 50 kg}}
gravity: g
beams:
  post: {{from: [0, 0], to: [0, L], EI: EI, {EA}mass_per_length: mu, left: clamped, attached: [{{at: L/2, mass: M}}]}}
"""
    bar = """
parameters: {L: 10 m, mu: 20 kg/m, M: 50 kg}
bars: {post: {length: L, EA: 1 MN, mass_per_length: mu, left: clamped, attached: [{at: L/2, mass: M}]}}
"""
    parts = [*squares(column.format(EA=""), 8), *squares(bar, 8)]
    assert squares(column.format(EA="EA: 1 MN, "), 8) == pytest.approx(sorted(parts)[:8], rel=1e-11)


@pytest.mark.sweep
def test_motions_of_one_beam_are_those_of_a_bar_and_those_of_a_beam():
    """Pulled aslant at a place and let go: along it moves by waves alone, across by its own modes."""
    head = "parameters: {{P: 5 N, c: 0.8, s: 0.6}}\n" \
           "{kind}: {{w: {{{body}, mass_per_length: 1 kg/m, left: clamped}}}}\n" \
           "points: {{tip: {{body: w, at: 0.7 m}}}}\nforces: {{f: {{at: tip, force: {force}}}}}\n" \
           "initial: {{released: f}}\n"
    both = head.format(kind="beams", body="from: [0 m, 0 m], to: [0.8 m, 0.6 m], EI: 300 N*m^2, EA: 30 kN",
                       force="[P*(c - s), P*(s + c)]")
    bar = head.format(kind="bars", body="length: 1 m, EA: 30 kN", force="P").replace(", c: 0.8, s: 0.6", "")
    beam = head.format(kind="beams", body="length: 1 m, EI: 300 N*m^2", force="P").replace(", c: 0.8, s: 0.6", "")
    times = np.linspace(0.0, 0.05, 9)

    def motion(text, name):
        return problem(text).response.signal(NameRef(0, len(name), name, 0)).values(times)

    for name, text, other in (("w.along(0.7 m)", bar, "w.u(0.7 m)"), ("w.u(0.7 m)", beam, "w.u(0.7 m)")):
        expected = motion(text, other)
        assert motion(both, name) == pytest.approx(expected, abs=1e-3 * max(abs(expected)))


@pytest.mark.sweep
def test_a_joint_on_a_beam_is_a_body_without_mass():
    usual = "EI: 300 N*m^2, EA: 30 kN, mass_per_length: 1 kg/m"
    bed, hung = "foundation: 900 N/m^2", "attached: [{at: 0.5 m, oscillator: {mass: 0.2 kg, k: 300 N/m}}]"
    joined = f"""
beams:
  girder: {{from: [0, 0], to: [2 m, 1 m], {usual}, {bed}, left: clamped, right: guided, {hung}}}
  post: {{from: [1 m, 0.5 m], to: [1 m, -1 m], {usual}, left: {{clamped: girder, at: sqrt(1.25 m^2)}}}}
"""
    parts = f"""
bodies: {{n: {{mass: 0 kg, inertia: 0 kg*m^2, at: [1 m, 0.5 m], move: [x, y, p]}}}}
beams:
  one: {{from: [0, 0], to: [1 m, 0.5 m], {usual}, {bed}, left: clamped, right: {{clamped: n}}, {hung}}}
  two: {{from: [1 m, 0.5 m], to: [2 m, 1 m], {usual}, {bed}, left: {{clamped: n}}, right: guided}}
  post: {{from: [1 m, 0.5 m], to: [1 m, -1 m], {usual}, left: {{clamped: n}}}}
"""
    assert squares(joined, 10) == pytest.approx(squares(parts, 10), rel=1e-11)


def test_columns_under_weight_bend_as_those_that_keep_their_length():
    text = (Path(__file__).parents[2] / "trials/loaded_portal_frame.yaml").read_text()
    kept = squares(text, 1)
    differences = [squares(text.replace("EI: EI, ", f"EI: EI, EA: {EA} N, "), 1) / kept - 1 for EA in ("1e12", "1e13")]
    assert (abs(differences[0]) < 1e-5).all()
    assert differences[1] == pytest.approx(differences[0] / 10, rel=1e-3, abs=1e-10)
