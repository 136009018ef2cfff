"""What is printed of very many coordinates: some of them, evenly spread; their equations in numbers are all told."""

import json

import pytest

from vibcli.api.source import problem_of, text_source
from vibcli.cli.program import run
from vibcli.report.sections.equations_of_motion import equation_rows
from vibcli.report.sections.too_long import TALL, TOLD, places_told


def chain(n, *more):
    """Masses of 1 kg, springs of 100 N/m one after another from the ground on, a damper at the last one."""
    bodies = [f"  b{i}: {{mass: 1 kg, slide: x{i}}}" for i in range(1, n + 1)]
    ends = ["ground", *(f"b{i}" for i in range(1, n + 1))]
    springs = [f"  k{i}: {{k: 100 N/m, between: [{ends[i - 1]}, {ends[i]}]}}" for i in range(1, n + 1)]
    return "\n".join(["bodies:", *bodies, "springs:", *springs, *more, ""])


@pytest.mark.sweep
def test_equations_in_numbers_need_no_dense_matrices():
    """Of 2,050 coordinates, above the limit of what does: each equation holds its neighbours."""
    n = 2050
    scene = chain(n, "dampers:", f"  c: {{c: 3 N*s/m, between: [ground, b{n}]}}")
    rows = list(equation_rows(problem_of(text_source(scene))))
    assert rows[1]["linear_text"] == "x2'' - 100*x1 + 200*x2 - 100*x3 = 0"
    assert rows[-1]["linear_text"] == f"x{n}'' + 3*x{n}' - 100*x{n - 1} + 100*x{n} = 0"
    assert len(rows) == n


@pytest.mark.sweep
def test_shapes_of_very_many_coordinates_are_told_at_some(tmp_path, capsys):
    n, file = TALL + 50, tmp_path / "chain.yaml"
    file.write_text(chain(n, "find: [{modes: 2}]"))
    assert run(["solve", str(file)]) == 0
    text = capsys.readouterr().out
    assert text.count(f"{TOLD} of {n} coordinates, evenly spread; --json tells all") == 2
    assert sum("displacement of" in line for line in text.splitlines()) == TOLD
    assert f"b{n}" in text
    assert run(["solve", str(file), "--json"]) == 0
    whole = json.loads(capsys.readouterr().out)
    assert len(whole["coordinates"]) == n


@pytest.mark.parametrize("count", [0, 1, TALL, TALL + 1, 10_000])
def test_places_that_are_told(count):
    told = places_told(count)
    assert told == sorted(set(told))
    assert len(told) == (count if count <= TALL else TOLD)
    assert not count or (told[0], told[-1]) == (0, count - 1)


def test_many_shapes_of_many_coordinates_are_told_at_evenly_spread_ones(tmp_path, capsys):
    file = tmp_path / "chain.yaml"
    file.write_text(chain(34))
    assert run(["frequencies", str(file), "--modes", "9"]) == 0
    _, told = capsys.readouterr().out.split("Mode shapes\n")
    assert told.startswith("  at x₁, x₄, x₇, x₁₀, x₁₃, x₁₆, x₁₉, x₂₂, x₂₅, x₂₈, x₃₁, x₃₄\n  mode 1: 1 3.97")
    assert run(["frequencies", str(file), "--modes", "9", "--json"]) == 0
    shape = json.loads(capsys.readouterr().out)["modes"][0]["shape"]
    assert " ".join(f"{shape[f'x{i}']:.6g}" for i in range(1, 35, 3)) in " ".join(told.split())
