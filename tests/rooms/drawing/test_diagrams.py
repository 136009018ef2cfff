"""Diagrams of forces and moments within members: what is drawn are the values of signals, nothing lies over another."""

from functools import cache
from itertools import combinations, pairwise
from math import pi, sin
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from support.scenes import problem, problem_of, value

from vibcli.api.values import quantity_value
from vibcli.base.errors import NoBound, PhysicsError
from vibcli.drawing.canvas.primitives import LetterRuns, Polyline
from vibcli.drawing.layout.compose import Scenery
from vibcli.drawing.layout.diagram_values import told, zeros
from vibcli.drawing.layout.lettering import letters
from vibcli.mechanics.internal_forces import InternalForce, forces_at_rest
from vibcli.numerics.stretches import CurveStretch
from vibcli.report.sections.force_diagrams import WhichForces, force_drawing, force_figure, found_forces

ROOT = Path(__file__).parents[3]
LOADED = """
    parameters: {L: 2 m, q0: 300 N/m, F: 500 N, T: 80 N*m}
    beams: {wing: {length: L, EI: 4e3 N*m^2, mass_per_length: 3 kg/m, left: pinned, right: pinned}}
    points: {mid: {body: wing, at: L/4}}
    forces: {w: {body: wing, per_length: -q0}, F: {at: mid, force: -F}, T: {at: mid, moment: T}}
"""
INCLINED = """
    parameters: {EI: 4e5 N*m^2}
    gravity: 9.81 m/s^2
    beams: {boom: {from: [0, 0], to: [3 m, 4 m], EI: EI, left: clamped, attached: [{at: 5 m, mass: 100 kg}]}}
"""
STRETCHING = """
    parameters: {H: 3 m, L: 4 m, EI: 4 MN*m^2, EA: 900 MN, mu: 400 kg/m}
    bodies: {A: {mass: 0 kg, inertia: 0 kg*m^2, at: [0, H], move: [x, y, p]}}
    beams:
      post: {from: [0, 0], to: [0, H], EI: EI, EA: EA, mass_per_length: mu, left: clamped, right: {clamped: A}}
      girder: {from: [0, H], to: [L, H], EI: EI, EA: EA, mass_per_length: mu, left: {clamped: A}, right: clamped}
"""
TURNED = """
    parameters: {EI: 4e3 N*m^2, mu: 3 kg/m, F: 50 N, q: 20 N/m}
    gravity: 9.81 m/s^2
    bodies: {head: {mass: 2 kg, at: [0, 2 m], move: [x, 0, p]}}
    beams:
      post: {from: [0, 0], to: [0, 2 m], EI: EI, mass_per_length: mu, left: clamped, right: {clamped: head}}
      arm: {from: [0, 2 m], to: [1 m, 2 m], EI: EI, mass_per_length: mu, left: {clamped: head}, right: pinned}
    strings: {chain: {from: [0.5 m, 2 m], to: [0.5 m, 1 m], mass_per_length: mu, left: {pinned: arm, at: 0.5 m}}}
    forces:
      F: {at: head, force: [F*cos(300 rad/s*t), 0]}
      q: {body: arm, per_length: q*x/(1 m)*cos(100 rad/s*t)}
"""
CASES = {
    "two frequencies, a chain and a post that is pressed": (TURNED, WhichForces(amplitudes=True)),
    "stretching": (STRETCHING, WhichForces(mode=2)),
    "loaded": (LOADED, WhichForces()), "a mode": (LOADED, WhichForces(mode=3)), "inclined": (INCLINED, WhichForces()),
    **{f"{name} {which.mode or 'at rest'}": (ROOT / f"vibcli/examples/{name}.yaml", which)
       for name, which in (("beams", WhichForces()), ("beams", WhichForces(2)), ("shafts", WhichForces(2)),
                           ("strings", WhichForces()), ("bars", WhichForces()))},
    "frame": (ROOT / "problems/8_continuous/portal_frame.yaml", WhichForces(mode=1)),
    "struck": (ROOT / "problems/8_continuous/struck_bar.yaml", WhichForces(at=150e-6)),
    "kept up": (ROOT / "problems/8_continuous/bridge_under_an_engine.yaml", WhichForces(amplitudes=True)),
}


@cache
def scene_of(name):
    found, which = CASES[name]
    return (problem_of(found) if isinstance(found, Path) else problem(found)), which


@pytest.mark.sweep
@pytest.mark.parametrize("name", CASES)
def test_values_drawn_are_those_of_signals(name):
    scene, which = scene_of(name)
    quantity = ("amplitude({})" if which.amplitudes else f"{{}}({which.at} s)" if which.at else
                f"mode[{which.mode}][{{}}]" if which.mode else "equilibrium[{}]")
    forces = [one for one in found_forces(scene, which)[0] if one.largest]
    assert forces
    for force in forces:
        for stretch in force.stretches[:3]:
            for x in (stretch.start, stretch.start + 0.37 * (stretch.end - stretch.start)):
                known = quantity_value(scene, quantity.format(f"{force.member}.{force.part}({x!r} m)")).value
                assert stretch.values(np.array([x]))[0] == pytest.approx(known, rel=1e-9, abs=1e-9 * force.largest)


