"""`vibcli bench FILE`: what is compared, what is told of it, what is refused; no times."""

import json

import pytest
from support.scenes import problem

from vibcli.cli.program import run
from vibcli.evidence import timing
from vibcli.evidence.asked import subjects

SCENE = """title: A damped mass that is driven
parameters: {m: 2 kg, k: 800 N/m, c: 8 N*s/m}
bodies: {a: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, a]}}
dampers: {d: {c: c, between: [ground, a]}}
forces: {F: {at: a, force: 5 N*cos(10 rad/s*t)}}
initial: {x: 2 cm}
find: [{response: {until: 2 s}}]
answers:
  omega[1]: 20 rad/s
  stable: true
cases:
  stiff: {parameters: {k: 8 kN/m}}
"""
LETTERS = "parameters: {m: , k: }\nbodies: {a: {mass: m, slide: x}}\nsprings: {s: {k: k, between: [ground, a]}}\n"


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "one.yaml"
    path.write_text(SCENE, encoding="utf-8")
    return str(path)


@pytest.fixture
def few(monkeypatch):
    """Three tolerances, three numbers of steps, four grids, and a single run of each after the first."""
    from vibcli.evidence.methods import dense_grids, held_inputs, integrators

    monkeypatch.setattr(integrators, "TOLERANCES", (1e-3, 1e-5, 1e-7))
    monkeypatch.setattr(held_inputs, "STEPS", held_inputs.STEPS[:3])
    monkeypatch.setattr(dense_grids, "POINTS", dense_grids.POINTS[:4])
    monkeypatch.setattr(timing, "FEW", 1)


def out_of(capsys, *args, code=0):
    assert run(["bench", *args, "--quick"]) == code
    return capsys.readouterr()


def test_what_the_file_asks_and_what_has_no_other_method(scene, capsys):
    out = out_of(capsys, scene).out
    assert "omega: natural modes, one rate λ = iω" in out and "47 digits alike with 60 and 120" in out
    assert all(name in out for name in ("vibcli", "scipy eigh", "numpy eigh", "numpy eig", "scipy eig"))
    assert "Not compared\n  stable: it is no number." in out and "eigenvalue:" not in out


@pytest.mark.parametrize(("quantity", "kind", "others"), [
    ("omega", "modes", {"scipy eigh", "numpy eigh", "numpy eig", "scipy eig"}),
    ("zeta[1]", "damped modes", {"numpy eig", "scipy eig", "scipy eig of the pencil"}),
    ("frf[x, F](5 Hz)", "response", {"numpy solve", "modal superposition"}),
    ("amplitude(x')", "response", {"numpy solve", "modal superposition"})])
def test_every_method_that_can(scene, capsys, quantity, kind, others):
    found, = json.loads(out_of(capsys, scene, "--of", quantity, "--json").out)["compared"]
    require_true_and_complete(found, kind, others)


def require_true_and_complete(found, kind, others):
    ours, *points = found["points"]
    assert found["kind"] == kind and {point["method"] for point in points} == others
    assert ours["error"] <= ours["bound"] <= 1e-12 and ours["runs"] == timing.FEW
    assert all(point["error"] is not None and point["bound"] is None for point in points)
    assert min(point["error"] for point in points) < 1e-11


@pytest.mark.sweep
def test_motions_by_every_method_and_their_curves_over_tolerances_fall(scene, few, capsys):
    found, = json.loads(out_of(capsys, scene, "--of", "x(0.5 s)", "--json").out)["compared"]
    require_true_and_complete(found, "motion",
                              {"RK45", "DOP853", "LSODA", "Radau", "BDF", "odeint", "modal superposition", "lsim"})
    for method in ("RK45", "DOP853", "LSODA", "odeint"):
        errors = [point["error"] for point in found["points"] if point["method"] == method]
        assert len(errors) == 3 and errors[0] > 10 * errors[1] > 100 * errors[2]


