"""Reading scene files: what stands in the tree, and the place and the words of every slip."""

import os
import re
import subprocess
import sys

import pytest
from support.documents import SCENE, plain

from vibcli.base.diagnostics import render
from vibcli.base.errors import Diagnostic, Where
from vibcli.language.document import document
from vibcli.language.document.document import Sequence, read, read_file


def read_text(text):
    return read(text.encode(), "s.yaml")


def found(text):
    """(line, column, message) of every diagnostic."""
    return [(d.where.line, d.where.column, d.message) for d in read_text(text)[1]]


@pytest.fixture(params=["libyaml", "pure Python"])
def parser(request, monkeypatch):
    if request.param == "pure Python":
        monkeypatch.setattr(document, "_Parser", document.SlowParser)
    return request.param


def test_tree_keeps_text_and_order(parser):
    node, problems = read_text(SCENE)
    assert problems == []
    assert plain(node) == {
        "title": "Mass: on a spring",
        "parameters": {"m": "2 kg", "k": "", "on": "010"},
        "bodies": {"block": {"mass": "m", "slide": "x"}, "tip's": [["0", "-(L + h)"], {"omega[1]": "1e3"}]},
        "answers": {"omega[1]": "sqrt(k/m)", "x'": ""},
        "question": "What is asked\n",
    }
    assert list(node.entries) == ["title", "parameters", "bodies", "answers", "question"]


def test_empty_value_and_empty_text_differ():
    node, _ = read_text("m:\nk: ''\nq: |\n")
    assert [(v.text, v.quoted) for _, v in node.entries.values()] == [("", False), ("", True), ("", True)]
    assert node.entries["m"][1].where == Where("s.yaml", 1, 3, 1)


def test_places_of_nodes():
    node, _ = read_text(SCENE)
    key, block = node.entries["bodies"][1].entries["block"]
    assert key.where == Where("s.yaml", 4, 3, 5)
    assert block.where == Where("s.yaml", 4, 10, 19)
    assert block.entries["slide"][1].where == Where("s.yaml", 4, 27, 1)
    assert node.entries["question"][1].where == Where("s.yaml", 11, 11, 1)


@pytest.mark.parametrize(("text", "offset", "column"), [
    ("a: m*xx", 2, 6), ("a: 'm*xx'", 2, 7), ('a: "m*xx"', 2, 7), ("é: [ü, m*xx]", 2, 10),
    ("\ufeffa: m*xx", 2, 6), ("a: m*xx", 99, 8), ("a: m*xx", -3, 4)])
def test_offset_in_text_is_a_place_in_the_file(text, offset, column):
    value = read_text(text)[0].entries[text[0].strip("\ufeff") or "a"][1]
    value = value.items[1] if isinstance(value, Sequence) else value
    assert value.place(offset).column == column
    assert value.place(1, 99).width == 3


@pytest.mark.parametrize("text", ["a: 'it''s'", 'a: "\\u00e9 x"', "a: x\n  y", "a: >\n  x y", 'a: "x\n  y"'])
def test_folded_or_escaped_text_falls_back_to_its_start(text):
    value = read_text(text)[0].entries["a"][1]
    assert value.place(3) == value.where
    assert value.where[1:3] == (1, 4)


def test_byte_order_mark_and_line_ends_are_tolerated():
    for text in (SCENE, SCENE.replace("\n", "\r\n"), "\ufeff" + SCENE):
        node, problems = read_text(text)
        assert problems == []
        assert plain(node) == plain(read_text(SCENE)[0])
        assert node.entries["answers"][0].where == Where("s.yaml", 8, 1, 7)


NOT_USED = ", which scenes do not use"


