"""Every problem as text, part of them in every format: no line too long, no rounding, no unit as it was typed."""

import json
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest
from support.scenes import kept_problem_of

from vibcli.api.reports import data, report, solution
from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import width
from vibcli.report.blocks import Equations, Paragraph, TableBlock
from vibcli.report.formats import asciidoc, html, latex, markdown, text

FILES = sorted((Path(__file__).parents[2] / "problems").glob("*/*.yaml"))
PARTS, WIDEST = 6, 102
EVERY = 4       # of the problems so many are written as text alone, but for the first
FORMATS = (text, markdown, latex, html, asciidoc)
TYPED = re.compile(r"\bN\*|\*s/m\b|\bkg\*m|\bm/s\^2|\d deg\b")
NOTHING = re.compile(r"\b(None|nan|NaN)\b(?! [a-z])")
ROUNDING = re.compile(r"(?<![\d.])\d(?:\.\d+)?e-1[3-9]")
BOUNDS = re.compile("error|what is left|residual|left of")    # heads of numbers that tell how small something is
BOUNDED = re.compile("what is left|holds to|agrees to|stay closed|±")
VOID = {"meta", "br", "img", "link", "hr", "input"}


class Balanced(HTMLParser):
    """HTML in which every element is closed where it should be."""

    def __init__(self):
        super().__init__()
        self.open, self.wrong = [], []

    def handle_starttag(self, tag, attrs):
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        pass

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.wrong.append(tag)


def numbers_in(block):
    """Texts in which a number so small would be rounding."""
    if isinstance(block, Equations):
        yield from (text.formula(line.parts, text.plain) for line in block.lines)
    elif isinstance(block, Paragraph):
        told = text.running(block.parts)
        yield "" if BOUNDED.search(told) else told
    elif isinstance(block, TableBlock):
        kept = [i for i, head in enumerate(block.head) if not BOUNDS.search(text.running((head,)))]
        for row in block.rows:
            yield from (cell for i in kept if "±" not in (cell := text.running((row[i],))))


def faults(document, formats):
    """What is wrong with a document in any of the formats."""
    found = []
    for section in document.sections:
        small = [told for block in section.blocks for told in numbers_in(block) if ROUNDING.search(told)]
        found += [f"{section.title}: {told}" for told in small]
    for kind in formats:
        shown = kind.render([document], None)
        found += [f"{kind.__name__}: {one.group()}" for wrong in (TYPED, NOTHING) for one in wrong.finditer(shown)]
        if kind is text:
            found += [line for line in shown.split("\n") if width(line) > WIDEST]
        elif kind is html:
            page = Balanced()
            page.feed(shown)
            found += [f"html: {page.wrong or page.open}"] * bool(page.wrong or page.open)
        elif kind is latex and not shown.isascii():
            found.append("latex: not ASCII")
    return found


@pytest.mark.sweep
@pytest.mark.parametrize("part", range(PARTS))
def test_of_all_problems(part):
    wrong = {}
    for number, path in enumerate(FILES[part::PARTS]):
        found = kept_problem_of(path)
        if found.spec.choices:
            continue
        sections = solution(found)
        if one := faults(report(found, sections).document(), (text,) if number % EVERY else FORMATS):
            wrong[path.stem] = one
        try:
            json.dumps(data(found, ("equations", "frequencies", "equilibria"), "first", None, sections),
                       allow_nan=False, default=str)
        except PhysicsError:
            continue
    assert not wrong, "\n".join(f"{stem}: {one}" for stem, one in wrong.items())
