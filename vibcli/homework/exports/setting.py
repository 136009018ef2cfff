"""Words, formulas and blocks of reports as HTML that course systems show: formulas in TeX, or in MathML."""

import re
from collections.abc import Iterable, Sequence
from html import escape
from typing import TYPE_CHECKING, Any

from vibcli.notation.mathml import mathml, row
from vibcli.notation.plain import plain
from vibcli.report.blocks import Definitions, Equations, Heading, Maths, Paragraph, TableBlock
from vibcli.report.formats.formula import formula, rows, without_words
from vibcli.report.formats.html_page import words as words_of_html
from vibcli.report.formats.latex import aligned, is_signed
from vibcli.report.formats.markdown import latex

if TYPE_CHECKING:
    from vibcli.report.blocks import Section

COLUMNS = 95        # of plain text, in a row of a formula
SPECIAL = {"{": "&#123;", "}": "&#125;", "$": "<span>$</span>", "\\": "<span>&#92;</span>"}


class SetInTeX:
    """For systems whose pages set what stands between \\( and \\), and may take $ and {{ for more than words."""

    def words(self, text: str) -> str:
        """Words of a file, none of them markup, the beginning of a formula or of a template."""
        return re.sub(r"[{}$\\]", lambda found: SPECIAL[found[0]], words_of_html(text))

    def maths(self, parts: Sequence[Any]) -> str:
        return rf"\({escape(formula(parts, latex))}\)"

    def equations(self, block: Equations) -> str:
        lines = " \\\\\n".join(aligned(block, latex))
        return f"<p>\\[\\begin{{aligned}}\n{escape(lines)}\n\\end{{aligned}}\\]</p>"

    def numeral(self, text: str) -> str:
        return rf"\({latex.numeral(text)}\)"


class SetInMathML:
    """For systems that show MathML, each formula with its plain text beside."""

    def words(self, text: str) -> str:
        """Words of a file, none of them markup."""
        return words_of_html(text)

    def maths(self, parts: Sequence[Any]) -> str:
        return _math(row(formula(parts, mathml)), parts)

    def equations(self, block: Equations) -> str:
        return "\n".join(f"<div>{self._line(line)}</div>" for line in block.lines)

    def _line(self, line):
        label = f"{self.maths(line.label)}: " if line.label else ""
        first, *others = rows(line.parts, mathml, COLUMNS)
        return label + "<br/>".join(_math(row(one), line.parts if one is first else ()) for one in (first, *others))

    def numeral(self, text: str) -> str:
        return _math(row(mathml.numeral(text)), (text,))


def _math(inner, parts):
    said = formula(parts, plain).replace("\u00a0", " ").strip() if parts else ""
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML" alttext="{words_of_html(said)}">{inner}</math>'


TEX, MATHML = SetInTeX(), SetInMathML()


def running(parts: Iterable[Any], setting: SetInTeX | SetInMathML) -> str:
    """Words and Maths as HTML."""
    return "".join(setting.maths(part.parts) if isinstance(part, Maths) else setting.words(part)
                   for part in without_words(tuple(parts)))


def html(sections: "Iterable[Section]", setting: SetInTeX | SetInMathML) -> str:
    """Sections as HTML, their titles in bold."""
    found: list[str] = []
    for section in sections:
        found.append(f"<p><strong>{setting.words(section.title)}</strong></p>")
        found += [_BLOCKS[type(block)](block, setting) for block in section.blocks if type(block) in _BLOCKS]
    return "\n".join(found)


def _paragraph(block, setting):
    return f"<p>{running(block.parts, setting).strip()}</p>"


def _heading(block, setting):
    return f"<p><em>{setting.words(block.text.rstrip(':'))}</em></p>"


def _equations(block, setting):
    return setting.equations(block)


def _definitions(block, setting):
    items = [running(item.term, setting) + (f" ({setting.words(item.about)})" if item.about else "")
             for item in block.items]
    return "<ul>" + "".join(f"<li>{item}</li>" for item in items) + "</ul>"


def _table(block, setting):
    head, *body = ([_cell(cell, setting) for cell in cells] for cells in (block.head, *block.rows))
    return ("<table><thead><tr>" + "".join(f"<th>{cell}</th>" for cell in head) + "</tr></thead><tbody>"
            + "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>" for cells in body)
            + "</tbody></table>")


def _cell(cell, setting):
    return setting.numeral(cell) if is_signed(cell) else running((cell,), setting)


_BLOCKS = {Paragraph: _paragraph, Heading: _heading, Equations: _equations, Definitions: _definitions,
           TableBlock: _table}
