"""Which modes are printed: so many, from one number to another, up to a frequency; of finite ones and without end."""

import json
from math import pi, sin
from pathlib import Path

import pytest
from support.scenes import problem

import vibcli
from vibcli.analyses.modal.mode_sequence import Modes
from vibcli.analyses.modal.undamped import Mode
from vibcli.cli.program import run
from vibcli.report.sections.shown_modes import shown

CHAIN = Path(vibcli.__file__).parent / "examples" / "many_modes.yaml"
ALL = [2 * 10 * sin(i * pi / 20) for i in range(10)]


def printed(capsys, command, *options):
    assert run([command, str(CHAIN), "--json", *options]) == 0
    return json.loads(capsys.readouterr().out)


@pytest.mark.parametrize(("case", "first", "last"), [
    (None, 1, 4), ("up to a frequency", 1, 3), ("the stiffest ones", 9, 10)])
def test_those_asked_are_printed_and_no_others(capsys, case, first, last):
    for command in ("solve", "frequencies"):
        found = printed(capsys, command)
        modes = (found if case is None else found["cases"][case])["modes"]
        assert [mode["index"] for mode in modes] == list(range(first, last + 1))
        assert [mode["omega"] for mode in modes] == pytest.approx(ALL[first - 1:last], rel=1e-12)


def test_the_command_says_how_many(capsys):
    for count, options in ((2, ("--modes", "2")), (10, ("--modes", "99")), (3, ("--modes", "3", "--digits", "30"))):
        assert len(printed(capsys, "frequencies", "--case", "the stiffest ones", *options)["modes"]) == count
    for wrong in ("0", "1000000", "some"):
        assert run(["frequencies", str(CHAIN), "--modes", wrong]) == 2


def test_of_damped_modes_those_of_the_same_numbers(capsys, tmp_path):
    path = tmp_path / "damped.yaml"
    path.write_text(CHAIN.read_text(encoding="utf-8").replace(
        "find:", "dampers: {d: {c: 2e4 N*s/m, between: [w1, ground]}}\nfind:", 1).partition("answers:")[0])
    assert run(["solve", str(path), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert [mode["index"] for mode in found["damped"]] == [1, 2, 3, 4] and len(found["modes"]) == 4


class Rod:
    """ω = i π without end."""

    def numbered(self, first, last):
        return [Mode(i, i * pi, None, [1.0], [1.0], 1e-16) for i in range(first, last + 1)]

    def count(self, Omega):
        return int(Omega / pi)


@pytest.mark.parametrize(("asked", "first", "last"), [
    ("frequencies", 1, 5), ("{modes: 7}", 1, 7), ("{modes: [990, 1000]}", 990, 1000),
    ("{modes: {up_to: 20 Hz}}", 1, 40), ("{modes: {up_to: 40 rad/s}}", 1, 12)])
def test_of_those_without_end(asked, first, last):
    scene = problem(f"""
        bodies: {{a: {{mass: 2 kg, slide: x}}}}
        springs: {{s: {{k: 50 N/m, between: [ground, a]}}}}
        find: [{asked}]""")
    scene.modal.__dict__["modes"] = Modes((), Rod())
    assert [mode.index for mode in shown(scene)] == list(range(first, last + 1))


@pytest.mark.parametrize(("motion", "said"), [("x", "there is one mode"), ("X*sin(t/s)", "nothing moves freely")])
def test_shapes_that_there_are_not_are_no_blank_page(tmp_path, capsys, motion, said):
    path = tmp_path / "scene.yaml"
    path.write_text(f"parameters: {{X: {{value: 1 m, unused: allowed}}, s: {{value: 1 s, unused: allowed}}}}\n"
                    f"bodies: {{b: {{mass: 1 kg, slide: {motion}}}}}\nfind: [modes]\n")
    assert run(["solve", str(path)]) == (4 if "nothing" in said else 0)
    assert said in "".join(capsys.readouterr())


@pytest.mark.parametrize(("asked", "said"), [
    ("1000 GHz", "modes are asked for; at most 10000 are found at once"),
    ("-3 Hz", "is negative, and no mode has such a frequency"), ("1 Hz", "there is no mode up to 6.28319 rad/s")])
def test_a_frequency_up_to_which_no_modes_or_too_many_are_is_refused_where_it_is_written(capsys, tmp_path, asked, said):
    path = tmp_path / "wing.yaml"
    path.write_text("beams: {wing: {length: 2 m, EI: 300 N*m^2, mass_per_length: 1 kg/m, left: clamped}}\n"
                    f"find: [{{modes: {{up_to: {asked}}}}}]\n")
    assert run(["solve", str(path)]) in (3, 4)
    told = capsys.readouterr().err
    assert said in told and "wing.yaml:2:24" in told and "^" * len(asked) in told
