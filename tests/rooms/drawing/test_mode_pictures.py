"""Pictures of modes, still and moving, go the way that the table of mode shapes tells, in every scene that has any."""

import cmath
from itertools import pairwise
from math import pi
from pathlib import Path

import pytest
from support.scenes import kept_problem_of, problem, problem_of

from vibcli.analyses.continuous import mode_fields
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.drawing import animation, vibration
from vibcli.drawing.canvas.primitives import SURFACE, Polygon, Polyline
from vibcli.drawing.layout import compose, plane
from vibcli.drawing.layout.lumped_place import KEPT
from vibcli.drawing.symbols import mode_shape
from vibcli.drawing.symbols.member import BED, bed, place
from vibcli.report.sections.spectrum_data import frequencies_data

ROOT = Path(__file__).parents[3]
FILES = sorted([*(ROOT / "problems").glob("*/*.yaml"), *(ROOT / "vibcli" / "examples").glob("*.yaml"),
                *(ROOT / "tests" / "trials").glob("*.yaml")])[::3]
STEP, LEAST_SCENES, LEAST_MODES = 1e-5, 40, 70


def displaced(rest, moved):
    """{what moves: how far, as numbers of one length} between two Sketches."""
    found = {(name, "place"): plane.minus(moved.frames[name].place, frame.place) for name, frame in rest.frames.items()}
    found |= {(name, "angle"): (moved.frames[name].angle - frame.angle,) for name, frame in rest.frames.items()}
    return found | {(name, "axis"): (moved.lumped[name] - u,) for name, u in rest.lumped.items()}


def against(told, shown):
    """What moves against what was told, small displacements left out."""
    wrong = []
    for kind in ("place", "angle", "axis"):
        parts = {key: value for key, value in told.items() if key[1] == kind}
        most = max((sum(x * x for x in value) for value in parts.values()), default=0.0)
        wrong += [key for key, value in parts.items() if sum(x * x for x in value) > 0.01 * most
                  and sum(x * y for x, y in zip(value, shown[key], strict=True)) <= 0]
    return wrong


def checked(found):
    """How many modes of a scene were drawn; AssertionError where a picture contradicts the table."""
    stage, count = compose.Scenery(found.scene), 0
    for row in frequencies_data(found)["modes"]:
        mode = found.modal.modes[row["index"] - 1]
        shape = {name: complex(*value) if isinstance(value, list) else value for name, value in row["shape"].items()}
        if mode.rigid or any(isinstance(value, complex) for value in shape.values()):
            continue
        base = found.configuration.equilibrium.values
        told = stage.at({**base, **{name: base[name] + STEP * value for name, value in shape.items()}})
        moving = vibration.Vibration(found, mode.index, stage)
        for theta in (0.0, vibration.phases(36)[1]):        # the still picture; the moving one, just after its start
            other = moving.at(theta + pi)                   # to the other side: large turns displace alike to both
            assert not against(displaced(moving.rest, told), displaced(other, moving.at(theta))), row
        count += 1
    return count


@pytest.mark.sweep
def test_pictures_agree_with_the_table():
    counts = []
    for path in FILES:
        found = kept_problem_of(path)
        if found.numeric.has_free_symbols or found.spec.choices or not found.scene.bodies:
            continue
        try:
            counts.append(checked(found))
        except PhysicsError:
            continue
    assert len(counts) >= LEAST_SCENES and sum(counts) >= LEAST_MODES


SEEN = """
bodies:
  near: {mass: 2 kg, at: [0, 0], slide: x}
  far: {mass: 1 kg, at: [1 m, 0], slide: y}
springs: {s: {k: 300 N/m, between: [[-1 m, 0], near]}, u: {k: 200 N/m, between: [near, far]}}
"""


@pytest.mark.parametrize("normalise", ["first", "largest", "mass"])
def test_the_table_may_be_normalised_otherwise(normalise):
    found = problem(SEEN)
    stage = compose.Scenery(found.scene)
    for mode in found.modal.modes:
        moving = vibration.Vibration(found, mode.index, stage, normalise)
        for name, value in zip(("near", "far"), found.modal.shape(mode, normalise), strict=True):
            assert (moving.at(0.0).frames[name].place[0] - moving.rest.frames[name].place[0]) * value > 0


