"""Drawings as SVG: nothing that loads or runs, words as words, and motion that passes through every frame."""

import math
import re
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import pytest
from support.scenes import kept_drawing_of, kept_problem_of, problem, problem_of

from vibcli.base.errors import PhysicsError
from vibcli.drawing import animation
from vibcli.drawing.canvas.primitives import Circle, Hatch, LetterRuns, Polygon, Polyline, extent
from vibcli.drawing.canvas.svg_canvas import MARGIN, picture
from vibcli.drawing.canvas.svg_motion import MOVES, RESTS, moving
from vibcli.drawing.drawing import contents, draw
from vibcli.drawing.layout import fonts, lettering, plane

ROOT = Path(__file__).parents[3]
FILES = sorted([*ROOT.glob("problems/*/*.yaml"), *ROOT.glob("vibcli/examples/*.yaml")])
SVG = "{http://www.w3.org/2000/svg}"
ALLOWED = {"svg", "title", "desc", "style", "rect", "circle", "path", "text", "g", "animate",
           "animateTransform"}
HOSTILE = "</title><script>alert(1)</script>\x00\u202e\"'&]]>"
SPRING = Path("vibcli/examples/free_vibration.yaml")
LEAST_MODES, FEW = 100, 12          # frames


def parsed(data):
    """The root, when the text is XML of allowed elements that name nothing outside."""
    root = ElementTree.fromstring(data)
    assert {element.tag.removeprefix(SVG) for element in root.iter()} <= ALLOWED
    for element in root.iter():
        assert not [name for name in element.attrib if name.lower().startswith("on") or "href" in name or name == "id"]
        assert not re.search(r"url\(|javascript:|@import", " ".join([*element.attrib.values(), element.text or ""]))
    return root


def points(path):
    """[[(x, y), …] of each stroke], y upwards."""
    return [[(float(x), -float(y)) for x, y in (pair.split(",") for pair in stroke.split())]
            for stroke in path.get("d").removesuffix("Z").split("M")[1:]]


# still pictures

@pytest.mark.sweep
def test_every_scene_is_drawn_within_its_frame():
    for path in FILES:
        given = kept_problem_of(path)
        drawn = kept_drawing_of(path)
        root = parsed(picture(drawn, given.spec.get("title") or "", contents(given.spec)))
        left, top, width, height = map(float, root.get("viewBox").split())
        box = extent(drawn)
        assert [left, top, left + width, top + height] == pytest.approx(
            [box[0] - MARGIN, -box[3] - MARGIN, box[2] + MARGIN, -box[1] + MARGIN], abs=0.03)
        assert len(root.findall(f"{SVG}g")) == sum(isinstance(part, LetterRuns) for part in drawn)


def test_the_elements_are_those_of_the_drawing():
    drawn = [Polyline(((0.0, 0.0), (30.0, 10.0)), dashed=True, width=2.0), Circle((5.0, 7.0), 3.0, "body"),
             Polygon(((0, 0), (9, 0), (9, 4)), layer=0), Hatch(((0.0, 0.0), (12.0, 0.0))),
             lettering.text(lettering.named("phi1"), 4.0, 20.0, "coordinate")]
    root = parsed(picture(drawn, "t", "a"))
    kinds = [element.tag.removeprefix(SVG) for element in root]
    assert kinds == ["title", "desc", "rect", "path", "path", "circle", "path", "g"]
    triangle, ground, line = root.findall(f"{SVG}path")
    assert triangle.get("d").endswith("Z") and points(triangle) == [[(0, 0), (9, 0), (9, 4)]]
    assert [[p for stroke in points(ground) for p in stroke]] == [
        [pytest.approx(p, abs=0.006) for stroke in drawn[3].strokes() for p in stroke]]
    assert line.get("stroke-dasharray") == "8 6" and line.get("fill") is None
    assert root.find(f"{SVG}circle").get("cy") == "-7"
    runs = root.find(f"{SVG}g")
    assert [run.text for run in runs] == ["φ", "1"] and runs[0].get("font-style") == "italic"
    assert float(runs[1].get("y")) > float(runs[0].get("y")) and float(runs[1].get("x")) > float(runs[0].get("x"))


def test_words_are_text_and_hostile_ones_stay_words():
    root = parsed(picture(draw(problem("bodies: {b: {mass: 2 kg, slide: x}}")), HOSTILE, HOSTILE))
    assert root.find(f"{SVG}title").text == root.find(f"{SVG}desc").text == HOSTILE.replace(
        "\x00", "\ufffd").replace("\u202e", "\ufffd")
    assert "".join(root.find(f"{SVG}g").itertext()) == "2 kg"


