"""Residual ratios of what is found: rounding where values and shapes belong together, large where they do not."""

import numpy as np
import pytest
from support.scenes import problem

from vibcli.cli.program import run
from vibcli.results.certificate import certificate, orthogonality, residual_ratio

ROUNDING = 20
SCENE = """
parameters: {m: 2 kg, k: 300 N/m, stiff: %s, c: 4 N*s/m, J: 3 g*m^2}
bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}, d: {inertia: J, turn: phi}}
springs:
  s: {k: k, between: [ground, a]}
  t: {k: stiff*k, between: [a, b]}
  u: {torsion: 50 N*m, between: [ground, d]}
dampers: {d1: {c: c, between: [ground, b]}}
"""


@pytest.mark.parametrize("stiff", ["1", "1e8", "1e16"])
def test_of_what_is_found_they_are_rounding_whatever_the_units(stiff):
    one = problem(SCENE % stiff)
    assert certificate(one) == {}
    assert len(one.modal.modes) == 3 and one.modal.damped
    found = certificate(one)
    assert list(found) == ["force balance", "modes", "orthogonality", "damped modes"]
    assert max(found.values()) <= ROUNDING


def test_a_value_and_a_shape_that_are_off_are_seen():
    M, K = np.diag([1.0, 4.0]), np.array([[3.0, -1.0], [-1.0, 2.0]])
    squares, shapes = np.linalg.eigh(K / np.outer([1, 2], [1, 2]))
    shapes = shapes / np.array([[1.0], [2.0]])
    norm = 4.0
    modes = [(1j * np.sqrt(square), shape) for square, shape in zip(squares, shapes.T, strict=True)]
    assert residual_ratio(M, 0 * M, K, modes, norm) <= ROUNDING and orthogonality(M, shapes) <= ROUNDING
    (first, shape), second = modes
    wrong = (first * (1 + 1e-13), shape), (first, shape + np.array([0, 1e-13])), (first, second[1])
    for off in ([one, second] for one in wrong):
        assert residual_ratio(M, 0 * M, K, off, norm) > ROUNDING
    assert orthogonality(M, shapes * (1 + 1e-13)) > ROUNDING


def test_terms_that_cancel_leave_rounding_of_their_own(tmp_path, capsys):
    """A rod that nearly buckles: K is what is left of 100 and 99.99999999999991 N·m."""
    path = tmp_path / "rod.yaml"
    path.write_text("bodies: {rod: {shape: rod, mass: 2 kg, from: [0 m, 0 m], to: [0 m, 1 m], pin: {at: [0 m, 0 m], "
                    "by: phi}}}\npoints: {top: {body: rod, at: [0 m, 1 m]}}\nsprings: {t: {torsion: 100 N*m, between: "
                    "[ground, rod]}}\nforces: {load: {at: top, force: [0 N, -99.99999999999991 N]}}\n")
    assert run(["frequencies", str(path), "--strict"]) == 0
    assert "3.67423e-7" in capsys.readouterr().out


def test_timings_tell_them_beside_the_stages(tmp_path, capsys):
    path = tmp_path / "one.yaml"
    path.write_text(SCENE % "2", encoding="utf-8")
    assert run(["frequencies", str(path), "--timings"]) == 0
    found = [line for line in capsys.readouterr().err.splitlines() if line.startswith("residual ratio of ")]
    assert [line.split(":")[0].removeprefix("residual ratio of ") for line in found] == [
        "force balance", "modes", "orthogonality", "damped modes"]