@pytest.mark.parametrize("shape", [[1.0, -2j], [1.0, 2j], [1.0, -2 + 0.1j], [1.0, -2.0]])
def test_what_leads_by_a_quarter_of_a_period_is_seen(shape):
    """Of a gyroscopic mode the largest amplitude is shown, and what is in phase with the first goes its way."""
    turned = [value * cmath.exp(-1j * vibration._lead(max(shape, key=abs))) for value in shape]
    assert turned[0].real >= -1e-12 and abs(turned[1].real) == pytest.approx(abs(shape[1]), rel=1e-2)


@pytest.mark.parametrize("name", ["two_storeys", "beats", "chain_of_masses"])
def test_arrows_are_as_long_as_the_mode_tells(name):
    """Of lumped bodies: the largest LUMPED long, the others in proportion."""
    found = problem_of(ROOT / f"vibcli/examples/{name}.yaml")
    stage = compose.Scenery(found.scene)
    for mode in found.modal.modes:
        moving = vibration.Vibration(found, mode.index, stage)
        ways = [moving.at(0.0).lumped[body] - moving.rest.lumped[body] for row in stage.rows for body in row.places]
        parts = mode_shape._arrows(stage, moving.rest, moving.at(0.0), moving.unit)
        starts = [part.points[0][0] for part in parts if isinstance(part, Polyline) and part.role == "coordinate"
                  and part.points[0][0] == part.points[1][0]]
        tips = [part.points[0][0] for part in parts if isinstance(part, Polygon)]
        told = [(start, way / max(map(abs, ways)) * vibration.LUMPED) for start, way in zip(starts, ways, strict=True)]
        assert tips == pytest.approx([start + length for start, length in told if abs(length) > 2.0])


@pytest.mark.sweep
def test_the_shape_of_a_member_is_found_once_for_all_frames(monkeypatch):
    asked, shape_along = [], mode_fields.shape_along

    def counting(pieces, places):
        asked.append(places)
        return shape_along(pieces, places)

    monkeypatch.setattr(mode_fields, "shape_along", counting)
    frames, _, _ = animation.of_mode(problem_of(ROOT / "problems/8_continuous/hanging_chain.yaml"), 1)
    assert len(frames) >= 36 and 1 <= len(asked) <= 6


@pytest.mark.parametrize("index", [3, 10])
def test_bodies_close_together_in_a_row_leave_room_for_the_springs_between_them(index):
    found = kept_problem_of(ROOT / "vibcli" / "examples" / "many_modes.yaml")
    stage = compose.Scenery(found.scene)
    motion = vibration.Vibration(found, index, stage)
    (row,) = stage.rows
    for theta in (0.0, pi):
        moved = {name: place.middle[0] + motion.unit * motion.at(theta).lumped[name]
                 for name, place in row.places.items()}
        gaps = [moved[b] - moved[a] - row.places[a].half - row.places[b].half for a, b in pairwise(row.row.bodies)]
        assert min(gaps) > KEPT - 1e-9 and max(gaps) > KEPT + 5.0


@pytest.mark.sweep
@pytest.mark.parametrize("index", [1, 2])
def test_springs_of_a_bed_follow_the_member_that_rests_on_them(index):
    """Each reaches from the ground to the edge of the rail, which stays above the ground."""
    found = kept_problem_of(ROOT / "problems" / "8_continuous" / "rail_on_elastic_foundation.yaml")
    stage = compose.Scenery(found.scene)
    motion = vibration.Vibration(found, index, stage)
    (strip,) = stage.strips
    for theta in (0.0, pi):
        bend = motion.bends(theta)[strip.name]
        springs = [part.points for part in bed(strip, bend, ()) if part.role == "spring"]
        for points in springs:
            x = (points[-1][0] - strip.start[0]) / strip.scale
            ((_, u),) = bend.at([x])
            assert abs(points[0][1] - points[-1][1] - BED - u * bend.unit) < 1e-9
        assert len(springs) > 5 and min(points[0][1] - points[-1][1] for points in springs) > 5.0