def test_words_are_as_wide_as_drawn_in_every_font():
    """A run of letters, be it one (m of m₁), states its width, which is that up to the next run; blanks need none. Each
    is an element text of its own: Firefox knows no width of parts of one."""
    drawn = draw(kept_problem_of(ROOT / "problems/5_forced/compressor_to_be_isolated.yaml"))
    load = next(part for part in drawn if isinstance(part, LetterRuns) and part.role == "load")
    spans = [*parsed(picture([load])).iter(f"{SVG}text")]
    assert any("sin" in span.text for span in spans) and not any(span.text != span.text.strip(" ") for span in spans)
    for span, after in pairwise(spans):
        if span.text.strip():
            assert 0 < float(after.get("x")) - float(span.get("x")) - float(span.get("textLength")) < 1.0
        else:
            assert span.get("textLength") is None


def test_what_a_scene_consists_of():
    assert contents(problem_of(ROOT / "problems/6_two_degrees/quarter_car_damped.yaml").spec) == (
        "bodies: wheel, sprung; springs: tyre, suspension; dampers: absorber")


@pytest.mark.sweep
@pytest.mark.parametrize("file", sorted({file for files in lettering.FONTS.values() for file in files}))
def test_fonts_are_read_as_freetype_reads_them(file):
    """Every letter has the glyph and the advance that FreeType finds, and no other letter any."""
    from matplotlib.ft2font import FT2Font, LoadFlags

    ours, theirs = fonts.font(file), FT2Font(fonts.path(file))
    glyphs = theirs.get_charmap()
    assert [code for code in range(0x110000) if ours.glyph(chr(code)) != glyphs.get(code, 0)] == []
    advances = [theirs.load_char(code, flags=LoadFlags.NO_SCALE | LoadFlags.NO_HINTING).horiAdvance for code in glyphs]
    assert [round(ours.units * ours.advance(chr(code))) for code in glyphs] == advances and len(glyphs) > 1000


# what moves

def said_of(element, count):
    """{attribute: its values in each of `count` frames and the first again} of a path or circle, as its animations
    tell."""
    said = {child.get("attributeName") + child.get("type", ""): child.get("values").split(";") for child in element}
    assert all(len(values) == count + 1 for values in said.values())
    return said


def shown(element, said, index):
    """[places] of a path or circle in a frame."""
    now = {name: values[index] for name, values in said.items()}
    if element.tag == f"{SVG}circle":
        return [tuple(float(now.get(name, element.get(name))) * sign for name, sign in (("cx", 1), ("cy", -1)))]
    if "d" in now:
        return [point for stroke in points({"d": now["d"]}) for point in stroke]
    shift = now.get("transformtranslate", (element.get("transform") or "(0 0)").split("(")[1].strip(")"))
    x, y = map(float, shift.split())
    turn = -math.radians(float(now.get("transformrotate", 0)))
    return [plane.plus((x, -y), plane.turned(point, turn)) for stroke in points(element) for point in stroke]


