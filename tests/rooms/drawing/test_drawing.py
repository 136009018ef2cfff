"""Drawings: every scene is drawn, no word lies over another, the same bytes, nothing is overwritten."""

import math
import os
import re
import subprocess
import sys
from html.parser import HTMLParser
from io import BytesIO
from itertools import combinations, pairwise
from pathlib import Path
from types import SimpleNamespace

import pytest
from support.imported import imported
from support.scenes import kept_drawing_of, kept_problem_of, problem, problem_of

from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.drawing import animation, vibration
from vibcli.drawing.canvas import pillow_canvas
from vibcli.drawing.canvas.matplotlib_canvas import MARGIN, figure, picture
from vibcli.drawing.canvas.primitives import Circle, Hatch, LetterRuns, Polygon, Polyline, extent
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout import compose, lettering, plane
from vibcli.drawing.layout.lettering import set_apart
from vibcli.drawing.symbols import SYMBOLS, mode_shape, on_surfaces, rope, sliding
from vibcli.elements import ELEMENTS
from vibcli.language.named_elements import load

ROOT = Path(__file__).parents[3]
FILES = sorted([*ROOT.glob("problems/*/*.yaml"), *ROOT.glob("vibcli/examples/*.yaml")])
CART = ROOT / "problems/6_two_degrees/cart_with_pendulum.yaml"
BLOCK = """
    parameters: {m: 2 kg, k: 800 N/m, c: 3 N*s/m}
    bodies: {block: {mass: m, slide: x}}
    springs: {s: {k: k, between: [ground, block]}}
    dampers: {d: {c: c, between: [ground, block]}}
"""
PENDULUM = """
    parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2}
    gravity: g
    bodies: {bob: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi}}}
"""


def texts(found):
    return [part for part in found if isinstance(part, LetterRuns)]


def words(found):
    return ["".join(run.text for run in part.runs) for part in texts(found)]


def test_figures_are_no_wider_than_a_column_of_text():
    wide = """
        parameters: {m: 2 kg, k: 800 N/m, L: 3 m}
        bodies: {beam: {shape: rod, mass: m, from: [0, 0], to: [L, 0], pin: {at: [0, 0], by: phi}}}
        springs: {s: {k: k, between: [end, [L, -0.1*L]]}}
        points: {end: {body: beam, at: [L, 0]}}
    """
    names = "abcdef"
    row = "parameters: {m: 2 kg, k: 800 N/m}\nbodies:\n" + "".join(
        f"  {name}: {{mass: m, slide: x_{name}}}\n" for name in names) + "springs:\n" + "".join(
        f"  s{i}: {{k: k, between: [{one}, {two}]}}\n" for i, (one, two) in enumerate(pairwise(names)))
    for scene in (wide, row):
        left, _, right, _ = extent(draw(problem(scene)))
        assert right - left < 425.0



def overlapping(boxes):
    """Pairs of boxes that share more than an edge."""
    return [(a, b) for a, b in combinations(boxes, 2) if min(a[2], b[2]) - max(a[0], b[0]) > 1e-6
            and min(a[3], b[3]) - max(a[1], b[1]) > 1e-6]


def test_the_rule_sees_words_over_one_another():
    assert overlapping([(0, 0, 10, 5), (9, 4, 12, 8)])
    assert not overlapping([(0, 0, 10, 5), (10, 0, 12, 8), (0, 5, 3, 8)])


@pytest.mark.parametrize("rate", [1, 7, 50, 1200])
@pytest.mark.parametrize("sign", ["", "-"])
def test_a_force_that_swings_points_the_way_in_which_it_begins(rate, sign):
    found = draw(problem(PENDULUM + f"    forces: {{pull: {{at: bob, force: [{sign}3 N*sin({rate} rad/s*t), 0]}}}}\n"))
    (start, tip), = (part.points for part in found if isinstance(part, Polyline) and part.role == "load")
    assert start[1] == pytest.approx(tip[1]) and (tip[0] > start[0]) == (not sign)


