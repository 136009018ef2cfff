"""Options and commands that messages, help and manual name: each exists, and belongs to the command it is named with;
hints that a command prints name options that it has."""

import ast
import re
from functools import cache
from pathlib import Path

import pytest
from support.wrong_scenes import BAD, expected

import vibcli
from vibcli.cli import COMMANDS
from vibcli.cli.program import group, run
from vibcli.language.dimension_check import unit_of_a_number
from vibcli.manual.index import words
from vibcli.quantities import FAMILIES
from vibcli.quantities.quantity import named
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import whole_literal

PACKAGE = Path(vibcli.__file__).parent
FILES = sorted(path for path in PACKAGE.rglob("*.py") if "bench" not in path.parts)
OPTION = re.compile(r"(?<![\w(-])--[a-z][a-z-]*(?!:)\b")
COMMAND = re.compile(r"\bvibcli ([a-z]+)\b([^`;,]*)")
NAMING = re.compile(r"--[a-z]|vibcli[ \"']")        # in the text of a file in which something may be named
PROSE = {"derives", "alone", "itself"}        # vibcli derives …, which is no command line


@cache
def read(path):
    """((line, text) of every string of a file, {…} standing for what is filled in; the lines on which keys of --json
    are described: the manual alone prints what they say); none of a file that names neither options nor commands."""
    found, parts, described = [], set(), set()
    source = path.read_text(encoding="utf-8")
    for node in ast.walk(ast.parse(source)) if NAMING.search(source) else ():
        if isinstance(node, ast.Call) and getattr(node.func, "id", None) == "Key":
            described |= {text.lineno for text in node.args[:2]}
        elif isinstance(node, ast.JoinedStr):
            parts.update(map(id, node.values))
            found.append((node.lineno, "".join(part.value if isinstance(part, ast.Constant) else "{…}"
                                               for part in node.values)))
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in parts:
            found.append((node.lineno, node.value))
    return found, described


def texts(path):
    return read(path)[0]


def options(command):
    context = group.make_context("vibcli", [], resilient_parsing=True)
    of = group if command is None else group.get_command(context, command)
    return {name for parameter in of.get_params(context) for name in (*parameter.opts, *parameter.secondary_opts)}


OPTIONS = {command: options(command) | {"--help"} for command in COMMANDS}
OF_GIT = {"--show-toplevel", "--name-only", "--no-renames", "--others", "--exclude-standard"}
ANY = set().union(*OPTIONS.values(), options(None), {"--quick", "--only", "--sympy"}, OF_GIT)


@pytest.mark.sweep
def test_what_is_named_exists():
    for path, line, text in [(file, *found) for file in FILES for found in texts(file)]:
        for option in OPTION.findall(text):
            assert option in ANY, f"{path.name}:{line}: {option}"
        for command, rest in COMMAND.findall(text):
            if command in PROSE:
                continue
            assert command in COMMANDS, f"{path.name}:{line}: vibcli {command}"
            assert set(OPTION.findall(rest)) <= OPTIONS[command], f"{path.name}:{line}: vibcli {command}{rest}"
            page = re.match(r" ([a-z_]+)\b", rest) if command == "explain" else None
            assert page is None or page[1] in words() or "{…}" in rest, f"{path.name}:{line}: explain {page[1]}"


@pytest.mark.sweep
def test_many_are_named():
    named = [found for path in FILES for _, text in texts(path) for found in OPTION.findall(text)]
    called = [found for path in FILES for _, text in texts(path) for found in COMMAND.findall(text)]
    assert len(named) > 100 and len(called) > 60


def test_hints_name_options_of_the_command_that_prints_them():
    for path in BAD:
        _, command, diagnostics = expected(path)
        for _, message, hint in diagnostics:
            assert set(OPTION.findall(f"{message} {hint}")) <= OPTIONS[command], path.stem


REPORTED = {"--digits", "--json", "--of", "--steps", "--strict"}     # in what these print