def assert_passes_through(frames, data):
    """What moves is in every frame where the drawing has it."""
    root, ordered = parsed(data), [sorted(frame, key=lambda part: part.layer) for frame in frames]
    elements = [element for element in root if element.tag in (f"{SVG}path", f"{SVG}circle")
                and element.get("class") != RESTS]
    assert len(elements) == len(ordered[0])
    for element, *parts in zip(elements, *ordered, strict=True):
        said = said_of(element, len(frames))
        for index in (0, 1, len(frames) // 3, len(frames) - 1):
            part = parts[index]
            wanted = [part.centre] if isinstance(part, Circle) else part.points
            found = shown(element, said, index)[:len(wanted)]
            assert max(map(plane.distance, found, wanted)) < 0.06
    return sum(element.get("class") == MOVES for element in elements)


@pytest.mark.sweep
def test_modes_pass_through_every_frame(monkeypatch):
    """Of a third of the frames in a third of the room."""
    assert animation.FRAMES == 3 * FEW
    monkeypatch.setattr(animation, "FRAMES", FEW)
    checked = 0
    for path in FILES:
        given = kept_problem_of(path)
        if given.numeric.has_free_symbols or given.spec.choices:
            continue
        try:
            frames, words, _ = animation.of_mode(given, 1)
        except PhysicsError:
            continue
        data = moving(frames, words, closed=True)
        assert assert_passes_through(frames, data) and len(data) < 400_000 / 3
        checked += 1
    assert checked >= LEAST_MODES


def test_what_keeps_its_shape_is_shifted_and_turned():
    wheel = Polygon(tuple(plane.circle((0.0, 0.0), 20.0)))
    
    def at(angle):
        return [wheel._replace(points=tuple(plane.plus((9.0 * angle, 1.0), plane.turned(p, angle))
                                            for p in wheel.points))]
    frames = [at(0.5 * i) for i in range(40)]       # three turns, in one sense
    data = moving(frames, "a wheel", closed=False)
    assert assert_passes_through(frames, data) == 1
    path, = (element for element in parsed(data) if element.get("class") == MOVES)
    turns = [float(value) for value in path[1].get("values").split(";")]
    assert [child.get("type") for child in path] == ["translate", "rotate"] and path[1].get("additive") == "sum"
    assert turns == sorted(turns, reverse=True) and turns[-1] == pytest.approx(-math.degrees(0.5 * 39), abs=0.01)
    assert turns[-1] == turns[-2]       # an open motion waits for its end


def test_springs_are_stretched_and_walls_stand():
    frames, words, _ = animation.of_mode(problem_of(ROOT / SPRING), 1)
    root = parsed(moving(frames, words, closed=True))
    still = [path for path in root.findall(f"{SVG}path") if path.get("class") is None]
    assert still and all(not len(path) for path in still)
    stretched = [path for path in root.findall(f"{SVG}path") if len(path) and path[0].get("attributeName") == "d"]
    assert stretched and all(path[0].get("values").split(";")[0] == path[0].get("values").split(";")[-1] for path in
                             stretched)


def test_one_frame_rests_for_who_prefers_it():
    frames, words, _ = animation.of_mode(problem_of(ROOT / SPRING), 1)
    text = moving(frames, words, closed=True).decode()
    assert "prefers-reduced-motion:reduce" in text and "@media print" in text
    root, quarter = parsed(text.encode()), {part.points for part in frames[len(frames) // 4]
                                            if isinstance(part, Polyline)}
    resting = [element for element in root if element.get("class") == RESTS]
    assert len(resting) == sum(element.get("class") == MOVES for element in root) and not any(map(len, resting))
    wanted = [[pytest.approx(p, abs=0.006) for p in line] for line in quarter]
    assert any(points(element)[0] in wanted for element in resting if element.tag == f"{SVG}path")
    assert RESTS not in moving(frames, words, rests=False).decode()


def test_frames_that_do_not_consist_of_the_same_are_shown_in_turn():
    line = Polyline(((0.0, 0.0), (9.0, 0.0)))
    root = parsed(moving([[line], [line, Circle((4.0, 4.0), 1.0)], [line]], "t", milliseconds=100, rests=False))
    groups = root.findall(f"{SVG}g")
    told = [(group[-1].get("values"), group[-1].get("keyTimes")) for group in groups]
    assert [len(group) - 1 for group in groups] == [1, 2, 1] and groups[0].get("visibility") == "hidden"
    assert told == [("visible;hidden", "0;0.333333"), ("hidden;visible;hidden", "0;0.333333;0.666667"),
                    ("hidden;visible", "0;0.666667")]
    assert groups[0][-1].get("dur") == "0.3s"


def test_ordinates_of_members_are_there_all_the_time():
    frames, *_ = animation.of_mode(problem_of(ROOT / "problems/8_continuous/bar_with_end_mass.yaml"), 1)
    assert len({len(frame) for frame in frames}) == 1


def test_a_motion_without_bodies_is_refused():
    with pytest.raises(PhysicsError, match="no bodies") as refused:
        animation.of_response(problem("coordinates: [x]\nmatrices: {M: [[1]], K: [[4]]}\ninitial: {x: 1}"))
    assert "--plot" in refused.value.hint


@pytest.mark.sweep
@pytest.mark.parametrize("kind", ["gif", "svg"])
def test_it_is_told_how_far_the_frames_are(kind):
    given, told = problem_of(ROOT / SPRING), []
    given.work.tell = lambda *said: told.append(said)
    animation.of_mode(given, 1)
    assert [said for said in told if said[0] == "the frames"] == [
        ("the frames", i / animation.FRAMES, True) for i in range(1, animation.FRAMES + 1)]
    from vibcli.api.pictures import animated

    told.clear()
    animated(given, 1, "", kind)
    assert (("the picture", 1.0, True) in told) == (kind == "gif")
