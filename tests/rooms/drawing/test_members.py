"""Pictures of members: every one is drawn with what holds it, modes are bent as their fields tell, nodes are marked."""

from math import pi, sin
from pathlib import Path

import pytest
from support.overlaps import crossed, touching
from support.scenes import kept_problem_of, problem, problem_of

from vibcli.drawing import animation
from vibcli.drawing.canvas.primitives import BODY, Circle, Hatch, LetterRuns, Polygon, Polyline
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout import compose, plane
from vibcli.drawing.symbols import member, member_ends, mode_shape
from vibcli.drawing.vibration import Vibration

ROOT = Path(__file__).parents[3]
EXAMPLES = [ROOT / "vibcli/examples" / f"{name}.yaml" for name in ("bars", "shafts", "beams", "strings", "beam")]
STRING = """
    strings: {cord: {length: 2 m, preload: 50 N, mass_per_length: 0.1 kg/m, left: clamped, right: pinned}}
"""
CANTILEVER = """
    parameters: {M: 2 kg}
    beams: {arm: {from: [0, 0], to: [3 m, 0], EI: 900 N*m^2, mass_per_length: 1 kg/m, left: clamped,
      right: {clamped: block}}}
    bodies: {block: {mass: M, at: [3 m, 0], move: [0, y, psi]}}
"""


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_member_is_drawn_and_no_word_lies_over_another(path):
    found = kept_problem_of(path)
    stage, drawn = compose.Scenery(found.scene), draw(found)
    assert {strip.name for strip in stage.strips} == {name.partition(".")[0] for name in found.scene.members}
    boxes = [part.box for part in drawn if isinstance(part, LetterRuns)]
    assert not [(a, b) for i, a in enumerate(boxes) for b in boxes[:i]
                if min(a[2], b[2]) - max(a[0], b[0]) > 1e-6 and min(a[3], b[3]) - max(a[1], b[1]) > 1e-6]


def test_numbers_of_the_file_stand_as_in_print():
    drawn = draw(problem("""
        gravity: 9.81 m/s^2
        beams: {arm: {from: [0, 0], to: [3 m, 0], EI: 900 N*m^2, mass_per_length: 1 kg/m, left: clamped}}
    """))
    written = {"".join(run.text for run in part.runs) for part in drawn if isinstance(part, LetterRuns)}
    assert {"g = 9.81 m/s²", "900 N·m²"} <= written


def test_a_beam_is_named_by_all_its_stiffnesses():
    drawn = draw(problem("""
        parameters: {EI: 900 N*m^2, EA: 1 MN}
        beams: {arm: {from: [0, 0], to: [3 m, 0], EI: EI, EA: 2*EA, mass_per_length: 1 kg/m, left: clamped}}
    """))
    told = ["".join(run.text for run in part.runs) for part in drawn if isinstance(part, LetterRuns)]
    assert [text for text in told if "E" in text] == ["EI, 2EA"]


def test_a_clamped_string_bends_as_its_mode_and_rests_at_its_nodes():
    found = problem(STRING)
    vibration = Vibration(found, 3, compose.Scenery(found.scene))
    (bend,), (strip,) = vibration.bends(0.0).values(), vibration.stage.strips
    places = [0.1 * i for i in range(21)]
    size = bend.at([1 / 3])[0][1]
    for x, (_, u) in zip(places, bend.at(places), strict=True):
        assert u == pytest.approx(size * sin(3 * pi * x / 2), abs=1e-9 * abs(size))
    assert bend.nodes == pytest.approx([2 / 3, 4 / 3])
    drawn = mode_shape.draw(found, 3)
    marks = [part for part in drawn if isinstance(part, Circle) and part.role == "coordinate"]
    assert [part.centre for part in marks] == [pytest.approx(strip.at(x)) for x in bend.nodes]


def test_a_beam_ends_where_the_body_is_that_it_holds():
    found = problem(CANTILEVER)
    for index in (1, 2, 3):
        stage = compose.Scenery(found.scene)
        vibration = Vibration(found, index, stage)
        moved, (bend,) = vibration.at(0.0), vibration.bends(0.0).values()
        assert member.place(stage.strips[0], bend, 3.0) == pytest.approx(moved.frames["block"].place, abs=1e-6)
        assert member.place(stage.strips[0], bend, 0.0) == pytest.approx(stage.strips[0].start)


