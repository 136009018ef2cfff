"""The solution of a scene that is driven to and fro tells its steady state."""

import pytest

import vibcli
from vibcli.cli.program import run

MOTOR = """
title: A motor on springs
parameters: {m: 60 kg, k: 90 kN/m, c: 700 N*s/m, F: 75 N, Omega: 50 rad/s}
bodies: {motor: {mass: m, slide: y}}
springs: {s: {k: k, between: [ground, motor]}}
dampers: {d: {c: c, between: [ground, motor]}}
forces: {drive: {at: motor, force: LOAD}}
"""


def told(tmp_path, capsys, load, *options, text=MOTOR):
    path = tmp_path / "motor.yaml"
    path.write_text(text.replace("LOAD", load))
    assert run(["solve", str(path), *options]) == 0
    return path, capsys.readouterr().out.partition("Steady state")[2]


def test_amplitude_and_lag(tmp_path, capsys):
    path, steady = told(tmp_path, capsys, "F*sin(Omega*t)")
    row = steady.strip().split("\n")[-1].split()
    p = vibcli.load(path)
    assert steady.startswith(" X·sin(Ω·t − θ)")
    assert float(row[5]) == pytest.approx(p["amplitude(y)"].value, rel=1e-5)
    assert float(row[6]) == pytest.approx(p["phase(y)"].value, rel=1e-5)


def test_in_letters(tmp_path, capsys):
    text = MOTOR.replace("{m: 60 kg, k: 90 kN/m, c: 700 N*s/m, F: 75 N, Omega: 50 rad/s}",
                         "{m: , k: , c: , F: , Omega: }")
    assert "X = F/√((k − m·Ω²)² + c²·Ω²)" in told(tmp_path, capsys, "F*sin(Omega*t)", text=text)[1]


@pytest.mark.parametrize("load", [
    "F*step(t)", "F*(1 - step(t - 1 s))*sin(Omega*t)", "F*exp(-t/(1 s))", "F", "F*t/(1 s)"])
def test_what_does_not_go_on_to_and_fro_has_none(tmp_path, capsys, load):
    text = MOTOR if "Omega" in load else MOTOR.replace(", Omega: 50 rad/s", "")
    assert not told(tmp_path, capsys, load, text=text)[1]


def test_at_resonance_without_a_damper_there_is_none(tmp_path, capsys):
    text = MOTOR.replace("dampers: {d: {c: c, between: [ground, motor]}}\n", "").replace("c: 700 N*s/m, ", "").replace(
        "Omega: 50 rad/s", "Omega: sqrt(k/m)")
    assert not told(tmp_path, capsys, "F*sin(Omega*t)", text=text)[1]
