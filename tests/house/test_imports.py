"""What each question imports, by a process of its own and sys.modules."""

import subprocess
import sys
from pathlib import Path

import pytest
from support.imported import imported, modules

import vibcli
from vibcli.bench.scenes import TWO_DRIVEN

PACKAGE = Path(vibcli.__file__).parent
PROBLEMS = PACKAGE.parent / "problems"


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


@pytest.mark.sweep
def test_frequencies_in_numbers(two_degrees):
    code, names = modules("frequencies", two_degrees)
    assert code == 0
    assert names <= {"numpy", "mpmath"}


@pytest.mark.sweep
def test_springs_in_series_need_no_heavy_package_but_numpy(tmp_path):
    path = tmp_path / "series.yaml"
    path.write_text("parameters: {m: 2 kg, k: 800 N/m, g: 3 N/m^3}\nbodies: {a: {mass: m, slide: x}}\n"
                    "springs:\n  s: {series: [{k: k}, {law: k*d + g*d^3}], between: [ground, a]}\n"
                    "forces: {load: {at: a, force: 20 N}}\nfind: [equations, equilibrium, frequencies]\n")
    code, names = modules("solve", path)
    assert code == 0
    assert names <= {"numpy", "mpmath"}


@pytest.mark.parametrize("stem", ["cantilever", "cantilever_with_tip_mass"])
def test_frequencies_of_members_need_no_part_of_numpy_that_is_not_there_at_once(stem):
    code, names = imported("frequencies", PROBLEMS / "8_continuous" / f"{stem}.yaml")
    assert code == 0
    assert not {"numpy.ma", "scipy", "sympy", "matplotlib", "mpmath", "vibcli.numerics.pieces.graded"} & names


@pytest.mark.sweep
@pytest.mark.parametrize("args", [("frf",), ("frf", "--of", "x", "--save", "x.csv"), ("response",)])
def test_responses_in_numbers_need_no_part_of_numpy_that_is_not_there_at_once(two_degrees, tmp_path, args):
    path = tmp_path / "driven.yaml"
    path.write_text(two_degrees.read_text().partition("answers:")[0]
                    + "forces: {drive: {at: a, force: 5 N*sin(10 rad/s*t)}}\n")
    command, *options = (str(tmp_path / part) if part.endswith(".csv") else part for part in args)
    code, names = imported(command, path, *options)
    assert code == 0
    assert not {"numpy.ma", "scipy", "sympy", "matplotlib", "mpmath"} & names
    assert "vibcli.analyses.frequency_response.large_systems" not in names


@pytest.mark.sweep
@pytest.mark.parametrize("command", ["solve", "equations", "check"])
def test_other_questions_in_numbers(two_degrees, command):
    code, names = modules(command, two_degrees)
    assert code == 0
    assert not names & {"scipy", "sympy", "matplotlib"}


@pytest.mark.sweep
@pytest.mark.parametrize("stem", ["2_lagrange/bead_on_swinging_rod", "4_free_damped/sagging_boom",
                                  "6_two_degrees/double_pendulum_rods", "1_statics_and_energy/ladder_held_by_spring"])
def test_check_in_numbers(stem):
    code, names = modules("check", PROBLEMS / f"{stem}.yaml")
    assert code == 0
    assert not names & {"scipy", "sympy", "matplotlib"}


@pytest.mark.sweep
@pytest.mark.parametrize(("args", "example"), [
    (["response"], "forced_vibration"), (["response", "--plot"], "free_vibration"), (["response"], "bump_in_the_road"),
    (["response", "--plot"], "square_wave"), (["frf", "--plot"], "frequency_response"), (["check"], "forced_vibration"),
    (["frf"], "beats"), (["response", "--json"], "beats"), (["response", "--phase-plane"], "free_vibration")],
    ids=lambda part: "-".join(part) if isinstance(part, list) else part)
def test_responses_in_numbers_need_numpy_alone(args, example):
    code, names = modules(*args, PACKAGE / "examples" / f"{example}.yaml")
    assert code == 0
    assert names <= {"numpy"}


@pytest.mark.sweep
def test_a_picture_needs_matplotlib_and_no_scipy(tmp_path):
    path = tmp_path / "response.svg"
    code, names = imported("response", PACKAGE / "examples" / "free_vibration.yaml", "--save", path)
    assert code == 0 and path.stat().st_size > 2000
    assert "matplotlib.figure" in names and "matplotlib.pyplot" not in names
    assert not {name.partition(".")[0] for name in names} & {"scipy", "sympy"}


