"""Limit loads: folds of an equilibrium that is followed, against closed forms; what runs off or ends is said."""

import math
import random
from types import SimpleNamespace

import mpmath
import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.inverse import settled
from vibcli.mechanics.equilibrium.continuation import Branch
from vibcli.notation.numbers import figure

TRUSS = """
parameters: {{b: {b} m, h: {h} m, k: {k} N/m, m: 1 kg{more}}}
bodies: {{p: {{mass: m, at: [b, h], slide: {{along: [0, -1], by: w}}}}}}
springs: {{s: {{k: k, between: [[0, 0], p]}}}}
forces: {{F: {{at: p, force: [0, -P]}}}}
choose: {{{choose}}}
"""
TRUSSES = 3


def trusses():
    generator = random.Random("trusses")
    for _ in range(TRUSSES):
        b, h = 10 ** generator.uniform(-2, 1), 10 ** generator.uniform(-1, 0)
        yield b, round(h * b, 9), 10 ** generator.uniform(1, 6)


def limit_load(b, h, k):
    """max k (ℓ0/ℓ − 1) y, at ℓ³ = ℓ0 b²."""
    length = math.hypot(b, h)
    shorter = (length * b * b) ** (1 / 3)
    y = math.sqrt(shorter * shorter - b * b)
    return k * (length / shorter - 1) * y, h - y


@pytest.mark.sweep
@pytest.mark.parametrize(("b", "h", "k"), list(trusses()))
def test_a_truss_snaps_at_its_limit_load(b, h, k):
    found = settled(problem(TRUSS.format(b=b, h=h, k=k, more="", choose="P: stability limit")))
    load, sunk = limit_load(b, h, k)
    first = found.choice.solutions[0]
    assert first.fold and len(found.choice.solutions) == 1
    assert float(first.values["P"]) == pytest.approx(load, rel=1e-9) and found.choice.error("P") <= 2.0**-51 * load
    assert found.configuration.equilibrium.values["w"] == pytest.approx(sunk, rel=1e-6)
    assert [mode.rigid for mode in found.modal.modes] == [True]


def test_a_limit_load_is_known_to_the_last_digits():
    """Of a shallow truss, whose force in floats is what 200 times as large ones leave."""
    scene = problem(TRUSS.format(b=1, h=0.1, k=1000, more=", P: 0.19 N", choose="").replace("choose: {}", ""))
    branch = Branch(scene.numeric, "P")
    found = branch.fold(branch.start(0.19, scene.configuration.equilibrium.values))
    with mpmath.workdps(30):
        length = mpmath.sqrt(1 + mpmath.mpf("0.1")**2)
        shorter = mpmath.cbrt(length)
        load = 1000 * (length / shorter - 1) * mpmath.sqrt(shorter**2 - 1)
        assert abs(found.value - load) <= 2.0**-52 * load


@pytest.mark.sweep
def test_a_stiffness_below_which_a_load_snaps():
    load, _ = limit_load(1.0, 0.3, 500.0)
    text = TRUSS.format(b=1, h=0.3, k="", more=f", P: {load!r} N", choose="k: stability limit").replace("k:  N/m, ", "")
    found = settled(problem(text)).choice.solutions
    assert [float(solution.values["k"]) for solution in found] == pytest.approx([500.0], rel=1e-9) and found[0].fold


@pytest.mark.sweep
@pytest.mark.parametrize(("potential", "end"), [("F0*sqrt(L^2 + x^2)", 10.0), ("F0*(x + L*exp(-x/L))", 10.0)])
def test_what_runs_off_is_never_called_stable_for_all(potential, end):
    text = f"""
parameters: {{F0: 10 N, L: 0.1 m, m: 1 kg}}
bodies: {{p: {{mass: m, slide: x}}}}
energies: {{V: {potential} - P*x}}
choose: {{P: stability limit}}
"""
    with pytest.raises(PhysicsError) as caught:
        settled(problem(text))
    assert "for all of them" not in caught.value.message
    if end is not None:
        assert f"up to {figure(end)} N, where it runs off without bound along 'x'" in caught.value.message


@pytest.mark.parametrize("size", [1e-6, 0.3, 1.0, 40.0, 1e6])
def test_a_position_is_like_itself_and_no_other_at_any_size(size):
    branch = SimpleNamespace(names=["u", "w"], scale=[2.0, 0.05])
    one = {"u": -2.0 * size, "w": 0.05 * size}
    assert Branch.alike(branch, one, dict(one))
    assert not Branch.alike(branch, one, {**one, "w": one["w"] + 0.05 * 0.01 * (1 + size)})
