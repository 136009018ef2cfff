"""What a report consists of: plain data that every format renders.

A section is a generator `name(problem, report)` in one of the files that `sections.SECTIONS` lists; it yields

    Section("Potential energy", (Equations((line("V = ", node),)),))

and leaves out what is empty (`section` does). A PhysicsError that it raises is kept by the report, with what was
yielded before. Texts are Unicode words, whatever a file says; Maths and Lines are typeset, and consist of

    a Node                an expression of the scene
    Name("phi1'")         a symbol of the scene by its name
    a text                in notation: "δA = ", " + 1.44·", "ω_d = ω·√(1 − ζ²)" (report/reading.py reads it)
    Words("for ζ < 1")    words within mathematics
    SumOfTerms, WithNumbers, Factor, Quotient, Either, ShownMatrix: what stands in no single node
    Typed("2*L/3", tree, names): what the file holds, as it was typed

A renderer never looks into a problem, and a section never at a format: `hang` is all that is said of the layout as
plain text, the columns by which the lines after the first are indented (None: the line is never broken), and `inset`
those of the first.
"""

import re
from collections.abc import Callable, Iterable, Iterator
from itertools import compress
from typing import TYPE_CHECKING, Any, cast

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


FEWER = re.compile(r"[\d.]+(?:e-?\d+)?\?")       # notation.numbers.FEWER behind a number
EXPLAINED = "A figure with ? behind it has fewer digits than others: no more are within the bound of its error."


class Name(NamedTuple):
    """A symbol by its name in the scene, primes for time derivatives."""

    text: str


class Words(NamedTuple):
    """Words within mathematics."""

    text: str


class SumOfTerms(NamedTuple):
    """A sum of nodes whose own sums lose their brackets."""

    nodes: "tuple[Node, ...]"


class WithNumbers(NamedTuple):
    """A node with numbers put in for its symbols, {name: number as text}."""

    node: Any
    values: Any


class Factor(NamedTuple):
    """A node within a product: a sum has brackets."""

    node: Any


class Quotient(NamedTuple):
    """A node over another, before it is simplified."""

    above: Any
    below: Any

    @property
    def node(self) -> "Node":
        """Its value."""
        return cast("Node", self.above / self.below)


class Either(NamedTuple):
    """A node of which + `mark` is a term: it is read as ∓ `root`."""

    node: Any
    mark: Any
    root: Any


class ShownMatrix(NamedTuple):
    """Rows of entries between brackets, each the parts of a formula."""

    rows: tuple[tuple[tuple[Any, ...], ...], ...]


class Typed(NamedTuple):
    """An expression as it was typed, with its syntax; `names`: those of the scene."""

    text: str
    tree: Any
    names: Any


class Maths(NamedTuple):
    """A formula in running text or in a cell."""

    parts: tuple[Any, ...]


class Line(NamedTuple):
    """A formula in a line of its own, with what stands before it: `φ:` or `mode 1:`."""

    parts: tuple[Any, ...]
    label: tuple[Any, ...] = ()
    hang: int | None = 4
    inset: int = 0


class Equations(NamedTuple):
    """Lines of mathematics, set apart from the text."""

    lines: tuple[Line, ...]


class Paragraph(NamedTuple):
    """Words and Maths in running text; `aside`: it explains symbols of what stands above."""

    parts: tuple[str | Maths, ...]
    hang: int | None = 2
    aside: bool = False


class Heading(NamedTuple):
    """A heading within a section."""

    text: str


class TableBlock(NamedTuple):
    """A head and rows; a cell is a text or Maths."""

    head: tuple[str | Maths, ...]
    rows: tuple[tuple[str | Maths, ...], ...]


class Definition(NamedTuple):
    """What something is called, or what it is, and what is said of it."""

    term: tuple[str | Maths, ...]
    about: str = ""


class Definitions(NamedTuple):
    """Definitions, one a line, or `flowing` one after the other; `gap` stands between term and words."""

    items: tuple[Definition, ...]
    gap: str = "  "
    flowing: bool = False