@pytest.mark.sweep
def test_peaks_by_grids(scene, few, capsys):
    found, = json.loads(out_of(capsys, scene, "--of", "peak[1](frf[x, F]).Omega", "--json").out)["compared"]
    grid = [point["error"] for point in found["points"] if point["method"] == "grid with parabolas"]
    assert found["points"][0]["error"] < 1e-15 and grid[0] > 10 * grid[1] > 1e4 * grid[3]


def test_other_values_and_cases(scene, capsys):
    for options in (["--case", "stiff"], ["--set", "k=8000"]):
        found = json.loads(out_of(capsys, scene, "--of", "omega", "--json", *options).out)
        assert found["compared"][0]["reference"]["digits"] == 47


@pytest.mark.sweep
def test_files_that_are_written(scene, tmp_path, capsys):
    paths = [tmp_path / name for name in ("curve.svg", "curve.png", "table.md", "table.txt")]
    options = [part for path in paths for part in ("-o", str(path))]
    told = out_of(capsys, scene, "--of", "omega", *options)
    assert paths[0].read_text(encoding="utf-8").startswith("<?xml") and paths[1].read_bytes()[:4] == b"\x89PNG"
    text = paths[2].read_text(encoding="utf-8")
    assert "| vibcli |" in text and "![Run time over true error](table-1-curve-1.svg)" in text
    assert (tmp_path / "table-1-curve-1.svg").exists() and "scipy eigh" in paths[3].read_text(encoding="utf-8")
    assert f"wrote {paths[0]}" in told.err
    assert "exists already" in out_of(capsys, scene, "-o", str(paths[0]), code=2).err


def test_letters_are_given_values_which_are_told(tmp_path, capsys):
    path = tmp_path / "letters.yaml"
    path.write_text(LETTERS, encoding="utf-8")
    first, again = (out_of(capsys, str(path)).out for _ in range(2))
    told = next(line for line in first.splitlines() if "drawn for letters" in line)
    assert told in again and "m = " in told and "scipy eigh" in first
    assert "drawn for letters" not in out_of(capsys, str(path), "--set", "m=2 kg", "--set", "k=3 N/m").out


@pytest.mark.parametrize(("options", "code", "said"), [
    (["--of", "omgea"], 3, "did you mean 'omega'?"),
    (["--of", "x"], 3, "'x' is a function of time"),
    (["--of", "max(y)"], 3, "no coordinate or signal 'y'"),
    (["--of", "omega", "--case", "stif"], 2, "did you mean 'stiff'?"),
    (["--only", "growth"], 2, "which take no FILE"),
    (["-o", "curve.gif"], 2, "curve.gif")])
def test_bad_input(scene, capsys, options, code, said):
    assert said in out_of(capsys, scene, *options, code=code).err


CHOSEN = """bodies: {a: {mass: m, slide: x}}
springs: {s: {k: 80 N/m, between: [ground, a]}}
choose: {m: "omega[1] = 9 rad/s"}
answers:
  m: 0.99 kg
"""


@pytest.mark.sweep
def test_a_parameter_that_is_chosen_is_compared_and_what_is_made_of_it_is_not(tmp_path, capsys):
    path = tmp_path / "chosen.yaml"
    path.write_text(CHOSEN, encoding="utf-8")
    for options, compared in [(["--of", "2*m"], []), (["--of", "m[1]"], ["m[1]"]), ([], ["m", "omega"]),
                              (["--of", "omega", "--of", "m"], ["omega", "m"])]:
        found = json.loads(out_of(capsys, str(path), "--json", *options).out)
        assert [one["asked"] for one in found["compared"]] == compared
        left = [(one["asked"], "no other method" in one["why"]) for one in found["not compared"]]
        assert left == ([] if compared else [("2*m", True)])


def test_without_a_file_options_of_scenes_are_refused(capsys):
    assert "name its FILE" in out_of(capsys, "--of", "omega", code=2).err


def test_what_is_found_by_vibcli_alone_has_no_picture(scene, tmp_path, capsys):
    path = tmp_path / "none.svg"
    told = out_of(capsys, scene, "--of", "stable", "-o", str(path))
    assert "stable: it is no number" in told.out and "no picture is written" in told.err and not path.exists()