def test_there_are_files():
    assert len(FILES) >= 100


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_scene_is_drawn(path):
    given = kept_problem_of(path)
    for case in ("", *given.spec.cases):
        found = kept_drawing_of(path, case)
        assert all(math.isfinite(x) for part in found for stroke in part.strokes() for point in stroke for x in point)
        assert not overlapping([part.box for part in texts(found)])
        left, bottom, right, top = extent(found)
        assert right - left < 1500 and top - bottom < 1500
        assert all(left <= box[0] and bottom <= box[1] and box[2] <= right and box[3] <= top
                   for box in (part.box for part in texts(found)))


@pytest.mark.sweep
@pytest.mark.parametrize("path", [path for path in FILES if path.stem in (
    "chain_of_masses", "unbalanced_motor", "epicyclic_gear_with_sprung_ring", "lever_on_shaking_floor", "u_tube")],
    ids=lambda path: path.stem)
def test_words_are_as_large_as_measured(path):
    found = draw(problem_of(path))
    made = figure(found, dpi=144)
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    renderer = FigureCanvasAgg(made).get_renderer()
    boxes = [artist.get_window_extent(renderer) for artist in made.artists if hasattr(artist, "get_text")]
    left, bottom, _, _ = extent(found)
    measured = [part.box for part in texts(found) for run in part.runs for _ in set_apart(run)]
    assert len(boxes) == len(measured)
    for box, (x0, y0, x1, y1) in zip(boxes, measured, strict=True):
        if box.width:
            assert box.x0 / 2 >= x0 - left + MARGIN - 2 and box.x1 / 2 <= x1 - left + MARGIN + 2
            assert box.y0 / 2 >= y0 - bottom + MARGIN - 2 and box.y1 / 2 <= y1 - bottom + MARGIN + 2
        assert min(box.x0, box.y0) >= 0 and box.x1 <= made.bbox.width and box.y1 <= made.bbox.height


@pytest.mark.sweep
def test_the_same_bytes():
    """As PNG, SVG and PDF, in two processes that hash otherwise."""
    code = ("import sys, hashlib; sys.path.insert(0, 'tests')\nfrom support.scenes import problem_of\n"
            "from vibcli.drawing.drawing import draw\n"
            "from vibcli.drawing.canvas.files import data\n"
            f"drawn = draw(problem_of({str(CART)!r}))\n"
            "print([kind + hashlib.sha256(data(drawn, kind)).hexdigest() for kind in ('png', 'svg', 'pdf')])")
    one, two = (subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT,
                               env={**os.environ, "PYTHONHASHSEED": seed}).stdout for seed in ("1", "2"))
    assert one == two


@pytest.mark.sweep
def test_settings_of_the_user_change_nothing():
    import matplotlib

    before = picture(draw(problem(BLOCK)), "png")
    with matplotlib.rc_context({"savefig.bbox": "tight", "text.parse_math": True, "savefig.transparent": True,
                                "path.sketch": (5.0, 9.0, 2.0)}):
        assert picture(draw(problem(BLOCK)), "png") == before


def test_names_of_a_figure():
    found = words(draw(problem(PENDULUM)))
    assert {"m", "φ", "g", "L"} <= set(found)
    assert {"m", "k", "c", "x"} == set(words(draw(problem(BLOCK))))
    assert {"φ1", "k1"} <= set(words(draw(problem(
        "parameters: {J: 1 kg*m^2, k1: 3 N*m}\nbodies: {a: {inertia: J, turn: phi1}}\n"
        "springs: {s: {torsion: k1, between: [ground, a]}}\n"))))


def test_letters_and_indices():
    assert [(run.text, run.rise < 0) for run in lettering.named("phi1")] == [("φ", False), ("1", True)]
    assert [(run.text, run.rise < 0) for run in lettering.named("k_t")] == [("k", False), ("t", True)]
    assert lettering.words("a\u202eb\x07\U0010ffff")[0].text == "a□b□□"


