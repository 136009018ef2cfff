"""step, ramp, impulse, square, sawtooth: their values, rates and dimensions, and scenes that they drive."""

import math
import random

import mpmath
import numpy as np
import pytest

from vibcli.base.errors import PhysicsError
from vibcli.check.verdicts import check
from vibcli.language.document.document import read
from vibcli.notation.latex import latex
from vibcli.notation.plain import plain
from vibcli.quantities.expression import measure
from vibcli.reader.read import read_spec
from vibcli.results.problem import Problem
from vibcli.scene.displacements import stays_bounded
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.dual_numbers import Dual, Duals
from vibcli.symbolic.evaluation import Floats, evaluate, from_sympy, multiprecision, sympy_arithmetic
from vibcli.symbolic.expression import Table
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.smoothed_functions import SmoothFloats, smooth_arrays
from vibcli.symbolic.syntax import parts_of

REFERENCE = {
    "step": lambda u: float(u >= 0), "ramp": lambda u: max(u, 0.0), "impulse": lambda u: 0.0,
    "square": lambda u: 1.0 if u % (2 * math.pi) < math.pi else -1.0,
    "sawtooth": lambda u: u % (2 * math.pi) / math.pi - 1,
}
RATES = {"step": lambda u: 0.0, "ramp": lambda u: float(u >= 0), "impulse": lambda u: 0.0, "square": lambda u: 0.0,
         "sawtooth": lambda u: 1 / math.pi}


def problem(text):
    root, diagnostics = read(text.encode(), "scene.yaml")
    return Problem(read_spec(root, "scene.yaml", diagnostics))


def expression(text):
    table = Table()
    time = table.time = table.variable("t")
    return lower(parse(text), table, lambda name, primes, tree: time if name == "t" else table.parameter(name)), time


@pytest.mark.parametrize("name", ["step", "ramp", "square", "sawtooth"])
def test_at_a_jump_the_value_is_that_after_it(name):
    """In each arithmetic, of an argument that is zero of either sign or comes there by subtraction."""
    node, _ = expression(f"{name}(t)")
    late, time = expression(f"{name}(2*t - 1)")
    after = REFERENCE[name](1e-9)
    for arithmetic, number in ((Floats, float), (Duals(Floats), lambda u: Dual(u, 1.0)), (multiprecision(), mpmath.mpf),
                               (Arrays, lambda u: np.array([u, u]))):
        for where, instants in ((node, (0.0, -0.0)), (late, (0.5,))):
            for u in instants:
                found, = evaluate([where], arithmetic, {time.name: number(u)})
                values = np.ravel(np.asarray(getattr(found, "value", found), dtype=float))
                assert values == pytest.approx(np.full(len(values), after), abs=1e-8), (name, arithmetic, u)


@pytest.mark.parametrize("motion", ["small", "full"])
@pytest.mark.parametrize(("load", "before", "after"), [
    ("step(t - t1)", 0, 1), ("3 - step(t - t1)", 3, 2), ("square(pi*t/t1)", 1, -1), ("sawtooth(2*pi*t/t1)", 1, -1),
    ("step(t)*step(t - t1)", 0, 1)])
def test_motions_at_a_jump_of_the_load(load, before, after, motion):
    """x'' = F/m − k/m x jumps with the load: at t1 the value after it, and just before that before it."""
    scene = problem(f"""
parameters: {{t1: 0.5 s}}
bodies: {{a: {{mass: 2 kg, slide: x}}}}
springs: {{s: {{k: 8 N/m, between: [ground, a]}}}}
forces: {{F: {{at: a, force: "6 N*({load})"}}}}
initial: {{x: 0}}
motion: {motion}
find: [{{response: {{until: 1 s}}}}]
""")
    for instant, wanted in (("t1", after), ("t1 - 1e-9 s", before)):
        found = measure(scene, parse(f"(x'' + x*4 s^-2)({instant})"))[0]
        assert found == pytest.approx(3 * wanted, abs=1e-6), instant


