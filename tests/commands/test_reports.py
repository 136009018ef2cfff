"""Reports in every format: well formed, escaped, free of references; formulas as they are typeset; files."""

import re
import subprocess
import xml.etree.ElementTree as ET
from io import BytesIO
from itertools import pairwise
from pathlib import Path
from shutil import which

import pytest
from support.imported import modules
from support.scenes import kept_problem_of, problem

from vibcli.cli.program import run
from vibcli.notation.latex import latex
from vibcli.notation.latex_text import escaped
from vibcli.notation.mathml import mathml
from vibcli.notation.plain import plain
from vibcli.notation.typst import typst
from vibcli.reader.sections.find import INSIGHT, ON_REQUEST
from vibcli.report.blocks import (
    Definition,
    Definitions,
    Document,
    Equations,
    Name,
    Picture,
    Section,
    Words,
    line,
    maths,
    paragraph,
)
from vibcli.report.blocks import TableBlock as Cells
from vibcli.report.document import EVERYTHING, Report
from vibcli.report.formats import asciidoc, html, markdown
from vibcli.report.formats import latex as render_latex
from vibcli.report.formats import text as render_text
from vibcli.report.formats import typst as render_typst
from vibcli.report.formats.formula import formula, pieces, rows, without_words
from vibcli.symbolic.expression import Table

PROBLEMS = Path(__file__).parents[2] / "problems"
SAMPLE = sorted(PROBLEMS.glob("*/*.yaml"))[::9]
FORMATS = ("markdown", "latex", "asciidoc", "html", "typst")


def render(documents, kind, place=None):
    if kind == "html":
        return html.render(documents)
    return {"latex": render_latex, "markdown": markdown, "asciidoc": asciidoc,
            "typst": render_typst}[kind].render(documents, place)


def document(found, sections=EVERYTHING, **options):
    report = Report(found, **options)
    for name in sections:
        report.add(name)
    return report.document()


# well-formed, whatever the scene

ARITY = {"mfrac": 2, "msup": 2, "msub": 2, "mover": 2, "msubsup": 3}
LEAVES = {"mi", "mn", "mo", "mtext"}
ROWS = {"math", "mrow", "msqrt", "mtable", "mtr", "mtd", "mspace", "mstyle"}


def assert_mathml(element):
    """Every element is one of MathML Core, with as many arguments as it takes."""
    assert element.tag in LEAVES | ROWS | set(ARITY)
    assert len(element) == ARITY.get(element.tag, len(element))
    assert (element.tag in LEAVES) == bool((element.text or "").strip("\n"))
    assert not (element.tag in LEAVES and len(element)) and not (element.tail or "").strip()
    for part in element:
        assert_mathml(part)


REFERENCES = ("src", "href", "{http://www.w3.org/1999/xlink}href", "srcset", "action", "poster", "background")
LOADING = {"img", "script", "link", "iframe", "object", "embed", "base", "form", "image", "foreignObject"}


def assert_page(text):
    """A page that XML reads, with nothing that loads, runs or leads elsewhere; its formulas; its root."""
    root = ET.fromstring(text)
    assert root.get("lang") == "en"
    for element in root.iter():
        assert element.tag.rpartition("}")[2] not in LOADING
        assert not [name for name in element.attrib if name.lower().startswith("on")]
        assert all(element.get(name, "#").startswith("#") for name in REFERENCES)
        assert not re.search(r"url\((?!#)|@import|javascript:", " ".join(element.attrib.values()), re.IGNORECASE)
    for style in root.iter("style"):
        assert not re.search(r'url\((?!#|"data:font)|@import|expression', style.text, re.IGNORECASE)
    for math in root.iter("math"):
        tail, math.tail = math.tail, None
        assert_mathml(math)
        math.tail = tail
        assert math.get("alttext")
    levels = [int(element.tag[1]) for element in root.iter() if re.fullmatch("h[1-6]", element.tag)]
    assert levels[0] == 1 and all(b - a <= 1 for a, b in pairwise(levels))
    return root


TOKEN = re.compile(r"\\(begin|end)\{([a-z*]+)\}|\\(left|right)\b|\\[a-zA-Z]+|\\.|[{}$%#~^&]", re.DOTALL)


