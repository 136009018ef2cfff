"""Rows of a long formula end between clauses and words, else before a relation or a term; nothing is lost."""

import pytest
from support.renderings import too_wide
from support.scenes import problem

from vibcli.notation.latex import in_one_line, latex
from vibcli.notation.mathml import mathml
from vibcli.notation.numbers import width, wrapped
from vibcli.notation.plain import plain
from vibcli.notation.typst import typst
from vibcli.report.blocks import (
    Definition,
    Definitions,
    Document,
    Equations,
    Heading,
    Line,
    Name,
    Paragraph,
    Section,
    Words,
)
from vibcli.report.formats import text
from vibcli.report.formats.formula import formula, rows
from vibcli.report.formats.latex import fragment


def joined(found):
    return " ".join(" ".join(found).split())


def test_words_are_divided_at_spaces():
    said = "  by a search (what is left of the forces is 7.4e-18 of their terms); from now on all are counted there"
    parts = [Words("at rest  "), Name("phi"), " = 0.168255", Words(" rad"), Words(said)]
    found = rows(parts, plain, 60)
    assert len(found) == 3 and all(width(row) <= 60 for row in found)
    assert joined(found) == joined([formula(parts, plain)])


def test_a_clause_that_fits_stands_whole():
    parts = [Name("b1"), " = −0.0702054", Words(",  "), Name("b2"), " = 0.467208", Words(",  "), Name("b3"),
             " = 0.459075"]
    assert [row.strip(" ,") for row in rows(parts, plain, 40)] == ["b₁ = −0.0702054,  b₂ = 0.467208", "b₃ = 0.459075"]


def test_no_row_is_a_letter_alone():
    scene = problem("parameters: {m: , k: , c: , L: }\nbodies: {b: {mass: m, slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, b]}, r: {k: c + L, between: [ground, b]}}\n")
    k, c, L = (scene.scene.parameters.nodes[name] for name in "kcL")
    long = (k + c) * (k + L) * (c + L) * (k + c + L) / (k + 2 * c)
    found = rows([Words("with "), Name("b1"), " = ", long, " = 0.3"], plain, 30)
    assert found[0].startswith("with b₁ = (") and found[-1] == "= 0.3"


def test_a_line_of_text_begins_at_its_indent_where_two_spaces_are_broken():
    assert wrapped("aaa bbbb,  ccc = 2", 9, indent=4) == ["aaa bbbb,", "    ccc =", "    2"]
    assert wrapped("a = 1,  b", 100) == ["a = 1,  b"]


@pytest.mark.parametrize(("write", "row"), [(latex, r" \\ & "), (mathml, "<mtr>"), (typst, "; display(")])
def test_what_stands_in_a_fraction_or_a_root_is_broken_where_it_is_wide(write, row):
    names = [f"stiffness{i}" for i in range(10)]
    scene = problem(f"parameters: {{m: , {''.join(f'{name}: , ' for name in names)}}}\n"
                    "bodies: {b: {mass: m, slide: x}}\n"
                    f"springs: {{s: {{k: {' + '.join(names)}, between: [ground, b]}}}}\n")
    table, (m, *k) = scene.scene.table, (scene.scene.parameters.nodes[name] for name in ("m", *names))
    total, few = sum(k[1:], k[0]), k[0] + k[1] + k[2]
    for wide in (m / total, total / m, table.sqrt(total), few * few * total):
        assert row in formula([wide], write) and row not in in_one_line(wide)
    for narrow in (m / few, table.sqrt(few), few * (k[0] + k[4])):
        assert row not in formula([narrow], write)
    assert row not in write(total)       # which whoever sets it breaks


def test_what_is_wider_than_a_page_is_seen():
    rows = "".join(f"<mtr><mtd><mi>{'a' * 99}</mi></mtd></mtr>" for _ in range(2))
    assert not too_wide(f"<math alttext=''><mtable>{rows}</mtable></math>")
    assert not too_wide(f"<math alttext=''><mfrac><mi>{'a' * 99}</mi><mi>{'b' * 99}</mi></mfrac></math>")
    assert too_wide(f"<math alttext=''><mi>{'a' * 99}</mi><mo>+</mo><mi>{'b' * 30}</mi></math>")


@pytest.mark.parametrize("block", [
    Equations((Line((Words("a b " * 40),)),)), Equations((Line((Words(",  ".join(["x = 1.2345"] * 12)),), hang=None),)),
    Paragraph(("ab c " * 40,)), Paragraph(("ab c " * 40,), aside=True), Heading("ab c " * 40),
    Definitions(tuple(Definition(("a = 1 N",)) for i in range(20)), flowing=True)])
def test_lines_of_text_end_within_a_page(block):
    """Sections are indented: what fills a line ends at the hundredth column."""
    lines = text.section_lines([Section("title", (block,))])
    assert 88 <= max(map(width, lines)) <= 100


def test_the_indent_of_a_row_that_is_made_smaller_is_made_smaller_with_it():
    long = [Name(f"length_{i}") for i in range(30)]
    parts = [part for i, name in enumerate(long) for part in ((" + ", name) if i else (name,))]
    shown = fragment(Document("T", None, (), (Section("S", (Equations((Line(tuple(parts)),)),)),)))
    assert r"\wide{$\displaystyle \qquad" in shown and r"\qquad \wide" not in shown