@pytest.mark.parametrize("name", REFERENCE)
def test_values_and_rates(name):
    node, time = expression(f"{name}(t)")
    rate = gradient(node)[time]
    points = [random.Random(name).uniform(-20, 20) for _ in range(60)]
    arrays = evaluate([node, rate], Arrays, {"t": np.array(points)})
    for i, u in enumerate(points):
        wanted = [pytest.approx(REFERENCE[name](u)), pytest.approx(RATES[name](u))]
        assert evaluate([node, rate], Floats, {"t": u}) == wanted
        assert list(map(float, evaluate([node, rate], multiprecision(), {"t": mpmath.mpf(u)}))) == wanted
        assert [float(np.broadcast_to(values, (60,))[i]) for values in arrays] == wanted
        found, = evaluate([node], Duals(Floats), {"t": Dual(u, 1.0)})
        assert [getattr(found, "value", found), getattr(found, "slope", 0.0)] == wanted


def test_values_at_the_instant():
    """What begins has begun, but as drawn; an impulse has no value where it acts."""
    for arithmetic, zero in ((Floats, 0.0), (multiprecision(), mpmath.mpf(0)), (Arrays, np.array([0.0]))):
        found = {name: evaluate([expression(f"{name}(t)")[0]], arithmetic, {"t": zero})[0] for name in REFERENCE}
        assert found["step"] == 1 and found["ramp"] == 0 and found["square"] == 1 and found["sawtooth"] == -1
        assert found["impulse"] != found["impulse"]
    table = Table()
    drawn = {name: table.call(name, table.zero) for name in REFERENCE}
    assert all(drawn[name].is_zero for name in ("step", "ramp", "impulse", "square"))
    assert drawn["sawtooth"].coefficient == -1
    assert table.call("step", table.number(3)).coefficient == 1 and table.call("step", table.number(-3)).is_zero


def test_rates_follow_one_another():
    node, time = expression("ramp(2*t - p)")
    texts = []
    for _ in range(4):
        node = gradient(node)[time]
        texts.append(plain(node))
    assert texts == ["2·step(2·t − p)", "4·impulse(2·t − p)", "8·impulse'(2·t − p)", "16·impulse''(2·t − p)"]
    kink, time = expression("abs(sin(t))")
    twice = gradient(gradient(kink)[time])[time]
    assert "impulse(sin" in plain(twice) and "impulse" not in plain(gradient(kink)[time])


def test_how_they_are_written():
    node = expression("F*step(t - p)^2*square(W*t)")[0]
    assert plain(node) == "F·step(t − p)²·square(W·t)"
    assert r"\operatorname{step}\left(t - p\right)^{2}" in latex(node)
    back = from_sympy(node.table, evaluate([node], sympy_arithmetic(), symbols(node))[0],
                      {symbol: node for node, symbol in nodes_and_symbols(node)})
    assert back is node


def nodes_and_symbols(node):
    import sympy

    from vibcli.symbolic.expression_graph import reachable

    return [(part, sympy.Symbol(part.name, positive=True)) for part in reachable([node]) if part.op == "symbol"]


def symbols(node):
    return {part.name: symbol for part, symbol in nodes_and_symbols(node)}


@pytest.mark.parametrize(("text", "same"), [
    ("ramp(t - p)", "(t - p)*step(t - p)"), ("step(p - t)", "1 - step(t - p)"), ("impulse(p - t)", "impulse(t - p)"),
    ("square(t + pi)", "-square(t)")])
def test_stand_ins_keep_what_rewriting_uses(text, same):
    table = Table()
    nodes = [lower(parse(part), table, lambda name, primes, tree: table.parameter(name)) for part in (text, same)]
    for values in ({"t": 0.3, "p": 1.7}, {"t": 2.9, "p": 0.1}):
        one, other = evaluate(nodes, SmoothFloats, values)
        assert one == pytest.approx(other, rel=1e-13)
        arrays = evaluate(nodes, smooth_arrays(), {name: np.array([value]) for name, value in values.items()})
        assert arrays[0][0] == pytest.approx(one, rel=1e-13)


