"""Springs and dampers in series and in parallel: closed forms, inner equilibrium, and what follows from it."""

import json

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import vibcli
from vibcli.cli import run
from vibcli.drawing.symbols.spring import between

UNITS = {"m": "kg", "k1": "N/m", "k2": "N/m", "g": "N/m^3", "P": "N", "c1": "N*s/m", "c2": "N*s^2/m^2"}
VALUES = {"m": 2.0, "k1": 300.0, "k2": 200.0, "g": 5e4, "P": 40.0, "c1": 3.0, "c2": 5.0}
NUMBERS = {name: f"{value} {UNITS[name]}" for name, value in VALUES.items()}
LETTERS = {name: {"unit": unit} for name, unit in UNITS.items()}
HARDENING = [{"k": "k1"}, {"law": "k2*d + g*d^3"}]


def scene(parts, values=NUMBERS, **sections):
    used = {name: value for name, value in values.items() if name in json.dumps([parts, sections]) + "m"}
    return vibcli.load({"parameters": used, "bodies": {"block": {"mass": "m", "slide": "x"}},
                        "springs": {"s": {"series": parts, "between": ["ground", "block"]}}, **sections})


def _inner(x, k1=300.0, k2=200.0, g=5e4):
    """The deflection of the hardening part, by hand."""
    return brentq(lambda d: k1 * (x - d) - k2 * d - g * d**3, min(x, 0), max(x, 0), xtol=1e-17, rtol=1e-15)


@pytest.mark.parametrize(("parts", "law"), [
    ([{"k": "k1"}, {"k": "k2"}], lambda x: x / (1 / 300 + 1 / 200)),
    ([{"k": "k1"}] * 4, lambda x: 75 * x),
    ([{"law": "k2*d + g*d^3"}] * 3, lambda x: 200 * x / 3 + 5e4 * (x / 3) ** 3),
    ([{"law": "g*d^3"}, {"law": "4*g*d^3"}, {"law": "g*d*d^2"}],
     lambda x: (2 * 5e4 ** (-1 / 3) + 2e5 ** (-1 / 3)) ** -3 * x**3),
    ([{"k": "k1"}, {"parallel": [{"k": "k2"}, {"series": [{"k": "k1"}, {"k": "k2"}]}]}],
     lambda x: x / (1 / 300 + 1 / (200 + 120)))])
def test_closed_forms(parts, law):
    model = scene(parts, answers={"equilibrium[x]": "0.1 m"}, forces={"load": {"at": "block", "force": "P"}})
    place = model["equilibrium[x]"].value
    assert law(place) == pytest.approx(40.0, rel=1e-13)
    assert "F_s" not in str(model.equations)


def test_inner_equilibrium_and_its_stiffness():
    model = scene(HARDENING, forces={"load": {"at": "block", "force": "P"}})
    d = brentq(lambda d: 200 * d + 5e4 * d**3 - 40, 0, 1, xtol=1e-17, rtol=1e-15)
    assert model["equilibrium[x]"].value == pytest.approx(d + 40 / 300, rel=1e-14)
    assert model["equilibrium[s.stretch.2]"].value == pytest.approx(d, rel=1e-14)
    assert model["equilibrium[s.stretch.1]"].value == pytest.approx(40 / 300, rel=1e-14)
    assert model["equilibrium[s.force]"].value == pytest.approx(40.0, rel=1e-14)
    stiffness = 1 / (1 / 300 + 1 / (200 + 1.5e5 * d * d))
    assert model.omega[0] == pytest.approx(np.sqrt(stiffness / 2), rel=1e-14)


@pytest.mark.parametrize("name", ["k1", "k2", "g"])
def test_sensitivities_against_differences(name):
    model = scene(HARDENING, forces={"load": {"at": "block", "force": "P"}})
    step = 1e-4 * VALUES[name]
    ends = [model.with_values(**{name: VALUES[name] + side * step}).omega[0] for side in (-1, 1)]
    assert model[f"sensitivity[1, {name}]"].value == pytest.approx((ends[1] - ends[0]) / (2 * step), rel=1e-6)


