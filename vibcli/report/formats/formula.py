"""The mathematics of blocks in a notation: as text, LaTeX or MathML, piece by piece where a line may end."""

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from typing import TYPE_CHECKING, Any, cast

from vibcli.notation.numbers import centred, width
from vibcli.notation.plain import plain
from vibcli.report.blocks import (
    Either,
    Equations,
    Factor,
    Maths,
    Name,
    Paragraph,
    Quotient,
    ShownMatrix,
    SumOfTerms,
    Typed,
    WithNumbers,
    Words,
    line,
)

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

FEW, STUB = 40, 12  # characters of words that stay in a row; columns that no row ends with
CLAUSE, GAP = ",  ", "  "       # what ends a clause, and what begins one
WORD = re.compile(r"^\s+|\S+\s*")
TENS = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?)e([+-]?)0*(\d+)\b")
OVER = re.compile("/")
BREAK = re.compile(r"(?= [+−=<>] )")
INDEXED = re.compile(r"(?<!\w)(\w|\\ensuremath\{\\\w+\})(?:\\?_|&#95;)(\w)(?!\w)")  # a letter, its index, as escaped


def formula(parts: Sequence[Any], write: Any) -> str:
    """Mathematics as one text."""
    found = pieces(parts, write)
    return found[0] if len(found) == 1 else write.beside(*found)


def pieces(parts: Sequence[Any], write: Any) -> list[str]:
    """[text] of mathematics; a line may end before each but the first. All notations give the same number of them."""
    found = []
    for part in parts:
        first, *others = _pieces(part, write)
        found[-1:] = [write.beside(*found[-1:], first)]
        found += others
    return found


def without_words(parts: Sequence[str | Maths]) -> Iterator[str | Maths]:
    """Running text in which the words within formulas stand outside of them, and the space that ends one too."""
    for part in parts:
        if not isinstance(part, Maths):
            yield with_tens(part)
            continue
        for are_words, group in groupby(part.parts, lambda one: isinstance(one, Words)):
            found = tuple(group)
            yield with_tens("".join(one.text for one in found)) if are_words else Maths(found)
            if isinstance(found[-1], str) and found[-1].endswith(" "):
                yield " "


def apart(parts: Sequence[str | Maths], columns: int) -> list[Paragraph | Equations]:
    """Running text in which formulas wider than a line stand apart."""
    def is_wide(part: "str | Maths") -> bool:
        return isinstance(part, Maths) and width(formula(part.parts, plain)) > columns

    found = [(wide, tuple(group)) for wide, group in groupby(without_words(parts), is_wide)]
    return [Equations(tuple(line(*part.parts) for part in group if isinstance(part, Maths))) if wide else
            Paragraph(group) for wide, group in found]


def with_tens(text: str) -> str:
    """Words with the powers of ten of their numbers as they are printed: 3.3·10⁻¹⁷."""
    from vibcli.notation.typed_values import SUPERSCRIPT

    return TENS.sub(lambda found: f"{found[1]}·10{(found[2].strip('+') + found[3]).translate(SUPERSCRIPT)}", text)


def rows(parts: Any, write: Any, columns: int) -> list[str]:
    """A formula broken into rows of about so many columns of plain text: between clauses and words where that is
    enough, else before a relation or a term."""
    return [text for text, _ in rows_and_plain(parts, write, columns)]


def rows_and_plain(parts: Any, write: Any, columns: int) -> list[tuple[str, str]]:
    """[(row, the same in plain text)] of a formula broken into rows."""
    found, size = [([], [])], 0
    for clause in _clauses(parts):
        told = pieces(list(map(flat, clause)), plain)
        texts = told if write is plain else pieces(clause, write)
        widths = list(map(width, told))
        together = sum(widths) if sum(widths) <= columns else sum(widths[:2])
        for i, (wide, text, said) in enumerate(zip(widths, texts, told, strict=True)):
            if size > STUB and size + (wide if i else together) > columns:
                found.append(([], []))
                size = 0
            found[-1][0].append(text)
            found[-1][1].append(said)
            size += wide
    return [(write.beside(*row).strip(), plain.beside(*said).strip()) for row, said in found]


def flat(part: Any, space: str = " ") -> Any:
    """A part, of a matrix its first row, as wide as it is shown."""
    return Words(rows_of_matrix(part)[0].replace(" ", space)) if isinstance(part, ShownMatrix) else part