@pytest.mark.parametrize(("text", "expected"), [
    ("a: !t x\n", [(1, 4, "found the tag '!t'" + NOT_USED)]),
    ("a: !!python/name:os.system [1]\n", [(1, 4, "found the tag '!!python/name:os.system'" + NOT_USED)]),
    ("a: !x &y 1\nb: *y\n", [(1, 4, "found the tag '!x'" + NOT_USED),
                             (1, 7, "found the anchor '&y'" + NOT_USED),
                             (2, 4, "found the alias '*y'" + NOT_USED)]),
    ("b:\n  <<: {a: 1}\n", [(2, 3, "found the merge key '<<'" + NOT_USED)]),
    ("%YAML 1.1\n---\na: 1\n", [(1, 1, "found a '%' directive" + NOT_USED)]),
    ("a: 1\nb: {c: 1,\n    c: 2}\na: 3\n", [(3, 5, "the key 'c' is written twice, first in line 2"),
                                           (4, 1, "the key 'a' is written twice, first in line 1")]),
    ("a: 1\n---\nb: 2\n", [(2, 1, "found a second document in the file, expected one scene")]),
    ("", [(1, 1, "the file is empty, expected a scene")]),
    ("# only words\n", [(1, 1, "the file is empty, expected a scene")]),
    ("- a\n- b\n", [(1, 1, "expected keys such as 'bodies:' at the top level, found a list")]),
    ("a:1\nb:2\n", [(1, 1, "expected keys such as 'bodies:' at the top level, found 'a:1 b:2'")]),
    ("a:\n\tb: 1\n", [(2, 1, "found a tab in the indentation, expected spaces")]),
    ("a: 1\n\tb: 2\n", [(2, 1, "found a tab in the indentation, expected spaces")]),
    ("b: {a: 1, [x]: 2}\n{c: d}: 3\n", [(1, 11, "expected a name as key, found a list"),
                                      (2, 1, "expected a name as key, found a mapping")]),
    ("{a:1}\n", [(1, 2, "no space after the ':' in 'a:1'")]),
    ("a: [1, 2\n", [(1, 4, "the '[' opened here is never closed")]),
    ("a: {b:\n", [(1, 4, "the '{' opened here is never closed")]),
    ("a:\n  b: {c: m\n  d: {c: 2}\n", [(2, 6, "the '{' opened here is never closed before line 3")]),
    ("{a: 1 b: 2}\n", [(1, 8, "expected ',' or '}' after this entry, found ':'")]),
    ("a: 'x\nb: 2\n", [(1, 4, "the quote ' opened here is never closed")]),
    ('a: "x\nb: "y"\n', [(1, 4, 'the quote " opened here is closed only in line 2')]),
    ("a: 'it's'\n", [(1, 8, "expected the end of the line after the closing quote, found 's'")]),
    ("title: Rolling: a disc\n", [(1, 15, "found a second ':' in the line of the key 'title'")]),
    ("a: 1\n  b: 2\n", [(2, 3, "indented deeper than line 1, whose key has a value already")]),
    ("a:\n    b: 1\n  c: 2\n", [(3, 3, "the indentation of 'c' fits none of the lines above")]),
    ("b:\n  a: 1\n  mass m\n  k: 3\n", [(3, 3, "expected key: value, found 'mass m'")]),
    ("mass m\nk: 3\n", [(1, 1, "expected key: value, found 'mass m'")]),
    ("- a\nb: 1\n", [(2, 1, "the indentation of 'b' fits none of the lines above")]),
    ("a: @x\n", [(1, 4, "no value can start with '@'")]),
    ("a: *\n", [(1, 4, "no value can start with '*'")]),
    ("a: \x1b[2J\nb: \u202e\u200b\n", [(1, 4, "found the control character U+001B"),
                                     (2, 4, "found the bidirectional character U+202E"),
                                     (2, 5, "found the invisible character U+200B")]),
    ('a: "x\\e\\x9b\\\\x1b"\nb: ["\\u202e"]\n', [
        (1, 6, "the escape '\\e' is the control character U+001B"),
        (1, 8, "the escape '\\x9b' is the control character U+009B"),
        (2, 6, "the escape '\\u202e' is the bidirectional character U+202E")]),
    ("a: 1\rb: 2\r\n", [(1, 5, "found a carriage return that no line feed follows")]),
])
def test_each_problem_has_its_place_and_words(text, expected, parser):
    assert found(text) == expected
    assert all(problem.hint for problem in read_text(text)[1])


@pytest.mark.parametrize(("text", "line", "column"), [
    ("a: !<\n", 1, 6), ("a: 1\n...\nb: 2\n", 3, 1), ("a:\n  : 3\n", 2, 3), ("{a: [1, 2}\n", 1, 10),
    ("a: 3]\nb: }\n", 2, 4), ("{a: b,, c: d}\n", 1, 7), ("a: [- 1]\n", 1, 5), ("a: {m} kg\n", 1, 8),
    ("a: - 5\n", 1, 4), ("a: 1\n- b\n", 2, 1), ("a: |x\n", 1, 5)])
def test_all_other_slips_are_said_in_words_of_the_parser(text, line, column, parser):
    [problem] = read_text(text)[1]
    assert problem.where[1:3] == (line, column)
    assert problem.message.startswith("this is no YAML: ")
    assert problem.hint


@pytest.mark.parametrize(("data", "line", "column", "words"), [
    (b"a: 1\nb\xc3\xa9: \xe9t\xe9\n", 2, 5, "the byte 0xe9 is not UTF-8"), (b"a: \0", 1, 4, "NUL"),
    ("a: 1".encode("utf-16"), 1, 1, "UTF-16"), (b"\x7fELF\2\0\0", 1, 6, "NUL"),
    (b"a: \xed\xa0\x80", 1, 4, "UTF-8")])
def test_bytes_that_are_no_text(data, line, column, words):
    node, [problem] = read(data, "s.yaml")
    assert node is None
    assert problem.where[1:3] == (line, column)
    assert words in problem.message


