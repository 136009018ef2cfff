"""Which way imports run, by ast: each rule of the house with the change that it would notice."""

import ast
import re
import subprocess
import sys

import pytest

from house.measure import FLOOR, FLOORS, House, lines_for_types, room_of
from vibcli import elements, quantities
from vibcli.cli import COMMANDS
from vibcli.language import sections as of_language
from vibcli.reader import sections as of_questions
from vibcli.report import formats
from vibcli.report import sections as of_report

MOST_ARROWS, MOST_FLOORS = 114, 14
HOUSE = House()


@pytest.fixture
def planted(tmp_path):
    """A house of few files: {path: text}."""
    def build(files):
        package = tmp_path / "vibcli"
        for name, text in {"__init__.py": "", **files}.items():
            path = package / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return House(package)
    return build


def test_every_file_stands_in_a_room_with_a_floor():
    assert {room_of(module) for module in HOUSE.trees} == {*FLOOR, "__init__"}
    assert len(HOUSE.trees) > 400
    flat = [path.name for path in HOUSE.package.iterdir() if path.suffix == ".py"]
    assert sorted(flat) == ["__init__.py", "__main__.py"]


def test_every_folder_with_code_is_a_package_that_says_what_it_is():
    folders = {path.parent for path in HOUSE.package.rglob("*.py")}
    assert [folder for folder in folders if not (folder / "__init__.py").read_text().startswith('"""')] == []


def test_the_readme_draws_the_floors_as_they_are():
    section = (HOUSE.package.parent / "README.md").read_text(encoding="utf-8").split("## How it is built")[1]
    drawing = section.split("```")[1].split("\n")[1:-1]
    floors = [(int(number), tuple(rooms)) for number, *rooms in map(str.split, drawing)]
    assert floors == [(i + 1, tuple(room for room in rooms if room != "__main__"))
                      for i, rooms in reversed(list(enumerate(FLOORS)))]
    told = set(re.findall(r"`([a-z]+)`", section.split("```")[2].split("##")[0]))
    assert told >= {room for _, rooms in floors for room in rooms} - {"base", "bench", "manual"}


def test_imports_run_downwards_only():
    assert HOUSE.upward() == []
    assert len(HOUSE.arrows()) <= MOST_ARROWS
    assert HOUSE.floors() <= MOST_FLOORS


def test_an_upward_import_is_seen(planted):
    house = planted({"scene/a.py": "def f():\n    from vibcli.cli.common import load\n    return load\n",
                     "cli/common.py": "load = 1\n", "base/b.py": "import vibcli.numerics.c\n", "numerics/c.py": ""})
    assert house.upward() == ["vibcli.base.b:1 imports vibcli.numerics.c",
                              "vibcli.scene.a:2 imports vibcli.cli.common"]


def test_no_syntax_tree_is_read_by_the_number_of_a_part():
    assert HOUSE.subscripts() == []


def test_a_subscript_of_a_tree_is_seen(planted):
    assert planted({"scene/a.py": "def f(tree, row):\n    return tree.args[0], row[1], tree[4]\n"}).subscripts() == [
        "vibcli.scene.a:2"]


def test_a_public_class_has_a_name_of_its_own():
    assert HOUSE.class_names() == {}


def test_no_circle_of_files():
    assert HOUSE.circles() == []


def test_a_circle_is_seen(planted):
    house = planted({"scene/a.py": "from vibcli.scene import b\n", "scene/c.py": "from vibcli.scene.a import x\n",
                     "scene/b.py": "def f():\n    import vibcli.scene.c\n"})
    assert house.circles() == [("vibcli.scene.a", "vibcli.scene.b", "vibcli.scene.c")]


def test_what_is_defined_is_used_by_the_program():
    assert sorted(HOUSE.unused()) == []


