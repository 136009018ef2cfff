"""An option that holds one value is given once: none of several is dropped in silence."""

import pytest

from vibcli.cli.program import run


@pytest.mark.parametrize(("args", "said"), [
    (["solve", "-", "-o", "a.tex", "--output", "b.html"], "-o or --output is given twice"),
    (["solve", "-", "--digits", "20", "--digits=30"], "--digits is given twice"),
    (["frequencies", "-", "--modes", "3", "--modes", "4"], "--modes is given twice")])
def test_an_option_with_one_value_is_given_once(args, said, capsys):
    assert run(args) == 2
    assert said in capsys.readouterr().err


def test_what_may_be_given_several_times_and_values_like_options(tmp_path, capsys):
    path = tmp_path / "a.yaml"
    path.write_text("parameters: {m: 1 kg, k: 4 N/m}\nbodies: {a: {mass: m, slide: x}}\n"
                    "springs: {s: {k: k, between: [ground, a]}}\n", encoding="utf-8")
    assert run(["frequencies", str(path), "--set", "k=9", "--set", "m=4", "--json", "--json"]) == 0
    assert '"omega": 1.5' in capsys.readouterr().out