def test_the_end_of_an_arm_and_the_hub_that_guides_it_are_joined_by_a_rail():
    found = kept_problem_of(ROOT / "vibcli" / "examples" / "arm_on_a_hub.yaml")
    stage = compose.Scenery(found.scene)
    motion = vibration.Vibration(found, 1, stage)
    (strip,) = stage.strips
    for theta in (0.0, pi):
        bends, sketch = motion.bends(theta), motion.at(theta)
        (rail,) = [part.points for part in mode_shape.frame(stage, sketch, motion.unit, motion.room, bends)
                   if isinstance(part, Polyline) and part.width == 2.4 and part.layer == SURFACE]
        for joined in (place(strip, bends[strip.name], strip.metres), sketch.frames["hub"].place):
            assert plane.distance(plane.nearest_on(joined, *rail), joined) < 1.0


def test_a_bead_stays_on_the_rod_that_turns_with_it_however_far_it_goes():
    found = kept_problem_of(ROOT / "vibcli" / "examples" / "bead_on_a_turning_rod.yaml")
    stage = compose.Scenery(found.scene)
    (slide,) = found.scene.coordinates
    positions = [{slide: u} for u in (0.0, 0.4, 1.5)]
    sketches, unit, room = vibration.response(stage, positions, [0.0, 0.3, 0.7])
    for sketch in sketches:
        rods = [part.points for part in mode_shape.frame(stage, sketch, unit, room)
                if isinstance(part, Polyline) and part.width == 2.4]
        (bead,) = [sketch.frames[name].point(sketch.centre(name)) for name in sketch.frames
                   if "slide" in found.scene.bodies[name].record]
        assert any(plane.distance(plane.nearest_on(bead, *rod), bead) < 1e-6 for rod in rods)


LETTERS = """\
parameters: {m: , k: , L: }
bodies: {a: {mass: m, at: [0, 0], slide: x}, b: {mass: m, at: [L, 0], slide: y}}
springs: {s: {k: k, between: [[-L, 0], a]}, t: {k: k, between: [a, b]}}
"""
BAR = "parameters: {L: , EA: , mu: }\nbars: {r: {length: L, EA: EA, mass_per_length: mu, left: clamped}}\n"


@pytest.mark.parametrize(("text", "command", "what", "names"), [
    (LETTERS, ["animate"], "the picture of a mode", "m, k, L"),
    (LETTERS, ["draw", "--mode", "1"], "the picture of a mode", "m, k, L"),
    (LETTERS, ["animate", "--response"], "the picture of a motion in time", "m, k, L"),
    (BAR, ["draw", "--diagrams"], "a diagram of forces", "L, EA, mu"),
    (LETTERS, ["frequencies", "--plot"], "a plot of the eigenvalues", "m, k, L"),
    (LETTERS, ["solve", "--digits", "20"], "--digits", "m, k, L")])
def test_what_needs_numbers_says_what_and_which_parameters_have_none(scene, capsys, text, command, what, names):
    assert run([command[0], scene(text), *command[1:]]) == 4
    told = capsys.readouterr().err
    assert f"error: {what} needs numbers, and these parameters have none: {names}\n" in told
    assert "hint: give them values in the file or with --set\n" in told


def test_a_page_says_which_modes_it_does_not_draw(scene, tmp_path):
    assert run(["solve", scene(LETTERS), "--pictures", "-o", str(tmp_path / "r.md")]) == 0
    told = (tmp_path / "r.md").read_text()
    assert "## Mode shapes on the scene at rest\n\nnot drawn: these parameters have no values: m, k, L\n" in told


@pytest.mark.parametrize("index", [1, 2])
def test_the_dashed_line_between_two_strings_follows_their_joined_ends(index):
    """The wire ends at the tip of the gut, in motion too; both are drawn as far aside, each in its own row."""
    found = kept_problem_of(ROOT / "problems" / "8_continuous" / "two_strings.yaml")
    stage = compose.Scenery(found.scene)
    motion = vibration.Vibration(found, index, stage)
    bends = motion.bends(0.0)
    dashed, = [part.points for part in compose.figure(stage, motion.at(0.0), motion.unit, bends=bends)[0]
               if isinstance(part, Polyline) and part.dashed]
    joined = [place(strip, bends[strip.name], x) for strip in stage.strips for x in (0.0, strip.metres)]
    assert all(any(plane.distance(end, one) < 1e-9 for one in joined) for end in dashed)
    still = [strip.at(x) for strip in stage.strips for x in (0.0, strip.metres)]
    assert min(plane.distance(end, one) for end in dashed for one in still) > 3.0
