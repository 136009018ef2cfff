"""Values whose bound exceeds what is asked are computed anew in more digits; others are not, nor what is too large."""

import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import mpmath
import pytest
from support.scenes import problem, value
from support.signals import signal_of

from vibcli.quantities.expression import measure
from vibcli.report.sections.motion_data import response_data
from vibcli.report.sections.requested_signals import RequestedSignal, symbol
from vibcli.report.sections.steady_state import steady_rows
from vibcli.report.wanted import Wanted
from vibcli.results import precise_instants, precise_work
from vibcli.results.escalation import extreme_of_signal, phasors_of_signal, value_of_signal
from vibcli.results.signals import ComposedSignal, LinearSignal

SCENE = """
parameters: {m: 1 kg, k: 400 N/m, F: 2 N, W: 20.0000002 rad/s}
bodies: {a: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, a]}}
forces: {f: {at: a, force: F*sin(W*t)}}
find: [{response: {until: 2 s}}]
answers:
  x(1e6 s): -35901.765347113675 m
  max(x): 0.09 m
  argmin(x): 1 s
  zero[3](x): 0.3 s
  s.force(3 s): 1 N
"""


@pytest.fixture
def doubtful(monkeypatch):
    """Bounds of a millionth of the signal."""
    for kind in (LinearSignal, ComposedSignal):
        monkeypatch.setattr(kind, "error", lambda signal, t: 1e-6)
        monkeypatch.setattr(kind, "error_of_time", lambda signal, t: 1e-6)


def exact(t):
    w, W = mpmath.mpf(20), mpmath.mpf("20.0000002")
    return 2 / (w * w - W * W) * (mpmath.sin(W * t) - W / w * mpmath.sin(w * t))


def test_a_value_in_doubt_is_found_anew(doubtful):
    with mpmath.workdps(50):
        found, error = value_of_signal(signal_of(problem(SCENE), "x"), Fraction(3))
        assert abs(found - exact(mpmath.mpf(3))) <= error <= 1e-15 * abs(found)
        top = extreme_of_signal(signal_of(problem(SCENE), "x"), 0.0, 2.0, 1)
        at = mpmath.findroot(lambda t: mpmath.diff(exact, t), top.time)
        assert abs(top.time - at) <= top.error_of_time <= 1e-15 and abs(top.value - exact(at)) <= top.error <= 1e-15


def test_a_value_that_is_not_in_doubt_stays(monkeypatch):
    """Of what is small beside the largest value the bound is measured by that."""
    monkeypatch.setattr(LinearSignal, "precise", None)
    signal = signal_of(problem(SCENE), "x")
    monkeypatch.setattr(LinearSignal, "error", lambda signal, t: 5e-11)
    assert value_of_signal(signal, 2.0)[1] == 5e-11
    assert extreme_of_signal(signal, 0.0, 2.0, -1).error == 5e-11


def test_what_is_too_large_keeps_its_bound(doubtful, monkeypatch):
    monkeypatch.setattr(precise_work, "OWN", 1e6)
    assert value_of_signal(signal_of(problem(SCENE), "x"), 3.0)[1] == 1e-6
    assert extreme_of_signal(signal_of(problem(SCENE), "x"), 0.0, 2.0, 1).error == 1e-6


def test_a_motion_at_rest_is_looked_at_once(doubtful, monkeypatch):
    """In two precisions, and no instant but the first."""
    looked_at, extreme = [], precise_instants._extreme
    monkeypatch.setattr(precise_instants, "_extreme", lambda *args: looked_at.append(args[1]) or extreme(*args))
    rest = SCENE.replace(", F: 2 N, W: 20.0000002 rad/s", "").replace("forces: {f: {at: a, force: F*sin(W*t)}}\n", "")
    assert extreme_of_signal(signal_of(problem(rest), "x"), 0.0, 2.0, 1)[:2] == (0.0, 0.0) and looked_at == [0.0, 0.0]


def test_what_is_kept_of_a_signal_is_found_once(monkeypatch):
    """The report and the data read the same extremes."""
    found, sought, extreme = problem(SCENE), [], LinearSignal.extreme
    monkeypatch.setattr(LinearSignal, "extreme", lambda *args: sought.append(args) or extreme(*args))
    first, second = (response_data(found, Wanted())["signals"] for _ in "ab")
    assert first == second and len(sought) == 2


@pytest.mark.sweep
def test_quantities_to_digits():
    found = problem(SCENE)
    for answer in found.spec.answers:
        for tree in answer.asked.parts.quantities:
            one, (two, error) = value(found, tree.text), measure(found.with_digits(30), tree)
            assert float(two) == pytest.approx(one, rel=1e-8), symbol(tree.text)
            assert error <= 1e-15
            if tree.text.startswith("x("):
                with mpmath.workdps(50):
                    assert abs(two - exact(mpmath.mpf(10) ** 6)) <= 1e-11


@pytest.mark.sweep
def test_twelve_right_digits_are_printed_and_mpmath_stays_out_without_need(tmp_path):
    path = tmp_path / "scene.yaml"
    program = ("import sys\nfrom vibcli.cli.program import main\ntry:\n    main(sys.argv[1:])\n"
               "except SystemExit:\n    pass\n"
               "print('mpmath' in sys.modules, file=sys.stderr)\n")

    def run(scene, *args):
        path.write_text(scene)
        done = subprocess.run([sys.executable, "-c", program, "response", path, *args], capture_output=True, text=True,
                              cwd=Path(__file__).parents[3], timeout=60, check=False)
        return done.stdout, done.stderr.strip()

    assert run(SCENE.replace("20.0000002", "21"), "--at", "1.5")[1] == "False"
    printed, imported = run(SCENE, "--at", "1e6")
    assert "-35901.7653471\n" in printed and imported == "True"


def test_the_table_of_the_steady_state_near_a_resonance():
    """X = F/(m (ω² − Ω²)), of which floats have five digits; all that are printed are right."""
    found = problem(SCENE.replace("20.0000002", "20.0000000007"))
    with mpmath.workdps(40):
        X = 2 / (400 - mpmath.mpf("20.0000000007") ** 2)
        (_, phasor, error), = phasors_of_signal(signal_of(found, "x"))
        assert abs(abs(phasor) - abs(X)) <= error <= 1e-15 * abs(X)
        assert abs(abs(signal_of(found, "x").phasors[0][1]) - abs(X)) > 1e-8 * abs(X)
    (_, _, _, _, amplitude, _, _), = steady_rows([RequestedSignal("x", None, {}, signal_of(found, "x"))], "sine")
    assert amplitude == "7.14286e7"