def assert_latex(text):
    """ASCII, balanced braces, environments and \\left … \\right; no character that TeX takes for its own."""
    assert text.isascii() and text.isprintable() is False and not re.search(r"[\x00-\x09\x0b-\x1f\x7f]", text)
    body = text[text.index(r"\begin{document}"):]
    depth, opened, dollars = 0, [], 0
    for token in TOKEN.finditer(body):
        word = token[0]
        if token[1] == "begin":
            opened.append(token[2])
        elif token[1] == "end":
            assert opened.pop() == token[2]
        elif token[3]:
            depth += 1000 if token[3] == "left" else -1000
        elif word == "$":
            dollars += 1
        elif word == "&":
            assert opened[-1] in ("align*", "aligned", "longtable", "tabular")
        elif word == "^":
            assert dollars % 2 or opened[-1] == "align*" or body[:token.start()].endswith(("{", "{}", "}", ")"))
        elif word == "~":
            assert re.search(r"\d~[\w\\]", body[token.start() - 1:token.end() + 1])      # before a unit
        else:
            assert word not in "%#"
            depth += (word == "{") - (word == "}")
        assert depth >= 0
    assert depth == 0 and not opened and dollars % 2 == 0
    assert len(re.findall(r"\\left\b", body)) == len(re.findall(r"\\right\b", body))
    assert not re.search(r"\\(input|include|write|openin|openout|read|catcode|def|csname|immediate)(?![a-z])", body)


def assert_markdown(text):
    """No HTML but the dollar's, as many dollars as formulas need, tables of one width."""
    assert set(re.findall(r"<[^\s>][^>]*>", text)) <= {"<span>", "</span>"}
    bare = text.replace(r"<span>\$</span>", "").replace(r"\$", "")
    assert bare.count("$$") % 2 == 0 and bare.replace("$$", "").count("$") % 2 == 0
    for found in re.finditer(r"\$\$\n.*?\n\$\$|\$[^$\n]+\$", bare, re.DOTALL):
        assert not bare[found.end():found.end() + 1].isdigit()
        assert not re.search(r"\\[^a-zA-Z]|\S_|_\S|^[-+=*#] |`", found[0], re.MULTILINE)
    for block in re.findall(r"(?:^\|.*\n)+", text + "\n", re.MULTILINE):
        assert len({len(re.findall(r"(?<!\\)\|", line)) for line in block.splitlines()}) == 1


BLOCKS = {      # of AsciiDoc, each by the whole of it
    "title": r"={1,5} \S.*(\n:stem: latexmath)?",
    "display": r"\[stem\]\n\+{4}\n(?:[^+\n].*\n|\+ .*\n)+\+{4}",
    "table": r"\[%autowidth,options=header\]\n\|===\n\|.*\n\n(?:\|.*\n)*\|===",
    "list": r"\* .*(?:\n\* .*)*",
    "picture": r"image::[\w.-]+\[\"[^\"\]]+\"\]",
    "paragraph": r"(?:\{empty\}|\*Not found:\*|stem:\[|[^\W\d_]+[ ,;:]).*(?:\nstem:\[.*)*"}
STEM = re.compile(r"stem:\[(?:[^\]\\]|\\.)+\]")


def assert_asciidoc(text):
    """Blocks of six kinds, apart by empty lines; titles that go one deeper at a time; tables of one width; outside of
    formulas and of references to characters nothing that is markup."""
    blocks = re.split(r"\n\n(?=\S)(?!\|)", text.rstrip("\n"))
    kinds = [next((kind for kind, form in BLOCKS.items() if re.fullmatch(form, block)), block) for block in blocks]
    assert set(kinds) <= set(BLOCKS) and kinds[0] == "title" and text.count(":stem: latexmath") == 1
    levels = [len(block.split(" ")[0]) for block, kind in zip(blocks, kinds, strict=True) if kind == "title"]
    assert levels[0] == 1 and all(1 < b <= a + 1 for a, b in pairwise(levels))
    for block, kind in zip(blocks, kinds, strict=True):
        if kind == "display":
            assert block.count("\\begin{aligned}") == block.count("\\end{aligned}") == block.count("{aligned}") / 2
            assert block.count("{") == block.count("}")
            continue
        bare = STEM.sub("", block)
        if kind == "table":
            rows = [line for line in bare.split("\n")[2:-1] if line]
            assert len({line.count("|") for line in rows}) == 1
            bare = "\n".join(rows).replace("|", "")
        bare = re.sub(r"(?m)&#\d+;|^\* |^=+ |\n:stem: latexmath|\{empty\}|^\*Not found:\*|^image::", "", bare)
        assert not re.search(r"[*_`#^~+{<>&|\\@]|::|;;|://|\S\[(?!\")|\[\[|\(\(|--|\.\.\.|\(C\)", bare)


def assert_typst(text):
    """Dollars, brackets and braces close, and nothing is called but what the head defines and Typst has."""
    bare = re.sub(r'"(?:\\.|[^"\\])*"|\\.', "", text[text.index("\n= "):])
    assert bare.count("$") % 2 == 0
    assert all(bare.count(opened) == bare.count(closed) for opened, closed in ("()", "[]", "{}"))
    assert set(re.findall(r"#(\w*)", bare)) <= {"table", "fitted", "picture", "block", "box", "h",
                                                 "pagebreak", "none", "left", "0"}        # of rows: delim, align, gap


CHECKS = {"html": assert_page, "latex": assert_latex, "markdown": assert_markdown, "asciidoc": assert_asciidoc,
          "typst": assert_typst}


