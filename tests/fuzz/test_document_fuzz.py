"""Reading hostile files: limits hold, nothing hangs or crashes, nothing but diagnostics comes back."""

import random
import subprocess
import sys

import pytest
import yaml
from support.counting import calls
from support.documents import SCENE, plain

from vibcli.base import decoding
from vibcli.base.diagnostics import render
from vibcli.base.errors import Diagnostic
from vibcli.language.document.document import Mapping, Scalar, read

MOST_CALLS = 10**5
DATA = SCENE.encode()


def read_text(text):
    return read(text.encode(), "s.yaml")


def found(text):
    return [(d.where.line, d.where.column, d.message) for d in read_text(text)[1]]


def nested(depth):
    return "a: " + "[" * depth + "]" * depth


def test_limits_hold_and_are_wide_enough():
    assert read_text(nested(31))[1] == []
    assert found(nested(32)) == [(1, 35, "nested more than 32 deep")]
    assert read_text("a: " + "x" * 4096)[1] == []
    assert found("a: " + "x" * 4097) == [(1, 4, "expected at most 4096 characters, found 4097")]
    big = b"# " + b"x" * (2**20 - 7) + b"\na: 1"
    assert len(big) == 2**20
    assert read(big, "s")[1] == []
    assert "more than 1048576 bytes" in read(big + b"\n", "s")[1][0].message
    many = "a: [" + "1," * 199_997 + "1]"
    assert read_text(many)[1][0].message == "more than 200000 values in one file"
    assert read_text(many.replace("1,", "", 10))[1] == []
    assert len(read_text("a: 1\n" * 1000)[1]) == 101


MIB = 2**20
LOADER = getattr(yaml, "CBaseLoader", yaml.BaseLoader)
HOSTILE = [
    "[", "{", "- ", "? ", "[{", "a: [", "- ? ", ": ", "{? ", "{a: ", "!", "&a ", "*a ", "[]: ", '"', "'",
    "\t",
    "\n", "\r", "#\n", "a: b\n", "? a\n", "%\n", "---\n", "...\n", "|\n", "(,", "[(,", "@", '"\\x1b', "\\",
    "\u202e", "a:", "a b ", "\x1b", "<<: ", "!a &b ", "- !a &b c\n", "-", "-: ", "a: [f(x, y), o[1]]\n",
    "a\n"]


@pytest.mark.parametrize("piece", HOSTILE)
def test_hostile_mebibyte_is_refused_at_once(piece):
    data = (piece * (MIB // len(piece.encode())))[:MIB].encode()[:MIB]
    (node, problems), count = calls(read, data, "s")
    assert count < MOST_CALLS
    assert node is None
    assert 1 <= len(problems) <= 102


@pytest.mark.parametrize("piece", ["[", "{", "- ", "? ", "[{", "a: ["])
def test_process_survives_deep_nesting(piece):
    """In a process of its own: a crash of the C parser would take the tests with it."""
    code = ("from vibcli.language.document.document import read\n"
            f"print(read(({piece!r} * 30000).encode(), 's')[1][-1].message)")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "nested more than 32 deep\n" or "as key" in done.stdout


PIECES = [
    b"[", b"]", b"{", b"}", b",", b": ", b":", b"- ", b"\n", b" ", b"\t", b'"', b"'", b"#", b"|\n", b">\n",
    b"!t ", b"&a ", b"*a", b"<<: ", b"%", b"@", b"---\n", b"? ", b"\\x1b", b'"\\u202e"', b"\r", b"\0",
    b"\xff",
    b"\xc3\xa9", b"\xef\xbb\xbf", b"\xc2\x85", b"\xe2\x80\xa8", b"omega[1]", b"f(x, y)", b"(", b"a: b\n",
    b"''", b"\\"]


def bad_bytes(dice):
    """Random bytes, random YAML pieces, or the scene with a few changes."""
    kind = dice.random()
    if kind < 0.2:
        return dice.randbytes(dice.randrange(40))
    if kind < 0.5:
        return b"".join(dice.choices(PIECES, k=dice.randrange(1, 25)))
    data = bytearray(DATA)
    for _ in range(dice.randrange(1, 5)):
        place = dice.randrange(len(data) + 1)
        change = dice.randrange(4)
        if change == 0:
            data[place:place] = dice.choice(PIECES)
        elif change == 1:
            del data[place : place + dice.randrange(1, 6)]
        elif change == 2:
            data[place : place + 1] = dice.randbytes(1)
        else:
            data[place:place] = data[place - 20 : place]
    return bytes(data)


def check_tree(node, lines, depth=0):
    """Depth and texts are bounded; what claims to be letter by letter in the file is."""
    assert depth <= 32
    if isinstance(node, Scalar):
        assert len(node.text) <= 4096
        assert not decoding.forbidden().search(node.text)
        if node.inset is not None and decoding.STAND_IN not in node.text:
            where = node.place(0, len(node.text))
            assert lines[where.line - 1][where.column - 1 :].startswith(node.text)
        return
    pairs = node.entries.values() if isinstance(node, Mapping) else [node.items]
    for child in (child for pair in pairs for child in pair):
        check_tree(child, lines, depth + 1)


def read_and_checked(data):
    """Read bytes: whether nothing is wrong with them, and then they are what PyYAML reads."""
    node, problems = read(data, "s.yaml")
    lines = decoding.lines(data)
    for problem in problems:
        assert type(problem) is Diagnostic
        assert problem.message and problem.hint, data
        assert 1 <= problem.where.line <= len(lines), data
        assert 1 <= problem.where.column <= len(lines[problem.where.line - 1]) + 1, data
        assert render(problem, lines).replace("\n", "").isprintable(), data
    assert problems or isinstance(node, Mapping), data
    if node is not None:
        check_tree(node, lines)
    if not problems:
        assert plain(node) == yaml.load(data, LOADER), data
    return not problems


def test_fuzz_nothing_but_diagnostics_escapes():
    dice = random.Random(20)
    assert sum(read_and_checked(bad_bytes(dice)) for _ in range(4000)) > 300
