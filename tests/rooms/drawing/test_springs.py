"""Springs with a gap, or that only push or only pull, show it; what runs over bodies leaves their arrows free."""

from pathlib import Path

import pytest
from support.overlaps import cross, crossed, touching
from support.scenes import kept_drawing_of, problem

from vibcli.drawing.canvas.primitives import ARROW, LetterRuns, Polyline
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.lettering import words
from vibcli.drawing.layout.space import Space

ROOT = Path(__file__).parents[3]

PLACES = {"row": "slide: x", "plane": "at: [0, -1 m], slide: {along: [0, -1], by: x}"}


def springs(place, more):
    fixed = "ground" if place == "row" else "[0, 0]"
    drawn = draw(problem(f"""
        parameters: {{m: 2 kg, k: 900 N/m, a: {{value: 5 mm, unused: allowed}}}}
        bodies: {{p: {{mass: m, {PLACES[place]}}}}}
        springs: {{s: {{k: k, between: [{fixed}, p]{more}}}}}
        motion: full
    """))
    assert touching(drawn) == []
    return [part.points for part in drawn if isinstance(part, Polyline) and part.role == "spring"]


def apart(lines):
    """The largest distance, along it, of two points of a spring between which there is nothing."""
    along = 0 if len({y for _, y in lines[0][:1] + lines[0][-1:]}) == 1 else 1
    ends = sorted((min(p[along] for p in line), max(p[along] for p in line)) for line in lines)
    reached, widest = ends[0][1], 0.0
    for low, high in ends:
        widest, reached = max(widest, low - reached), max(reached, high)
    return widest


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize(("more", "lines", "wide"), [
    ("", 1, False), (", acts: compression", 4, False), (", acts: compression, gap: a", 4, True),
    (", acts: tension", 5, False), (", acts: tension, gap: a", 5, False), (", gap: a", 5, False)])
def test_one_sided_springs_and_gaps(place, more, lines, wide):
    found = springs(place, more)
    assert len(found) == lines and (apart(found) > 5.0) == wide


def test_a_slack_rope_has_room_to_go_before_it_pulls_and_play_is_on_both_sides():
    for more, low, high in ((", acts: tension, gap: a", 0.2, 0.45), (", gap: a", 0.45, 0.55),
                            (", acts: tension", 0.6, 0.9)):
        _, _, head, *frame = springs("row", more)
        left, right = (end(x for line in frame for x, _ in line) for end in (min, max))
        assert low < (head[0][0] - left) / (right - left) < high


def test_the_arrow_of_a_coordinate_stands_beside_what_is_led_over_its_body():
    drawn = draw(problem("""
        parameters: {m: 2 kg, k: 900 N/m}
        bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}, c: {mass: m, slide: z}}
        springs: {s: {k: k, between: [a, b]}, t: {k: k, between: [b, c]}, u: {k: k, between: [a, c]}}
    """))
    arrows = [part.points for part in drawn if isinstance(part, Polyline) and part.layer == ARROW]
    legs = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "ink" and len(part.points) == 2
            and part.layer != ARROW]
    assert len(legs) == 2 and crossed(drawn) == touching(drawn) == []
    assert not [1 for arrow in arrows for leg in legs if cross(arrow, leg)]


def test_each_of_three_elements_side_by_side_has_its_name_at_it():
    drawn = draw(problem("""
        parameters: {m: 2 kg, k: 900 N/m, c: 3 N*s/m, b: 1 kg}
        bodies: {a: {mass: m, slide: x}}
        springs: {s: {k: k, between: [ground, a]}}
        dampers: {d: {c: c, between: [ground, a]}}
        inerters: {i: {b: b, between: [ground, a]}}
    """))
    piston = next(part for part in drawn if part.role == "damper" and part.width > 1.5).points
    middle = (piston[0][1] + piston[-1][1]) / 2
    levels = {part.runs[0].text: (part.box[1] + part.box[3]) / 2 for part in drawn if isinstance(part, LetterRuns)}
    assert abs(levels["c"] - middle) < 15.0 < levels["k"] - levels["c"] and touching(drawn) == []


def test_a_radius_meets_no_arrow_of_a_coordinate_where_another_place_is_free():
    drawn = kept_drawing_of(ROOT / "problems/3_free_undamped/half_disc_in_track.yaml")
    arc, = [part.points for part in drawn
            if isinstance(part, Polyline) and part.role == "coordinate" and len(part.points) > 2]
    ray, = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "measure"]
    assert min(plane.distance(p, q) for p in arc for q in (ray[0], ray[-1])) > 6.0


def test_words_keep_clear_of_the_edges_of_thick_lines():
    for thick, far in ((0.8, 0.8), (1.7, 1.7)):
        line = Polyline(((0.0, 0.1), (60.0, 0.1)), "load", thick)
        word = Space([line]).put(words("F0 saw(t)"), [(30.0, 1.2)])
        assert max(word.box[1] - 0.1, 0.1 - word.box[3]) > far