@pytest.mark.parametrize(("text", "bounded"), [
    ("Y*sin(W*t)", True), ("Y*sin(pi*t/p)*(step(t) - step(t - p))", True), ("Y*step(t)", True), ("v*t", False),
    ("v*(ramp(t) - ramp(t - p))", True), ("v*t + Y*sin(W*t)", False), ("v*ramp(t - p)", False), ("W*t", False),
    ("Y*square(W*t) + Y*sawtooth(W*t)", True), ("Y*exp(-W*t)", True), ("Y*t/p*exp(-W*t)*sin(W*t)", True),
    ("Y*exp(W*t)", False), ("Y*t^2*step(t - p)", False), ("P*impulse(t)", False), ("Y*abs(sin(W*t))", True),
    ("min(Y, v*ramp(t))", True), ("Y*(1 - exp(-W*t))", True),
    ("Y/(1 - cos(W*t))", True), ("Y*t/(1 - sin(W*t)^2)", False), ("Y/(sin(W*t) - cos(W*t))", True)])
def test_what_counts_as_a_small_displacement(text, bounded):
    node, time = expression(text)
    assert stays_bounded(node, time, {"Y": 0.01, "W": 30.0, "p": 0.2, "v": 3.0, "P": 2.0}) == bounded


# scenes

VALUES = {"F": "5 N", "P": "3 N*s", "t1": "5 ms", "W": "9 rad/s"}
SCENE = """parameters: {m: 2 kg, k: 800 N/m}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
forces: {f: {at: b, force: "%s"}}
answers: {"equation[x]": "m*x'' + k*x = %s"}
"""


def scene(force, expected="0"):
    """A scene with the parameters that it uses."""
    used = {name for tree in (force, expected) for name, *_ in parts_of(parse(tree)).names}
    given = "".join(f", {name}: {value}" for name, value in VALUES.items() if name in used)
    return (SCENE % (force, expected)).replace("800 N/m", "800 N/m" + given)


@pytest.mark.parametrize(("force", "expected", "agrees"), [
    ("F*(step(t) - step(t - t1))", "F*step(t) - F*step(t - t1)", True), ("F*ramp(t)/t1", "F*t*step(t)/t1", True),
    ("F*(step(t) - step(t - t1))", "F*step(t)", False), ("P*impulse(t - t1)", "0", False),
    ("P*impulse(t - t1)", "P*impulse(t)", False), ("P*impulse(t - t1)", "2*P*impulse(t - t1)", False),
    ("F*square(W*t)", "F*sawtooth(W*t)", False), ("F*square(W*t)", "F*square(W*t)", True),
    ("F*step(t - 1000 s)", "0", False)])
def test_equations_are_compared_pulses_included(force, expected, agrees):
    verdict, = check(problem(scene(force, expected)))
    assert verdict.agrees == agrees


def test_a_stiffness_that_changes_late_is_no_constant():
    with pytest.raises(PhysicsError, match="depends on the time"):
        problem(scene("F*step(t - 1000 s) - k*x*step(t - 1000 s)")).modal.modes  # noqa: B018


def test_a_pivot_shaken_by_a_pulse_changes_the_stiffness():
    text = """gravity: 9.81 m/s^2
parameters: {L: 1 m, Y: 5 cm, p: 5 ms}
points: {O: {at: [0, 0], moves: [0, Y*sin(pi*t/p)*(step(t) - step(t - p))]}}
bodies: {bob: {mass: 1 kg, at: [0, -L], pin: {at: O, by: phi}}}
"""
    with pytest.raises(PhysicsError, match="stiffness of 'phi' depends on the time"):
        problem(text).modal.modes  # noqa: B018


def test_forces_that_bend_where_things_are():
    """A stop at a distance acts not yet; one that touches leaves no slope."""
    for gap, omega in (("1 mm", 20), ("(-1 mm)", math.sqrt(800))):
        assert problem(scene(f"-k*ramp(x - {gap})")).modal.modes[0].omega == pytest.approx(omega)
    with pytest.raises(PhysicsError, match="kink"):
        problem(scene("-k*ramp(x)")).modal.modes  # noqa: B018
