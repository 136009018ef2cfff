"""Hints that say word for word what to write are followed, in every wrong scene: the diagnostic is gone then, and
nothing at that place is wrong in its spelling."""

import re

import pytest
from support.wrong_scenes import BAD, diagnostics, expected

from vibcli.cli.program import run
from vibcli.quantities import FAMILIES
from vibcli.quantities.quantity import named

UNIT = re.compile(r"write the unit: (?P<text>\S+(?: .+)?)$")
NAME = re.compile(r"did you mean '(?P<text>[^']+)'\?$")
SPELT = ("expected an operator", "expected an expression", "unknown", "found a pure number", "should go on")


def followed(source, place, message, hint):
    """The scene with what the hint says in the place of what it is about; None where it says no such thing."""
    line, column = (int(part) - 1 for part in place.split(":"))
    rows = source.split("\n")
    rest = rows[line][column:]
    unit, name = UNIT.search(hint), NAME.search(hint)
    if unit:
        old = unit["text"].split(" ")[0]
    elif name and (quoted := re.findall(r"'([^']+)'", message)):
        old = quoted[0]
    else:
        return None
    if not rest.startswith(old):
        return None
    rows[line] = rows[line][:column] + (unit or name)["text"] + rest[len(old):]
    return "\n".join(rows)


FOLLOWED = [(path, place, message, hint) for path in BAD for place, message, hint in expected(path)[2]
            if place != "-" and followed(path.read_text(encoding="utf-8"), place, message, hint)]


@pytest.mark.parametrize(("path", "place", "message", "hint"), FOLLOWED, ids=lambda part: getattr(part, "stem", None))
def test_it_helps(path, place, message, hint, tmp_path, capsys):
    file = tmp_path / "scene.yaml"
    file.write_text(followed(path.read_text(encoding="utf-8"), place, message, hint), encoding="utf-8")
    run([expected(path)[1], str(file)])
    err = capsys.readouterr().err
    for at, found, *_ in diagnostics(err, str(file)) if err else ():
        assert at != place or (found != message and not found.startswith(SPELT)), found


def test_many_are_followed():
    assert len(FOLLOWED) > 20


def test_units_without_their_brackets_are_understood(tmp_path, capsys):
    """Each value is replaced by that which its hint says."""
    file = tmp_path / "scene.yaml"
    source = (BAD[0].parent / "unit_in_brackets.yaml").read_text(encoding="utf-8")
    rows = source.split("\n")
    for place, _, hint in expected(BAD[0].parent / "unit_in_brackets.yaml")[2]:
        line = int(place.split(":")[0]) - 1
        rows[line] = rows[line].split(":")[0] + ": " + hint.partition("write ")[2]
    file.write_text("\n".join(rows), encoding="utf-8")
    run(["solve", str(file)])
    assert "unknown name" not in capsys.readouterr().err


QUANTITIES = [name + "[1]" for name in FAMILIES if named(name).unit not in (None, "", "1")
              and named(name).indices == ("mode",)]


@pytest.mark.parametrize("quantity", QUANTITIES)
def test_the_unit_that_is_due_is_one_that_can_be_written(quantity, tmp_path, capsys):
    file = tmp_path / "scene.yaml"
    text = ("parameters: {m: 2 kg, k: 800 N/m, c: 8 N*s/m}\nbodies: {b: {mass: m, slide: x}}\n"
            "springs: {s: {k: k, between: [ground, b]}}\ndampers: {d: {c: c, between: [ground, b]}}\n"
            "answers:\n  {}: {}\n")
    file.write_text(text.replace("{}: {}", f"{quantity}: 1.25"))
    run(["check", str(file)])
    found = [hint for _, _, hint, *_ in diagnostics(capsys.readouterr().err.replace("✗", ""), str(file))]
    due = next(filter(None, map(UNIT.search, found)))
    file.write_text(text.replace("{}: {}", f"{quantity}: {due['text']}"))
    assert run(["check", str(file)]) != 3