# the elements

JOINING = [name for name in ELEMENTS if getattr(load(name).ELEMENT, "signals", None)]


@pytest.mark.parametrize("name", JOINING)
def test_springs_and_dampers_end_where_they_should(name):
    between = load(SYMBOLS[name][0], "drawing.symbols").between
    for a, b in (((0.0, 0.0), (60.0, 0.0)), ((3.0, 4.0), (-20.0, 90.0)), ((0.0, 0.0), (1.0, 0.0))):
        drawn = [p for part in between({}, a, b, plane.distance(a, b)) for p in getattr(part, "points", ())]
        assert min(plane.distance(a, p) for p in drawn) < 1e-9 and min(plane.distance(b, p) for p in drawn) < 1e-9
    stretched = between({}, (0, 0), (75, 0), 60)
    assert len(between({}, (0, 0), (60, 0), 60)[0].points) == len(stretched[0].points)


@pytest.mark.parametrize("element", [
    "springs: {s: {law: (3 N/m)*d + (5 N/m^3)*d^3, stretch: L*sin(phi)}}",
    "springs: {s: {torsion: true, law: (4 N*m)*sin(d), stretch: phi}}", "springs: {s: {k: 3 N/m, stretch: L*phi}}",
    "dampers: {s: {friction: 2 N, stretch: L*phi}}", "dampers: {s: {law: (3 N*s/m)*v, stretch: L*phi}}",
    "inerters: {s: {torsion: 3 kg*m^2, stretch: phi}}"])
def test_what_acts_on_a_written_stretch_stands_in_a_note(element):
    written = words(draw(problem(f"{PENDULUM}    {element}\n")))
    assert any(line.startswith("s: ") and " on " in line for line in written)


def test_ropes_are_tangents():
    given = problem_of(ROOT / "vibcli/examples/rope_over_pulleys.yaml")
    stage = compose.Scenery(given.scene)
    chain = stage.ropes["hoist"]
    pulleys = [(stage.sketch.now(stop.at), stop.radius) for stop in chain if stop.sense]
    assert len(pulleys) == 2
    parts = rope.draw(chain, stage.sketch)
    lines, arcs = ([part.points for part in parts if (len(part.points) > 2) == bent] for bent in (False, True))
    for centre, radius in pulleys:
        near = [plane.distance(centre, plane.nearest_on(centre, *points)) for points in lines]
        assert sorted(near)[:2] == pytest.approx([radius, radius])
    assert [plane.distance(arc[0], arc[-1]) / 2 for arc in arcs] == pytest.approx([radius for _, radius in pulleys])


def test_hatching_lies_on_its_side():
    strokes = Hatch(((0.0, 0.0), (40.0, 0.0)), -1).strokes()
    assert len(strokes) == 9 and all(p[1] <= 0 for stroke in strokes for p in stroke)


def test_a_floor_lies_below_and_a_wall_behind():
    found = draw(problem(BLOCK))
    hatch = next(part for part in found if isinstance(part, Hatch))
    box = next(part for part in found if isinstance(part, Polygon) and part.fill == "body")
    assert min(x for x, _ in hatch.points) < min(x for x, _ in box.points)
    assert min(y for _, y in hatch.points) < min(y for _, y in box.points)


def test_scale_changes_nothing():
    """A scene in millimetres is drawn as in metres."""
    small, large = (words_and_size(PENDULUM.replace("L: 1 m", f"L: {size}")) for size in ("1 mm", "1 km"))
    assert small == large


def words_and_size(text):
    found = draw(problem(text))
    return words(found), [round(x, 6) for x in extent(found)]


