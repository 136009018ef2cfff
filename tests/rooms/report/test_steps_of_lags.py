"""Lags and amplitudes under sines and cosines at once."""

from pathlib import Path

from support.scenes import kept_problem_of, problem
from support.worked_lines import Checked, InOtherUnits

from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula
from vibcli.report.steps.worked import worked
from vibcli.symbolic.expression_graph import reachable


def test_what_sine_and_cosine_of_a_load_have_in_common_stands_once():
    """F sin Wt + 2F cos Wt: not in the lag, and before the root of an amplitude, with the factor that only numbers
    tell apart."""
    text = """
        parameters: {m: , c: , k: , F: , W: }
        bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
        springs: {s: {k: k, between: [ground, a]}, r: {k: 2*k, between: [a, b]}}
        dampers: {d: {c: c, between: [ground, b]}}
        forces: {load: {at: b, force: F*sin(W*t) + 2*F*cos(W*t)}}
        answers: {amplitude(y): 0 m}
    """
    found = problem(text)
    lines = worked(found)
    told = next(formula(line.parts, plain) for line in lines if line.settles == "amplitude(y)")
    assert "|X₂| = √5·F·|3·k − m·W²|/√(" in told and not Checked(found, lines).wrong
    alone = problem(text.replace(", b: {mass: m, slide: y}", "").replace(", r: {k: 2*k, between: [a, b]}", "").replace(
        "[ground, b]", "[ground, a]").replace("at: b", "at: a").replace("amplitude(y): 0 m", "phase(x): 0 rad"))
    lag = next(line.node for line in worked(alone) if line.settles == "phase(x)")
    assert "F" not in {part.name for part in reachable([lag])} and lag.name == "atan2"


def test_a_long_lag_goes_by_the_parts_of_load_and_resistance():
    path, = Path("problems").glob("*/block_between_two_shaken_walls.yaml")
    found = kept_problem_of(path)
    lines = worked(found)
    told = {line.settles: formula(line.parts, plain) for line in lines}
    assert told["tan theta"].startswith("tan\u00a0θ = (S·F_re − R·F_im)/(R·F_re + S·F_im) = (90·5.1082 − ")
    assert told["R"].startswith("with  R = k₁ + k₂ − m·W² = 476 N/m")
    assert not Checked(found, lines).wrong and not InOtherUnits(found, [
        one for one in lines if "(" not in one.settles]).wrong
