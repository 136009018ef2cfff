"""`vibcli response FILE --phase-plane`: in the terminal, as a file, as data, and what does not go with it."""

import json

import pytest

from vibcli.cli.program import run
from vibcli.plots.words import width

SWING = """title: A pendulum
gravity: 9.81 m/s^2
bodies: {b: {mass: 1 kg, at: [0 m, -1 m], pin: {at: [0 m, 0 m], by: phi}}}
initial: {phi: 2}
"""


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "swing.yaml"
    path.write_text(SWING, encoding="utf-8")
    return str(path)


def test_it_stands_in_the_terminal(scene, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    assert run(["response", scene, "--phase-plane"]) == 0
    out = capsys.readouterr().out
    plot = out[out.rindex("A pendulum"):].splitlines()
    assert max(map(width, plot)) <= 80
    assert sum(line.count("saddle") for line in plot) == 2 and sum(line.count("centre") for line in plot) == 1
    assert "separatrix" in plot[1] and "from the initial state" in plot[1]
    assert any(head in "".join(plot[2:]) for head in "→↗↘") and any(head in "".join(plot[2:]) for head in "←↙↖")
    assert "× " not in plot[-1] and "φ [rad]" in plot[-1]
    assert "it comes back after" in out


@pytest.mark.sweep
def test_it_is_written_once(scene, capsys, tmp_path):
    target = tmp_path / "plane.svg"
    assert run(["response", scene, "--phase-plane", "--save", str(target)]) == 0
    assert "⠉" not in capsys.readouterr().out
    first = target.read_bytes()
    assert run(["response", scene, "--phase-plane", "--save", str(target)]) == 2
    assert run(["response", scene, "--phase-plane", "--save", str(target), "--force"]) == 0
    assert target.read_bytes() == first
    assert run(["response", scene, "--phase-plane", "--save", str(tmp_path / "plane.csv")]) == 2


def test_its_data(scene, capsys):
    assert run(["response", scene, "--phase-plane", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["phase_plane"]
    assert [one["kind"] for one in found["equilibria"]] == ["saddle", "centre", "saddle"]
    assert found["separatrices"] == [pytest.approx(2 * 9.81, rel=1e-14)]
    assert found["start"]["turns"] == pytest.approx([-2, 2], rel=1e-14)


@pytest.mark.parametrize("option", ["--of=phi", "--until=2", "--at=1", "--digits=20", "--steady", "--transient",
                                    "--points=5", "--phase=lead"])
def test_what_belongs_to_motions_in_time_is_refused(scene, capsys, option):
    assert run(["response", scene, "--phase-plane", option]) == 2
    assert f"{option.partition('=')[0]} does not go with --phase-plane" in capsys.readouterr().err


def test_many_equilibria_are_named_in_the_legend():
    from vibcli.plots.phase_plane import of_phase_plane

    few = [[(0.0, "centre")], [(-1.0, "saddle"), (1.0, "saddle")]]
    near = [[(0.0, "centre")], [(-0.01, "saddle"), (0.01, "saddle")]]
    for points, named, told in ((few, {"centre", "saddle"}, set()), (near, set(), {"centre", "saddle"})):
        panel, = of_phase_plane(("x", "x'"), ("m", "m/s"), (-1.5, 1.5), 2.0, [], points, "").panels
        markers = [curve for curve in panel.curves if curve.kind == "markers"]
        assert {name for curve in markers for name in curve.names} == named
        assert {curve.label for curve in markers} - {""} == told
