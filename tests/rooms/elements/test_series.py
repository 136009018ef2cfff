"""Springs and dampers in series and in parallel: closed forms, inner equilibrium, and what follows from it."""

import json

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import vibcli
from vibcli.cli.program import run
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


@pytest.mark.sweep
@pytest.mark.parametrize("name", ["k1", "k2", "g"])
def test_sensitivities_against_differences(name):
    model = scene(HARDENING, forces={"load": {"at": "block", "force": "P"}})
    step = 1e-4 * VALUES[name]
    ends = [model.with_values(**{name: VALUES[name] + side * step}).omega[0] for side in (-1, 1)]
    assert model[f"sensitivity[1, {name}]"].value == pytest.approx((ends[1] - ends[0]) / (2 * step), rel=1e-6)


def test_letters_at_rest():
    assert str(scene(HARDENING, LETTERS).omega[0]) == "sqrt(k1*k2/(m*(k1 + k2)))"


@pytest.mark.sweep
def test_motion_with_an_inner_equilibrium():
    model = scene(HARDENING, initial={"x": "0.2 m"}, motion="full", answers={"x(0.4 s)": "0.1 m"})
    exact = solve_ivp(lambda t, y: [y[1], -150 * (y[0] - _inner(y[0]))], (0, 0.4), [0.2, 0.0], rtol=1e-12, atol=1e-14,
                      method="DOP853")
    assert model["x(0.4 s)"].value == pytest.approx(exact.y[0, -1], rel=1e-9)
    assert model["s.stretch.2(0 s)"].value == pytest.approx(_inner(0.2), rel=1e-14)
    assert model["s.energy(0 s)"].value == pytest.approx(
        150 * (0.2 - _inner(0.2)) ** 2 + 100 * _inner(0.2) ** 2 + 1.25e4 * _inner(0.2) ** 4, rel=1e-14)


@pytest.mark.sweep
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


def _let_go(parts, place, **values):
    """A block of 2 kg on parts in series, let go at a place."""
    given = {"k1": "300 N/m", "k2": "200 N/m", **values}
    used = {name: value for name, value in given.items() if name in str(parts)}
    return vibcli.load({"parameters": {"m": "2 kg", **used},
                        "bodies": {"block": {"mass": "m", "slide": "x"}}, "motion": "full", "initial": {"x": place},
                        "springs": {"s": {"series": parts, "between": ["ground", "block"]}}})


SOFTENING = [{"k": "k1"}, {"law": "k2*d - g*d^3"}]


@pytest.mark.sweep
def test_a_softening_part():
    model = _let_go(SOFTENING, "5 cm", g="5e4 N/m^3")
    with mpmath.workdps(25):
        def inner(D):
            return mpmath.findroot(lambda d: 300 * (D - d) - 200 * d + 50000 * d**3, 0.6 * D)

        def V(D):
            d = inner(D)
            return 150 * (D - d) ** 2 + 100 * d**2 - 12500 * d**4

        def part(u):
            D = A * mpmath.sin(u)
            return A * mpmath.cos(u) / mpmath.sqrt(V(A) - V(D)) if u < end else 0
        A, end = mpmath.mpf("0.05"), mpmath.pi / 2 * (1 - mpmath.mpf(10) ** -12)
        exact = 4 * mpmath.quad(part, [0, mpmath.pi / 4, mpmath.pi / 2], maxdegree=5)
    assert model["period(x)"].value == pytest.approx(float(exact), rel=1e-11)
    assert model["law[s](4 cm)"].value == pytest.approx(
        300 * (0.04 - brentq(lambda d: 300 * (0.04 - d) - 200 * d + 5e4 * d**3, 0, 0.03, xtol=1e-17)), rel=1e-13)
    assert model["law[s, d^3]"].value == pytest.approx(-5e4 * 0.6**4, rel=1e-13)


@pytest.mark.sweep
@pytest.mark.parametrize("asked", ["law[s](7 cm)", "period(x)", "x(0.1 s)"])
def test_a_snap_is_told(asked):
    """It snaps where 300 = 3·5e4 d² − 200: d = 1/√300, F = 200 d − 5e4 d³, D = d + F/300."""
    d = 1 / np.sqrt(300)
    place = d + (200 * d - 5e4 * d**3) / 300
    with pytest.raises(vibcli.PhysicsError, match=f"parts of 's' in series snap at a deflection of ±{place:.6g} m, "
                       "beyond which no inner equilibrium is near"):
        _ = _let_go(SOFTENING, "7 cm", g="5e4 N/m^3")[asked].value