def test_the_sample_is_wide():
    assert len(SAMPLE) >= 10 and len({path.parent for path in SAMPLE}) >= 4


@pytest.mark.parametrize("path", SAMPLE, ids=lambda path: path.stem)
def test_problems_in_every_format(path):
    found = kept_problem_of(path)
    documents = [document(part, [*EVERYTHING, *(word for word in ON_REQUEST if word in part.spec.get("find", INSIGHT))])
                 for part in (found, *map(found.case, found.spec.cases)) if not part.spec.choices]
    for kind in FORMATS:
        if documents:
            CHECKS[kind](render(documents, kind))


# hostile words

WORDS = ("<script>alert(1)</script><img src=x onerror=alert(1)> \\input{/etc/passwd} \\end{document} 100 % & ~ ^ {a} # "
         "[l](javascript:x) ![i](http://e.vil) `code` *b* _i_ $x$ $$y$$ | &quot; \" ' --- 中文 é č ∫ φ̈ www.e.vil")
HOSTILE = """
title: '{words}'
source: '# {words}'
question: '- {words}'
parameters: {{k: {{value: 3 N/m, about: '{words}'}}, m: {{about: '1. {words}'}}}}
bodies: {{b: {{mass: m, slide: x}}}}
springs: {{s: {{k: k, between: [ground, b]}}}}
coordinates: {{x: {{about: '+ {words}'}}}}
""".format(words=WORDS.replace("'", "''"))


@pytest.fixture(scope="module")
def hostile():
    text = HOSTILE.replace("{a}", "a").replace("{/etc/passwd}", "/etc/passwd").replace("{document}", "document")
    return document(problem(text))


def test_hostile_words_in_html(hostile):
    root = assert_page(html.render([hostile]))
    assert root.find(".//h1").text == hostile.title and "<script>" in hostile.title


def test_hostile_words_in_latex(hostile):
    text = render_latex.render([hostile], None)
    assert_latex(text)
    assert r"\textbackslash{}input/etc/passwd" in text and r"\$x\$" in text and "[U+4E2D]" in text


def test_hostile_words_in_markdown(hostile):
    text = markdown.render([hostile], None)
    assert_markdown(text)
    assert "](" not in text.replace(r"\](", "") and "&lt;script&gt;" in text
    assert not re.search(r"(?<!\\)`|www\.|\]\(|://|^(- <|\d\. |\+ |# #)", text.replace(r"\](", ""), re.MULTILINE)


def test_hostile_words_in_asciidoc(hostile):
    text = asciidoc.render([hostile], None)
    assert_asciidoc(text)
    assert "&#60;script&#62;" in text and "http:&#47;" not in text and "http&#58;//" in text


@pytest.mark.sweep
def test_hostile_words_in_typst(hostile, tmp_path):
    text = render_typst.render([hostile], None)
    assert_typst(text)
    assert r"\<script\>" in text and r"\#" in text and r"\$x\$" in text and r"http:\//e.vil" in text
    shown = words_of(compiled(text, tmp_path))
    assert hostile.title.replace("\u0308", "")[:40] in shown and "[l](javascript:x)" in shown


@pytest.mark.parametrize("text, expected", [
    ("a_b *c* #let $x$", r"a\_b \*c\* \#let \$x\$"), ("[x] <y> @z `q` ~", r"\[x\] \<y\> \@z \`q\` \~"),
    ("a -- b -1 -?", r"a \-- b \-1 \-?"), ("a-b", "a-b"), ("...", r"\..."), ("// /* http://x", r"\// \/\* http:\//x"),
    ("\\u{41}", r"\\u{41}")])
def test_words_in_typst(text, expected):
    assert render_typst.escaped(text) == expected


@pytest.mark.sweep
def test_no_formula_leaves_the_pages_of_typst(tmp_path):
    """Many lines, each wider than a page, stand on as many pages as they need."""
    pypdf = pytest.importorskip("pypdf")
    lines = tuple(line(Words(f"line{i}: " + "a long word " * 12)) for i in range(200))
    text = render_typst.render([Document("T", None, (), (Section("S", (Equations(lines),)),))], None)
    pages = pypdf.PdfReader(BytesIO(compiled(text, tmp_path))).pages
    assert len(pages) >= 4 and "line199:" in pages[-1].extract_text()
    assert all(page.extract_text().count("line") <= 60 for page in pages)


@pytest.mark.sweep
def test_no_formula_leaves_the_pages_of_latex(tmp_path):
    """Nor a table, nor a formula in running text, be they without a place to break them."""
    if not which("pdflatex"):
        pytest.skip("no pdflatex")
    table = Table()
    node = table.sqrt(table.total([table.parameter(f"wide{i}") for i in range(30)]))
    wide = "a long cell without an end " * 5
    text = render_latex.render([Document("T", None, (), (Section("S", (
        Equations((line("x = ", node),)), paragraph("with ", maths("x = ", node)), Cells(("a", "b"), ((wide, wide),)),
        Definitions((Definition(("a",), wide * 2),), flowing=True))),))], None)
    (tmp_path / "t.tex").write_text(text)
    done = subprocess.run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "t.tex"], cwd=tmp_path,
                          capture_output=True, check=False)
    assert done.returncode == 0 and b"Overfull" not in done.stdout