class Picture(NamedTuple):
    """A picture: a short name for its file, the words that describe it, and draw("svg") or draw("pdf"), which gives
    its bytes; `animated` gives those of an SVG for pages, if it moves; `about`: what it holds, in words. A section adds
    pictures only where `report.pictures` is set; plain text leaves them out."""

    name: str
    caption: str
    draw: Any
    animated: Any = None
    about: str = ""


class Refusal(NamedTuple):
    """Why something that was asked for is missing; beside plain text it is a diagnostic."""

    message: str
    hint: str | None

    def told(self, escaped: Callable[[str], str]) -> str:
        """Its message, and its hint in brackets, where `escaped` writes a text as it is to be shown."""
        return escaped(self.message) + (f" ({escaped(self.hint)})" if self.hint else "")


class Section(NamedTuple):
    """A title and its blocks."""

    title: str
    blocks: tuple[Any, ...]


class Document(NamedTuple):
    """The report about one scene or one case of it."""

    title: str
    source: str | None
    question: tuple[str | Maths, ...]
    sections: tuple[Section, ...]
    refusal: Refusal | None = None


def maths(*parts: "str | Name | Words | Typed | Node") -> Maths:
    return Maths(parts)


def line(*parts: Any, label: Any = None, hang: int = 4, inset: int = 0) -> Line:
    return Line(parts, () if label is None else (label,), hang, inset)


def factors(nodes: "Iterable[Node]") -> list[Any]:
    """Parts of a product, sums behind; of one node it is that."""
    found = list(nodes)
    alone = [node for node in found if node.op != "sum"]
    sums: list[Any] = [node for node in found if node.op == "sum"]
    together = [found[0].table.product(*((node, 1) for node in alone))] if alone else []
    return [*together, *sums] if len(together + sums) == 1 else [
        part for node in together + sums for part in ("·", Factor(node))][1:]


def equations(lines: Iterable[Line]) -> Equations | None:
    """The lines as a block, or None where there are none."""
    lines = tuple(lines)
    return Equations(lines) if lines else None


def section(title: str, *blocks: Any) -> tuple[Section, ...]:
    """A section of the blocks that are there, or nothing: for `yield from`."""
    blocks = tuple(without_empty(block) if isinstance(block, TableBlock) else block for block in blocks if block)
    told = any(not (isinstance(block, Paragraph) and block.aside) for block in blocks)
    return (Section(title, blocks),) if told else ()


def without_empty(table: TableBlock, *nothing: str) -> TableBlock:
    """A table without columns that have nothing in any row: no text, or one of those that say so."""
    said = [not table.rows or any(row[i] not in ("", *nothing) for row in table.rows) for i in range(len(table.head))]
    return TableBlock(tuple(compress(table.head, said)), tuple(tuple(compress(row, said)) for row in table.rows))


def note(*parts: Any) -> Paragraph:
    """What a section says of its terms, below them."""
    return paragraph("(", *parts, ")", hang=1, aside=True)


def paragraph(*parts: Any, hang: int | None = 2, aside: bool = False) -> Paragraph:
    return Paragraph(parts, hang, aside)


def separated(parts: Iterable[str | Maths], by: str = ", ") -> list[str | Maths]:
    """[part, by, part …]"""
    found = []
    for part in parts:
        found += [by, part]
    return found[1:]


def figures_of_fewer_digits(section: Section) -> list[str]:
    """The figures of a section that have fewer digits than are asked for."""
    return [found for text in _texts(section.blocks) if "?" in text for found in FEWER.findall(text)]


def explained(section: Section) -> Section:
    """The section, with a word on such figures where it has any."""
    return section._replace(blocks=(*section.blocks, paragraph(EXPLAINED))) if figures_of_fewer_digits(
        section) else section


def _texts(part: Any) -> Iterator[str]:
    if isinstance(part, str):
        yield part
    elif isinstance(part, (tuple, list)):
        for one in part:
            yield from _texts(one)