INSIGHT = {f"vibcli.{name}" for name in (
    "symbolic.dual_numbers", "analyses.modal.modes_precise", "analyses.modal.energy_shares",
    "analyses.modal.sensitivities", "analyses.modal.estimates", "mechanics.inner_products",
    "mechanics.element_contributions", "mechanics.parameter_derivatives", "report.sections.insight",
    "report.sections.shares", "report.sections.sensitivities", "report.sections.estimates")}


@pytest.mark.sweep
@pytest.mark.parametrize(("args", "expected"), [
    (["solve"], set()), (["solve", "--json"], set()), (["frequencies"], set()), (["check"], set()),
    (["solve", "--insight"], INSIGHT)], ids=["solve", "json", "frequencies", "check", "insight"])
def test_insight_is_imported_only_where_it_is_asked_for(two_degrees, args, expected):
    code, names = imported(*args, two_degrees)
    assert code == 0
    assert INSIGHT & names == expected
    assert not {"scipy", "sympy", "matplotlib"} & set(names)


def test_one_degree_in_letters_needs_no_sympy(tmp_path):
    path = tmp_path / "one.yaml"
    path.write_text("parameters: {m: , c: , k: }\nbodies: {b: {mass: m, slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, b]}}\ndampers: {d: {c: c, between: [ground, b]}}\n")
    code, names = modules("solve", path)
    assert code == 0
    assert names <= {"numpy"}


@pytest.mark.sweep
def test_solve_in_letters_needs_neither_scipy_nor_matplotlib():
    code, names = modules("solve", PROBLEMS / "3_free_undamped" / "taut_bead.yaml")
    assert code == 0
    assert not names & {"scipy", "matplotlib"}


def test_the_package_alone_imports_nothing():
    """`import vibcli` opens the door only where a name is asked of it."""
    code = "import sys; before = set(sys.modules); import vibcli; print(*set(sys.modules) - before)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60,
                          cwd=PACKAGE.parent)
    assert done.stdout.split() == ["vibcli"]


ROOMS_OF_FREQUENCIES = {"analyses", "api", "base", "cli", "elements", "language", "mechanics", "notation", "numerics",
                        "quantities", "reader", "report", "results", "scene", "symbolic"}
BESIDE_FREQUENCIES = {"shutil", *(f"vibcli.{name}" for name in (
    "analyses.modal.damped", "analyses.modal.massless_coordinates", "base.unit_suggestions", "language.unit_brackets",
    "mechanics.autonomous", "mechanics.energies", "mechanics.equilibrium.dry_friction",
    "mechanics.equilibrium.zero_modes", "mechanics.initial_state", "mechanics.lagrange", "notation.latex",
    "notation.scene_language", "notation.typeset", "numerics.general_eigenvalues", "quantities.frequency_response",
    "report.sections.equations_of_motion", "report.sections.equilibria", "report.sections.numeric_equations",
    "scene.closed_loops", "scene.constraints", "scene.laws", "symbolic.antiderivatives"))}
MODULES_OF_FREQUENCIES = 158        # to be lowered whenever they are fewer


@pytest.mark.sweep
def test_frequencies_of_a_mass_on_a_spring_import_what_they_use(tmp_path):
    path = tmp_path / "one.yaml"
    path.write_text("parameters: {m: 2 kg, k: 800 N/m}\nbodies: {b: {mass: m, slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, b]}}\ninitial: {x: 1 cm}\nanswers: {max(x): 1 cm}\n")
    code, names = imported("frequencies", path)
    own = [name.split(".") for name in names if name.startswith("vibcli.")]
    assert code == 0
    assert {room for _, room, *_ in own} <= ROOMS_OF_FREQUENCIES
    assert names & BESIDE_FREQUENCIES == set()
    assert len(own) <= MODULES_OF_FREQUENCIES


BESIDE_RESPONSE = {f"vibcli.{name}" for name in (
    "analyses.excitation.periods", "analyses.excitation.tabulated", "analyses.modal.massless_coordinates",
    "analyses.transient.single_degree", "analyses.transient.zeros", "mechanics.energies",
    "mechanics.equilibrium.dry_friction", "mechanics.inputs_outputs.inputs", "mechanics.lagrange", "mechanics.signals",
    "mechanics.support_forces", "quantities.frequency_response", "report.sections.equations_of_motion",
    "report.sections.mode_tables", "symbolic.delta_functions")}