@pytest.mark.parametrize("cells, expected", [
    (("short", "words"), "#block(breakable: false, table(columns: (auto, auto,)"),
    (("mistake", "a sentence that is longer than the page is wide " * 2), "false, table(columns: (auto, 1fr,)"),
    (("a sentence that is longer than the page is wide " * 2, "gives"), "false, table(columns: (1fr, auto,)"),
    (("12345.678",) * 12, "#fitted(table(columns: (auto, ")])
def test_tables_in_typst(cells, expected, tmp_path):
    """Words are broken where a table is wide, numbers never."""
    found = Document("T", None, (), (Section("S", (Cells(cells, (cells,)),)),))
    text = render_typst.render([found], None)
    assert expected in text
    compiled(text, tmp_path)


@pytest.mark.sweep
def test_short_tables_in_typst_stay_on_a_page_and_long_ones_go_on(tmp_path):
    pypdf = pytest.importorskip("pypdf")
    blocks = tuple(Cells(("word", "number"), tuple((f"t{i}", str(j)) for j in range(9))) for i in range(9))
    long = Cells(("word", "number"), tuple(("row", str(j)) for j in range(90)))
    text = render_typst.render([Document("T", None, (), (Section("S", (*blocks, long)),))], None)
    pages = [page.extract_text() for page in pypdf.PdfReader(BytesIO(compiled(text, tmp_path))).pages]
    assert all(sum(f"t{i}" in page for page in pages) == 1 for i in range(9))
    assert sum("row" in page for page in pages) > 1


@pytest.mark.parametrize("text, expected", [
    ("- a", r"\- a"), ("+ a", r"\+ a"), ("= a", r"\= a"), ("/ a: b", r"\/ a: b"), ("1. a", r"1\. a"), ("12 a", "12 a")])
def test_no_line_of_typst_begins_with_markup(text, expected):
    assert render_typst.beginning(text) == expected


def compiled(text, folder):
    """The PDF that Typst makes of a report, without a warning."""
    typst = pytest.importorskip("typst")
    path = folder / "compiled.typ"
    path.write_text(text, encoding="utf-8")
    pdf, warnings = typst.compile_with_warnings(str(path))
    assert [warning.message for warning in warnings if "font" not in warning.message] == []
    return pdf


def words_of(pdf):
    pypdf = pytest.importorskip("pypdf")
    return " ".join(page.extract_text() for page in pypdf.PdfReader(BytesIO(pdf)).pages)


@pytest.mark.parametrize("path", SAMPLE[::4], ids=lambda path: path.stem)
@pytest.mark.parametrize("options", [(), ("--steps",)], ids=["solution", "steps"])
def test_typst_compiles(path, options, tmp_path, capsys):
    if run(["solve", str(path), "--format", "typst", *options]) not in (0, 4):
        pytest.fail("no report")
    out = capsys.readouterr().out
    assert compiled(out, tmp_path).startswith(b"%PDF")


@pytest.mark.sweep
def test_typst_compiles_with_pictures(scene, tmp_path):
    assert run(["solve", scene, "--pictures", "-o", "r.typ"]) == 0
    text = Path("r.typ").read_text()
    shown = re.findall(r'#picture\("(.*?)"', text)
    assert len(shown) == 3 and all(b"<svg" in Path(name).read_bytes() for name in shown)
    assert "mode 1" in words_of(compiled(text, Path()))


@pytest.mark.parametrize("text, expected", [
    ("k*x [N]", "k&#42;x [N]"), ("a -- b...", "a -&#45; b&#46;.."),
    ("{x} <<y>> [[z]]", "&#123;x} &#60;&#60;y&#62;&#62; &#91;&#91;z]]"), ("t:: u;; v; w", "t&#58;: u;&#59; v; w"),
    ("link:x[y]", "link:x&#91;y]"), ("(C) ((x))", "&#40;C) &#40;(x))")])
def test_words_in_asciidoc(text, expected):
    assert asciidoc.escaped(text) == expected


@pytest.mark.parametrize("text", ["- a", "1. a", "a. b", "NOTE: a", ".a", "// a", "|===", "[a]", ":a: b", "i) a"])
def test_no_line_of_asciidoc_begins_with_markup(text):
    assert asciidoc.beginning(text) == "{empty}" + text


@pytest.mark.parametrize("kind", [*FORMATS, "text"])
def test_control_characters_pass_in_no_format(kind):
    found = Document("a\x1b]52;c;x\x07b\u202ec\r\x9b1m", "s\x1b[2J", ("q\x00",), (), None)
    text = render_text.render([found]) if kind == "text" else render([found], kind)
    assert not re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202e]", text)