def test_what_only_something_unused_uses_is_seen(planted):
    house = planted({
        "scene/a.py": "LEFT = 1\n\n\ndef outer():\n    return inner()\n\n\ndef inner():\n    return outer()\n",
        "scene/b.py": "import click\n\nfrom vibcli.scene import c\n\n\nclass Kind(click.Group):\n"
                      "    def called_by_click(self):\n        return c.used().taken()\n\n\nprint(Kind)\n",
        "scene/c.py": "def used():\n    return Value()\n\n\ndef taken():\n    pass\n\n\nclass Value:\n"
                      "    def taken(self):\n        return getattr(self, 'in_' + 'time')\n\n    def in_time(self):\n"
                      "        pass\n\n    def left(self):\n        pass\n"})
    assert sorted(house.unused()) == [("vibcli.scene.a", "LEFT"), ("vibcli.scene.a", "inner"),
                                      ("vibcli.scene.a", "outer"), ("vibcli.scene.c", "Value.left"),
                                      ("vibcli.scene.c", "taken")]


FACES = ("elements", "language/sections", "quantities", "reader/sections", "report/formats", "report/sections")


def defines(path, name):
    """Does a file define a function, class or value of that name?"""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return name in {getattr(node, "name", None) for node in tree.body} | {
        target.id for node in tree.body if isinstance(node, ast.Assign) for target in node.targets
        if isinstance(target, ast.Name)}


@pytest.mark.parametrize("folder", FACES)
def test_a_face_imports_nothing(folder):
    tree = ast.parse((HOUSE.package / folder / "__init__.py").read_text(encoding="utf-8"))
    assert all(isinstance(node, (ast.Expr, ast.Assign)) for node in tree.body)


@pytest.mark.parametrize(("table", "folder"), [
    pytest.param(elements.NAMES, "elements", id="elements"),
    pytest.param(of_language.NAMES, "language/sections", id="language"),
    pytest.param(of_questions.NAMES, "reader/sections", id="reader")])
def test_a_face_tells_of_every_file_of_its_folder(table, folder):
    files = {path.stem for path in (HOUSE.package / folder).glob("*.py")} - {"__init__"}
    assert list(table) == sorted(files)
    assert [name for name, about in table.items() if not is_a_line(about)] == []


def is_a_line(about):
    return 0 < len(about) <= 90 and "\n" not in about


def test_formats_are_the_files_that_render():
    files = (HOUSE.package / "report" / "formats").glob("*.py")
    assert {path.stem for path in files if defines(path, "render")} == set(formats.FORMATS)
    assert all(is_a_line(about) for _, _, about in formats.FORMATS.values())


def test_sections_of_a_report_are_the_generators_of_their_files():
    """A section is a generator that takes the problem and the report, which it may not need."""
    found = {(node.name, module.rpartition(".")[2]) for module, tree in HOUSE.trees.items()
             if module.startswith("vibcli.report.sections.") for node in tree.body
             if isinstance(node, ast.FunctionDef) and [arg.arg for arg in node.args.args] in (
                 ["problem", "report"], ["problem", "_"]) and not node.name.startswith("_")
             and any(isinstance(part, (ast.Yield, ast.YieldFrom)) for part in ast.walk(node))}
    assert found == {(name, file) for name, (file, _) in of_report.SECTIONS.items()}
    assert all(is_a_line(about) for _, about in of_report.SECTIONS.values())


def test_commands_are_the_files_that_define_one():
    files = (HOUSE.package / "cli").glob("*.py")
    assert {path.stem for path in files if defines(path, "command")} == set(COMMANDS)


def test_families_of_quantities_are_the_values_of_their_files():
    from importlib import import_module

    families = {name: set(import_module(f"vibcli.quantities.{name}").VALUES)
                for name in set(quantities.FAMILIES.values())}
    assert {head: name for name, heads in families.items() for head in heads} == quantities.FAMILIES


def test_only_algebra_and_closed_forms_import_sympy():
    users = {room_of(module) for module, tree in HOUSE.trees.items() if "sympy" in _top_imports(tree)}
    assert users <= {"symbolic", "analyses", "notation", "report", "bench"}


def _top_imports(tree):
    names, for_types = set(), lines_for_types(tree)
    for node in ast.walk(tree):
        if getattr(node, "lineno", 0) in for_types:
            continue
        if isinstance(node, ast.Import):
            names |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add(node.module.split(".")[0])
    return names


def test_the_figures_are_printed():
    done = subprocess.run([sys.executable, HOUSE.package.parent / "tests" / "house" / "measure.py"],
                          capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert "import circles of files" in done.stdout