MODULES_OF_MOTIONS = {"response": 216, "frf": 172}      # to be lowered whenever they are fewer


@pytest.mark.sweep
@pytest.mark.parametrize("command", MODULES_OF_MOTIONS)
def test_forced_motions_of_two_masses_import_what_they_use(tmp_path, command):
    path = tmp_path / "driven.yaml"
    path.write_text(TWO_DRIVEN)
    code, names = imported(command, path)
    assert code == 0
    assert len([name for name in names if name.startswith("vibcli.")]) <= MODULES_OF_MOTIONS[command]
    assert not {name.partition(".")[0] for name in names} & {"scipy", "sympy", "matplotlib", "mpmath"}
    if command == "response":
        assert names & BESIDE_RESPONSE == set()
        assert not {name for name in names if name.startswith("vibcli.analyses.frequency_response.")}


PENDULUM = "  b: {mass: 2 kg, at: [0, -1 m], pin: {at: [0, 0], by: phi}}\n"
TENSIONS = "mechanics.numeric_system", "mechanics.configuration", "language.sections.initial"     # told by statics
PARTS_OF_FIGURES = {        # {what a scene has: (its text, what draws it)}
    "nothing more": ("", set()),
    "a row": ("  a: {mass: 1 kg, slide: x}\nsprings: {s: {k: 8 N/m, between: [ground, a]}}\n",
              {"drawing.layout.unplaced", "drawing.layout.lumped", "drawing.symbols.spring"}),
    "a load": ("forces: {f: {at: b, force: [2 N, 0 N]}}\n", {"drawing.symbols.load"}),
    "a member": ("beams: {r: {from: [0, 0], to: [1 m, 0], EI: 2 N*m^2, left: clamped, right: free}}\n",
                 {"drawing.layout.unplaced", "drawing.layout.drawn_members", "drawing.layout.strips",
                  "drawing.symbols.spring", *TENSIONS}),
    "a rope": ("  a: {mass: 1 kg, at: [1 m, -1 m], slide: {along: [0, 1], by: y}}\n"
               "constraints: {h: {rope: [a, {over: [1 m, 0]}, b]}}\n", {"drawing.symbols.rope"}),
}


@pytest.mark.parametrize("part", PARTS_OF_FIGURES)
def test_a_figure_imports_what_it_draws(part, tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text("bodies:\n" + PENDULUM + PARTS_OF_FIGURES[part][0])
    code, names = imported("draw", path, "-o", tmp_path / "scene.svg")
    assert code == 0
    drawn = {f"vibcli.{name}" for name in PARTS_OF_FIGURES[part][1]}
    elsewhere = {f"vibcli.{name}" for _, found in PARTS_OF_FIGURES.values() for name in found} - drawn
    beside = {f"vibcli.{name}" for name in (
        "analyses.modal", "mechanics.configuration", "mechanics.numeric_system", "mechanics.symbolic_system",
        "drawing.layout.letters", "drawing.symbols.path", "drawing.symbols.tracks", "notation.plain",
        "reader.sections.answer", "reader.sections.find", "reader.choices", "language.sections.initial")}
    assert drawn <= names
    assert (elsewhere | beside - drawn) & names == set()


def test_a_scene_to_start_from_is_a_copied_file():
    code, names = imported("new")
    assert code == 0
    assert {name.split(".")[1] for name in names if name.startswith("vibcli.")} == {"base", "cli", "language", "manual"}
    assert {name for name in names if name.startswith("vibcli.manual.")} == {"vibcli.manual.scenes"}


def test_the_manual_opens_no_printer_of_expressions():
    code, names = imported("explain", "spring")
    assert code == 0
    assert not names & {"numpy", "vibcli.notation.latex", "vibcli.notation.plain", "vibcli.symbolic.expression",
                        "vibcli.reader.quantity_check"}


OF_CHOICES = {"vibcli.inverse", "vibcli.reader.choices", "vibcli.reader.sections.choose",
              "vibcli.report.sections.design_parameters", "vibcli.symbolic.equations.univariate",
              "vibcli.numerics.root_finding", "vibcli.numerics.newton_systems"}


@pytest.mark.parametrize("command", ["solve", "frequencies", "equations", "check"])
def test_a_scene_that_chooses_nothing_imports_nothing_of_it(two_degrees, command):
    code, names = imported(command, two_degrees)
    assert code == 0
    assert not names & OF_CHOICES


@pytest.mark.sweep
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