def test_letters_at_rest():
    assert str(scene(HARDENING, LETTERS).omega[0]) == "sqrt(k1*k2/(m*(k1 + k2)))"


def test_motion_with_an_inner_equilibrium():
    model = scene(HARDENING, initial={"x": "0.2 m"}, motion="full", answers={"x(0.4 s)": "0.1 m"})
    exact = solve_ivp(lambda t, y: [y[1], -150 * (y[0] - _inner(y[0]))], (0, 0.4), [0.2, 0.0], rtol=1e-12, atol=1e-14,
                      method="DOP853")
    assert model["x(0.4 s)"].value == pytest.approx(exact.y[0, -1], rel=1e-9)
    assert model["s.stretch.2(0 s)"].value == pytest.approx(_inner(0.2), rel=1e-14)
    assert model["s.energy(0 s)"].value == pytest.approx(
        150 * (0.2 - _inner(0.2)) ** 2 + 100 * _inner(0.2) ** 2 + 1.25e4 * _inner(0.2) ** 4, rel=1e-14)


def test_dampers_linear_and_quadratic_in_series():
    def rate(v):
        """Of the quadratic one: c₁ (v − u) = c₂ u |u|."""
        return 2 * v / (1 + np.sqrt(1 + 4 * 5 / 3 * abs(v)))

    model = vibcli.load({"parameters": {name: NUMBERS[name] for name in ("m", "k1", "c1", "c2")},
                         "bodies": {"block": {"mass": "m", "slide": "x"}},
                         "springs": {"s": {"k": "k1", "between": ["ground", "block"]}},
                         "dampers": {"d": {"series": [{"c": "c1"}, {"law": "c2*v*abs(v)"}],
                                           "between": ["ground", "block"]}},
                         "initial": {"x": "0.2 m"}, "motion": "full", "answers": {"x(0.4 s)": "0.1 m"}})
    exact = solve_ivp(lambda t, y: [y[1], -150 * y[0] - 1.5 * (y[1] - rate(y[1]))], (0, 0.4), [0.2, 0.0], rtol=1e-12,
                      atol=1e-14, method="DOP853")
    assert model["x(0.4 s)"].value == pytest.approx(exact.y[0, -1], rel=1e-8)


def test_torsion_and_a_nested_law():
    parts = [{"torsion": "k1"}, {"parallel": [{"torsion": "k2"}, {"series": [
        {"torsion": "k1"}, {"law": "g*d^3", "torsion": "true"}]}]}]
    model = vibcli.load({"parameters": {"k1": "300 N*m", "k2": "200 N*m", "g": "5e4 N*m", "M": "50 N*m"},
                         "bodies": {"disc": {"inertia": "2 kg*m^2", "turn": "phi"}},
                         "springs": {"s": {"series": parts, "between": ["ground", "disc"]}},
                         "forces": {"load": {"body": "disc", "moment": "M"}}})
    inner = model["equilibrium[s.stretch.2]"].value
    cubic = model["equilibrium[s.stretch.2.2.2]"].value
    assert model["equilibrium[s.stretch.2.2]"].value == inner
    assert 5e4 * cubic**3 == pytest.approx(300 * (inner - cubic), rel=1e-12)
    assert 200 * inner + 5e4 * cubic**3 == pytest.approx(50.0, rel=1e-12)
    assert model["equilibrium[phi]"].value == pytest.approx(inner + 50 / 300, rel=1e-13)


def test_a_stop_made_of_parts():
    spring = {"series": HARDENING, "gap": "0.05 m", "acts": "compression", "between": ["ground", "block"]}
    model = vibcli.load({"parameters": {name: NUMBERS[name] for name in ("m", "k1", "k2", "g", "P")},
                         "bodies": {"block": {"mass": "m", "slide": "x"}}, "springs": {"s": spring},
                         "forces": {"load": {"at": "block", "force": "-P"}}})
    d = brentq(lambda d: 200 * d + 5e4 * d**3 - 40, 0, 1, xtol=1e-17, rtol=1e-15)
    assert model["equilibrium[x]"].value == pytest.approx(-0.05 - d - 40 / 300, rel=1e-13)
    assert model["equilibrium[s.stretch.2]"].value == pytest.approx(-d, rel=1e-13)