@pytest.mark.sweep
def test_hints_from_within_can_be_followed_in_every_command():
    """What is refused while scenes are solved is told by `check` too: the options that it names are there."""
    for path in FILES:
        if {"cli", "evidence", "manual"}.intersection(path.parts) or path.name == "page.py":
            continue
        found, described = read(path)
        for line, text in found:
            bare = "" if line in described else COMMAND.sub("", text)
            assert set(OPTION.findall(bare)) <= OPTIONS["check"] | REPORTED, f"{path.name}:{line}: {text}"


def test_a_scene_in_letters_is_checked_with_numbers(tmp_path, capsys):
    scene = tmp_path / "scene.yaml"
    scene.write_text("parameters: {k: , m: }\nbodies: {a: {mass: m, slide: x}}\n"
                     "springs: {s: {k: k, between: [ground, a]}}\nanswers:\n  omega[1]: 3 rad/s\n")
    assert run(["check", str(scene), "--set", "k=18 N/m", "--set", "m=2 kg"]) == 0
    assert run(["check", str(scene), "--set", "k=20 N/m", "--set", "m=2 kg"]) == 1
    assert "1 answer agrees" in capsys.readouterr().out


def test_a_number_with_the_unit_that_a_hint_names_is_one_value(tmp_path, capsys):
    units = {named(head).unit for head in FAMILIES} - {None, "", "1", "signal"}
    assert "1/s" in units
    for unit in units:
        assert whole_literal(parse(f"3.13 {unit_of_a_number(unit)}")), unit
    scene = tmp_path / "scene.yaml"
    text = """parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2}
gravity: g
bodies: {b: {mass: m, at: [0, L], pin: {at: [0, 0], by: phi}}}
answers:
  growth_rate[1]: 3.13209
"""
    scene.write_text(text)
    assert run(["check", str(scene)]) == 3
    advised = re.search(r"write the unit: (.*)", capsys.readouterr().err)[1]
    scene.write_text(text.replace("3.13209", advised))
    assert run(["check", str(scene)]) == 0


ENDLESS = "bodies: {b: {mass: 1, slide: x}, c: {mass: 1, slide: y}}\nenergies: {V: x^4/4 - x^2 + (y - x)^2}\n"


def test_a_hint_writes_numbers_as_its_scene_does(tmp_path, capsys):
    """One unit makes every plain number of a scene without units an error."""
    scene = tmp_path / "scene.yaml"
    scene.write_text(ENDLESS + "find: [{equilibria: all}]\n")
    assert run(["solve", str(scene)]) == 4
    advised = re.search(r"as in find: (\{.*\})", capsys.readouterr().err)[1]
    scene.write_text(ENDLESS + f"find: {advised}\n")
    run(["solve", str(scene)])
    assert "write the unit" not in capsys.readouterr().err


@pytest.mark.parametrize(("kind", "scene"), [
    ("a length", "bodies: {a: {mass: 1 kg, slide: x}}\n"
                 "springs: {s: {law: 1 N/m*d + 1 N/m^3*d^3, between: [ground, a]}}\n"),
    ("an angle", "bodies: {p: {shape: rod, mass: 1 kg, from: [0, 0], to: [0, -1 m], pin: {at: [0, 0], by: phi}}}\n"
                 "gravity: 9.81 m/s^2\n"),
    ("numbers alone", "bodies: {a: {mass: 1, slide: x}}\nsprings: {s: {law: d + d^3, between: [ground, a]}}\n")])
def test_how_a_backbone_is_asked_for_fits_the_scene(kind, scene, tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text(scene)
    assert run(["frequencies", "--backbone", str(path)]) == 4
    asked = re.search(r"hint: ask with (find: .*)", capsys.readouterr().err)[1]
    path.write_text(f"{scene}{asked}\n")
    assert run(["frequencies", "--backbone", str(path)]) == 0


def test_where_nothing_moves_that_is_said(tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text("bodies: {a: {mass: 1 kg, at: [0 m, 0 m]}}\n")
    for command in (["frequencies"], ["frequencies", "--backbone"], ["frf"], ["response"], ["solve"]):
        assert run([*command, str(path)]) == 4, command
        assert "nothing moves in this scene" in capsys.readouterr().err