def test_a_beam_under_a_force_a_moment_and_an_even_load():
    """R = F·3/4 + qL/2 + T/L at the left end; the shear jumps by −F, the moment by −T, which lifts what follows."""
    L, q, F, T = 2.0, 300.0, 500.0, 80.0
    R = 0.75 * F + q * L / 2 + T / L
    shear, moment = found_forces(problem(LOADED), WhichForces())[0]
    assert told(shear) == [pytest.approx(pair) for pair in (
        (0.0, R), (0.5, R - q / 2 - F), (0.5, R - q / 2), (L, R - q * L - F))]
    below = 0.5 * R - q * 0.125
    top = (R - F) / q
    assert [y for _, y in told(moment)] == pytest.approx(
        [0.0, below - T, below, (R - F) * top - q * top**2 / 2 + F / 2 - T, 0.0], abs=1e-9)
    assert shear.stretches[1].zeros(shear.largest) == pytest.approx([top])


def test_a_mode_of_a_beam_on_two_supports():
    scene = problem_of(ROOT / "vibcli/examples/beam.yaml")
    shear, moment = found_forces(scene, WhichForces(mode=3))[0]
    size = value(scene, "mode[3][wing.moment(1 m/3)]")
    for stretch in moment.stretches:
        x = np.linspace(stretch.start, stretch.end, 9)
        assert stretch.values(x) == pytest.approx([size * sin(3 * pi * y / 2) for y in x], abs=1e-9 * abs(size))
    assert zeros(moment) == pytest.approx([2 / 3, 4 / 3])
    assert [y for y, _ in told(moment)] == pytest.approx([0, 1 / 3, 1, 5 / 3, 2], abs=1e-5)
    assert zeros(shear) == pytest.approx([1 / 3, 1, 5 / 3])


@pytest.mark.sweep
@pytest.mark.parametrize("name", CASES)
def test_no_word_lies_over_another(name):
    drawn = force_drawing(*scene_of(name))
    boxes = [part.box for part in drawn if isinstance(part, LetterRuns)]
    assert len(boxes) > 3
    assert not [(a, b) for a, b in combinations(boxes, 2) if min(a[2], b[2]) - max(a[0], b[0]) > 1e-6
                and min(a[3], b[3]) - max(a[1], b[1]) > 1e-6]


def test_moments_stand_on_the_side_in_tension_and_the_front_of_a_wave_is_upright():
    scene = problem("parameters: {P: 9 N}\nbeams: {arm: {length: 1 m, EI: 9 N*m^2, left: clamped}}\n"
                    "points: {tip: {body: arm, at: 1 m}}\nforces: {P: {at: tip, force: -P}}")
    drawn = force_drawing(scene, WhichForces())
    curves = [part.points for part in drawn if isinstance(part, Polyline) and part.width == 1.4]
    lines, outlines = curves[::2], curves[1::2]
    tops = [outline[1][1] - line[0][1] for line, outline in zip(lines, outlines, strict=True)]
    assert tops == pytest.approx([40.0, 40.0])
    assert "−9 N·m" in [letters(part.runs) for part in drawn if isinstance(part, LetterRuns)]
    force, = found_forces(*scene_of("struck"))[0]
    places, values = force.stretches[0].points()
    i = int(np.abs(np.diff(values)).argmax())
    assert places[i + 1] - places[i] < 1e-3 and np.abs(np.diff(values))[i] > 0.9 * force.largest


def test_where_the_motion_has_no_bound_the_scene_stands_at_rest_above_the_diagrams(monkeypatch):
    def refused(*_):
        raise NoBound("no bound is known")

    monkeypatch.setattr("vibcli.drawing.animation.at_instant", refused)
    drawn = force_drawing(*scene_of("struck"))
    assert "the scene is drawn at rest: no bound is known" in [
        letters(part.runs) for part in drawn if isinstance(part, LetterRuns)]


def test_forces_and_moments_balance_at_a_corner_without_mass():
    """What turns the corner passes on: the tension of the post is less the shear of the girder, its shear the tension
    of the girder, and the moment stands on one side."""
    at = {(force.member, force.part): force for force in found_forces(*scene_of("stretching"))[0]}
    post = {part: at["post", part].stretches[-1].values(np.array([3.0]))[0] for part in ("force", "shear", "moment")}
    girder = {part: at["girder", part].stretches[0].values(np.array([0.0]))[0] for part in post}
    assert [post["force"], post["shear"], post["moment"]] == pytest.approx(
        [-girder["shear"], girder["force"], girder["moment"]], rel=1e-9)


@pytest.mark.sweep
def test_members_in_the_plane_stand_where_they_are():
    scene, which = scene_of("frame")
    drawn, stage = force_drawing(scene, which), Scenery(scene.scene)
    lines = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "ink" and part.width == 1.4]
    for strip in stage.strips:
        way = np.subtract(strip.end, strip.start)
        assert sum(np.allclose(np.subtract(b, a), way) for a, b in lines) >= 2     # of shear and of moment


