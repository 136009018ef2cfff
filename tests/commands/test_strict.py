"""Figures of which the bound of their errors leaves fewer digits: marked, explained below, and refused by --strict."""

import json

import pytest

from vibcli.cli.program import run
from vibcli.notation.numbers import figure, supported
from vibcli.report.blocks import EXPLAINED
from vibcli.results import certificate

CHAOTIC = """
parameters: {m: 1 kg, L: 1 m, g: 9.81 m/s^2}
gravity: g
bodies:
  a: {mass: m, at: [0, -L], pin: {at: [0, 0], by: p}}
  b: {mass: m, at: [0, -2*L], pin: {carrier: a, at: [0, -L], by: s}}
motion: full
initial: {p: 2 rad, s: 1 rad}
find: [{response: {until: 16 s}}]
"""
PLAIN = "bodies: {b: {mass: 2 kg, slide: x}}\nsprings: {s: {k: 300 N/m, between: [ground, b]}}\n"


@pytest.fixture
def ask(tmp_path, capsys):
    """ask(scene, command, options…) -> (exit code, stdout, stderr)."""
    def asked(scene, *options):
        (tmp_path / "one.yaml").write_text(scene, encoding="utf-8")
        capsys.readouterr()
        code = run([options[0], str(tmp_path / "one.yaml"), *options[1:]])
        return code, *capsys.readouterr()
    return asked


@pytest.mark.parametrize(("error", "text"), [(0.0, "1.23457"), (9e-7, "1.23457"), (2e-6, "1.2346?"), (0.3, "1?")])
def test_a_mark_stands_behind_fewer_than_six_digits(error, text):
    assert figure(1.2345678, error) == supported(1.2345678, 1.2345678 * error) == text


def test_fewer_than_are_asked_are_those_that_count():
    assert figure(1.2345678, 1e-3, 3) == "1.23" and figure(1.2345678, 2e-3, 3) == "1.2?"
    assert figure(1.2345678, 1e-8, 12) == "1.2345678" and figure(1.23456789e-9, 1e-3) == "1.23e-9?"


@pytest.mark.sweep
def test_they_are_explained_where_they_stand_and_refused_where_all_is_strict(ask):
    code, out, _ = ask(CHAOTIC, "response", "--at", "15")
    assert code == 0 and "1.797?" in out and EXPLAINED in out
    for more in ((), ("--json",)):
        code, out, err = ask(CHAOTIC, "response", "--at", "15", "--strict", *more)
        assert (code, out) == (4, "") and "'Values' stands 1.797?" in err and "--strict" in err


def test_what_has_all_its_digits_is_printed_as_it_is(ask):
    plain, strict = (ask(PLAIN, "solve", *more) for more in ((), ("--strict",)))
    assert plain == strict and plain[0] == 0 and EXPLAINED not in plain[1]
    assert json.loads(ask(PLAIN, "solve", "--strict", "--json")[1])["certificate"]["modes"] <= 20


def test_a_residual_over_rounding_is_refused(ask, monkeypatch):
    monkeypatch.setattr(certificate, "_of_modes", lambda problem: {"modes": 21.0})
    code, out, err = ask(PLAIN, "solve", "--strict")
    assert (code, out) == (4, "") and "residual ratio of modes is 21" in err


def test_forces_at_rest_that_do_not_balance_to_rounding_are_found_anew(ask):
    springs = ("[-0.5 m, 0.4 m]", "k"), ("[0.6 m, 0.3 m]", "k"), ("[0.1 m, -0.7 m]", "2*k")
    scene = ("parameters: {m: 3 kg, k: 500 N/m, g3: 2000 N/m^3, g: 9.81 m/s^2}\ngravity: g\n"
             "bodies: {p: {mass: m, at: [0 m, 0 m], move: [x, y, 0]}}\nsprings:\n" + "".join(
                 f"  s{i}: {{law: '{k}*d + g3*d^3', between: [{place}, p]}}\n" for i, (place, k) in enumerate(springs)))
    data = json.loads(ask(scene, "solve", "--json")[1])
    assert data["certificate"]["force_balance"] <= 20
    place = data["equilibrium"]["coordinates"]
    assert place["x"] == pytest.approx(-0.00647365706300602, rel=1e-15)       # of 30 digits, by Newton's method
    assert place["y"] == pytest.approx(-0.0236846008444415, rel=1e-14)


def test_forces_of_small_stretches_of_stiff_springs_balance(ask):
    """A cord that is all but straight, k y³ = m g: its stretch is rounding to 11 digits, but not its sag."""
    scene = ("parameters: {m: 3 kg, k: 1e9 N/m, h: 1e-7 m, g: 9.81 m/s^2}\ngravity: g\n"
             "bodies: {p: {mass: m, at: [0 m, 0 m], move: [x, y, 0]}}\nsprings:\n"
             "  a: {k: k, between: [[-1 m, h], p]}\n  b: {k: k, between: [[1 m, h], p]}\n")
    code, out, _ = ask(scene, "solve", "--strict", "--json")
    data = json.loads(out)
    assert code == 0 and data["certificate"]["force_balance"] <= 20
    assert data["equilibrium"]["coordinates"]["y"] == pytest.approx(-0.0030873347583058609, rel=4e-16)   # of 40 digits