@pytest.mark.parametrize(("text", "cut", "tree"), [
    ("a: {omega[1]: 3, k: 2}\n", [(1, 5, "omega[1]")], {"a": {"omega[1]": "3", "k": "2"}}),
    ("a: {by: atan2(x, y), k: 2}\n", [(1, 9, "atan2(x, y)")], {"a": {"by": "atan2(x, y)", "k": "2"}}),
    ("a: [zeta[1], mode[1][x, y]]\n", [(1, 5, "zeta[1]"), (1, 14, "mode[1][x, y]")],
     {"a": ["zeta[1]", "mode[1][x, y]"]}),
    ("a: [(s.force + d[1])(3 s)]\n", [(1, 5, "(s.force + d[1])(3 s)")], None),
    ("a: {max(x, y): (1), frf[q, F](5 Hz): 2}\n", [(1, 5, "max(x, y)"), (1, 21, "frf[q, F](5 Hz)")],
     {"a": {"max(x, y)": "(1)", "frf[q, F](5 Hz)": "2"}})])
def test_expressions_that_braces_cut(text, cut, tree, parser):
    node, problems = read_text(text)
    assert [p.where[1:] for p in problems] == [(line, column, len(words)) for line, column, words in cut]
    for problem, (_, _, words) in zip(problems, cut, strict=True):
        assert f"'{words}'" in problem.message
        assert f'"{words}"' in problem.hint
    assert tree is None or plain(node) == tree


def test_reading_goes_on_after_a_cut_expression():
    text = "a: {omega[1]: 3}\nb: {by: max(x, y)}\nc: &x 1\nd: 1\nd: 2\n"
    assert [line for line, _, _ in found(text)] == [1, 2, 3, 5]


def test_hint_says_what_to_write():
    for text, hint in [("title: Rolling: a disc", 'put the whole value in quotes, title: "Rolling: a disc"'),
                       ("a:1", "put a space after the colon, a: 1")]:
        assert read_text(text)[1][0].hint == hint


def test_import_is_light():
    code = ("import sys, vibcli.language.document.document\n"
            "print(*sorted(m for m in sys.modules if m.startswith('vibcli.')))")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == [f"vibcli.{module}" for module in (
        "base", "base.decoding", "base.diagnostics", "base.errors", "base.named_tuple", "language", "language.document",
        "language.document.document", "language.document.nodes", "language.document.tree_builder")]


def test_read_file(tmp_path):
    scene = tmp_path / "s.yaml"
    scene.write_text("a: 1\r\nb: [\n", newline="")
    node, [problem], lines = read_file(scene)
    assert node is None
    assert problem.where == Where(str(scene), 2, 4, 1)
    assert lines == ["a: 1", "b: [", ""]
    with pytest.raises(FileNotFoundError):
        read_file(tmp_path / "none.yaml")
    with pytest.raises(FileNotFoundError):
        read_file(scene / "below.yaml")


@pytest.mark.parametrize("kind", ["directory", "pipe", "loop", "large", "locked", "nul"])
def test_files_that_cannot_be_read(tmp_path, kind):
    path, words = tmp_path / "x.yaml", {"directory": "found a directory", "pipe": "a device or pipe",
                                        "large": "bytes, expected at most"}.get(kind, "cannot be read")
    if kind == "directory":
        path.mkdir()
    elif kind == "pipe":
        os.mkfifo(path)
    elif kind == "loop":
        path.symlink_to(path)
    elif kind == "nul":
        path = "a\0b"
    else:
        path.write_bytes(b"#" * (2**20 + 1 if kind == "large" else 1))
    if kind == "locked":
        path.chmod(0)
        if os.access(path, os.R_OK):
            pytest.skip("the superuser may read everything")
    node, [problem], lines = read_file(path)
    assert node is None
    assert lines == []
    assert words in problem.message
    assert re.fullmatch(r".*: error: .*\nhint: .*", render(problem, lines))


def test_render_shows_line_caret_and_hint():
    [problem] = read_text("a: 1\n  b: {omega[1]: 3}\n".replace("  b", "b"))[1]
    assert render(problem, ["a: 1", "b: {omega[1]: 3}"]) == """\
s.yaml:2:5: error: inside [ ] and { } the brackets of 'omega[1]' need quotes
  b: {omega[1]: 3}
      ^^^^^^^^
hint: write "omega[1]", or give it a line of its own outside the brackets"""


def test_render_is_safe_and_bounded():
    problem = Diagnostic(Where("\x1b[2J", 1, 3, 2), "\u202e" + "m" * 10_000, "a\nb\x07")
    text = render(problem, ["é\x9bxy\t"])
    assert text.split("\n")[1:3] == ["  é\\x9bxy\\t", "       ^^"]
    assert text.replace("\n", "").isprintable()
    assert len(text) < 800
    assert "\x1b[1;31merror:\x1b[0m" in render(problem, [], color=True)
    assert render(Diagnostic(None, "m"), []) == "error: m"


@pytest.mark.parametrize(("line", "column"), [
    ("x" * 5000, 1), ("x" * 5000, 2500), ("x" * 5000, 5000), ("\x01" * 5000, 90), ("語" * 300, 200),
    ("e\u0301" * 300, 400), ("ab", 3)])
def test_render_cuts_long_lines_around_the_caret(line, column):
    _, source, caret = render(Diagnostic(Where("s", 1, column, 3), "m"), [line]).split("\n")
    assert len(source) <= 110
    assert 1 <= caret.count("^") <= 12
    assert caret.index("^") < 110