@pytest.mark.sweep
def test_letters_draw_what_overlaps_least():
    given = problem_of(ROOT / "problems/3_free_undamped/geared_pendulums.yaml")
    assert given.numeric.has_free_symbols
    found = draw(given)
    wheels = [part for part in found if isinstance(part, Polygon) and len(part.points) > 100]
    boxes = [plane.bounds(part.points) for part in wheels]
    assert len(boxes) == 2 and min(boxes[0][2], boxes[1][2]) - max(boxes[0][0], boxes[1][0]) < 5.0


def test_too_many_bodies_are_refused():
    many = "bodies:\n" + "".join(f"  b{i}: {{mass: 1 kg, slide: x{i}}}\n" for i in range(200))
    with pytest.raises(PhysicsError, match="not legible"):
        draw(problem(many))


def test_places_that_are_no_numbers_are_refused():
    given = problem(PENDULUM)
    stage = compose.Scenery(given.scene)
    with pytest.raises(PhysicsError, match="cannot be drawn"):
        stage.at({"phi": math.inf})


def test_sizes_that_differ_hugely():
    found = draw(problem("parameters: {a: 1e-60 m, b: 1e60 m}\nbodies: {b: {mass: 1 kg, at: [a, 0], slide: x}, "
                         "c: {mass: 1 kg, at: [b, 0], slide: y}, d: {shape: disc, radius: a, mass: 1 kg, at: [0, b], "
                         "pin: phi}}\nsprings: {s: {k: 1 N/m, between: [b, c]}}"))
    left, bottom, right, top = extent(found)
    assert right - left < 800 and top - bottom < 800


# modes and animations

def test_the_largest_displacement_is_readable():
    given = problem_of(CART)
    stage = compose.Scenery(given.scene)
    for index in (1, 2):
        moving = vibration.Vibration(given, index, stage)
        size = vibration.largest_displacement(moving.rest, moving.at(0.0), stage)
        assert 20 < size < 34
        rest = moving.at(math.pi / 2)
        assert vibration.largest_displacement(moving.rest, rest, stage) < 1e-9


def test_a_mode_moves_as_its_shape():
    given = problem_of(ROOT / "vibcli/examples/two_storeys.yaml")
    moving = vibration.Vibration(given, 2, compose.Scenery(given.scene))
    shape, sketch = given.modal.modes[1].shape, moving.at(0.0)
    assert sketch.lumped["second"] / sketch.lumped["first"] == pytest.approx(shape[1] / shape[0])
    assert max(abs(u) * moving.unit for u in sketch.lumped.values()) == pytest.approx(vibration.LUMPED)


@pytest.mark.parametrize("shape", ["shape: disc, radius: 0.7 m", "inertia: 1 kg*m^2"])
@pytest.mark.parametrize("pitch", [[0.5, 0.1], [0.1, 0.5]])
def test_the_inner_teeth_are_those_of_the_larger_pitch_radius(pitch, shape):
    """Whatever else a wheel has."""
    given = problem(f"""
        bodies:
          one: {{{shape}, mass: 1 kg, at: [0, 0], pin: phi}}
          two: {{mass: 1 kg, shape: disc, radius: 0.2 m, at: [0.4 m, 0], pin: psi}}
        constraints: {{mesh: {{gear: [one, two], radii: [{pitch[0]} m, {pitch[1]} m], inside: true}}}}
    """)
    assert compose.Scenery(given.scene).ties.rims == {"one" if pitch[0] > pitch[1] else "two"}


def test_inner_teeth_of_a_shape():
    given = problem_of(ROOT / "problems/6_two_degrees/epicyclic_gear_with_sprung_ring.yaml")
    assert compose.Scenery(given.scene).ties.rims == {"ring"}


def test_loops_stay_closed_in_a_mode():
    given = problem_of(ROOT / "problems/3_free_undamped/four_bar_with_springs.yaml")
    stage = compose.Scenery(given.scene)
    moving = vibration.Vibration(given, 1, stage)
    one, two = stage.ties.ends[-1]
    for theta in (0.0, 1.0, math.pi):
        sketch = moving.at(theta)
        assert plane.distance(sketch.now(one), sketch.now(two)) < 1e-6


