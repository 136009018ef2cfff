"""What is wrong with a document as it is written in a format: lines too long, rounding, units as they were typed,
elements, braces and environments that are not closed."""

import re
from collections.abc import Iterable, Iterator
from types import ModuleType
from typing import Any
from xml.etree import ElementTree
from xml.parsers import expat

from vibcli.notation.numbers import width
from vibcli.report.blocks import Document, Equations, Paragraph, TableBlock
from vibcli.report.formats import asciidoc, html, latex, markdown, text, typst

WIDEST = 102
WIDEST_FORMULA, SPACED = 125, "+−=<>≤"     # columns of formulas of a page; signs between spaces
FORMULA = re.compile("<math .*?</math>", re.DOTALL)
FORMATS = (text, markdown, latex, html, asciidoc, typst)
WRONG = {word: re.compile(wrong) for word, wrong in {      # {what stands in it: what is wrong}
    "N*": r"\bN\*", "*s/m": r"\*s/m\b", "kg*m": r"\bkg\*m", "m/s^2": r"\bm/s\^2", " deg": r"\d deg\b",
    "an expression of": r"an expression of \d+ characters(?!;\W+in\b)",
    **{word: rf"\b{word}\b(?! [a-z])" for word in ("None", "nan", "NaN")}}.items()}
ROUNDING = re.compile(r"(?<![\d.])\d(?:\.\d+)?e-1[3-9]")
BOUNDS = re.compile("error|what is left|residual|left of")    # heads of numbers that tell how small something is
BOUNDED = re.compile("what is left|by a search|holds to|agrees to|stay closed|±")
# Attributes of the elements of a page that the standards of HTML and MathML know; others than `id` and `class` of all.
ATTRIBUTES = {
    "html": "lang", "meta": "charset name content http-equiv", "a": "href", "nav": "aria-label", "p": "role",
    "th": "scope", "math": "alttext displaystyle display", "mi": "mathvariant", "mspace": "width", "mover": "accent",
    "mtable": "columnalign displaystyle", "mo": "stretchy fence separator form lspace rspace minsize maxsize symmetric",
    "mfrac": "linethickness displaystyle", "mpadded": "width lspace height depth voffset", "mtd": "columnspan rowspan",
    "mstyle": "displaystyle scriptlevel", "mrow": "displaystyle"}
GLOBAL = {"id", "class"}
KNOWN = {tag: {*GLOBAL, *names.split()} for tag, names in ATTRIBUTES.items()}


class Page:
    """What is `wrong` with HTML that is XML as well: elements that are not closed where they should be, attributes that
    they may not have, paths of pictures that do not say where they run."""

    def __init__(self, text: str):
        self.wrong: list[str] = []
        self._pictures = 0      # that stand open
        parser = expat.ParserCreate()
        parser.StartElementHandler, parser.EndElementHandler = self._begins, self._ends
        try:
            parser.Parse(text, True)
        except expat.ExpatError as error:
            self.wrong.append(str(error))

    def _begins(self, tag, attributes):
        if self._pictures:
            self.wrong += ["path without d"] * (tag == "path" and "d" not in attributes)
        elif tag != "svg" and attributes:
            self.wrong += [f"{tag} {name}" for name in attributes if name not in KNOWN.get(tag, GLOBAL)]
        self._pictures += tag == "svg"

    def _ends(self, tag):
        self._pictures -= tag == "svg"


def numbers_in(block: Any) -> Iterator[str]:
    """Texts in which a number so small would be rounding."""
    if isinstance(block, Equations):
        told = [text.formula(line.parts, text.plain) for line in block.lines]
        yield from (one for one in told if not BOUNDED.search(one))
    elif isinstance(block, Paragraph):
        told = text.running(block.parts)
        yield "" if BOUNDED.search(told) else told
    elif isinstance(block, TableBlock):
        kept = [i for i, head in enumerate(block.head) if not BOUNDS.search(text.running((head,)))]
        for row in block.rows:
            yield from (cell for i in kept if "±" not in (cell := text.running((row[i],))))


TEX = re.compile(r"\\\\|\\[{}]|[{}]|\\(?:begin|end)\{(\w+\*?)\}|\\(?:left|right)(?![a-zA-Z])")


def unbalanced(shown: str) -> list[str]:
    """Braces, environments and \\left of LaTeX that are not closed as they were opened."""
    opened: list[str] = []
    for mark in TEX.finditer(shown):
        one = mark.group()
        if mark.group(1):
            one = one[:4].rstrip("{") + mark.group(1)
        if one in ("{", "\\left") or one.startswith("\\beg"):
            opened.append({"{": "}", "\\left": "\\right"}.get(one) or "\\end" + one.removeprefix("\\beg"))
        elif (one in ("}", "\\right") or one.startswith("\\end")) and (not opened or opened.pop() != one):
            return [f"latex: {one} closes nothing"]
    return [f"latex: {opened[-1]} is missing"] if opened else []


def columns(element: ElementTree.Element) -> float:
    """About those of a formula of a page, where what stands above and below a line, or in rows, is as wide as the
    widest."""
    own = [columns(one) for one in element]
    if element.tag in ("mfrac", "mtable", "mover", "munder"):
        return max(own)
    if element.tag == "mspace":
        return 2 * float(element.attrib["width"].removesuffix("em"))
    seen = width(re.sub("[\u2061\u2062]", "", element.text or "")) if not own else 0
    return sum(own) + (3 if element.tag == "mo" and element.text in SPACED else seen)


def too_wide(page: str) -> list[str]:
    """Formulas of a page that are wider than it."""
    return [f"{size:.0f} columns: {one.group()[:120]}" for one in FORMULA.finditer(page)
            if (size := columns(ElementTree.fromstring(one.group()))) > WIDEST_FORMULA]


def faults(document: Document, formats: Iterable[ModuleType]) -> list[str]:
    """What is wrong with a document in any of the formats."""
    found = []
    for section in document.sections:
        small = [told for block in section.blocks for told in numbers_in(block) if ROUNDING.search(told)]
        found += [f"{section.title}: {told}" for told in small]
    for kind in formats:
        shown = kind.render([document], None)
        found += [f"{kind.__name__}: {one.group()}" for word, wrong in WRONG.items() if word in shown
                  for one in wrong.finditer(shown)]
        if kind is text:
            found += [line for line in shown.split("\n") if width(line) > WIDEST]
        elif kind is html:
            found += [f"html: {wrong}" for wrong in Page(shown).wrong] + too_wide(shown)
        elif kind is latex:
            found += ["latex: not ASCII"] * (not shown.isascii()) + unbalanced(shown)
    return found