@pytest.mark.parametrize("text, expected", [
    ("50 % of a_b & c#", r"50 \% of a\_b \& c\#"), (r"\input{x}", r"\textbackslash{}input\{x\}"),
    ("~^", r"\textasciitilde{}\textasciicircum{}"), ("né č ø", r"n\'{e} \v{c} \o{}"), ("--", "-{}-"), (",,", ",{},"),
    ("ω² ≤ 3·x₁", r"\ensuremath{\omega}\ensuremath{{}^{2}} \ensuremath{\le} 3\ensuremath{\cdot}x\ensuremath{{}_{1}}"),
    ("φ̈", r"\ensuremath{\ddot{\varphi}}"), ("中", "[U+4E2D]"), ("1" * 25, r"1111111111\allowbreak{}111111111111111")])
def test_words_in_latex(text, expected):
    assert escaped(text) == expected


def test_every_letter_of_words_in_latex_is_ascii():
    shown = "".join(map(chr, [*range(32, 0x250), *range(0x370, 0x400), *range(0x2000, 0x2300)]))
    assert escaped(shown).isascii()


# formulas

@pytest.fixture
def nodes():
    table = Table()
    x, v, phi = table.variable("x"), table.variable("x'"), table.variable("phi1")
    m, k = table.parameter("m"), table.parameter("k_s")
    sin = table.call("sin", phi)
    return {"fraction": m * v ** 2 / 2, "frequency": table.sqrt(k / m), "function": sin ** 2, "sum": x - 3 * m,
            "bracket": m * (x - v),
            "exponent": table.power(x, -2), "absolute": table.call("abs", x), "power": table.call("power", x, k),
            "two": table.call("atan2", x, v), "pi": 2 * table.pi / 3}


X, V, M = "<mi>x</mi>", "<mover><mi>x</mi><mtext>.</mtext></mover>", "<mi>m</mi>"
K, PHI = "<msub><mi>k</mi><mi>s</mi></msub>", "<msub><mi>φ</mi><mn>1</mn></msub>"
BY = '<mo>&#x2062;</mo><mspace width="0.17em"/>'
OPEN, CLOSE = '<mo stretchy="false">(</mo>', '<mo stretchy="false">)</mo>'
MARKUP = {
    "fraction": f"<mfrac><mrow>{M}{BY}<msup><mrow>{V}</mrow><mn>2</mn></msup></mrow><mn>2</mn></mfrac>",
    "frequency": f"<msqrt><mfrac><mrow>{K}</mrow>{M}</mfrac></msqrt>",
    "function": f'<msup><mi>sin</mi><mn>2</mn></msup><mo>&#x2061;</mo><mspace width="0.17em"/>{PHI}',
    "sum": f"{X}<mo>−</mo><mn>3</mn>{BY}{M}",
    "bracket": f"{M}{BY}<mrow>{OPEN}{X}<mo>−</mo>{V}{CLOSE}</mrow>",
    "exponent": f"<mfrac><mn>1</mn><mrow><msup>{X}<mn>2</mn></msup></mrow></mfrac>",
    "absolute": f'<mrow><mo form="prefix">|</mo>{X}<mo form="postfix">|</mo></mrow>',
    "power": f"<msup>{X}<mrow>{K}</mrow></msup>",
    "two": f"<mi>atan2</mi><mo>&#x2061;</mo><mrow>{OPEN}{X}<mo>,</mo>{V}{CLOSE}</mrow>",
    "pi": "<mfrac><mrow><mn>2</mn>" + BY + "<mi>π</mi></mrow><mn>3</mn></mfrac>"}


@pytest.mark.parametrize("name", MARKUP)
def test_markup_of_expressions(nodes, name):
    assert mathml(nodes[name]) == MARKUP[name]
    assert_mathml(ET.fromstring(f"<math>{mathml(nodes[name])}</math>"))


