"""Every problem in every format: no line too long, no rounding, no unit as it was typed, nothing left open."""

import json
from contextlib import suppress
from pathlib import Path

import pytest
from support.kinds import kinds
from support.renderings import FORMATS, Page, faults, unbalanced
from support.scenes import kept_settled_of, scene_of_potential

from vibcli.api.reports import data, report, solution
from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.report.blocks import Document, Heading, maths, paragraph, section
from vibcli.report.formats import html, text

FILES = sorted((Path(__file__).parents[2] / "problems").glob("*/*.yaml"))
WIDE = (text, html)     # in which each line may be too long: every document is written in them
MET: set = set()        # kinds of what stood in the documents that this process wrote in the other formats


def formats_of(document):
    """All formats of a document that holds a kind of anything that no document before it held."""
    new = set(kinds(document.sections)) - MET
    MET.update(new)
    return FORMATS if new else WIDE


@pytest.mark.sweep
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_of_all_problems(path):
    found = kept_settled_of(path)
    sections = solution(found)
    document = report(found, sections).document()
    assert not faults(document, formats_of(document))
    with suppress(PhysicsError):
        json.dumps(data(found, ("equations", "frequencies", "equilibria"), "first", None, sections),
                   allow_nan=False, default=str)


def test_what_no_format_has_met_is_told():
    """A block, mathematics in it, a character, a power, a fraction, a longer formula; not another letter."""
    x = scene_of_potential("x^2").scene.q[0]
    met, new = set(), []
    for block in (paragraph("a"), paragraph("b"), Heading("b"), paragraph(maths("b")), paragraph("b_"),
                  paragraph(maths(x)), paragraph(maths(x**2)), paragraph(maths(x**2 / 3)),
                  paragraph(maths(x**2 / 3 + x**3 / 3 + x**4 / 3 + x**5 / 3)), paragraph(maths(x**2 / 3))):
        found = set(kinds(section("", block)))
        new.append(not found <= met)
        met |= found
    assert new == [True, False, *[True] * 7, False]


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