def test_rest_is_grey_and_both_ways_are_dashed():
    found = mode_shape.draw(problem_of(CART), 2)
    assert any(part.role == "ghost" for part in found) and not any(getattr(part, "dashed", False) for part in found)
    both = mode_shape.draw(problem_of(CART), 2, both=True)
    assert any(getattr(part, "dashed", False) for part in both)
    assert words(found) == ["mode 2: ω = 4.17612 rad/s"]


@pytest.mark.parametrize(("text", "index", "message"), [
    (BLOCK, 2, "no mode 2"), ("parameters: {m: , k: }\nbodies: {b: {mass: m, slide: x}}\n"
                              "springs: {s: {k: k, between: [ground, b]}}", 1, "needs numbers"),
    ("coordinates: [x]\nmatrices: {M: [[1]], K: [[4]]}", 1, "no bodies")])
def test_modes_that_cannot_be_drawn(text, index, message):
    with pytest.raises(PhysicsError, match=message):
        mode_shape.draw(problem(text), index)


@pytest.mark.sweep
def test_gif_and_page_of_a_mode():
    from PIL import Image

    frames, caption, names = animation.of_mode(problem_of(CART), 2)
    assert caption == "mode 2: ω = 4.17612 rad/s" and len(frames) == len(names) == animation.FRAMES
    first, second = (animation.data(frames, caption, names, "title", "gif") for _ in range(2))
    assert first == second and len(first) < 2_000_000
    shown = Image.open(BytesIO(first))
    assert shown.is_animated and shown.n_frames > 10 and max(shown.size) <= 600
    assert len(animation.data(frames, caption, names, "title", "html")) < 2_000_000


@pytest.mark.parametrize("low", [-400.0, 0.0, 900.0])
@pytest.mark.parametrize("high", [30.0, 500.0])
def test_the_caption_of_a_gif_stands_whole_below_the_drawing(low, high):
    import numpy as np
    from PIL import Image

    frames = [[Polygon(((0, low), (200, low), (200, low + high), (0, low + high)))]] * 2
    page = np.asarray(Image.open(BytesIO(pillow_canvas.gif(frames, "ω = 4.17612 rad/s"))).convert("L"), int)
    margin, below = pillow_canvas.MARGIN, pillow_canvas.MARGIN + pillow_canvas.FOOT
    foot = page[-int(len(page) * below / (high + margin + below)) + 3:]
    rows, columns = np.nonzero(foot < 128)
    assert len(rows) > 30 and rows.min() > 0 and columns.max() < page.shape[1] - 2
    assert rows.max() < len(page) * (1 - margin / (high + margin + below)) - (len(page) - len(foot)) + 1