@pytest.mark.parametrize("text, expected, markup", [
    ("ω_d = ω·√(1 − ζ²)", r"\omega_{d} = \omega \, \sqrt{1 - \zeta^{2}}",
     f"<msub><mi>ω</mi><mi>d</mi></msub><mo>=</mo><mi>ω</mi>{BY}<msqrt><mn>1</mn><mo>−</mo>"
     "<msup><mi>ζ</mi><mn>2</mn></msup></msqrt>"),
    ("ω₁,₂² = ", r"\omega_{1,2}^{2} =", "<msubsup><mi>ω</mi><mn>1,2</mn><mn>2</mn></msubsup><mo>=</mo>"),
    (" + 1.2e+06·", r"+ 1.2 \cdot 10^{6} \,",
     f"<mo>+</mo><mn>1.2</mn><mo>·</mo><msup><mn>10</mn><mn>6</mn></msup>{BY}"),
    ("Q_φ₁·δφ₁", r"Q_{\varphi_{1}} \, \delta \varphi_{1}",
     "<msub><mi>Q</mi><mrow><msub><mi>φ</mi><mn>1</mn></msub></mrow></msub>" + BY + "<mi>δ</mi>"
     "<msub><mi>φ</mi><mn>1</mn></msub>"),
    ("3·e^(−0.5·t)·cos(2·t + 1)", r"3 \, e^{- 0.5 \, t} \, \cos ( 2 \, t + 1 )",
     f'<mn>3</mn>{BY}<msup><mi>e</mi><mrow><mo form="prefix">−</mo><mn>0.5</mn>{BY}<mi>t</mi></mrow></msup>{BY}<mi>cos'
     '</mi><mrow>'
     f'<mo stretchy="false">(</mo><mn>2</mn>{BY}<mi>t</mi><mo>+</mo><mn>1</mn><mo stretchy="false">)</mo></mrow>'),
    (" = -725.94", "= - 725.94", '<mo>=</mo><mo form="prefix">−</mo><mn>725.94</mn>'),
    ("−1.5·", r"- 1.5 \,", f'<mo form="prefix">−</mo><mn>1.5</mn>{BY}'), (" − ", "-", "<mo>−</mo>"),
    ("∂V/∂x", r"\partial V / \partial x",
     '<mi>∂</mi><mi>V</mi><mo lspace="0em" rspace="0em">/</mo><mi>∂</mi><mi>x</mi>'),
    ("t^2", "t^{2}", "<msup><mi>t</mi><mn>2</mn></msup>"), ("t^", "t^{}", "<msup><mi>t</mi><mrow></mrow></msup>"),
    ("√2", r"\sqrt{2}", "<msqrt><mn>2</mn></msqrt>"), ("√(a", r"\sqrt{(} a", "<msqrt><mo>(</mo></msqrt><mi>a</mi>")])
def test_texts_in_notation(text, expected, markup):
    assert latex.notation(text) == expected
    assert mathml.notation(text) == markup


def test_brackets_grow_with_what_stands_above_one_line():
    """With fractions and roots within, not with letters: a font may set brackets that grow apart."""
    table = Table()
    x, y = table.parameter("x"), table.parameter("y")
    assert mathml(table.call("sin", x + y)).count('stretchy="false"') == 2
    assert "stretchy" not in mathml(x * (y + x / (x + y)))
    assert "stretchy" not in mathml(x * (y + table.sqrt(x)))


def test_brackets_around_what_stands_on_one_line_stay_small_with_their_power():
    small = '<mo stretchy="false">(</mo><mi>a</mi><mo stretchy="false">)</mo>'
    assert mathml.notation("(a)²") == f"<msup><mrow><mrow>{small}</mrow></mrow><mn>2</mn></msup>"
    assert latex.notation("(a)²") == "( a )^{2}" and typst.notation("(a)²") == "(a)^(2)"
    assert mathml.notation("½(").endswith("</mstyle><mo>(</mo>")        # of an expression that follows: they grow


def test_long_sums_are_broken_before_their_terms():
    table = Table()
    total = table.sum(*((table.parameter(f"a{i}"), (-1) ** i) for i in range(40)))
    parts = ("T = ", total)
    broken = rows(parts, plain, 60)
    assert len(broken) > 2 and all(len(row) <= 60 for row in broken)
    assert all(row.startswith(("+", "−")) for row in broken[1:])
    assert len(rows(parts, latex, 60)) == len(rows(parts, mathml, 60)) == len(broken)
    assert " ".join(broken) == formula(parts, plain)


@pytest.mark.parametrize("write", [plain, latex, mathml])
def test_pieces_make_the_whole(nodes, write):
    for node in nodes.values():
        assert write.beside(*pieces((node,), write)) == write(node)
        assert len(pieces((node,), write)) == len(pieces((node,), plain))


def test_texts_are_broken_outside_of_brackets():
    assert pieces((" = e^(a − b)·c + d − (e = f)",), plain) == ["", " = e^(a − b)·c", " + d", " − (e = f)"]


@pytest.mark.parametrize("kind", [latex, mathml, typst])
def test_words_have_powers_of_ten_as_in_print(kind):
    assert list(without_words(("left is 3.3e-17, 2e+05 of d1e5",))) == ["left is 3.3·10⁻¹⁷, 2·10⁵ of d1e5"]
    assert formula((Words("left is 1e-6"),), kind) == kind.words("left is 1·10⁻⁶")
    assert formula((Words("left is 1e-6"),), plain) == "left is 1e-6"


