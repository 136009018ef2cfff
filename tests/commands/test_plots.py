"""Plots: what stands in the terminal, what stands in files, and that neither is ever cut off or different twice."""

import json
import math
import os
import re
import subprocess
import sys
import unicodedata
import xml.etree.ElementTree as ET
from itertools import pairwise

import pytest
from support.plots import EVIL, FIGURES, TIMES, digests, wave

from vibcli.base.decoding import cleaned
from vibcli.base.errors import PhysicsError
from vibcli.plots import style
from vibcli.plots.braille import braille
from vibcli.plots.figure import Curve, Figure, Mark, Panel
from vibcli.plots.frequency import lag, of_frequency_response
from vibcli.plots.paper import fewer, sheets, thinned
from vibcli.plots.picture import picture
from vibcli.plots.prefixes import readable
from vibcli.plots.response import of_response
from vibcli.plots.ticks import decimal, ticks
from vibcli.plots.words import printable, shortened, width, with_its_unit

EACH = pytest.mark.parametrize("name", FIGURES)


def number(text):
    """The value of a tick's label: −1.5, 10⁻³, 2·10⁶."""
    text = text.strip().replace("−", "-")
    found = re.fullmatch(r"(-?)(?:([\d.]+)·)?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)", text)
    if not found:
        return float(text)
    exponent = int(found[3].translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")))
    return float(found[1] + (found[2] or "1")) * 10.0 ** exponent


def canvas_lines(text):
    return [line for line in text.splitlines() if "┤" in line or "│" in line]


# prefixes and ticks

@pytest.mark.parametrize(("value", "unit", "factor", "found"), [
    (0.0032, "m", 1e3, "mm"), (3.2e-6, "m", 1e6, "µm"), (0.5, "m", 1, "m"), (25000, "N", 1e-3, "kN"),
    (2e-4, "m/N", 1e3, "mm/N"), (1e-12, "m", 1e12, "10⁻¹² m"), (0.0, "m", 1, "m"), (math.inf, "m", 1, "m"),
    (30000, "rad/s", 1, "rad/s"), (5e7, "", 1e-6, "10⁶"), (2e-9, "kg", 1e9, "10⁻⁹ kg"), (3e6, "N·m", 1e-6, "MN·m")])
def test_readable_prefixes(value, unit, factor, found):
    assert readable(value, unit) == (pytest.approx(factor, rel=1e-15), found)


@pytest.mark.parametrize(("n", "exponent", "text"), [
    (-15, -1, "−1.5"), (5, -3, "0.005"), (0, -4, "0"), (12, 0, "12"), (3, 4, "30000"), (1, 7, "10⁷"),
    (-25, 8, "−2.5·10⁹"), (2, -9, "2·10⁻⁹"), (100, -2, "1.00")])
def test_labels_of_ticks(n, exponent, text):
    assert decimal(n, exponent) == text


@pytest.mark.parametrize("log", [False, True])
@pytest.mark.parametrize(("low", "high"), [(-1, 1), (0, 0.003), (-12, -3), (2.1, 2.4), (0, 7), (-250, 12), (5, 5.01)])
@pytest.mark.parametrize("most", [2, 3, 5, 11])
def test_ticks_are_where_they_say(low, high, log, most):
    found = ticks(low, high, lambda places: len(places) <= most, log)
    assert found and len(found) <= most and (len(found) > 1 or log)
    assert all(a < b for (a, _), (b, _) in pairwise(found))
    for place, label in found:
        assert low - 1e-6 * (high - low) <= place <= high + 1e-6 * (high - low)
        assert number(label) == pytest.approx(10 ** place if log else place, rel=1e-9, abs=1e-12)


def test_ticks_of_phases_are_parts_of_a_turn():
    labels = [label for _, label in ticks(0, 360, lambda found: len(found) <= 6, degrees=True)]
    assert labels == ["0", "90", "180", "270", "360"]


# paper

def test_thinning_keeps_the_drawing():
    (sheet,) = sheets(FIGURES["noise"])
    (run,), = sheet.strokes
    few = thinned(run, sheet.x, 100)
    assert len(few) <= 404
    assert set(few) <= set(run) and few == sorted(few)
    scale = 100 / (sheet.x.high - sheet.x.low)
    for column in range(100):
        all_in, kept = ([y for x, y in points if int(x * scale) == column] for points in (run, few))
        assert (min(kept), max(kept), kept[0], kept[-1]) == (min(all_in), max(all_in), all_in[0], all_in[-1])


def test_very_many_points_become_fewer_with_their_extremes():
    x, y = list(range(100000)), [math.sin(i * i) for i in range(100000)]
    y[70000] = math.nan
    short_x, short_y = fewer(x, y, 2000)
    assert 1500 < len(short_x) < 2300 and (short_x[0], short_x[-1]) == (0, 99999)
    assert all(a < b for a, b in pairwise(short_x))
    assert max(short_y) == max(y) and min(short_y) == min(y) and 70000 in short_x
    assert fewer([1, 2], [3, 4]) == ((1, 2), (3, 4))


@EACH
def test_ranges_are_finite_and_hold_the_curves(name):
    for sheet in sheets(FIGURES[name]):
        for axis in (sheet.x, sheet.y):
            assert -math.inf < axis.low < axis.high < math.inf
        for runs in sheet.strokes:
            assert all(math.isfinite(x) and math.isfinite(y) for run in runs for x, y in run)


def test_a_pole_does_not_fill_a_logarithmic_axis():
    values = [10.0 ** -(i % 3) for i in range(100)] + [1e60, 1e-60]
    (sheet,) = sheets(Figure("", (Panel("x", "y", y_log=True, curves=(Curve("", tuple(range(102)), values),)),)))
    assert (sheet.y.low, sheet.y.high) == pytest.approx((-5, 3))


# frequency responses

def test_lag_is_positive_and_without_jumps():
    turning = [1 / complex(math.cos(a), math.sin(a)) for a in (i / 10 for i in range(100))]
    assert lag(turning) == pytest.approx([math.degrees(i / 10) for i in range(100)])
    assert lag([1 + 0j, -1 + 0j, complex(-1, -0.0), 0j, -2 + 0j, 1 + 0j]) == pytest.approx(
        (0, 180, 180, math.nan, 180, 0), nan_ok=True)


def test_peaks_at_nearly_the_same_place_are_marked_once():
    curves = {"x": [1, 0.1], "y": [1, 0.01]}
    upper, lower = of_frequency_response([1, 20], curves, "", "", peaks=(12.36, 3, 12.35)).panels
    assert [(mark.at, mark.label) for mark in upper.marks] == [(3, "3"), (12.35, "12.35")]
    assert [mark.label for mark in lower.marks] == ["", ""]


def test_phase_of_two_degrees():
    upper, lower = FIGURES["frf"].panels
    driven, other = (curve.y for curve in lower.curves)
    assert driven[0] == pytest.approx(0, abs=2) and driven[-1] == pytest.approx(180, abs=2)
    assert other[-1] == pytest.approx(360, abs=8)
    assert max(abs(b - a) for curve in (driven, other) for a, b in pairwise(curve)) < 45
    assert upper.x_log and upper.y_log and lower.y_range == (0, 360)
    assert upper.y_label == "receptance [m/N]"


# terminal

@EACH
@pytest.mark.parametrize("columns", [40, 80, 200])
def test_no_line_is_too_wide(name, columns):
    text = braille(FIGURES[name], columns)
    assert all(width(line) <= columns for line in text.splitlines())
    assert not any(unicodedata.category(letter)[0] == "C" for letter in text.replace("\n", ""))
    assert not text.isascii() or name == "nothing"


@EACH
def test_width_is_used_and_bounded(name):
    if FIGURES[name].panels:
        assert max(map(width, braille(FIGURES[name], 80).splitlines())) >= 79
    assert braille(FIGURES[name], 7) == braille(FIGURES[name], 40)
    assert braille(FIGURES[name], 1000) == braille(FIGURES[name], 200)


@EACH
@pytest.mark.parametrize("height", [8, 20])
def test_ticks_of_y_descend(name, height):
    for part in braille(FIGURES[name], height=height).split("└")[:-1]:
        labels = [number(line.split("┤")[0]) for line in canvas_lines(part) if "┤" in line and name != "hostile"]
        assert all(a > b for a, b in pairwise(labels))
        assert len(labels) >= 2 or name == "hostile"


def test_labels_of_x_stand_below_their_ticks():
    lines = braille(FIGURES["decay"]).splitlines()
    axis = next(i for i, line in enumerate(lines) if "└" in line)
    places = [i for i, letter in enumerate(lines[axis]) if letter == "┬"]
    labels = [(m.start(), m.end(), float(m.group())) for m in re.finditer(r"\S+", lines[axis + 1])]
    assert len(places) == len(labels) >= 4
    assert all(start - 1 <= place <= end for place, (start, end, _) in zip(places, labels, strict=True))
    assert all(a[1] + 2 <= b[0] and a[2] < b[2] for a, b in pairwise(labels))
    assert lines[axis + 2].strip() == "t [s]"


def test_peaks_of_a_sine_are_in_the_right_rows():
    """cos over two periods, −1 … 1: crests in the first row at 0, ½ and 1 of the width, troughs in the last."""
    figure = of_response([i / 1000 for i in range(1001)],
                         [("x", "m", [math.cos(4 * math.pi * i / 1000) for i in range(1001)])])
    lines = canvas_lines(braille(figure, 80, 21))
    start = lines[0].index("┤") + 1
    across = 80 - start

    def dotted(line):
        return [i - start for i, letter in enumerate(line) if "⠀" < letter <= "⣿"]

    assert len(lines) == 21
    crests, troughs = dotted(lines[0]), dotted(lines[-1])
    assert {round(4 * column / (across - 1)) for column in crests} == {0, 2, 4}
    assert {round(4 * column / (across - 1)) for column in troughs} == {1, 3}
    assert number(lines[10].split("┤")[0]) == 0
    assert {round(8 * column / (across - 1)) for column in dotted(lines[10])} == {1, 3, 5, 7}
    assert all(any("⠀" < line[start + column] <= "⣿" for line in lines) for column in range(across))


def test_fast_oscillation_fills_its_envelope():
    figure = of_response([i / 5000 for i in range(5001)],
                         [("x", "m", [math.sin(2000 * math.pi * i / 5000 + 0.3) for i in range(5001)])])
    lines = canvas_lines(braille(figure, 80, 12))
    assert all("⠀" < letter <= "⣿" for line in lines for letter in line[line.index("│" if "│" in line else "┤") + 1:])


def test_a_gap_stays_a_gap():
    lines = canvas_lines(braille(FIGURES["nan"], 80, 12))
    start = lines[0].index("┤") + 1
    columns = {i - start for line in lines for i, letter in enumerate(line) if "⠀" < letter <= "⣿"}
    assert min(columns) == 0 and max(columns) == 79 - start      # the range is that of the finite values


def test_several_curves_are_named_in_a_legend_and_beside():
    text = braille(FIGURES["frf"])
    assert text.count("x₁/F") == 3 and text.count("x₂/F") == 3      # one legend, and beside the curves of each panel
    first = text.splitlines()[0]
    assert first.startswith("receptance [m/N]") and first.endswith("x₂/F")
    samples = re.findall("[⠀-⣿][⠀-⣿ ]*", first)
    assert len(set(samples)) == 2


@pytest.mark.sweep
def test_a_dot_is_a_dot_in_the_legend():
    """One curve of a single point, one of two, one with a lone point beside others."""
    curves = (Curve("dot", (1.0,), (2.0,)), Curve("line", (1.0, 2.0), (3.0, 1.0)),
              Curve("both", (1.0, 2.0, math.nan, 3.0), (1.0, 2.0, math.nan, 2.5)))
    drawn = Figure("", (Panel("x", "y", curves=curves),))
    told = braille(drawn, 80, 12).splitlines()[0]
    assert "  o dot " in told and re.search("[⠀-⣿] line .*[⠀-⣿] ? both$", told)
    legend = next(part for part in ET.fromstring(picture(drawn, "svg")).iter() if part.get("id") == "legend_1")
    entries = [part for part in legend if (part.get("id") or "").startswith("line2d")]
    assert [[piece.tag.partition("}")[2] for piece in part] for part in entries] == [["g"], ["path"], ["path"]]


def test_marks_stand_at_their_places():
    lines = braille(FIGURES["frf"]).splitlines()
    first = next(i for i, line in enumerate(lines) if "│" in line or "┤" in line)
    for label in ("10", "14.1", "17.3"):
        start = next(line.index(label) for line in lines[1:first] if label in line)
        under = lines[first][start:start + len(label)]
        assert any(letter == "┊" or "⠀" < letter <= "⣿" for letter in under)


def test_words():
    assert printable("a\x1b[31m\n b\u202e\u200b  c") == "a[31m b c"
    assert width("φ̇ 日本") == 6
    assert [with_its_unit("rope.force.1 [N]", n) for n in (16, 12, 6)] == [
        "rope.force.1 [N]", "rope.force.1\n[N]", "rope.…\n[N]"]
    assert with_its_unit("displacement", 6) == "displ…"
    assert [shortened("日本語", n) for n in (6, 5, 4, 1, 0)] == ["日本語", "日本…", "日…", "…", ""]


def run(code):
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120,
                          cwd=os.path.dirname(__file__), env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.mark.sweep
def test_a_plot_in_the_terminal_needs_nothing_heavy():
    names = run("import json, sys\nfrom support import plots\nfrom vibcli.plots.braille import braille\n"
                "[braille(f) for f in plots.FIGURES.values()]\nprint(json.dumps(sorted(sys.modules)))")
    assert not {name.partition(".")[0] for name in names} & {"numpy", "scipy", "sympy", "matplotlib", "mpmath"}


# files

PICTURES = ("frf", "png"), ("frf", "svg"), ("frf", "pdf"), ("hostile", "svg")
ELSEWHERE = f"""
import json, sys
import matplotlib
matplotlib.rcParams['font.size'] = 30
matplotlib.rcParams['svg.fonttype'] = 'none'
from support import plots
found = plots.digests({PICTURES})
assert not [name for name in sys.modules if name.startswith(("matplotlib.pyplot", "scipy", "sympy"))]
print(json.dumps(found))
"""


@pytest.mark.sweep
def test_the_same_bytes_in_two_processes_and_again():
    """Where Matplotlib was given other settings, and where other pictures were drawn before."""
    assert run(ELSEWHERE) == digests(PICTURES)


@pytest.mark.sweep
def test_nothing_global_is_left_changed():
    import matplotlib

    matplotlib.rcParams["lines.linewidth"] = 3.5
    before = dict(matplotlib.rcParams)
    picture(FIGURES["units"], "png")
    assert dict(matplotlib.rcParams) == before
    matplotlib.rcParams["lines.linewidth"] = matplotlib.rcParamsDefault["lines.linewidth"]


def numbers(axis):
    """The labels of the ticks that are seen: Matplotlib keeps one beyond each end."""
    low, high = sorted(axis.get_view_interval())
    slack = 1e-9 * (high - low)
    return [label for label, at in zip(axis.get_ticklabels(), axis.get_majorticklocs(), strict=False)
            if low - slack <= at <= high + slack and label.get_visible() and label.get_text()]


def texts(name, inches=style.WIDTH):
    """The drawn page, so wide, and (text, its box in pixels) of everything written on it."""
    import matplotlib
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.text import Text

    from vibcli.plots.layout import drawn

    with matplotlib.rc_context(style.RC):
        page = drawn(FIGURES[name], inches)
        renderer = FigureCanvasAgg(page).get_renderer()
        page.draw(renderer)
        axes = [axis for one in page.axes for axis in (one.xaxis, one.yaxis)]
        unseen = {label for axis in axes for label in axis.get_ticklabels()} - {
            label for axis in axes for label in numbers(axis)}
        found = [(artist, artist.get_window_extent(renderer)) for artist in page.findobj(Text)
                 if artist not in unseen and artist.get_visible() and artist.get_text().strip()
                 and artist.get_figure() is page]
        return page, found


@pytest.mark.sweep
@EACH
@pytest.mark.parametrize("inches", [style.WIDTH, style.COLUMN])
@pytest.mark.filterwarnings("ignore:Glyph")
def test_nothing_is_cut_off_and_no_numbers_overlap(name, inches):
    page, found = texts(name, inches)
    wide, high = page.bbox.width, page.bbox.height
    assert found or not FIGURES[name].panels
    for artist, box in found:
        text = artist.get_text()
        assert box.x0 >= -0.5 and box.y0 >= -0.5 and box.x1 <= wide + 0.5 and box.y1 <= high + 0.5, (text, box)
        assert not artist.get_usetex() and not artist.get_parse_math(), text
    for axis in (axis for axes in page.axes for axis in (axes.xaxis, axes.yaxis)):
        boxes = [label.get_window_extent() for label in numbers(axis)]
        assert len(boxes) > 1 or (not boxes and axis.axis_name == "x")
        assert not any(a.overlaps(b) for a, b in pairwise(boxes))
    for axes in page.axes:      # of panels that share their x, the lowest alone has numbers and a label
        assert numbers(axes.xaxis) or not axes.xaxis.label.get_text()


@pytest.mark.sweep
@pytest.mark.parametrize("name", ["argand", "round", "nyquist"])
def test_names_of_points_are_written(name):
    written = [artist.get_text() for artist, _ in texts(name)[1]]
    wanted = [text for panel in FIGURES[name].panels for curve in panel.curves for text in curve.names if text]
    assert wanted and all(written.count(text) >= wanted.count(text) for text in wanted)


@pytest.mark.sweep
@pytest.mark.filterwarnings("ignore:Glyph")
def test_hostile_text_is_shown_as_it_is():
    _, found = texts("hostile")
    written = [artist.get_text() for artist, _ in found]
    shown = printable(EVIL)
    assert "_" + shown in written
    assert any(text.startswith(shown[:40]) for text in written)
    assert any(text.startswith("日本語") for text in written)


@pytest.mark.sweep
@pytest.mark.parametrize(("kind", "start"), [("png", b"\x89PNG"), ("svg", b"<?xml"), ("pdf", b"%PDF")])
def test_files_name_no_date_and_no_maker(kind, start):
    data = picture(FIGURES["hostile"], kind)
    assert data.startswith(start) and data == picture(FIGURES["hostile"], kind)
    assert not re.search(rb"CreationDate|dc:date|tIME|Matplotlib v|matplotlib\.org", data)
    if kind == "svg":
        ET.fromstring(data)


@pytest.mark.sweep
@pytest.mark.parametrize("name", ["frf", "hostile"])
def test_an_svg_has_the_title_of_its_figure(name):
    title = FIGURES[name].title
    found = ET.fromstring(picture(FIGURES[name], "svg")).find("{http://www.w3.org/2000/svg}title")
    assert (found.text.strip() == cleaned(title).strip()) if title else found is None


# figures

def test_the_data_of_a_figure_are_frozen():
    with pytest.raises(AttributeError):
        Curve("x", (), ()).label = "y"
    assert Mark(1.0) == (1.0, "")


def test_a_response_has_one_panel_a_unit():
    upper, lower = FIGURES["units"].panels
    assert (upper.y_label, lower.y_label) == ("x [mm]", "s.force [kN]")
    assert [curve.kind for curve in upper.curves] == ["line", "steady"]
    assert max(upper.curves[0].y) == pytest.approx(3) and max(lower.curves[0].y) == pytest.approx(90)


@pytest.mark.parametrize("sizes", [(3e-3, 4e-6), (2e-9, 5e3), (7.0, 8e-4), (6e5, 2.0)])
@pytest.mark.parametrize("turned", [1, -1])
def test_signals_of_a_unit_are_read_in_that_of_the_largest(sizes, turned):
    found = of_response(TIMES, [(f"x{i}", "m", wave(size, 2)) for i, size in enumerate(sizes[::turned])])
    greatest = max(abs(y) for panel in found.panels for curve in panel.curves for y in curve.y)
    assert 0.1 <= greatest < 1e4


def test_signals_that_turn_often_stand_apart_in_one_scale():
    first, second = FIGURES["beats"].panels
    assert first.y_range == second.y_range == pytest.approx((-2, 2), rel=1e-3)
    (together,) = of_response(TIMES, [("x", "m", wave(1, 6)), ("y", "m", wave(2, 5))]).panels
    assert together.y_label == "x, y [m]"


def test_rays_of_constant_damping():
    (panel,) = FIGURES["argand"].panels
    rays = [curve for curve in panel.curves if curve.kind == "guide"]
    assert len(rays) >= 4
    for ray in rays[::2]:
        zeta = float(ray.names[1].removeprefix("ζ = "))
        assert -ray.x[1] / math.hypot(ray.x[1], ray.y[1]) == pytest.approx(zeta, rel=1e-12)
    assert panel.x_label == "Re λ [1/s]" and panel.y_label == "Im λ [rad/s]"
    assert not panel.equal and FIGURES["round"].panels[0].equal


def test_too_many_panels_are_refused():
    panel = FIGURES["single"].panels[0]
    with pytest.raises(PhysicsError, match="41 panels"):
        braille(Figure("", (panel,) * 41))
    assert "no values" in braille(FIGURES["empty"])


@pytest.mark.sweep
def test_a_curve_without_points_takes_no_room():
    from vibcli.plots.layout import drawn

    def heights(*more):
        panels = [Panel(label, "y", False, False, (*more, Curve("one", (1.0, 2.0), (1.0, 2.0)))) for label in "ab"]
        page = drawn(Figure("", tuple(panels)))
        page.draw_without_rendering()
        return [axes.get_position().height for axes in page.axes]

    assert heights(Curve("", (), (), "markers")) == pytest.approx(heights(), rel=1e-6)
    assert min(heights()) > 0.3
