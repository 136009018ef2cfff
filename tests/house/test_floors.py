"""Every file has a room and every room a floor: imports run downwards and in no circle, by ast."""

import ast
import re

from house.measure import FLAT, FLOOR, FLOORS, PACKAGE, lines_for_types, room_of


def test_every_file_stands_in_a_room_with_a_floor(house):
    assert {room_of(module) for module in house.trees} == {*FLOOR, *FLAT}
    assert len(house.trees) > 400
    flat = [path.name for path in PACKAGE.iterdir() if path.suffix == ".py"]
    assert sorted(flat) == ["__init__.py", "__main__.py"]


def test_every_folder_with_code_is_a_package_that_says_what_it_is():
    folders = {path.parent for path in PACKAGE.rglob("*.py")}
    assert [folder for folder in folders if not (folder / "__init__.py").read_text().startswith('"""')] == []


def test_the_readme_draws_the_floors_as_they_are():
    section = (PACKAGE.parent / "README.md").read_text(encoding="utf-8").split("## How it is built")[1]
    drawing = section.split("```")[1].split("\n")[1:-1]
    floors = [(int(number), tuple(rooms)) for number, *rooms in map(str.split, drawing)]
    assert floors == [(i + 1, rooms) for i, rooms in reversed(list(enumerate(FLOORS)))]
    told = set(re.findall(r"`([a-z]+)`", section.split("```")[2].split("##")[0]))
    assert told >= {room for _, rooms in floors for room in rooms} - {"base", "bench", "manual"}


def test_imports_run_downwards_only(house):
    assert house.upward() == []


def test_an_upward_import_is_seen(planted):
    house = planted({"scene/a.py": "def f():\n    from vibcli.cli.common import load\n    return load\n",
                     "cli/common.py": "load = 1\n", "base/b.py": "import vibcli.numerics.c\n", "numerics/c.py": ""})
    assert house.upward() == ["vibcli.base.b:1 imports vibcli.numerics.c",
                              "vibcli.scene.a:2 imports vibcli.cli.common"]


def test_no_circle_of_files(house):
    assert house.circles() == []


def test_what_imports_by_the_names_in_a_table_is_imported_by_none_of_it(house):
    """But for quantities: an argument of one names others, and each is found in the file that the table tells."""
    assert [{module.rpartition(".")[0] for module in circle} for circle in house.circles(by_name=True)] == [
        {"vibcli.quantities"}]


def test_a_circle_by_the_names_in_a_table_is_seen(planted):
    house = planted({"scene/__init__.py": "INNER = {'b': 'c'}\nTABLE = {'a': 'a', **INNER}\nOTHER = {'d': 'd'}\n",
                     "scene/a.py": "from vibcli.scene import d\n", "scene/b.py": "", "scene/c.py": "",
                     "scene/d.py": "from importlib import import_module\nfrom vibcli.scene import TABLE\n\n\n"
                                   "def f(name):\n    return import_module(f'vibcli.scene.{TABLE[name]}')\n"})
    assert house.circles() == []
    assert house.circles(by_name=True) == [("vibcli.scene.a", "vibcli.scene.d")]
    assert {name for name, _ in house.imports["vibcli.scene.d"]} == {"vibcli.scene", "vibcli.scene.a", "vibcli.scene.b",
                                                                    "vibcli.scene.c"}


def test_a_circle_is_seen(planted):
    house = planted({"scene/a.py": "from vibcli.scene import b\n", "scene/c.py": "from vibcli.scene.a import x\n",
                     "scene/b.py": "def f():\n    import vibcli.scene.c\n"})
    assert house.circles() == [("vibcli.scene.a", "vibcli.scene.b", "vibcli.scene.c")]


def test_only_algebra_and_closed_forms_import_sympy(house):
    users = {room_of(module) for module, nodes in house.nodes.items() if "sympy" in _top_imports(nodes)}
    assert users <= {"symbolic", "analyses", "notation", "report", "bench"}


def _top_imports(nodes):
    names, for_types = set(), lines_for_types(nodes)
    for node in nodes:
        if getattr(node, "lineno", 0) in for_types:
            continue
        if isinstance(node, ast.Import):
            names |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add(node.module.split(".")[0])
    return names
