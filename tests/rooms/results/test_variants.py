"""A scene at many values of its parameters is at each the scene with that value."""

import numpy as np
import pytest

import vibcli
from vibcli.api.axis import of_numbers
from vibcli.quantities.expression import value_of
from vibcli.quantities.sweep import Sweep
from vibcli.results.variants import Variants

CAR = """
parameters: {m: 1 Mg, i: 0.9 m, l1: 1 m, l2: 1.5 m, h: 0.4 m, kf: 18 kN/m, kr: 22 kN/m, c: 900 N*s/m, g: 9.81 m/s^2}
gravity: g
points: {front: {body: car, at: [-l1, 0]}, rear: {body: car, at: [l2, 0]}}
bodies: {car: {mass: m, gyration: i, at: [0, 0], move: [0, y, phi]}}
springs:
  f: {k: kf, between: [[-l1, -h], front], preload: static}
  r: {k: kr, between: [[l2, -h], rear], preload: static}
dampers: {d: {c: c, between: [[-l1, -h], front]}}
"""
SAGGING = """
parameters: {m: 2 kg, L: 0.6 m, k: 600 N/m, h: 0.3 m, g: 9.81 m/s^2}
gravity: g
points: {end: {body: rod, at: [L, 0]}}
bodies: {rod: {mass: m, shape: rod, from: [0, 0], to: [L, 0], pin: {at: [0, 0], by: phi}}}
springs: {s: {k: k, between: [[L, h], end], free_length: 0.25 m}}
"""
GEARS = """
parameters: {R: 0.3 m, r: 0.1 m, m: 1 kg, g: 9.81 m/s^2}
gravity: g
surfaces: {bowl: {circle: [0, 0], radius: R, side: inside}}
bodies: {disc: {shape: disc, mass: m, radius: r, at: [0, r - R], roll: {surface: bowl, turn: phi}}}
"""
FREE = """
parameters: {m1: 6 kg, m2: 2 kg, L: 0.75 m, g: 9.81 m/s^2}
gravity: g
bodies:
  cart: {mass: m1, at: [0, 0], slide: x}
  bob: {mass: m2, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
"""


@pytest.mark.sweep
@pytest.mark.parametrize(("text", "name", "values", "quantities"), [
    (CAR, "kf", (9, 60), ("omega[1]", "omega[2]", "zeta[1]", "omega_d[2]", "mode[2][phi]", "max(y)")),
    (CAR, "l1", (0.5, 1.4), ("omega[1]", "zeta[2]", "mode[1][phi]")),
    (SAGGING, "k", (300, 900), ("omega[1]", "equilibrium[phi]", "s.force")),
    (SAGGING, "L", (0.4, 0.9), ("omega[1]", "equilibrium[phi]")),
    (GEARS, "r", (0.02, 0.28), ("omega[1]",)),
    (FREE, "L", (0.2, 2), ("omega[1]", "omega[2]", "mode[1][x]", "mode[2][phi]"))])
def test_each_is_the_scene_with_its_value(text, name, values, quantities):
    p = vibcli.loads(text + ("initial: {y: 1 cm}\n" if "max(y)" in quantities else ""))
    quantities = [f"equilibrium[{one}]" if one == "s.force" else one for one in quantities]
    numbers = np.linspace(*values, 25).round(6)
    found = p.sweep(*quantities, **{name: numbers})
    assert not found.gaps
    for i in (1, 8, 23):
        alone = p.with_values(**{name: float(numbers[i])})
        for text, values in found.values.items():
            assert values[i] == pytest.approx(alone[text].value, rel=1e-12, abs=1e-14)


@pytest.mark.sweep
def test_small_vibrations_are_found_by_arrays():
    p = vibcli.loads(CAR)
    axis = of_numbers(p._as_read.spec, "kf", np.linspace(9, 60, 40).tolist())
    found = [problem.modal._known for _, problem in Variants(p._as_read, [{"kf": axis.values}])]
    assert sum(natural is not None for natural, _ in found) == 31       # all but nine corners
    assert sum(damped is not None for _, damped in found) >= 20


