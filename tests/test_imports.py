"""Which way imports run, by ast; and what each question imports, by a process of its own and sys.modules."""

import ast
import json
import subprocess
import sys
from pathlib import Path

import pytest

import vibcli
from vibcli import elements

PACKAGE = Path(vibcli.__file__).parent
PROBLEMS = PACKAGE.parent / "problems"

# A module may import from its own room and from those above it. `foundation`: the package's docstring and version.
ROOMS = (
    ("foundation", ("vibcli",)),
    ("errors", ("errors", "work")),
    ("units", ("unit_table", "units")),
    ("questions", ("questions",)),
    ("document", ("decoding", "nodes", "diagnostics", "halt", "slips", "syntax", "syntax_flow", "tree", "document",
                  "columns")),
    ("algebra", ("algebra",)),
    ("fields", ("reading", "fields", "named_place")),
    ("elements", ("elements",)),
    ("spec", ("signals", "recorded", "unit_brackets", "fit", "counting", "naming", "consistent", "asking",
              "asking_signals", "choosing", "parameters", "spec")),
    ("scene", ("scene",)),
    ("mechanics", ("mechanics",)),
    ("analyses", ("analyses",)),
    ("results", ("report", "stage", "in_letters", "in_numbers", "in_time", "motions", "moving_signals", "sampled",
                 "full_motion", "full_signals", "shared_friction", "prescribed", "measured_signals",
                 "measured_frequency", "curves", "read_off", "kept_up",
                 "precise_motion", "on_request", "problem", "measured", "inverse", "draws", "check")),
    ("manual", ("manual",)),
    ("cli", ("cli", "__main__")),
    ("bench", ("bench",)),
)
RANK = {module: rank for rank, (_, modules) in enumerate(ROOMS) for module in modules}
HEAVY = ("numpy", "scipy", "sympy", "matplotlib", "mpmath")
FILES = sorted(PACKAGE.rglob("*.py"))


def room(parts):
    """The module below vibcli that a path or dotted name starts with."""
    return parts[0] if parts else "vibcli"


def of_file(path):
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    return room([part for part in parts if part != "__init__"])


def imports(path):
    """(line, dotted name below vibcli as a tuple) of every import of the project within a file, at any depth."""
    found = []
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}:{node.lineno}: relative import"
            names = [f"{node.module}.{alias.name}" if node.module == "vibcli" else node.module for alias in node.names]
        else:
            continue
        found += [(node.lineno, tuple(name.split(".")[1:])) for name in names if name.split(".")[0] == "vibcli"]
    return found


def test_every_module_has_a_room():
    assert {of_file(path) for path in FILES} <= set(RANK)
    assert len(FILES) > 60


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(PACKAGE)))
def test_imports_run_downwards_only(path):
    own = RANK[of_file(path)]
    wrong = []
    for line, name in imports(path):
        target = room(name) if room(name) in RANK else "vibcli"     # `from vibcli import __version__`
        if RANK[target] > own:
            wrong.append(f"{path.name}:{line} imports vibcli.{'.'.join(name)}")
    assert not wrong


def test_the_rule_sees_a_wrong_import(tmp_path):
    file = tmp_path / "wrong.py"
    file.write_text("def f():\n    from vibcli.cli.common import load\n    import vibcli.problem\n    return load\n")
    assert imports(file) == [(2, ("cli", "common")), (3, ("problem",))]


@pytest.mark.parametrize("room_name", ["problem", "scene", "mechanics", "analyses", "algebra", "report"])
def test_the_pipeline_imports_neither_check_nor_command_line(room_name):
    files = [path for path in FILES if of_file(path) == room_name]
    assert files
    assert not [name for path in files for _, name in imports(path) if room(name) in ("check", "cli", "inverse")]


def test_only_algebra_and_closed_forms_import_sympy():
    users = {of_file(path) for path in FILES if "sympy" in top_imports(path)}
    assert users <= {"algebra", "analyses", "report", "bench"}