def test_ends_have_their_signs():
    def drawn(left):
        return draw(problem("beams: {arm: {length: 1 m, EI: 9 N*m^2, mass_per_length: 1 kg/m, left: " + left
                            + ", attached: [{at: 1 m, k: 1 N/m}]}}"))

    def count(parts, kind):
        return sum(isinstance(part, kind) for part in parts)

    free, clamped, pinned, guided = map(drawn, ("free", "clamped", "pinned", "guided"))
    assert count(clamped, Hatch) == count(free, Hatch) + 1
    assert count(pinned, Polygon) == count(free, Polygon) + 1
    assert count(guided, Circle) == count(free, Circle) + 2
    assert count(drawn("{k: 2 N/m}"), Polyline) == count(free, Polyline) + 1


def test_modes_move_and_return():
    frames, words, _ = animation.of_mode(problem(STRING), 2)
    assert words.startswith("mode 2")
    assert frames[0] != frames[animation.FRAMES // 4]


@pytest.mark.sweep
def test_motions_in_time_bend_members_that_have_no_coordinates():
    found = problem_of(ROOT / "problems/8_continuous/plucked_string.yaml")
    frames, _, _ = animation.of_response(found)

    def curve(frame):
        return next(part.points for part in frame if isinstance(part, Polyline) and part.role == "ink")

    first = curve(frames[0])
    heights = [y - first[0][1] for _, y in first]
    assert max(heights) > 10.0 and heights[len(heights) // 4] == pytest.approx(max(heights), rel=0.05)
    assert curve(frames[7]) != first


HUNG = """
    parameters: {k: 2 kN/m, m: 1 kg}
    %s
"""
ATTACHED = "attached: [{at: 1 m, oscillator: {mass: m, k: k}}, {at: 2 m, k: 50*k}]"
CARRIERS = {
    "beam": "beams: {arm: {length: 2 m, EI: 900 N*m^2, mass_per_length: 1 kg/m, left: clamped, " + ATTACHED + "}}",
    "placed beam": "beams: {arm: {from: [0, 0], to: [0, 2 m], EI: 900 N*m^2, mass_per_length: 1 kg/m, left: clamped, "
                   + ATTACHED + "}}",
    "bar": "bars: {arm: {length: 2 m, EA: 900 N, mass_per_length: 1 kg/m, left: clamped, " + ATTACHED + "}}",
    "string": "strings: {arm: {length: 2 m, preload: 90 N, mass_per_length: 1 kg/m, left: pinned, " + ATTACHED + "}}",
}


@pytest.mark.parametrize("name", CARRIERS)
def test_oscillators_move_as_the_mode_tells_and_the_ground_stays(name):
    found = problem(HUNG % CARRIERS[name])
    for index in (1, 2, 3):
        stage = compose.Scenery(found.scene)
        vibration = Vibration(found, index, stage)
        (strip,), (still,), (moved,) = stage.strips, vibration.bends(None).values(), vibration.bends(0.0).values()
        drawn = [member_ends.draw(strip, bend, sketch)[0] for bend, sketch in (
            (still, vibration.rest), (moved, vibration.at(0.0)))]
        before, after = (next(part for part in parts if isinstance(part, Polygon) and part.layer == BODY and
                              abs(part.points[0][0] - part.points[2][0]) + abs(part.points[0][1] - part.points[2][1])
                              == pytest.approx(48.0)).points[0] for parts in drawn)
        shape = vibration.shape[found.scene.coordinates.index("arm.oscillator(1 m)")].real
        way = plane.left(strip.e) if strip.sideways else strip.e
        assert plane.minus(after, before) == pytest.approx(
            plane.times(way, shape * vibration.amplitude * moved.unit), abs=1e-6)
        grounds = [[part.points for part in parts if isinstance(part, Hatch)] for parts in drawn]
        assert grounds[0] and [end for one in grounds[0] for end in one] == [
            pytest.approx(end, abs=1e-9) for one in grounds[1] for end in one]


DRIVEN = """
    parameters: {k: 2 kN/m, m: 1 kg, F: 9 N, W: 8 rad/s}
    points: {mid: {body: arm, at: 0.5 m}}
    forces: {F: {at: mid, force: F*sin(W*t)}}
    bodies: {block: {mass: m, slide: y}}
    springs: {s: {k: k, between: [mid, block]}%s}
    find: [{response: {until: 0.5 s}}]
    %s
"""


@pytest.mark.sweep
def test_oscillators_move_in_time_and_lumped_bodies_are_tied_to_points():
    found = problem(DRIVEN % (", t: {k: k, between: [ground, block]}", CARRIERS["beam"]))
    frames, _, _ = animation.of_response(found)
    blocks = [[part.points for part in frame if isinstance(part, Polygon) and part.layer == BODY and
               plane.distance(part.points[0], part.points[2]) == pytest.approx(35.777, abs=1e-3)] for frame in frames]
    heights = [points[0][1] for points, in blocks]
    assert max(heights) - min(heights) > 3.0
    ties = [[part.points for part in frame if isinstance(part, Polyline) and part.dashed] for frame in frames]
    assert all(len(one) == 1 for one in ties) and ties[5] != ties[20]


BLOCK = pytest.approx(35.777, abs=1e-3)     # the diagonal of a block that hangs


def hanging(figure):
    return [part.points for part in figure
            if isinstance(part, Polygon) and plane.distance(part.points[0], part.points[2]) == BLOCK]


def test_a_body_that_a_spring_alone_joins_to_a_member_hangs_there():
    found = problem(DRIVEN % ("", CARRIERS["beam"].replace(", " + ATTACHED, "")))
    figure = draw(found)
    (block,) = hanging(figure)
    stage = compose.Scenery(found.scene)
    (strip,), (one,) = stage.strips, stage.hung
    assert not stage.rows and (one.body, one.moves, one.ties) == ("block", "y", ("s",))
    assert plane.middle(*block[::2])[0] == pytest.approx(strip.at(0.5)[0])
    names = {"".join(run.text for run in part.runs): part.role for part in figure if isinstance(part, LetterRuns)}
    assert names["k"] == names["m"] == "ink" and names["y"] == "coordinate"
    assert not [name for name in names if "between" in name] and crossed(figure) == touching(figure) == []


@pytest.mark.sweep
def test_a_body_that_hangs_moves_in_a_mode_and_in_time():
    found = problem(DRIVEN % ("", CARRIERS["beam"].replace(", " + ATTACHED, "")))
    stage = compose.Scenery(found.scene)
    for index in (1, 2):
        vibration = Vibration(found, index, stage)
        rest, moved = (hanging(compose.figure(stage, sketch, vibration.unit, None, vibration.bends(theta))[0])
                       for sketch, theta in ((vibration.rest, None), (vibration.at(0.0), 0.0)))
        shape = vibration.shape[found.scene.coordinates.index("y")].real
        assert moved[0][0][1] - rest[0][0][1] == pytest.approx(shape * vibration.amplitude * vibration.unit, abs=1e-6)
    frames, _, _ = animation.of_response(found)
    heights = [points[0][1] for frame in frames for points in hanging(frame)]
    assert len(heights) == len(frames) and max(heights) - min(heights) > 3.0


@pytest.mark.parametrize("more", [", t: {k: k, between: [ground, block]}", ", t: {k: k, between: [mid, block]}",
                                  ", t: {k: k, stretch: 2*y}"])
def test_a_body_that_more_joins_stands_in_a_row(more):
    stage = compose.Scenery(problem(DRIVEN % (more, CARRIERS["beam"])).scene)
    assert not stage.hung and [list(layout.places) for layout in stage.rows] == [["block"]]


def test_a_member_held_by_a_body_of_a_row_is_tied_to_it():
    text = """
        parameters: {k: 2 kN/m, m: 1 kg}
        bodies: {cart: {mass: m, slide: x}}
        springs: {s: {k: k, between: [ground, cart]}}
        beams: {mast: {length: 2 m, EI: 900 N*m^2, mass_per_length: 1 kg/m, left: {clamped: cart}}}
    """
    figure = draw(problem(text))
    (dashed,) = [part.points for part in figure if isinstance(part, Polyline) and part.dashed]
    assert not [part for part in figure if isinstance(part, Circle) and part.radius == member_ends.BALL]
    assert "mast: left end clamped to cart" in ["".join(run.text for run in part.runs) for part in figure
                                                if isinstance(part, LetterRuns)]
    (strip,) = compose.Scenery(problem(text).scene).strips
    assert dashed[1] == pytest.approx(strip.start)


@pytest.mark.parametrize("load", ["{at: tip, force: %sF*sin(W*t)}", "{body: arm, per_length: %sF/(1 m)*sin(W*t)}"])
def test_a_load_with_a_minus_has_its_arrow_the_other_way(load):
    senses = {}
    for sign in ("", "-"):
        figure = draw(problem(f"""
            parameters: {{F: 3 N, W: 2 rad/s}}
            points: {{tip: {{body: arm, at: 2 m}}}}
            beams: {{arm: {{length: 2 m, EI: 900 N*m^2, mass_per_length: 1 kg/m, left: clamped}}}}
            forces: {{load: {load % sign}}}
        """))
        arrows = [part.points for part in figure if isinstance(part, Polyline) and part.role == "load"]
        (name,) = ["".join(run.text for run in part.runs) for part in figure
                   if isinstance(part, LetterRuns) and part.role == "load"]
        assert arrows and not name.startswith("−")
        senses[sign] = {tip[1] > start[1] for start, tip in arrows}
    assert senses == {"": {True}, "-": {False}}
