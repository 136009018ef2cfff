"""Words, formulas and blocks of reports as HTML that course systems show: formulas in TeX, or in MathML."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache
from html import escape
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, cast

from vibcli.notation.mathml import mathml, row
from vibcli.notation.plain import plain
from vibcli.report.blocks import Definitions, Equations, Heading, Maths, Paragraph, TableBlock
from vibcli.report.formats.formula import formula, pieces, rows, without_words
from vibcli.report.formats.html_page import words as words_of_html
from vibcli.report.formats.latex import is_signed
from vibcli.report.formats.markdown import Protected, latex

if TYPE_CHECKING:
    from vibcli.report.blocks import Line, Section
    from vibcli.symbolic.node import Node

COLUMNS = 95        # of plain text, in a row of a formula
SPECIAL = {"{": "&#123;", "}": "&#125;", "$": "<span>$</span>", "\\": "<span>&#92;</span>"}

_COMMAND = re.compile(r"\\[a-zA-Z]+|[{}_^\\ ]")


@lru_cache(maxsize=10_000)
def _symbol(name: str) -> str:
    return latex.symbol(name)


@lru_cache(maxsize=10_000)
def _notation(text: str) -> str:
    return latex.notation(text)


class Remembering(Protected):
    """LaTeX of formulas in which expressions stand several times: those without numbers put in, which all variants of
    a problem share, are kept with their table, the others for this writer."""

    def __init__(self, values: Mapping[str, str] = MappingProxyType({})):
        super().__init__(values)
        self._own: dict[Any, Any] = {}

    def write(self, node: "Node", tightness: int) -> str:
        """The text of a node, once."""
        kept, key = self._kept(node), (Remembering.write, node, tightness)
        if key not in kept:
            kept[key] = super().write(node, tightness)
        return cast("str", kept[key])

    def terms(self, node: "Node") -> list[tuple[bool, str]]:
        """Its terms, once."""
        kept, key = self._kept(node), (Remembering.terms, node)
        if key not in kept:
            kept[key] = super().terms(node)
        return cast("list[tuple[bool, str]]", kept[key])

    def _kept(self, node: "Node") -> dict[Any, Any]:
        return self._own if self.values else node.table.kept

    def symbol(self, name: str) -> str:
        """That of a name, once for all formulas."""
        return _symbol(name)

    def notation(self, text: str) -> str:
        """A text in notation, likewise."""
        return _notation(text)


REMEMBERING = Remembering()


def _rows_in_tex(line: "Line") -> list[str]:
    """A formula as rows of an alignment, by about so many signs as are seen of them."""
    found, size = [""], 0
    for piece in pieces(line.parts, REMEMBERING):
        seen = len(_COMMAND.sub("", piece))
        if found[-1] and size + seen > COLUMNS:
            found, size = [*found, ""], 0
        found[-1], size = REMEMBERING.beside(found[-1], piece), size + seen
    label = formula(line.label, REMEMBERING) + r":\quad " if line.label else ""
    return [label + "& {} " + found[0].strip(), *(r"& {}\qquad " + one.strip() for one in found[1:])]


class SetInTeX:
    """For systems whose pages set what stands between \\( and \\), and may take $ and {{ for more than words."""

    def words(self, text: str) -> str:
        """Words of a file, none of them markup, the beginning of a formula or of a template."""
        return re.sub(r"[{}$\\]", lambda found: SPECIAL[found[0]], words_of_html(text))

    def maths(self, parts: Sequence[Any]) -> str:
        return rf"\({escape(formula(parts, REMEMBERING))}\)"

    def equations(self, block: Equations) -> str:
        lines = " \\\\\n".join(row for line in block.lines for row in _rows_in_tex(line))
        return f"<p>\\[\\begin{{aligned}}\n{escape(lines)}\n\\end{{aligned}}\\]</p>"

    def numeral(self, text: str) -> str:
        return rf"\({REMEMBERING.numeral(text)}\)"


class SetInMathML:
    """For systems that show MathML, each formula with its plain text beside."""

    def words(self, text: str) -> str:
        """Words of a file, none of them markup."""
        return words_of_html(text)

    def maths(self, parts: Sequence[Any]) -> str:
        return _math(row(formula(parts, mathml)), parts)

    def equations(self, block: Equations) -> str:
        return "\n".join(f"<div>{self._line(line)}</div>" for line in block.lines)

    def _line(self, line: "Line") -> str:
        label = f"{self.maths(line.label)}: " if line.label else ""
        first, *others = rows(line.parts, mathml, COLUMNS)
        return label + "<br/>".join(_math(row(one), line.parts if one is first else ()) for one in (first, *others))

    def numeral(self, text: str) -> str:
        return _math(row(mathml.numeral(text)), (text,))


def _math(inner: str, parts: Sequence[Any]) -> str:
    said = formula(parts, plain).replace("\u00a0", " ").strip() if parts else ""
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML" alttext="{words_of_html(said)}">{inner}</math>'


TEX, MATHML = SetInTeX(), SetInMathML()


class AsSet:
    """Words and Maths, or Sections, as HTML of some settings: what goes from process to process."""

    def __init__(self, found: Mapping[type, str]):
        self._found = found

    def within(self, setting: SetInTeX | SetInMathML) -> str:
        """The HTML of one."""
        return self._found[type(setting)]


def running(parts: Iterable[Any] | AsSet, setting: SetInTeX | SetInMathML) -> str:
    """Words and Maths as HTML."""
    if isinstance(parts, AsSet):
        return parts.within(setting)
    return "".join(setting.maths(part.parts) if isinstance(part, Maths) else setting.words(part)
                   for part in without_words(tuple(parts)))


def html(sections: "Iterable[Section] | AsSet", setting: SetInTeX | SetInMathML) -> str:
    """Sections as HTML, their titles in bold."""
    if isinstance(sections, AsSet):
        return sections.within(setting)
    found: list[str] = []
    for section in sections:
        found.append(f"<p><strong>{setting.words(section.title)}</strong></p>")
        found += [_BLOCKS[type(block)](block, setting) for block in section.blocks if type(block) in _BLOCKS]
    return "\n".join(found)


def _paragraph(block: Paragraph, setting: SetInTeX | SetInMathML) -> str:
    return f"<p>{running(block.parts, setting).strip()}</p>"


def _heading(block: Heading, setting: SetInTeX | SetInMathML) -> str:
    return f"<p><em>{setting.words(block.text.rstrip(':'))}</em></p>"


def _equations(block: Equations, setting: SetInTeX | SetInMathML) -> str:
    return setting.equations(block)


def _definitions(block: Definitions, setting: SetInTeX | SetInMathML) -> str:
    items = [running(item.term, setting) + (f" ({setting.words(item.about)})" if item.about else "")
             for item in block.items]
    return "<ul>" + "".join(f"<li>{item}</li>" for item in items) + "</ul>"


def _table(block: TableBlock, setting: SetInTeX | SetInMathML) -> str:
    head, *body = ([_cell(cell, setting) for cell in cells] for cells in (block.head, *block.rows))
    return ("<table><thead><tr>" + "".join(f"<th>{cell}</th>" for cell in head) + "</tr></thead><tbody>"
            + "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>" for cells in body)
            + "</tbody></table>")


def _cell(cell: str | Maths, setting: SetInTeX | SetInMathML) -> str:
    return setting.numeral(cell) if isinstance(cell, str) and is_signed(cell) else running((cell,), setting)


_BLOCKS: dict[type, Callable[[Any, SetInTeX | SetInMathML], str]] = {
    Paragraph: _paragraph, Heading: _heading, Equations: _equations, Definitions: _definitions,
    TableBlock: _table}