def top_imports(path):
    names = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            names |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add(node.module.split(".")[0])
    return names


def test_names_of_elements_are_the_folder():
    assert set(elements.NAMES) == {path.stem for path in (PACKAGE / "elements").glob("*.py")} - {"__init__"}
    assert sorted(elements.NAMES) == list(elements.NAMES)


# what a question imports

RUN = """
import json, sys
from vibcli.cli import run
code = run(sys.argv[1:])
sys.stdout.flush()
print(json.dumps([code, sorted(sys.modules)]), file=sys.stderr)
"""


def imported(*args):
    """(exit code, modules imported) of one command in a process of its own."""
    done = subprocess.run([sys.executable, "-c", RUN, *map(str, args)], capture_output=True, text=True, timeout=60)
    code, names = json.loads(done.stderr.splitlines()[-1])
    return code, set(names)


def modules(*args):
    """(exit code, heavy packages imported) of one command in a process of its own."""
    code, names = imported(*args)
    return code, {name.partition(".")[0] for name in names} & set(HEAVY)


@pytest.fixture(scope="module")
def two_degrees(tmp_path_factory):
    """A damped numeric scene with two coordinates, which has answers."""
    path = tmp_path_factory.mktemp("scenes") / "two.yaml"
    path.write_text("parameters: {m: 2 kg, k: 800 N/m, c: 3 N*s/m}\n"
                    "bodies:\n  a: {mass: m, slide: x}\n  b: {mass: m, slide: y}\n"
                    "springs:\n  s: {k: k, between: [ground, a]}\n  t: {k: k, between: [a, b]}\n"
                    "dampers:\n  d: {c: c, between: [ground, a]}\n"
                    "answers:\n  omega[1]: 12.36 rad/s\n  K[x,x]: 2*k\n  C[x,x]: c\n"
                    "  motion[y]: m*y'' + k*(y - x) = 0\n")
    return path


@pytest.mark.parametrize("args", [("--help",), ("--version",), ("check", "--help"), ("solve", "--help")])
def test_help_imports_nothing_heavy(args):
    assert modules(*args) == (0, set())


@pytest.mark.parametrize("text", ["bodies: [", "bodies: {b: {mass: 2 kg, slide: x, wrong: 3}}", "", "bodies: {b: "
                                                            "{mass: (}}"])
def test_a_wrong_file_imports_nothing_heavy(tmp_path, text):
    path = tmp_path / "wrong.yaml"
    path.write_text(text)
    assert modules("check", path) == (3, set())


def test_frequencies_in_numbers(two_degrees):
    code, names = modules("frequencies", two_degrees)
    assert code == 0
    assert names <= {"numpy", "mpmath"}


@pytest.mark.parametrize("command", ["solve", "equations", "check"])
def test_other_questions_in_numbers(two_degrees, command):
    code, names = modules(command, two_degrees)
    assert code == 0
    assert not names & {"scipy", "sympy", "matplotlib"}


@pytest.mark.parametrize("stem", ["2_lagrange/bead_on_swinging_rod", "4_free_damped/sagging_boom",
                                  "6_two_degrees/double_pendulum_rods", "1_statics_and_energy/ladder_held_by_spring"])
def test_check_in_numbers(stem):
    code, names = modules("check", PROBLEMS / f"{stem}.yaml")
    assert code == 0
    assert not names & {"scipy", "sympy", "matplotlib"}


@pytest.mark.parametrize(("args", "example"), [
    (["response"], "forced_vibration"), (["response", "--plot"], "free_vibration"), (["response"], "bump_in_the_road"),
    (["response", "--plot"], "square_wave"), (["frf", "--plot"], "frequency_response"), (["check"], "forced_vibration"),
    (["frf"], "beats"), (["response", "--json"], "beats")], ids=lambda part: "-".join(part) if isinstance(
        part, list) else part)