def test_words_stand_outside_of_formulas_in_running_text():
    assert list(without_words(("a", maths("x = "), "3"))) == ["a", maths("x = "), " ", "3"]
    cells = Cells((maths(Name("phi"), Words(" [rad|$]")), maths("|λ|")), ())
    found = Document("t", None, (), (Section("s", (cells,)),), None)
    assert r"| $\varphi$ [rad\|<span>\$</span>] | $\vert  \lambda \vert $ |" in markdown.render([found], None)
    assert r"$\varphi$ [rad\textbar{}\$]" in render_latex.render([found], None)


@pytest.mark.sweep
def test_matplotlib_reads_the_formulas(nodes):
    from matplotlib.mathtext import MathTextParser

    parser = MathTextParser("path")
    for node in nodes.values():
        parser.parse(f"${latex(node)}$")


# the command

SCENE = """parameters: {m: 2 kg, k: 800 N/m, c: 3 N*s/m}
bodies:
  a: {mass: m, slide: x}
  b: {mass: m, slide: y}
springs:
  s: {k: k, between: [ground, a]}
  t: {k: k, between: [a, b]}
dampers:
  d: {c: c, between: [ground, a]}
"""
REFUSED = "bodies: {a: {mass: 2 kg, slide: x}}\nforces: {f: {at: a, force: 3 N}}\nfind: [equilibrium]\n"


@pytest.fixture
def scene(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("two.yaml").write_text(SCENE)
    return "two.yaml"


@pytest.mark.parametrize("command", ["solve", "equations", "frequencies"])
@pytest.mark.parametrize("name", ["r.txt", "r.md", "r.tex", "r.adoc", "r.html"])
def test_files_by_their_suffix(scene, capsys, command, name):
    assert run([command, scene, "-o", name]) == 0
    assert capsys.readouterr().out == ""
    kind = {"md": "markdown", "tex": "latex", "txt": "text", "adoc": "asciidoc"}.get(name.split(".")[1], "html")
    assert run([command, scene, "--format", kind]) == 0
    text = Path(name).read_text()
    assert text == capsys.readouterr().out
    CHECKS.get(kind, len)(text)
    assert sorted(path.name for path in Path().iterdir()) == sorted([name, scene])


def test_json_goes_to_a_file_too(scene, capsys):
    assert run(["frequencies", scene, "--json", "-o", "r.json"]) == 0
    assert run(["frequencies", scene, "--json"]) == 0
    assert Path("r.json").read_text() == capsys.readouterr().out


def test_nothing_is_overwritten_unless_it_is_told(scene, capsys):
    Path("r.md").write_text("mine")
    assert run(["solve", scene, "-o", "r.md"]) == 2
    assert Path("r.md").read_text() == "mine" and "--force" in capsys.readouterr().err
    assert run(["solve", scene, "-o", "r.md", "--force"]) == 0
    assert Path("r.md").read_text().startswith("# two")


@pytest.mark.parametrize("args", [
    ["-o", "r.pdf"], ["-o", "no/r.md"], ["--format", "latex", "-o", "r.html"], ["--json", "--format", "html"],
    ["--pictures"], ["--pictures", "--format", "latex"], ["--format", "pdf"]])
def test_what_cannot_be_written_is_a_usage_error(scene, args):
    assert run(["solve", scene, *args]) == 2
    assert [path.name for path in Path().iterdir()] == [scene]


@pytest.mark.sweep
@pytest.mark.parametrize("kind", FORMATS)
def test_refusals_stand_in_the_report(scene, capsys, kind):
    Path("refused.yaml").write_text(REFUSED)
    assert run(["solve", "refused.yaml", "--format", kind]) == 4
    out, err = capsys.readouterr()
    assert "error" in err and "Not found:" in out
    CHECKS[kind](out)


@pytest.mark.sweep
def test_pictures_are_drawn_into_the_page_and_beside_the_others(scene):
    assert run(["solve", scene, "--pictures", "-o", "r.html"]) == 0
    root = assert_page(Path("r.html").read_text())
    assert len(root.findall(".//figure")) == 3
    named = [element.get("id") for element in root.iter() if element.get("id")]
    assert len(named) == len(set(named))
    assert run(["solve", scene, "--pictures", "-o", "r.tex"]) == 0
    shown = re.findall(r"\\drawn\{(.*?)\}", Path("r.tex").read_text())
    assert len(shown) == 3 and all(Path(name).read_bytes().startswith(b"%PDF") for name in shown)
    assert run(["solve", scene, "--pictures", "-o", "r.md"]) == 0
    shown = re.findall(r"!\[.*?\]\((.*?)\)", Path("r.md").read_text())
    assert len(shown) == 3 and all(b"<svg" in Path(name).read_bytes() for name in shown)
    assert run(["solve", scene, "--pictures", "--force", "-o", "r.adoc"]) == 0
    assert_asciidoc(Path("r.adoc").read_text())
    shown = re.findall(r"^image::(.*?)\[", Path("r.adoc").read_text(), re.MULTILINE)
    assert len(shown) == 3 and all(b"<svg" in Path(name).read_bytes() for name in shown)


def test_a_picture_that_exists_is_not_overwritten(scene):
    Path("r-1-scene.svg").write_text("mine")
    assert run(["solve", scene, "--pictures", "-o", "r.md"]) == 2
    assert Path("r-1-scene.svg").read_text() == "mine" and not Path("r.md").exists()


def test_names_within_pictures_do_not_mix():
    svg = b'<?xml version="1.0"?><svg><defs><path id="p"/></defs><use href="#p"/><g clip-path="url(#p)"/></svg>'
    found = [Picture(name, "c", lambda kind: svg) for name in ("one", "two")]
    text = html.render([Document("t", None, (), (Section("s", tuple(found)),), None)])
    assert re.findall(r'(?:id="|href="#|url\(#)(?!scene)(\w+-p)', text) == ["one-p"] * 3 + ["two-p"] * 3


@pytest.mark.parametrize(("write", "lowered", "kept"), [
    (html, '<th scope="col">ω<sub>d</sub> [rad/s]</th>', ">x_left<"),
    (render_latex, r"\ensuremath{\omega}$_{d}$ [rad/s]", r"x\_left"),
    (render_typst, r"[$ω_d$ \[rad/s\]]", r"[x\_left]"), (asciidoc, "|stem:[ω_d] [rad/s]", "x&#95;left"),
    (markdown, "| $ω _ d$ [rad/s] |", r"x\_left")])
def test_letters_above_columns_have_their_indices_lowered(write, lowered, kept):
    table = Cells(("mode", "ω_d [rad/s]", "x_left"), (("1", "2", "3"),))
    text = write.render([Document("t", None, (), (Section("s", (table,)),), None)], None)
    assert lowered in text and kept in text


def test_pictures_are_no_narrower_than_their_letters_can_be_read():
    svg = '<svg width="{}pt"><text x="1" font-size="9.5">a</text><text x="1" font-size="11.5">b</text></svg>'
    for wide, least in (300, 222), (600, 443):
        found = Picture("one", "c", lambda kind, wide=wide: svg.format(wide).encode())
        text = html.render([Document("t", None, (), (Section("s", (found,)),), None)])
        assert f'<svg style="min-width: {least}px" width="{wide}pt">' in text


@pytest.mark.sweep
@pytest.mark.parametrize("kind", FORMATS)
def test_formats_import_nothing_heavy(scene, kind):
    code, names = modules("solve", scene, "--format", kind)
    assert code == 0
    assert not names & {"scipy", "sympy", "matplotlib"}


@pytest.mark.sweep
@pytest.mark.skipif(which("pdflatex") is None, reason="no LaTeX here")
@pytest.mark.parametrize("scene", ["problems/7_forced_two_degrees/washing_machine_on_a_bench.yaml",
                                   "problems/5_forced/motor_raised_on_a_hinged_beam.yaml",
                                   "vibcli/examples/double_pendulum.yaml", "vibcli/examples/frequency_response.yaml",
                                   "vibcli/examples/arm_on_a_hub.yaml"])
def test_latex_compiles(scene, tmp_path):
    path = tmp_path / "report.tex"
    assert run(["solve", str(PROBLEMS.parent / scene), "-o", str(path), "--pictures"]) == 0
    done = subprocess.run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", path.name], cwd=tmp_path,
                          capture_output=True, timeout=120)
    assert done.returncode == 0, done.stdout[-2000:].decode(errors="replace")
    assert b"Overfull" not in done.stdout