def test_parts_share_a_preload():
    spring = {"series": HARDENING, "preload": "30 N", "between": ["ground", "block"]}
    model = vibcli.load({"parameters": {name: NUMBERS[name] for name in ("m", "k1", "k2", "g", "P")},
                         "bodies": {"block": {"mass": "m", "slide": "x"}}, "springs": {"s": spring},
                         "forces": {"load": {"at": "block", "force": "P"}}})
    before, after = (brentq(lambda d, force=force: 200 * d + 5e4 * d**3 - force, 0, 1, xtol=1e-17, rtol=1e-15)
                     for force in (30.0, 40.0))
    assert model["equilibrium[x]"].value == pytest.approx(after - before + 10 / 300, rel=1e-12)
    assert model["equilibrium[s.deflection]"].value == pytest.approx(after + 40 / 300, rel=1e-12)
    assert model["equilibrium[s.stretch.2]"].value == pytest.approx(after - before, rel=1e-12)


def test_more_digits_of_such_a_motion_are_refused(tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text("bodies: {a: {mass: 2 kg, slide: x}}\nsprings:\n  s:\n    series: [{k: 3 N/m}, {law: 2 N/m*d + 3 "
                    "N/m^3*d^3}]\n    stretch: x\nmotion: full\ninitial: {x: 0.1 m}\n")
    assert run(["response", str(path), "--digits", "20"]) == 4
    assert "the inner equilibrium of 's' is solved in floats along a motion" in capsys.readouterr().err
    assert run(["draw", str(path), "-o", str(tmp_path / "scene.svg")]) == 0


def test_the_expansion_of_its_energy():
    place, bodies = {"between": ["ground", "block"]}, {"block": {"mass": "m", "slide": "x"}}
    values = {"m": "2 kg", "k": "800 N/m", "g": "3e5 N/m^3"}
    model = vibcli.load({"parameters": values, "bodies": bodies,
                         "springs": {"s": {"series": [{"k": "k"}, {"law": "k*d + g*d^3"}], **place}}})
    assert model["V[x^2]"].value == pytest.approx(200, rel=1e-14)
    assert model["V[x^4]"].value == pytest.approx(3e5 / 64, rel=1e-14)      # F = k x/2 + g x³/16 − …
    bent = vibcli.load({"parameters": values, "bodies": bodies,
                        "springs": {"s": {"series": [{"k": "k"}, {"law": "k*d + g*d*abs(d)*1 m"}], **place}}})
    with pytest.raises(vibcli.PhysicsError, match="a kink of abs"):
        bent["V[x^4]"]


def test_parts_in_series_are_drawn_in_a_row():
    row = between({"series": [{"k": 1}, {"k": 2}, {"series": [{"k": 3}, {"k": 4}]}]}, (0.0, 0.0), (120.0, 0.0), 120.0)
    springs = [shape for shape in row if getattr(shape, "role", None) == "spring" or "spring" in shape]
    assert len(springs) == 4 and len(row) > 4
    assert [spring.points[0][0] for spring in springs] == [0.0, 30.0, 60.0, 90.0]


def test_parts_side_by_side_have_rows_of_their_own():
    from vibcli.drawing.symbols import damper
    from vibcli.drawing.symbols.parts import ROW, offsets, rows

    chain = {"series": [{"c": 1}, {"parallel": [{"c": 2}, {"series": [{"c": 3}, {"c": 4}]}]}]}
    found = damper.between(chain, (0.0, 0.0), (160.0, 0.0), 160.0)
    pistons = [shape.points for shape in found if getattr(shape, "width", None) == 1.8]
    middles = [(x, (y1 + y2) / 2) for (x, y1), (_, y2) in pistons]
    assert len(middles) == 4 and {round(y, 9) for _, y in middles} == {0.0, ROW / 2, -ROW / 2}
    assert middles[0][0] < 160 / 3 < min(x for x, _ in middles[1:])
    assert rows(chain) == 2 and offsets([{"c": 1}, chain], 20.0) == [18.0, -10.0]
    assert offsets([{"k": 1}, {"k": 2}], 20.0) == [10.0, -10.0]