def test_energies_and_equations_are_no_numbers_and_counts_have_no_digits(scene):
    with open(scene, encoding="utf-8") as file:
        one = problem(file.read().replace("  stable: true\n", "  T: 0\n  motion[x]: m*x'' = 0\n  equilibria: 1\n"))
    told = {each.asked: each.why for each in subjects(one, [answer.asked for answer in one.spec.answers][1:])}
    assert told == {"T": "it is no number", "motion[x]": "it is no number",
                    "equilibria": "it is a count, which has no digits to compare"}


def test_without_a_file_the_own_measurements_are_made(monkeypatch):
    from vibcli.cli import bench

    made = []

    def started(command, check):
        made.append(command[1:])
        return type("Done", (), {"returncode": 1})

    monkeypatch.setattr(bench.subprocess, "run", started)
    assert run(["bench", "--quick", "--json", "--only", "growth", "--only", "files"]) == 1
    assert made == [["-m", "vibcli.bench", "--quick", "--json", "--only", "growth", "--only", "files"]]


def test_beside_an_older_comparison(scene, tmp_path, capsys, monkeypatch):
    old = tmp_path / "old.json"
    data = json.loads(out_of(capsys, scene, "--of", "omega", "--json").out)
    for point in data["compared"][0]["points"][1:]:     # by far the faster then, each without spread
        point["seconds"] *= 1e4
        point["quartiles"] = [point["seconds"]] * 2
    data["machine"], data["compared"][0]["points"][-1]["method"] = "an older one", "scipy svd"
    old.write_text(json.dumps(data), encoding="utf-8")
    told = out_of(capsys, scene, "--of", "omega", "--against", str(old), code=1).out
    assert told.count("worse") == 3 and "The older one is of machine an older one." in told
    assert "On one side alone: omega: scipy eig, omega: scipy svd." in told
    for point in data["compared"][0]["points"][1:]:
        point["seconds"] /= 1e8
        point["quartiles"] = [point["seconds"]] * 2
    old.write_text(json.dumps(data), encoding="utf-8")
    assert "worse" not in out_of(capsys, scene, "--of", "omega", "--against", str(old)).out


@pytest.mark.parametrize(("text", "said"), [("{", "it is no JSON"), ("{}", "it holds no comparison"),
                                            ('{"compared": [{"points": [1, 2]}]}', "it holds no comparison")])
def test_what_is_no_older_comparison(scene, tmp_path, capsys, text, said):
    old = tmp_path / "old.json"
    old.write_text(text, encoding="utf-8")
    assert said in out_of(capsys, scene, "--against", str(old), code=2).err
    assert "does not exist" in out_of(capsys, scene, "--against", str(tmp_path / "none.json"), code=2).err


@pytest.mark.parametrize(("options", "said"), [
    (["--skipped", "--of", "omega"], "asks all questions"), (["--skipped", "-o", "x.svg"], "asks all questions"),
    (["--skipped", "--set", "m=1"], "asks all questions"), (["--against", "{old}", "--json"], "leave --json and -o"),
    (["--against", "{old}", "-o", "x.svg"], "leave --json and -o")])
def test_options_that_would_do_nothing_are_refused(scene, tmp_path, capsys, options, said):
    (tmp_path / "old.json").write_text("{}", encoding="utf-8")
    options = [option.format(old=tmp_path / "old.json") for option in options]
    assert said in " ".join(out_of(capsys, scene, *options, code=2).err.split())


def test_where_nothing_is_on_both_sides_nothing_is_compared(scene, tmp_path, capsys):
    old = tmp_path / "old.json"
    data = json.loads(out_of(capsys, scene, "--of", "omega", "--quick", "--json").out)
    for point in data["compared"][0]["points"]:
        point["method"] = f"another {point['method']}"
    old.write_text(json.dumps(data), encoding="utf-8")
    told = out_of(capsys, scene, "--of", "omega", "--quick", "--against", str(old), code=4).out
    assert "Nothing is on both sides" in told and "On one side alone: " in told