@pytest.mark.parametrize(("kind", "apart"), [(render_latex, "\\begin{align*}"), (markdown, "$$\n"),
                                             (asciidoc, "[stem]\n"), (render_typst, "$ & ")])
@pytest.mark.parametrize(("count", "rows"), [(5, 0), (40, 3)])
def test_a_formula_wider_than_a_line_stands_apart_from_the_text(kind, apart, count, rows):
    wide = paragraph("with ", maths("a = " + " + ".join(["b_1"] * count)), ", say")
    told = kind.render([Document("t", None, (), (Section("s", (wide,)),))], None)
    assert (apart in told) is bool(rows) and told.count("& ") == rows


@pytest.mark.parametrize(("count", "beside"), [(4, True), (40, False)])
def test_a_label_stands_above_formulas_that_fill_the_page(count, beside):
    """Its column would push them over the margin."""
    row = line("a = " + " + ".join(["b_1"] * count), label=Words("left, right, girder"))
    told = render_latex.render([Document("t", None, (), (Section("s", (Equations((row,)),)),))], None)
    assert (r"girder}:\quad & {}" in told) is beside and r"girder}:\quad" in told


def test_what_has_no_bodies_has_no_picture_of_its_modes(tmp_path):
    page = tmp_path / "page.html"
    assert run(["solve", "vibcli/examples/u_tube.yaml", "--pictures", "-o", str(page)]) == 0
    assert "given by its energies" in page.read_text() and "on the scene at rest" not in page.read_text()
