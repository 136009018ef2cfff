"""A report as a complete LaTeX document for pdflatex, in plain ASCII."""

import itertools
import re
from collections.abc import Callable, Sequence
from typing import Any, TypeGuard

from vibcli.notation.latex import Latex, latex
from vibcli.notation.latex_text import escaped
from vibcli.notation.numbers import width
from vibcli.notation.plain import plain
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
from vibcli.report.formats.formula import INDEXED, apart, formula, rows, rows_and_plain, without_words
from vibcli.report.formats.text import running

COLUMNS = 95        # of plain text, in a row of a formula
FITTING, ROWS = 60, 30      # columns of a row that surely fits a page, rows of a table that stays on one
LABEL, BESIDE = 20, 8       # of a label beside its formula, and beside formulas that fill the page
BOX = 30                    # of a definition that is not broken
WIDE, MADE = r"\wide", r"\wide{$\displaystyle "          # what is made smaller where it would not fit; a formula there
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
\renewcommand{\arraystretch}{1.3}
\raggedright
\allowdisplaybreaks
\newcommand{\wide}[1]{\resizebox{\ifdim\width>0.8\linewidth 0.8\linewidth\else\width\fi}{!}{#1}}
\newsavebox{\figurebox}
\newcommand{\drawn}[1]{\sbox{\figurebox}{\includegraphics{#1}}%
\ifdim\ht\figurebox>0.4\textheight\sbox{\figurebox}{\includegraphics[height=0.4\textheight]{#1}}\fi
\wide{\usebox{\figurebox}}}
\begin{document}
"""


def render(documents: Sequence[Document], place: Callable[[Picture], str] | None) -> str:
    """The LaTeX of all documents; `place(picture)` is the name of the file that a picture is written to."""
    return HEAD + "\n\\clearpage\n".join(_document(document, place) for document in documents) + "\n\\end{document}"


def fragment(document: Document) -> str:
    """One document without pictures as a piece of a LaTeX document."""
    return _document(document, None)


def _document(document: Document, place: Callable[[Picture], str] | None) -> str:
    parts = [rf"\section*{{{escaped(document.title)}}}"]
    parts += [f"Source: {escaped(document.source)}\n"] if document.source else []
    parts += [_running(document.question) + "\n"] if document.question else []
    for section in document.sections:
        parts.append(rf"\subsection*{{{escaped(section.title)}}}")
        parts += [_picture(block, place) if isinstance(block, Picture) else _RENDER[type(block)](block)
                  for block in section.blocks]
    parts += [_refusal(document.refusal)] if document.refusal else []
    return "\n".join(parts)


def _running(parts: Sequence[str | Maths]) -> str:
    return "".join(f"${formula(part.parts, latex)}$" if isinstance(part, Maths) else escaped(part)
                   for part in without_words(parts))


def _equations(block: Equations) -> str:
    lines = " \\\\\n".join(row.replace(rf"\qquad {MADE}", rf"{MADE}\qquad ")
                           for row in aligned(block, latex, _fitted_rows))
    return f"\\begin{{align*}}\n{lines}\n\\end{{align*}}"


def _fitted_rows(parts: Sequence[Any], write: Latex, columns: int) -> list[str]:
    """Rows of a formula, made smaller where they may be too wide for a page."""
    return [f"{MADE}{row}$}}" if width(text) > FITTING else row
            for row, text in rows_and_plain(parts, write, columns)]


def aligned(block: Equations, write: Latex,
            broken: Callable[[Sequence[Any], Latex, int], list[str]] = rows) -> list[str]:
    """Rows of an alignment: labels, then formulas, broken where they are long."""
    found, written = [], [broken(line.parts, write, COLUMNS) for line in block.lines]
    most = BESIDE if any(row.startswith(WIDE) for row in itertools.chain(*written)) else LABEL
    for line, (first, *others) in zip(block.lines, written, strict=True):
        label = formula(line.label, write) + r":\quad" if line.label else ""
        if width(formula(line.label, plain)) > most:
            found.append(rf"& {{}} {label}")
            label = ""
        head = f"{label} & {{}}".lstrip()
        found += [f"{head} {first}", *(rf"& {{}}\qquad {other}" for other in others)]
    return found


def _paragraph(block: Paragraph) -> str:
    """Running text; a formula that is wider than a line stands apart."""
    return "\n".join(_running(one.parts).strip() if isinstance(one, Paragraph) else _equations(one)
                     for one in apart(block.parts, COLUMNS)) + "\n"


def _heading(block: Heading) -> str:
    return rf"\subsubsection*{{{escaped(block.text.rstrip(':'))}}}"


def _table(block: TableBlock) -> str:
    """A table, on one page unless it is long; where it may be too wide, it is made smaller."""
    head, *body = (" & ".join(map(_cell, row)) + r" \\" for row in (block.head, *block.rows))
    head = INDEXED.sub(r"\1$_{\2}$", head)
    layout, lines = "l" * len(block.head), "".join(f"{{}}{row}\n" for row in body)
    columns = zip(block.head, *block.rows, strict=True)
    size = sum(max(width(running((cell,))) + 2 for cell in column) for column in columns)
    if len(body) <= ROWS:
        table = f"\\begin{{tabular}}{{{layout}}}\n{head} \\hline\n{lines}\\end{{tabular}}"
        return f"\\wide{{{table}}}\n" if size > FITTING else f"{table}\n"
    return f"\\begin{{longtable}}[l]{{{layout}}}\n{head} \\hline\n\\endhead\n{lines}\\end{{longtable}}"


def _cell(cell: str | Maths) -> str:
    if is_signed(cell):
        return f"${latex.numeral(cell)}$"
    return _running((cell,))


def is_signed(cell: str | Maths) -> TypeGuard[str]:
    """Is a cell a number with a sign or a power of ten, which is to be set as mathematics?"""
    return isinstance(cell, str) and bool(_SIGNED.fullmatch(cell))


def _definitions(block: Definitions) -> str:
    items = [_running(item.term) + (rf" \quad {escaped(item.about)}" if item.about else "") for item in block.items]
    sizes = [width(running(item.term) + item.about) for item in block.items]
    return (" \\quad\n".join(item if size > BOX else f"\\mbox{{{item}}}"
                              for item, size in zip(items, sizes, strict=True)) if block.flowing else
            "\n\n".join(items)) + "\n"


def _refusal(refusal: Refusal) -> str:
    return f"\\textbf{{Not found:}} {refusal.told(escaped)}\n"


def _picture(block: Picture, place: Callable[[Picture], str] | None) -> str:
    return f"\\begin{{center}}\n\\drawn{{{place(block)}}}\\\\\n{{}}{escaped(block.caption)}\n\\end{{center}}"


_RENDER: dict[type, Callable[[Any], str]] = {
    Equations: _equations, Paragraph: _paragraph, Heading: _heading, TableBlock: _table,
    Definitions: _definitions, Refusal: _refusal}