@pytest.mark.sweep
def test_a_snap_to_another_inner_equilibrium():
    """A cubic and a softening part: beyond the snap the other branch goes back to D = 0.05 m, where d = 0.0365…"""
    model = _let_go([{"law": "b*d^3"}, {"law": "k2*d - g*d^3"}], "2 cm", g="5e4 N/m^3", b="4e5 N/m^3")

    def total(d):
        return d + np.cbrt((200 * d - 5e4 * d**3) / 4e5)
    d = np.linspace(1 / 30, 0.062, 2_000_001)
    top = int(np.argmax(total(d)))
    with pytest.raises(vibcli.PhysicsError) as caught:
        _ = model["law[s](8 cm)"].value
    assert f"±{total(d)[top]:.6g} m: they have several inner equilibria between" in str(caught.value)


@pytest.mark.sweep
def test_a_bend_of_a_part():
    """Below e the second part has k₂, above it k₂ + b more: pieces of sines."""
    model = _let_go([{"k": "k1"}, {"law": "k2*d + b*max(d - e, 0)"}], "5 cm", b="800 N/m", e="1 cm")
    soft, stiff = 120.0, 300 * 1000 / 1300
    bend, force = 0.01 * 500 / 300, 2.0
    fast, slow = np.sqrt(stiff / 2), np.sqrt(soft / 2)
    shift = bend - force / stiff                    # where the stiff line would have no force
    t1 = np.arccos((bend - shift) / (0.05 - shift)) / fast
    speed = fast * np.sqrt((0.05 - shift) ** 2 - (bend - shift) ** 2)
    size, phase = np.hypot(bend, speed / slow), np.arctan2(bend, speed / slow)
    assert model["period(x)"].value == pytest.approx(2 * t1 + 2 * (phase + np.pi / 2) / slow, rel=1e-12)
    assert model["x(0.3 s)"].value == pytest.approx(-size * np.sin(slow * (0.3 - t1) - phase), rel=1e-11)


@pytest.mark.sweep
def test_a_part_with_play():
    model = _let_go([{"k": "k1"}, {"law": "k2*(max(d - e, 0) - max(-d - e, 0))"}], "5 cm", e="1 cm")
    w = np.sqrt(60.0)
    assert model["period(x)"].value == pytest.approx(2 * np.pi / w + 4 * 0.01 / (0.04 * w), rel=1e-12)
    assert model["law[s](5 mm)"].value == 0
    assert model["s.stretch.2(0 s)"].value == pytest.approx(0.05 - 0.04 * 120 / 300, rel=1e-12)


@pytest.mark.sweep
def test_a_part_of_one_side():
    model = _let_go([{"k": "k1"}, {"law": "k2*max(d, 0)"}], "5 cm")
    assert model["law[s](3 cm)"].value == pytest.approx(3.6, rel=1e-13)
    assert model["law[s](-3 cm)"].value == 0
    w = np.sqrt(60.0)
    assert model["x(0.3 s)"].value == pytest.approx(-0.05 * w * (0.3 - np.pi / 2 / w), rel=1e-12)


@pytest.mark.parametrize(("second", "third", "told"), [
    ("k2*d - g*d^3", "2*k2*d - 8*g*d^3", "give way at one force"),
    ("k2*max(d, 0)", "k1*max(d, 0)", "level over a stretch"),
    ("g*d*d*1 m", "k1*d", "falls from rest")])
def test_what_is_open_between_parts(second, third, told):
    with pytest.raises(vibcli.PhysicsError, match=told):
        _ = _let_go([{"k": "k1"}, {"law": second}, {"law": third}], "1 cm", g="5e4 N/m^3")["law[s](1 cm)"].value


@pytest.mark.sweep
def test_the_error_of_the_series_where_the_motion_starts(tmp_path, capsys):
    """F = k x/2 + … of two springs k and k d + g d³: the force by a root beside its terms to d³."""
    path = tmp_path / "scene.yaml"
    path.write_text("parameters: {k: 800 N/m, g: 3e5 N/m^3}\nbodies: {block: {mass: 2 kg, slide: x}}\nsprings:\n  s:\n"
                    "    series: [{k: k}, {law: k*d + g*d^3}]\n    between: [ground, block]\n  t: {k: k, between: "
                    "[ground, block]}\ninitial: {x: 0.1 m}\nfind: [expansion]\n")
    inner = brentq(lambda d: 800 * (0.1 - d) - 800 * d - 3e5 * d**3, 0, 0.1, xtol=1e-17)
    assert run(["solve", str(path), "--json"]) == 0
    one, = json.loads(capsys.readouterr().out)["expansion"]["series"]
    assert one == {"spring": "s", "deflection": 0.1, "force": pytest.approx(800 * (0.1 - inner), rel=1e-13),
                   "series": pytest.approx(400 * 0.1 + 3e5 / 16 * 0.1**3, rel=1e-13)}
    assert run(["solve", str(path)]) == 0
    off = 100 * (one["series"] / one["force"] - 1)
    assert f"its series to d^3 gives 58.75 N ({off:.2g} % too much)" in " ".join(capsys.readouterr().out.split())