def test_extremes_and_zeros_of_a_curve():
    curve = CurveStretch(0.0, 3.0, lambda x: np.cos(2 * np.asarray(x)))
    assert curve.extremes() == pytest.approx([pi / 2], abs=1e-5)
    assert curve.zeros(1.0) == pytest.approx([pi / 4, 3 * pi / 4], abs=1e-12)
    even = CurveStretch(0.0, 3.0, lambda x: 5.0 + 1e-13 * np.sin(99 * np.asarray(x)))
    assert even.extremes() == even.zeros(5.0) == []
    halves = InternalForce("a", "force", [curve._replace(end=pi / 4), curve._replace(start=pi / 4)])
    assert zeros(halves) == pytest.approx([pi / 4, 3 * pi / 4], abs=1e-12)
    assert told(InternalForce("a", "force", [even, even._replace(start=3.0, end=4.0)])) == [(2.0, pytest.approx(5.0))]


def test_what_is_not_there_is_refused_and_the_terminal_shows_the_same():
    with pytest.raises(PhysicsError, match="all diagrams are zero"):
        force_drawing(problem_of(ROOT / "vibcli/examples/beam.yaml"), WhichForces())
    with pytest.raises(PhysicsError, match="no members"):
        found_forces(problem("coordinates: [x]\nparameters: {m: 1 kg, k: 1 N/m}\nenergies: {T: m*x'^2/2, V: k*x^2/2}"),
                     WhichForces())
    figure = force_figure(problem(LOADED), WhichForces())
    assert [panel.y_label for panel in figure.panels] == ["shear (EI u″)′ [N]", "moment EI u″ [N·m]"]
    curve, = figure.panels[0].curves
    assert curve.x[0] == 0.0 and curve.y[0] == pytest.approx(715.0) and max(curve.x) == 2.0


def test_a_beam_whose_tension_varies_balances_piece_by_piece():
    """V(x) − V(0) = w x + N(x) u′(x) − N(0) u′(0) and M′ = V, u′ = θ₀ + ∫M/B, between displacements of the end that
    are given, N(x) = N₀ + n x being what the weight leaves."""
    scene = problem("gravity: 9.81 m/s^2\nbeams: {boom: {from: [0, 0], to: [3 m, 4 m], EI: 4e3 N*m^2, "
                    "mass_per_length: 8 kg/m, left: clamped}}")
    given = {"boom.u(5.0 m)": 0.02, "boom.slope(5.0 m)": -0.01}
    names = dict(zip(scene.scene.coordinates, given.values(), strict=True))
    bent = SimpleNamespace(scene=scene.configuration.scene, at_rest=scene.numeric.at_rest_in(names))
    shear, moment = forces_at_rest(bent)
    nodes, weights = np.polynomial.legendre.leggauss(40)
    B, n, w = 4e3, 8 * 9.81 * 0.8, -8 * 9.81 * 0.6
    N = lambda x: -n * 5 + n * x                       # noqa: E731 - pressed by what stands above

    def slope(x):
        places = x / 2 * (nodes + 1)
        return (x / 2 * weights) @ moment.stretches[0].values(places) / B

    assert slope(5.0) == pytest.approx(-0.01, rel=1e-10)
    assert sum(2.5 * weight * slope(2.5 * (x + 1)) for x, weight in zip(nodes, weights, strict=True)) == pytest.approx(
        0.02, rel=1e-10)
    V = shear.stretches[0].values(np.array([0.0, 1.0, 2.7, 5.0]))
    for x, value_there in zip((1.0, 2.7, 5.0), V[1:], strict=True):
        assert value_there - V[0] == pytest.approx(w * x + N(x) * slope(x), rel=1e-9)


def test_an_amplitude_that_vanishes_between_two_places_has_no_value_there():
    """|M| under one load comes to a corner at 0, which is no least value to be told."""
    for place in (0.3141592, 0.35, 0.3777, 0.41, 0.4321):
        corner = CurveStretch(0.0, 1.0, lambda x, place=place: np.abs(np.asarray(x) - place))
        assert [x for x, _ in told(InternalForce("a", "moment", [corner]))] == [0.0, 1.0]


def test_a_value_is_written_once_where_the_curve_has_it_twice_close_together():
    """The least shear between two supports stands so near to the second one that both read alike."""
    which = WhichForces(mode=2)
    scene = problem_of(ROOT / "problems/8_continuous/overhanging_beam_with_a_mass.yaml")
    words = ["".join(run.text for run in part.runs) for part in force_drawing(scene, which)
             if isinstance(part, LetterRuns)]
    shear = found_forces(scene, which)[0][0]
    values = [y for _, y in told(shear)]
    assert any(abs(a - b) < 1e-4 * shear.largest for a, b in pairwise(values)) and "0.5171 m" in words
    newtons = [word for word in words if word.endswith(" N")]
    assert len(newtons) > 3 and len(set(newtons)) == len(newtons)
