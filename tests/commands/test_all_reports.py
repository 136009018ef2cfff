"""Every problem in every format: no line too long, no rounding, no unit as it was typed, nothing left open."""

import json
from contextlib import suppress
from pathlib import Path

import pytest
from support.renderings import FORMATS, Page, faults, unbalanced
from support.scenes import kept_settled_of

from vibcli.api.reports import data, report, solution
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.report.blocks import Document, paragraph, section
from vibcli.report.formats import text

FILES = sorted((Path(__file__).parents[2] / "problems").glob("*/*.yaml"))


@pytest.mark.sweep
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_of_all_problems(path):
    found = kept_settled_of(path)
    sections = solution(found)
    assert not faults(report(found, sections).document(), FORMATS)
    with suppress(PhysicsError):
        json.dumps(data(found, ("equations", "frequencies", "equilibria"), "first", None, sections),
                   allow_nan=False, default=str)


def test_what_is_not_closed_is_seen():
    assert unbalanced(r"\begin{align*} \left( \frac{a}{b} \right) \\{x\\} \end{align*}") == []
    for wrong in (r"\frac{a}{b", r"a}", r"\left( a", r"\begin{align*} a", r"\begin{a} { \end{a} }"):
        assert unbalanced(wrong)


@pytest.mark.sweep
@pytest.mark.parametrize("words", (["--pictures"], ["--steps"]))
def test_pages_hold_what_the_standard_knows(tmp_path, words):
    """With the figure, a plot whose unit has a gap, formulas on several rows."""
    scene = next(path for path in FILES if path.stem == "ball_let_go_on_a_thread")
    assert run(["solve", str(scene), "-o", str(tmp_path / "page.html"), *words]) == 0
    assert not Page((tmp_path / "page.html").read_text(encoding="utf-8")).wrong


def test_what_the_standard_does_not_know_is_seen():
    page = ('<main><figure role="group" id="a"><svg viewBox="0 0 1 1"><path id="b"/><path d=""/></svg></figure>'
            '<math><mtable displaystyle="true"><mtr><mtd displaystyle="true"></mtd></mtr></mtable></math></main>')
    assert Page(page).wrong == ["figure role", "path without d", "mtd displaystyle"]
    assert "mismatched tag" in Page(page.replace("</mtr>", "")).wrong[-1]
    assert "no element found" in Page(page.removesuffix("</main>")).wrong[-1]


@pytest.mark.parametrize("wrong", ["5 N*m", "2 N*s/m", "1 kg*m^2", "9.81 m/s^2", "3 deg", "None", "is nan", "(NaN)",
                                   "an expression of 900 characters"])
def test_what_is_left_as_it_was_typed_is_seen(wrong):
    def found(words):
        return faults(Document("", None, (), section("Result", paragraph(words))), (text,))

    assert found(f"it is {wrong}") and not found("Nancy and a degree: N m, m/s²")
