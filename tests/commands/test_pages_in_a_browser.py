"""HTML reports as a browser sets them: brackets that grow, boxes that scroll, nothing that is loaded."""

from pathlib import Path

import numpy as np
import pytest
from support.browser import NEEDED, measured, picture

from vibcli.cli.program import run
from vibcli.report.blocks import Document, Equations, Section, line
from vibcli.report.formats import html
from vibcli.report.formats.html_page import FONTS
from vibcli.symbolic.expression import Table

PROBLEMS = Path(__file__).parents[2] / "problems"
WIDE = "document.documentElement.scrollWidth - innerWidth"
pytestmark = NEEDED


def page(*parts):
    return html.render([Document("t", None, (), (Section("s", (Equations((line(*parts),)),)),), None)])


def first_sign(found, folder):
    """(height of the first sign of the formula of a page, of the whole formula), as they are painted where no font for
    mathematics is installed."""
    assert found.count(FONTS) == 1
    found = found.replace(FONTS, "").replace("<style>", "<style>h1, h2 { display: none; } article { font-size: 3rem; }")
    dots = picture(found, folder, "--window-size=1200,600")
    columns = np.flatnonzero(dots.any(axis=0))
    ends = np.flatnonzero(np.diff(columns) > 1)
    return np.ptp(np.flatnonzero(dots[:, :columns[ends[0]] + 1].any(axis=1))), np.ptp(np.flatnonzero(dots.any(axis=1)))


@pytest.fixture
def tall():
    """a/(b/c + d) + e"""
    table = Table()
    a, b, c, d, e = map(table.parameter, "abcde")
    return a / (b / c + d) + e


@pytest.mark.sweep
def test_brackets_grow_with_the_fraction_within(tall, tmp_path):
    bracket, formula = first_sign(page(tall ** 2), tmp_path)
    assert bracket > 0.7 * formula


@pytest.mark.sweep
@pytest.mark.parametrize("words", ["(a)² = ", "|a| = "])
def test_brackets_and_bars_stay_small_around_a_letter(words, tall, tmp_path):
    bracket, formula = first_sign(page(words, tall), tmp_path)
    assert bracket < 0.5 * formula


@pytest.mark.sweep
@pytest.mark.parametrize("name", ["5_forced/feeder_tray_driven_by_a_sawtooth", "8_continuous/cantilever_with_tip_mass"])
def test_a_narrow_page_scrolls_within_its_boxes_alone(name, tmp_path):
    path = tmp_path / "r.html"
    assert run(["solve", str(PROBLEMS / f"{name}.yaml"), "--pictures", "-o", str(path)]) == 0
    text = path.read_text(encoding="utf-8")
    assert measured(text, tmp_path, WIDE, "--window-size=390,844") <= 0
    assert measured(text, tmp_path, "document.querySelectorAll('figure svg').length") >= 2
    assert measured(text, tmp_path, "performance.getEntriesByType('resource').filter(one => "
                    "!one.name.startsWith('data:')).length") == 0


@pytest.mark.sweep
@pytest.mark.parametrize(("preferred", "share"), [(0, 0.95), (1, 0.05)])
def test_plots_and_figures_stand_on_the_paper_of_the_page_that_is_dark_or_light(preferred, share, tmp_path):
    path = tmp_path / "r.html"
    assert run(["solve", str(PROBLEMS.parent / "vibcli/examples/frequency_response.yaml"), "--pictures", "-o",
                str(path)]) == 0
    shown = path.read_text().replace("<style>", "<style>section > :not(figure), article > :not(section) "
                                     "{ display: none; } ", 1)
    assert shown.count("<svg") == 2
    dark = picture(shown, tmp_path, "--window-size=800,900", f"--blink-settings=preferredColorScheme={preferred}")
    assert abs(dark.mean() - share) < 0.05