class Tags(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.tags, self.attributes = [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += attrs


def test_a_page_needs_nothing_else_and_escapes_titles():
    frames, caption, names = animation.of_mode(problem_of(CART), 2)
    plain, hostile = (Tags(animation.data(frames, caption, names, title, "html").decode()) for title in (
        "a", "</script><script>alert(1)</script><img src=x onerror=alert(1)>\"'&{0}"))
    assert plain.tags == hostile.tags and plain.tags.count("script") == 1
    assert not {name for name, _ in hostile.attributes} & {"src", "href", "onerror", "onload", "xlink:href"}
    text = animation.data(frames, caption, names, "a", "html").decode()
    assert set(re.findall(r"https?://[^\"]*", text)) == {"http://www.w3.org/2000/svg"} and "url(" not in text
    assert f'max="{len(frames) - 1}"' in text and all(f'"{name}"' in text for name in names)


def test_any_motion_can_be_shown():
    given = problem(PENDULUM)
    times = [0.1 * i for i in range(9)]
    frames, _, names = animation.of_positions(given, [{"phi": 0.5 * math.sin(3 * t)} for t in times], times)
    assert len(frames) == 9 and names[1] == "0.1 s"
    bobs = [next(part for part in frame if isinstance(part, Polygon) and len(part.points) > 20) for frame in frames]
    middle = [plane.middle(*[(box[0], box[1]), (box[2], box[3])]) for box in (plane.bounds(b.points) for b in bobs)]
    assert middle[1][0] > middle[0][0]
    assert middle[3][0] == pytest.approx(-middle[3][1] * math.tan(0.5 * math.sin(0.9)), rel=1e-3)


@pytest.mark.parametrize("kind", ["small", "full"])
def test_the_response_of_a_scene(kind):
    given = problem(PENDULUM + f"    initial: {{phi: 0.4 rad}}\n    motion: {kind}\n")
    given = given.until(2 * math.pi / math.sqrt(9.81))
    frames, words, names = animation.of_response(given)
    assert len(frames) == animation.FRAMES and words == "0 s to 2.006 s" and names[-1] == "2.006 s"
    bobs = [next(part for part in frame if isinstance(part, Polygon) and len(part.points) > 20) for frame in frames]
    across = [sum(plane.bounds(bob.points)[0::2]) / 2 for bob in bobs]
    assert across[0] == pytest.approx(max(across)) and min(across) < -0.9 * max(across)


@pytest.mark.sweep
def test_a_scene_at_rest_is_not_animated():
    sagging = "parameters: {L: 1 m, EI: 9 N*m^2, mu: 1 kg/m, q: 3 N/m}\n" \
        "beams: {b: {length: L, EI: EI, mass_per_length: mu, left: clamped}}\n" \
        "forces: {f: {body: b, per_length: q}}\n"
    for text in (BLOCK, sagging):
        with pytest.raises(PhysicsError, match="stays at rest"):
            animation.of_response(problem(text))


@pytest.mark.parametrize("frames", [
    lambda given: [mode_shape.draw(given, 1)], lambda given: animation.of_mode(given, 1)[0][::12],
    lambda given: animation.of_response(given)[0][::12]])
def test_a_particle_on_a_curve_is_seen_on_it_in_motion_too(frames):
    given = problem("""
        coordinates: {s: m}
        parameters: {m: 1 kg, a: 1 m, g: 9.81 m/s^2}
        gravity: g
        bodies: {p: {mass: m, at: [0, 0], move: {by: [s, s^2/(2*a), 0]}}}
        initial: {s: 0.2 m}
    """)
    for drawn in frames(given):
        path, = [part.points for part in drawn if isinstance(part, Polyline) and part.dashed]
        left, bottom, right, top = plane.bounds([p for part in drawn if isinstance(part, (Polygon, Circle))
                                                 and part.fill == "body" for p in part.points])
        ball = plane.middle((left, bottom), (right, top))
        near = [plane.distance(ball, plane.nearest_on(ball, *stretch)) for stretch in pairwise(path)]
        assert path[0][0] < ball[0] < path[-1][0] and min(near) < 0.5


@pytest.mark.sweep
def test_large_animations_lose_frames(monkeypatch):
    from vibcli.drawing.canvas import pillow_canvas

    frames, *_ = animation.of_mode(problem_of(CART), 2)
    whole = pillow_canvas.gif(frames, "")
    monkeypatch.setattr(pillow_canvas, "LARGEST", len(whole) - 1)
    assert len(pillow_canvas.gif(frames, "")) < 0.7 * len(whole)


def test_small_motions_are_magnified():
    given = problem(PENDULUM)
    times = [0.0, 1.0, 2.0]
    _, words, _ = animation.of_positions(given, [{"phi": 1e-4 * math.sin(t)} for t in times], times)
    factor = float(words.partition("×")[2])
    assert factor > 100 and f"{factor:g}"[0] in "125"


# the commands

def test_draw_writes_a_file_once(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert run(["draw", str(CART)]) == 0
    assert "wrote cart_with_pendulum.png" in capsys.readouterr().err
    made = tmp_path / "cart_with_pendulum.png"
    before = made.read_bytes()
    assert before.startswith(b"\x89PNG")
    made.write_bytes(b"mine")
    assert run(["draw", str(CART)]) == 2
    assert "exists already" in capsys.readouterr().err and made.read_bytes() == b"mine"
    assert run(["draw", str(CART), "--force"]) == 0
    assert made.read_bytes() == before
    assert sorted(path.name for path in tmp_path.iterdir()) == ["cart_with_pendulum.png"]


@pytest.mark.parametrize("command", [["draw"], ["draw", "--mode", "1"], ["animate"]])
def test_links_are_not_followed(command, tmp_path, capsys):
    suffix = ".gif" if command == ["animate"] else ".svg"
    target, link = tmp_path / f"target{suffix}", tmp_path / f"link{suffix}"
    target.write_bytes(b"mine")
    link.symlink_to(target)
    for options in ([], ["--force"]):
        assert run([*command, str(CART), "-o", str(link), *options]) == 2
        assert "link" in capsys.readouterr().err
    assert target.read_bytes() == b"mine" and link.is_symlink()
    dangling = tmp_path / f"dangling{suffix}"
    dangling.symlink_to(tmp_path / "nowhere")
    assert run([*command, str(CART), "-o", str(dangling)]) == 2
    assert not (tmp_path / "nowhere").exists()


@pytest.mark.parametrize(("args", "code", "message"), [
    (["draw", "-o", "a.jpg"], 2, ".png, .svg, .pdf"), (["animate", "-o", "a.png"], 2, ".gif, .svg, .html"),
    (["draw", "-o", "nowhere/a.png"], 2, "no folder"), (["draw", "--case", "x"], 2, "no case 'x'"),
    (["draw", "--both"], 2, "--both belongs to --mode"), (["draw", "--mode", "9"], 4, "no mode 9"),
    (["animate", "--response", "--mode", "1"], 2, "exclude"), (["animate", "--until", "2"], 2, "belongs to --response"),
    (["animate", "--response", "--until", "x"], 2, "expected a time"),
    (["draw", "--mode", "0"], 2, "--mode"), (["animate", "--mode", "9"], 4, "modes 1 to 2")])
def test_wrong_commands(args, code, message, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert run([args[0], str(CART), *args[1:]]) == code
    assert message in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.sweep
def test_a_mode_of_a_scene_that_chooses(tmp_path):
    scene = ROOT / "vibcli/examples/two_springs_for_two_frequencies.yaml"
    assert run(["draw", str(scene), "--mode", "2", "-o", str(tmp_path / "a.png")]) == 0
    assert run(["animate", str(scene), "-o", str(tmp_path / "a.gif")]) == 0


def test_hostile_names_make_plain_files(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    scene = tmp_path / "scene.yaml"
    scene.write_text("title: $\\alpha$ </script> {0}\nparameters: {m: 2 kg, k: 8 N/m}\n"
                     "bodies: {b: {mass: m, slide: x}}\nsprings: {s: {k: k, between: [ground, b]}}\n"
                     "cases: {'../../evil $x^2$ /etc': {parameters: {m: 3 kg}}}\n")
    assert run(["draw", "scene.yaml", "--case", "../../evil $x^2$ /etc"]) == 0
    assert run(["animate", "scene.yaml", "-o", "a.html"]) == 0
    assert run(["draw", "scene.yaml", "--mode", "1", "-o", "a.svg"]) == 0
    names = sorted(path.name for path in tmp_path.iterdir())
    assert names == ["a.html", "a.svg", "scene-evil-x-2-etc.png", "scene.yaml"]
    assert "&lt;/script&gt;" in (tmp_path / "a.html").read_text()


@pytest.mark.sweep
@pytest.mark.parametrize(("args", "unwanted"), [
    (["draw", "-o", "a.png"], ()), (["draw", "-o", "a.svg"], ("matplotlib", "numpy", "PIL", "html")),
    (["draw", "--mode", "1", "-o", "b.png"], ()), (["draw", "--mode", "1", "-o", "b.svg"], ("matplotlib", "PIL")),
    (["animate", "-o", "a.html"], ("matplotlib", "PIL")), (["animate", "-o", "a.svg"], ("matplotlib", "PIL")),
    (["animate", "-o", "a.gif"], ("matplotlib",)),
    (["solve", "--pictures", "-o", "a.html"], ("matplotlib", "PIL"))],
    ids=["png", "svg", "mode", "mode-svg", "html", "moving", "gif", "report"])
def test_what_a_picture_imports(args, unwanted, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code, names = imported(args[0], str(CART.resolve()), *args[1:])
    assert code == 0 and (tmp_path / args[-1]).exists()
    assert not {"matplotlib.pyplot", "scipy", "sympy", *unwanted} & set(names)


def test_circles_and_arcs_look_round():
    for radius in (2.0, 40.0, 300.0):
        points = Circle((0.0, 0.0), radius).points
        gaps = [radius - plane.distance((0, 0), plane.middle(a, b)) for a, b in pairwise(points)]
        assert max(gaps) < 0.1


@pytest.mark.parametrize("angle", range(-170, 180, 40))
@pytest.mark.parametrize("reach", [(-10, 90), (-150, 5), (-20, 20), (60, 200)])
def test_a_wedge_lies_under_all_that_slides_on_it(angle, reach):
    """Its slope is parallel to the way, below it by half a block, and as long as the way of what is carried."""
    along, place = (math.cos(math.radians(angle)), math.sin(math.radians(angle))), (30.0, -20.0)
    way = [plane.plus(place, along, s) for s in reach]
    (foot, _, head), = (part.points for part in sliding._ramp(place, along, way).pieces)
    up = along if along[1] > 0 else plane.times(along, -1)
    ends = [plane.dot(plane.minus(point, foot), up) for point in way]
    long = plane.dot(plane.minus(head, foot), up)
    assert foot[1] < head[1] and all(-1e-9 <= end <= long + 1e-9 for end in ends)
    normal = plane.left(up) if up[0] > 0 else plane.times(plane.left(up), -1)
    assert [plane.dot(plane.minus(point, corner), normal) for point in way for corner in (foot, head)] == \
        pytest.approx([sliding.BLOCK[1] / 2] * 4)


@pytest.mark.parametrize("place", [-60.0, -5.0, 10.0, 50.0, 95.0, 170.0])
@pytest.mark.parametrize("angle", [0, 50, 200])
def test_a_plank_lies_under_its_whole_surface_and_its_centre(place, angle, monkeypatch):
    e = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    a = (20.0, -30.0)
    b, centre = plane.plus(a, e, 100.0), plane.plus(plane.plus(a, e, place), plane.left(e), -12.0)
    monkeypatch.setattr(on_surfaces, "contacts", lambda *_: ())
    monkeypatch.setattr(on_surfaces, "free_side", lambda *_: 1)
    monkeypatch.setattr(on_surfaces, "straight", lambda record, *_: record["line"])
    sketch = SimpleNamespace(pair=lambda end: end, centre=lambda name: centre)
    surface = type("Surface", (dict,), {"name": "s"})(line=(a, b))
    plank = on_surfaces.platform(SimpleNamespace(name="p", record={}), sketch, surface).core
    along, across = ([plane.dot(plane.minus(corner, a), d) for corner in plank] for d in (e, plane.left(e)))
    deck = on_surfaces.DECK
    assert (min(along), max(along)) == pytest.approx((min(0, place - deck), max(100, place + deck)))
    assert max(across) == pytest.approx(0, abs=1e-9) and min(across) < -12


def test_a_radius_finds_a_ray_that_nothing_crosses():
    """Of a half disc in the middle of which springs end and a spiral is drawn."""
    assert "R" in words(draw(problem_of(ROOT / "tests" / "trials" / "moved_half_disc.yaml")))