def rows_of_matrix(part: ShownMatrix) -> list[str]:
    """The rows of a matrix in plain text, one below the other."""
    cells = [[formula(cell, plain) for cell in row] for row in part.rows]
    sizes = [max(map(width, column)) for column in zip(*cells, strict=True)]
    left, right = "⎛" + "⎜" * (len(cells) - 2) + "⎝", "⎞" + "⎟" * (len(cells) - 2) + "⎠"
    return [f"{begin} {'  '.join(map(centred, row, sizes))} {end}" for begin, row, end in zip(
        left, cells, right, strict=True)]


def _clauses(parts: Iterable[Any]) -> Iterator[list[Any]]:
    """The parts up to each comma among words, from each gap before words, and long words by few."""
    clause: list[Any] = []
    for part in parts:
        *more, last = _few_by_few(part.text) if isinstance(part, Words) else (part,)
        if clause and isinstance(part, Words) and part.text.startswith(GAP):
            yield clause
            clause = []
        for one in more:
            yield [*clause, one]
            clause = []
        clause.append(last)
        if isinstance(last, Words) and last.text.endswith(CLAUSE):
            yield clause
            clause = []
    if clause:
        yield clause


def _few_by_few(text: str) -> Iterator[Words]:
    """[Words] of a text, at its spaces where it is long, and where a clause ends."""
    found = [""]
    for word in WORD.findall(text):
        if found[-1].strip() and (len(found[-1]) + len(word) > FEW or found[-1].endswith(CLAUSE)):
            found.append("")
        found[-1] += word
    return map(Words, found)


def _pieces(part: Any, write: Any) -> list[str]:
    if isinstance(part, str):
        return [write.notation(text) for text in _split(part)]
    if isinstance(part, Words):
        return [write.words(part.text if write is plain else with_tens(part.text))]
    if isinstance(part, Name):
        return [write.symbol(part.text)]
    if isinstance(part, Typed):
        return [_typed(part, write)]
    if isinstance(part, Factor):
        return [write.write(part.node, 1)]
    if isinstance(part, Quotient):
        return [_quotient(part, write)]
    if isinstance(part, ShownMatrix):
        return [_matrix([[formula(cell, write) for cell in row] for row in part.rows], write)]
    if isinstance(part, Either):
        plus, either = write.signed(False, write(part.mark)), write.notation(" ∓ ")
        return [write(part.node).replace(plus, write.beside(either, write(part.root)))]
    if isinstance(part, WithNumbers):
        return _pieces(part.node, write.with_values(part.values))
    nodes = part.nodes if isinstance(part, SumOfTerms) else (part,)
    terms = [term for node in nodes for term in _terms(node, write)]
    return [write.signed(negative, text, not i) for i, (negative, text) in enumerate(terms)]


def _matrix(rows: Any, write: Any) -> str:
    """In plain text on one line, a semicolon between rows."""
    return write.matrix(rows) if write is not plain else f"[{'; '.join(map(', '.join, rows))}]"


def _quotient(part: Quotient, write: Any) -> str:
    if write is not plain:
        return cast("str", write.fraction(write(part.above), write(part.below)))
    divided = part.above.op == "product" and bool(_outside(OVER, write(part.above)))
    return f"{write.write(part.above, 1 + divided)}/{write.write(part.below, 2)}"


def _typed(part: Typed, write: Any) -> str:
    if write is plain:
        from vibcli.notation.as_printed import as_printed

        return as_printed(part.text, part.names)
    from vibcli.notation.typed_tree import typeset

    return typeset(part.tree, part.text, write)


def _terms(node: "Node", write: Any) -> list[tuple[bool, str]]:
    """Those of a node, written once in each notation where no numbers are put in."""
    terms: list[tuple[bool, str]]
    if write.values:
        terms = write.terms(node)
        return terms
    kept, key = node.table.kept, (type(write), node)
    if key not in kept:
        kept[key] = write.terms(node)
    terms = kept[key]
    return terms


def _split(text: str) -> list[str]:
    """A text in notation before each relation or sign that stands in no bracket."""
    places = _outside(BREAK, text)
    return [text[start:end] for start, end in zip([0, *places], [*places, len(text)], strict=True)]


def _outside(pattern: re.Pattern[str], text: str) -> list[int]:
    """Where something stands in no bracket."""
    return [found.start() for found in pattern.finditer(text)
            if text.count("(", 0, found.start()) == text.count(")", 0, found.start())]