def test_responses_in_numbers_need_numpy_alone(args, example):
    code, names = modules(*args, PACKAGE / "examples" / f"{example}.yaml")
    assert code == 0
    assert names <= {"numpy"}


def test_a_picture_needs_matplotlib_and_no_scipy(tmp_path):
    path = tmp_path / "response.svg"
    code, names = imported("response", PACKAGE / "examples" / "free_vibration.yaml", "--save", path)
    assert code == 0 and path.stat().st_size > 2000
    assert "matplotlib.figure" in names and "matplotlib.pyplot" not in names
    assert not {name.partition(".")[0] for name in names} & {"scipy", "sympy"}


INSIGHT = {f"vibcli.{name}" for name in (
    "algebra.dual", "analyses.sharp", "analyses.shares", "analyses.sensitivities", "analyses.estimates",
    "mechanics.inner_products", "mechanics.owners", "mechanics.perturbed", "report.insight", "report.insight_data")}
LOADED = RUN.replace("{name.partition('.')[0] for name in sys.modules}", "sys.modules")


@pytest.mark.parametrize(("args", "expected"), [
    (["solve"], set()), (["solve", "--json"], set()), (["frequencies"], set()), (["check"], set()),
    (["solve", "--insight"], INSIGHT)], ids=["solve", "json", "frequencies", "check", "insight"])
def test_insight_is_imported_only_where_it_is_asked_for(two_degrees, args, expected):
    done = subprocess.run([sys.executable, "-c", LOADED, *args, str(two_degrees)], capture_output=True, text=True,
                          timeout=60)
    code, names = json.loads(done.stderr.splitlines()[-1])
    assert code == 0
    assert INSIGHT & set(names) == expected
    assert not {"scipy", "sympy", "matplotlib"} & set(names)


def test_one_degree_in_letters_needs_no_sympy(tmp_path):
    path = tmp_path / "one.yaml"
    path.write_text("parameters: {m: , c: , k: }\nbodies: {b: {mass: m, slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, b]}}\ndampers: {d: {c: c, between: [ground, b]}}\n")
    code, names = modules("solve", path)
    assert code == 0
    assert names <= {"numpy"}


def test_solve_in_letters_needs_neither_scipy_nor_matplotlib():
    code, names = modules("solve", PROBLEMS / "3_free_undamped" / "taut_bead.yaml")
    assert code == 0
    assert not names & {"scipy", "matplotlib"}


OF_CHOICES = {"vibcli.inverse", "vibcli.choosing", "vibcli.elements.choose", "vibcli.report.chosen",
              "vibcli.analyses.solving", "vibcli.analyses.zeros", "vibcli.analyses.several"}


@pytest.mark.parametrize("command", ["solve", "frequencies", "equations", "check"])
def test_a_scene_that_chooses_nothing_imports_nothing_of_it(two_degrees, command):
    code, names = imported(command, two_degrees)
    assert code == 0
    assert not names & OF_CHOICES


@pytest.mark.parametrize("command", ["frequencies", "check"])
def test_choosing_in_numbers_needs_no_heavy_package_but_numpy(tmp_path, command):
    path = tmp_path / "chosen.yaml"
    path.write_text("parameters: {m: 2 kg, k: 800 N/m}\n"
                    "bodies:\n  a: {mass: m, slide: x}\n  b: {mass: m, slide: y}\n"
                    "springs:\n  s: {k: k, between: [ground, a]}\n  t: {k: k2, between: [a, b]}\n"
                    "dampers:\n  d: {c: c, between: [ground, a]}\n"
                    "choose:\n  k2: omega[2] = 40 rad/s\n  c: zeta[1] = 0.1\n"
                    "answers:\n  omega[2]: 40 rad/s\n")
    code, names = imported(command, path)
    assert code == 0 and "vibcli.inverse" in names
    assert not {name.partition(".")[0] for name in names} & {"scipy", "sympy", "matplotlib"}