@pytest.mark.sweep
def test_expressions_are_not_shared_where_the_drawing_turns():
    """A disc in a bowl that becomes a disc round a peg: its two drawings have other expressions."""
    text = GEARS.replace("side: inside", "side: outside").replace("r - R", "r + R")
    rolling = vibcli.loads(text).sweep("growth_rate[1]", r=np.linspace(0.02, 0.28, 12).tolist())
    assert np.isfinite(rolling.values["growth_rate[1]"]).all()
    p = vibcli.loads("""
parameters: {k: 100 N/m, a: 1 m, m: 1 kg}
points: {e: {body: b, at: [a, 0]}}
bodies: {b: {mass: m, at: [0, 0], move: [x, 0, 0]}}
springs: {s: {k: k, between: [[0.3 m, 0], e]}}
""")
    axis = of_numbers(p._as_read.spec, "a", [0.1, 0.15, 0.2, 0.25, 0.35, 0.4, 0.5, 0.6])
    for (i,), problem in Variants(p._as_read, [{"a": axis.values}]):
        stretch = float(problem.numeric.floats["a"]) - 0.3
        assert problem.configuration.linear_system.springs[0][1][0] == pytest.approx(np.sign(stretch), abs=1e-15), i


@pytest.mark.sweep
def test_blocks_are_halved_where_the_drawing_turns():
    """A bead that passes the other end of its spring, over five parameters: on either side the scene is shared."""
    p = vibcli.loads("""
parameters: {k: 100 N/m, a: 1 m, m: 1 kg, b: 0.3 m, K: 50 N/m}
points: {e: {body: bead, at: [a, 0]}}
bodies: {bead: {mass: m, at: [0, 0], slide: x}}
springs: {s: {k: k, between: [[b, 0], e]}, S: {k: K, stretch: x}}
""")
    numbers = {"k": [80, 90, 100], "a": [0.1, 0.2, 0.4, 0.5, 0.6, 0.7], "m": [1, 2, 3], "b": [0.27, 0.3, 0.33],
               "K": [40, 50, 60]}
    grid = Variants(p._as_read, [{name: of_numbers(p._as_read.spec, name, values).values}
                                 for name, values in numbers.items()])
    for _, problem in grid:
        known = problem.numeric.floats
        assert problem.configuration.linear_system.springs[0][1][0] == np.sign(known["a"] - known["b"])
        mode, = problem.modal.modes
        assert mode.omega == pytest.approx(((known["k"] + known["K"]) / known["m"])**0.5, rel=1e-14)
    assert len(grid._drawn) <= 3 * 2**5 < 486


@pytest.mark.sweep
def test_two_parameters():
    p = vibcli.loads(CAR)
    found = p.sweep("omega[1]", kf=np.linspace(9, 40, 6), kr=np.linspace(10, 30, 7))
    assert found.values["omega[1]"].shape == (6, 7) and not found.branches
    alone = p.with_values(kf=found.over["kf"][2] / 1e3, kr=found.over["kr"][5] / 1e3)
    assert found.values["omega[1]"][2, 5] == pytest.approx(alone.omega[0], rel=1e-13)


def test_exact_values_are_those_that_are_given():
    """What a scene knows exactly is overridden with its floats: damped modes are found from both."""
    p = vibcli.loads(CAR)._problem
    other = p.sharing({"c": 2 * p.numeric.rational["c"]})
    assert other.numeric.rational["c"] == 1800 and other.numeric.floats["c"] == 1800
    assert other.modal.damped[0].decay == pytest.approx(
        vibcli.loads(CAR.replace("c: 900", "c: 1800"))._problem.modal.damped[0].decay, rel=1e-14)


def test_values_that_share_a_scene_share_it_with_its_inputs():
    """It is built and linearised once; its numbers are those of the values."""
    p = vibcli.loads(CAR)._problem
    other = p.sharing({"c": 2 * p.numeric.rational["c"]})
    one, two = p.configuration.with_inputs, other.configuration.with_inputs
    assert one.scene is two.scene and one.form is two.form
    assert one.numbers.elements.dampers != two.numbers.elements.dampers


@pytest.mark.sweep
def test_an_interrupt_keeps_what_was_found(monkeypatch):
    p, calls = vibcli.loads(CAR), []
    axis = of_numbers(p._as_read.spec, "kf", np.linspace(9, 60, 40).tolist())

    def counted(problem, expression):
        calls.append(1)
        if len(calls) > 12:
            raise KeyboardInterrupt
        return value_of(problem, expression)

    monkeypatch.setattr("vibcli.quantities.sweep.value_of", counted)
    from vibcli.api.values import quantity_asked

    found = Sweep(p._as_read, [axis], [quantity_asked(p._as_read.spec, "omega[1]")], ["rad/s"], lambda problem: problem)
    assert found.done == 12 and np.isfinite(found.columns[0]).sum() == 12
