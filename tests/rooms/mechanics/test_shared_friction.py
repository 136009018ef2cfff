"""Dry friction that several elements share while they stick: what statics does not fix is refused, not halved."""

import json
import random

import numpy as np
import pytest
from scipy.optimize import linprog
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.cli.program import run
from vibcli.mechanics.equations_of_motion import dynamics
from vibcli.mechanics.equilibrium.redundant_friction import Redundancy
from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

HELD = """
parameters: {{m: 2 kg}}
bodies: {{b: {{mass: m, slide: x}}}}
dampers: {{d: {{friction: 4 N, {one}}}, e: {{{kind}: 4 N, {other}}}}}
forces: {{p: {{at: b, force: {load}}}}}
initial: {{x: 0, x': {speed} m/s}}
motion: full
find: [{{response: {{until: 3 s, of: {signals}}}}}]
"""
BETWEEN = "between: [ground, b]"


def value(found, text):
    """A quantity, or a signal at an instant."""
    signal, at, instant = text.removesuffix(" s)").rpartition("(")
    if at and text.endswith(" s)"):
        return found.response.signal(parse(signal)).values(np.array([float(instant)]))[0]
    return measure(found, parse(text))[0]


def held(one=BETWEEN, other=BETWEEN, load="5 N", kind="friction", speed=0, signals="[x, d.force, d.power]"):
    return HELD.format(one=one, other=other, load=load, kind=kind, speed=speed, signals=signals)


@pytest.mark.parametrize("seed", range(40))
def test_a_force_moves_where_the_least_is_not_the_largest_that_balances(seed):
    """min and max σₖ of A σ = b, |σ| ≤ 1, b = A σ* of some σ* within: equal where dₖ.force is fixed."""
    draw = random.Random(seed)
    n, count = draw.randint(1, 4), draw.randint(1, 5)
    A = np.array([[draw.choice((0, 0, 1, 1, -1, 2)) for _ in range(count)] for _ in range(n)], dtype=float)
    A[0, ~A.any(axis=0)] = 1.0
    limits = np.array([draw.choice((1.0, 4.0, 7.5)) for _ in range(count)])
    stretches = [" + ".join(f"({a:g})*x{i}" for i, a in enumerate(column) if a) for column in A.T]
    scene = problem("\n".join([
        "bodies:", *(f"  b{i}: {{mass: 1 kg, slide: x{i}}}" for i in range(n)),
        "dampers:", *(f"  d{k}: {{friction: {limits[k]} N, stretch: '{s}'}}" for k, s in enumerate(stretches))])).scene
    found = Redundancy(scene, dynamics(scene).h)
    moves = found.moves({}, 1, np.ones((len(found.parts), 1), dtype=bool))
    A, some = A * limits, np.array([draw.uniform(-0.6, 0.6) for _ in range(count)])
    for k in range(count):
        least, largest = (sign * linprog(sign * np.eye(count)[k], A_eq=A, b_eq=A @ some, bounds=(-1, 1)).fun
                          for sign in (1, -1))
        assert (abs(moves[f"d{k}"][0]) > 1e-6) == (largest - least > 1e-6), (A, k)
    forces = np.array([moves[f"d{k}"][0] for k in range(count)])
    assert np.abs(A / limits @ forces).max() < 1e-12


@pytest.mark.parametrize("other, total", [(BETWEEN, "d.force + e.force"), ("stretch: 2*x", "d.force + 2*e.force"),
                                          ("stretch: -x", "d.force - e.force")])
@pytest.mark.parametrize("load", ["5 N", "3 N*sin(2 rad/s*t) + 1 N"])
def test_what_is_shared_is_refused_and_its_sum_answered(other, total, load):
    found = problem(held(other=other, load=load))
    for text in ("d.force(1 s)", "e.force(1 s)", "max(d.force)", "(d.force - 0.1*e.force)(1 s)",
                 "(d.force^2)(1 s)"):
        with pytest.raises(PhysicsError, match=r"statics alone does not fix '[de]\.force'"):
            value(found, text)
    expected = 5.0 if load == "5 N" else 3 * np.sin(2.0) + 1
    assert value(found, f"({total})(1 s)") == pytest.approx(expected, rel=1e-12)
    assert [value(found, "max(d.power)"), value(found, "max(x)")] == pytest.approx([0, 0], abs=1e-14)


def test_friction_is_fixed_where_it_slides():
    """v = 3 m/s − (8 + 5)/2 m/s² t; at rest from 6/13 s on, where 5 N are shared."""
    found = problem(held(load="-5 N", speed=3))
    assert value(found, "d.force(0.4 s)") == value(found, "e.force(0.4 s)") == 4
    for text in ("d.force(0.5 s)", "min(d.force)"):
        with pytest.raises(PhysicsError, match=r"statics alone does not fix 'd\.force'"):
            value(found, text)
    assert value(found, "(d.force + e.force)(0.5 s)") == pytest.approx(-5, rel=1e-12)


@pytest.mark.parametrize("load, force", [("3 N - (1 N)*sign(x')", None), ("3 N", 3.0)])
def test_friction_written_as_a_load_shares_too(load, force):
    found = problem(held(load=load, kind="c").replace("c: 4 N", "c: 4 N*s/m"))
    if force is not None:
        assert value(found, "d.force(1 s)") == pytest.approx(force, rel=1e-12)
        return
    with pytest.raises(PhysicsError, match=r"statics alone does not fix 'd\.force'"):
        value(found, "d.force(1 s)")


@pytest.mark.sweep
@pytest.mark.parametrize("ends, loads, forces", [
    ((("ground", "a"), ("a", "b")), (1.0, 2.0), (3.0, 2.0)),
    ((("ground", "a"), ("ground", "b")), (1.0, 2.0), (1.0, 2.0))])
def test_friction_in_series_and_on_different_bodies_is_fixed(ends, loads, forces):
    found = problem("\n".join([
        "bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}}",
        "dampers:", *(f"  {name}: {{friction: 4 N, between: [{', '.join(pair)}]}}"
                      for name, pair in zip("de", ends, strict=True)),
        f"forces: {{p: {{at: a, force: {loads[0]} N}}, q: {{at: b, force: {loads[1]} N}}}}",
        "initial: {x: 0}\nmotion: full\nfind: [{response: {until: 3 s}}]"]))
    assert [value(found, f"{name}.force(1 s)") for name in "de"] == pytest.approx(forces, rel=1e-12)


def test_the_equilibrium_of_what_is_shared_is_refused():
    text = held().replace("motion: full\n", "springs: {s: {k: 100 N/m, between: [ground, b]}}\n")
    found = problem(text[:text.index("initial")] + text[text.index("springs"):text.index("find")])
    assert value(found, "equilibrium[x]") == pytest.approx(0.05)
    with pytest.raises(PhysicsError, match=r"statics alone does not fix 'd\.force'"):
        value(found, "equilibrium[d.force]")


@pytest.mark.sweep
def test_reports_answer_the_other_signals(tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text(held())
    assert run(["response", str(path), "--at", "1 s"]) == 0
    told = capsys.readouterr().out
    assert told.count("not fixed by statics") == 3 and "2.5" not in told
    assert run(["response", str(path), "--at", "1 s", "--json"]) == 0
    signals = {one["signal"]: one for one in json.loads(capsys.readouterr().out)["response"]["signals"]}
    assert signals["d.force"]["max"] is signals["d.force"]["argmin"] is signals["d.force"]["at"][0]["value"] is None
    assert signals["x"]["max"] == signals["d.power"]["at"][0]["value"] == 0
