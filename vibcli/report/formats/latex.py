"""A report as a complete LaTeX document for pdflatex, in plain ASCII."""

import re
from collections.abc import Callable, Sequence

from vibcli.notation.latex import Latex, latex
from vibcli.notation.latex_text import escaped
from vibcli.report.blocks import (
    Definitions,
    Document,
    Equations,
    Heading,
    Maths,
    Paragraph,
    Picture,
    Refusal,
    TableBlock,
)
from vibcli.report.formats.formula import formula, rows, without_words

COLUMNS = 95        # of plain text, in a row of a formula
_SIGNED = re.compile(r"(?=.*[-−e])[-−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
HEAD = r"""\documentclass[11pt,a4paper,fleqn]{article}
\usepackage[T1]{fontenc}
\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}
\usepackage{textcomp}
\usepackage{amsmath}
\usepackage{longtable}
\usepackage{graphicx}
\usepackage[margin=22mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
\setlength{\emergencystretch}{3em}
\allowdisplaybreaks
\begin{document}
"""


def render(documents: Sequence[Document], place: Callable | None) -> str:
    """The LaTeX of all documents; `place(picture)` is the name of the file that a picture is written to."""
    return HEAD + "\n\\clearpage\n".join(_document(document, place) for document in documents) + "\n\\end{document}"


def fragment(document: Document):
    """One document without pictures as a piece of a LaTeX document."""
    return _document(document, None)


def _document(document, place):
    parts = [rf"\section*{{{escaped(document.title)}}}"]
    parts += [f"Source: {escaped(document.source)}\n"] if document.source else []
    parts += [_running(document.question) + "\n"] if document.question else []
    for section in document.sections:
        parts.append(rf"\subsection*{{{escaped(section.title)}}}")
        parts += [_picture(block, place) if isinstance(block, Picture) else _RENDER[type(block)](block)
                  for block in section.blocks]
    parts += [_refusal(document.refusal)] if document.refusal else []
    return "\n".join(parts)


def _running(parts):
    return "".join(f"${formula(part.parts, latex)}$" if isinstance(part, Maths) else escaped(part)
                   for part in without_words(parts))


def _equations(block):
    lines = " \\\\\n".join(aligned(block, latex))
    return f"\\begin{{align*}}\n{lines}\n\\end{{align*}}"


def aligned(block: Equations, write: Latex) -> list[str]:
    """Rows of an alignment: labels, then formulas, broken where they are long."""
    found = []
    for line in block.lines:
        first, *others = rows(line.parts, write, COLUMNS)
        label = formula(line.label, write) + r":\quad" if line.label else ""
        head = f"{label} & {{}}".lstrip()
        found += [f"{head} {first}", *(rf"& {{}}\qquad {other}" for other in others)]
    return found


def _paragraph(block):
    return _running(block.parts) + "\n"


def _heading(block):
    return rf"\subsubsection*{{{escaped(block.text.rstrip(':'))}}}"


def _table(block):
    head, *body = (" & ".join(map(_cell, row)) + r" \\" for row in (block.head, *block.rows))
    return (f"\\begin{{longtable}}[l]{{{'l' * len(block.head)}}}\n{head} \\hline\n\\endhead\n"
            + "".join(f"{{}}{row}\n" for row in body) + "\\end{longtable}")


def _cell(cell):
    if is_signed(cell):
        return f"${latex.numeral(cell)}$"
    return _running((cell,))


def is_signed(cell: str | Maths) -> bool:
    """Is a cell a number with a sign or a power of ten, which is to be set as mathematics?"""
    return isinstance(cell, str) and bool(_SIGNED.fullmatch(cell))


def _definitions(block):
    items = [_running(item.term) + (rf" \quad {escaped(item.about)}" if item.about else "") for item in block.items]
    return (" \\quad\n".join(f"\\mbox{{{item}}}" for item in items) if block.flowing else
            "\n\n".join(items)) + "\n"


def _refusal(refusal):
    return f"\\textbf{{Not found:}} {refusal.told(escaped)}\n"


def _picture(block, place):
    size = r"width=0.8\linewidth,height=0.4\textheight,keepaspectratio"
    return (f"\\begin{{center}}\n\\includegraphics[{size}]{{{place(block)}}}\\\\\n"
            f"{{}}{escaped(block.caption)}\n\\end{{center}}")


_RENDER = {Equations: _equations, Paragraph: _paragraph, Heading: _heading, TableBlock: _table,
           Definitions: _definitions, Refusal: _refusal}
