"""Inverse questions: solutions against formulas, a second route and the scene itself; none invented, none missed."""

import json
import math

import pytest
from support.scenes import problem, value

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.check.verdicts import check
from vibcli.cli.program import run
from vibcli.inverse import search, settled
from vibcli.inverse.admissible_ranges import admissible, natural_scale
from vibcli.inverse.conditions import ConditionSystem
from vibcli.language.document.nodes import Scalar
from vibcli.language.reader import Expression
from vibcli.notation.scene_language import language
from vibcli.quantities.expression import value_of
from vibcli.symbolic.parser import parse

BLOCK = """
parameters: {{{parameters}}}
bodies: {{b: {{mass: m, slide: x}}}}
springs: {{s: {{k: k, between: [ground, b]}}}}
dampers: {{d: {{c: c, between: [ground, b]}}}}
choose:
  {choose}
"""
CARS = """
parameters: {{{parameters}}}
bodies: {{a: {{mass: m1, slide: x}}, b: {{mass: m2, slide: y}}}}
springs: {{s: {{k: k1, between: [ground, a]}}, t: {{k: k2, between: [a, b]}}}}
{dampers}
choose:
  {choose}
"""
MAST = """
parameters: {{{parameters}}}
gravity: g
points: {{A: {{body: rod, at: [0, L]}}}}
bodies: {{rod: {{shape: rod, mass: m, from: [0, 0], to: [0, L], pin: {{at: [0, 0], by: phi}}}}}}
springs: {{s: {{k: k, between: [A, [-L, L]]}}, t: {{k: k, between: [A, [L, L]]}}}}
choose:
  {choose}
"""
PENDULUM = """
parameters: {{{parameters}}}
gravity: g
coordinates: {{phi: {{drawn: a}}}}
bodies: {{p: {{mass: m, at: [L*sin(a), -L*cos(a)], pin: {{at: [0, 0], by: phi}}}}}}
energies: {{V: -F*L*sin(phi)}}
choose:
  {choose}
"""
GIVEN = "m: 2 kg, k: 800 N/m"
TWO = "m1: 2 kg, m2: 1 kg, k1: 900 N/m, k2: 400 N/m"
HANGING = "m: 2 kg, L: 1 m, g: 9.81 m/s^2"


def scene(frame, parameters, *choose, **more):
    return frame.format(parameters=parameters, choose="\n  ".join(choose), **{"dampers": "", **more})


def values(found, name):
    return [float(solution.values[name]) for solution in found.choice.solutions]


def forms(found, name):
    return [solution.forms[name] and language(solution.forms[name]) for solution in found.choice.solutions]


def measured(found, text):
    """The value of an expression of quantities in a settled problem."""
    return value_of(found, Expression(Scalar(text, None), parse(text)))[0]


def holds(found):
    """The largest relative misfit of the equations of a settled problem, measured on it."""
    worst = 0.0
    for record in found.spec.choices.values():
        left, right = (value_of(found, side)[0] for side in record["so"].sides)
        worst = max(worst, abs(left - right) / max(abs(left), abs(right)))
    return worst


def refused(text, thorough=True):
    with pytest.raises(PhysicsError) as caught:
        settled(problem(text), thorough)
    assert caught.value.hint and caught.value.where
    return caught.value.message


# one parameter


ONE = [
    (BLOCK, GIVEN, "c: zeta[1] = 1", [80.0]),
    (BLOCK, GIVEN, "c: zeta[1] = 1/4", [20.0]),
    (BLOCK, GIVEN, "c: 0.3 = zeta[1]", [24.0]),
    (BLOCK, GIVEN, "c: omega_d[1] = 12 rad/s", [64.0]),
    (BLOCK, GIVEN, "c: decay[1] = 3 s^-1", [12.0]),
    (BLOCK, GIVEN, "c: decay[1] = 30 s^-1", [120.0]),                 # over-damped
    (BLOCK, GIVEN, "c: omega_d[1] = omega[1]/2", [80 * math.sqrt(0.75)]),
    (BLOCK, "m: 2 kg, c: 3 N*s/m", "k: omega[1] = 20 rad/s", [800.0]),
    (BLOCK, "m: 2 kg, c: 3 N*s/m", "k: frequency[1] = 2 Hz", [2 * (4 * math.pi) ** 2]),
    (BLOCK, "m: 2 kg, c: 3 N*s/m", "k: period[1] = 0.5 s", [2 * (4 * math.pi) ** 2]),
    (BLOCK, "k: 800 N/m, c: 3 N*s/m", "m: omega[1] = 20 rad/s", [2.0]),
    (BLOCK, "k: 800 N/m, c: 16 N*s/m", "m: zeta[1] = 0.2", [2.0]),
    (BLOCK, "k: 800 N/m, c: 16 N*s/m", "m: omega_d[1] = 19 rad/s", [
        (800 - s * math.sqrt(640000 - 361 * 256)) / 722 for s in (1, -1)]),
    (CARS, TWO.replace("k2: 400 N/m", ""), "k2: omega[2] = 40 rad/s", [2300 * 1600 / 3900]),
    (CARS, TWO.replace("m2: 1 kg, ", ""), "m2: omega[1] = 10 rad/s", [400 * 700 / (100 * 1100)]),
    (CARS, TWO.replace("k1: 900 N/m, ", ""), "k1: K[x,x] = 1 kN/m", [600.0]),
    (CARS, TWO.replace("m1: 2 kg, ", ""), "m1: M[x,x] = 3*M[y,y]", [3.0]),
    (MAST, HANGING, "k: omega[1] = 3 rad/s", [(2 * 9.81 / 2 + 2 / 3 * 9) / 2]),
    (PENDULUM, "m: 2 kg, L: 1 m, F: 5 N, g: 9.81 m/s^2", "a: equilibrium",
     [math.atan(5 / 19.62), math.pi + math.atan(5 / 19.62)]),
    (PENDULUM, "m: 2 kg, L: 1 m, a: 30 deg, g: 9.81 m/s^2", "F: equilibrium", [19.62 / math.sqrt(3)]),
]


@pytest.mark.parametrize(("frame", "given", "choose", "expected"), ONE, ids=[part[2] for part in ONE])
def test_one_parameter(frame, given, choose, expected):
    found = settled(problem(scene(frame, given, choose)))
    name = choose.partition(":")[0]
    assert values(found, name) == pytest.approx(expected, rel=1e-12)
    assert all(solution.residual < 1e-12 for solution in found.choice.solutions)
    assert found.numeric.floats[name] == pytest.approx(expected[0], rel=1e-12)
    if "=" in choose:
        assert holds(found) < 1e-12


@pytest.mark.parametrize(("frame", "given", "choose", "expected"), ONE[:17], ids=[part[2] for part in ONE[:17]])
def test_the_search_finds_what_letters_give(frame, given, choose, expected, monkeypatch):
    monkeypatch.setattr(search, "candidates", lambda *args: None)
    found = settled(problem(scene(frame, given, choose)))
    name = choose.partition(":")[0]
    assert values(found, name) == pytest.approx(expected, rel=1e-9)
    assert forms(found, name) == [None] * len(expected)


def test_how_many_were_swept():
    assert len(ONE) >= 19


@pytest.mark.parametrize(("choose", "form"), [
    ("c: zeta[1] = 1", ["2*sqrt(m*k)"]), ("c: zeta[1] = q", ["2*q*sqrt(m*k)"]), ("k: omega[1] = q", ["m*q^2"]),
    ("c: decay[1] = omega[1]/4", ["sqrt(m*k)/2"]), ("m: period[1] = q", ["k*q^2/(4*pi^2)"])])
def test_closed_forms_in_letters(choose, form):
    name = choose.partition(":")[0]
    used = [f"{letter}: " for letter in "mkcq" if letter != name and (letter != "q" or choose.endswith("= q"))]
    found = settled(problem(scene(BLOCK, ", ".join(used), choose)))
    assert forms(found, name) == form
    assert found.choice.solutions[0].values[name] is None
    assert found.numeric.has_free_symbols and found.closed_forms is not None


def test_parameters_defined_by_the_chosen_one():
    found = settled(problem(scene(BLOCK, "m: 2 kg, r: , k: 100*r, c: 3 N*s/m", "r: omega[1] = 20 rad/s")))
    assert values(found, "r") == [8.0] and found.numeric.floats["k"] == 800.0
    assert forms(found, "r") == ["4*m"]


def test_an_equation_between_parameters():
    found = settled(problem(scene(BLOCK, GIVEN, "c: c = 3*sqrt(k*m)/4")))
    assert values(found, "c") == [30.0]


# several solutions, poles, jumps, double roots


@pytest.mark.sweep
def test_all_solutions_are_found_ascending():
    found = settled(problem(scene(CARS, TWO.replace("m2: 1 kg, ", ""), "m2: omega[2] = 3*omega[1]")))
    one, two = values(found, "m2")
    assert one < two
    for m2 in (one, two):
        squares = 900 / 2 + 400 / 2 + 400 / m2, 900 * 400 / (2 * m2)
        ratio = squares[0] ** 2 / squares[1]
        assert ratio == pytest.approx(100 / 9, rel=1e-10)
    assert holds(found) < 1e-12
    assert found.choice.value("m2", 2) == two


@pytest.mark.sweep
def test_the_admissible_range_takes_the_one_asked_for():
    text = scene(CARS, TWO.replace("m2: 1 kg, ", ""), "m2: {{so: 'omega[2] = 3*omega[1]', from: 1 kg}}".format())
    assert len(values(settled(problem(text)), "m2")) == 1
    assert "ranges from" in refused(scene(CARS, TWO.replace("k2: 400 N/m", ""),
                                          "k2: {so: 'omega[2] = 40 rad/s', from: 1 N/m, to: 100 N/m}"))


def test_a_bound_is_admissible_itself():
    text = scene(BLOCK, "m: 2 kg, c: 3 N*s/m", "k: {so: 'omega[1] = 20 rad/s', to: 800 N/m}")
    assert values(settled(problem(text)), "k") == [800.0]


@pytest.mark.parametrize("route", ["letters", "search"])
def test_sign_changes_at_poles_are_rejected(route, monkeypatch):
    """1/(k − 500) passes from −∞ to ∞ at k = 500, and is 1/300 at 800 alone."""
    if route == "search":
        monkeypatch.setattr(search, "candidates", lambda *args: None)
    text = scene(BLOCK, "m: 2 kg, c: 3 N*s/m", "k: 1/(K[x,x] - (500 N/m)) = 1/(300 N/m)")
    assert values(settled(problem(text)), "k") == pytest.approx([800.0], rel=1e-10)
    other = text.replace("= 1/(300 N/m)", "= -1/(100 N/m)")
    assert values(settled(problem(other)), "k") == pytest.approx([400.0], rel=1e-10)
    none = text.replace("= 1/(300 N/m)", "= -1/(600 N/m)")
    assert "no value of k in (0, ∞)" in refused(none)


@pytest.mark.parametrize("route", ["letters", "search"])
def test_a_double_root_is_found_once(route, monkeypatch):
    """m₂ with the least ratio of frequencies: there both solutions meet."""
    if route == "search":
        monkeypatch.setattr(search, "candidates", lambda *args: None)
    text = scene(BLOCK, "m: 2 kg, c: 3 N*s/m", "k: (K[x,x] - (300 N/m))^2 = 0")
    found = settled(problem(text))
    assert values(found, "k") == pytest.approx([300.0], rel=1e-6)
    near = text.replace("= 0", "= -1 (N/m)^2").replace("-1 (N/m)^2", "-1 N^2/m^2")
    assert "no value of k" in refused(near)


@pytest.mark.sweep
def test_a_double_root_at_a_minimum_of_a_quantity():
    """k₁ = 900, k₂ = 400: the ratio ω₂/ω₁ is least at m₂ = k₂ m₁/(k₁ + k₂), 2.0000…, and is reached there alone."""
    best = 400 * 2 / 1300
    total, product = 650 + 400 / best, 180000 / best
    squares = [(total + s * math.sqrt(total**2 - 4 * product)) / 2 for s in (1, -1)]
    least = math.sqrt(squares[0] / squares[1])
    text = scene(CARS, TWO.replace("m2: 1 kg, ", ""), f"m2: omega[2] = {least!r}*omega[1]")
    found = values(settled(problem(text)), "m2")
    assert found == pytest.approx([best] * len(found), rel=1e-4) and 1 <= len(found) <= 2
    assert "is larger than" in refused(text.replace(repr(least), repr(0.999 * least)))


@pytest.mark.sweep
def test_a_root_of_a_quantity_that_only_nears_its_limit_is_none():
    """ω₁ tends to √(k₁/m₁) as m₂ vanishes, without reaching it."""
    text = scene(CARS, TWO.replace("m2: 1 kg, ", ""), "m2: omega[1] = sqrt(k1/m1)")
    assert "no value of m2 in (0, ∞)" in refused(text)


def test_signs():
    text = scene(BLOCK, "m: 2 kg, k: 800 N/m", "c: decay[1] = -3 s^-1")
    assert "ranges from" in refused(text) and "no value of c" in refused(text)
    either = text.replace("k: 800 N/m", "k: 800 N/m, c: {sign: any}")
    assert values(settled(problem(either)), "c") == pytest.approx([-12.0], rel=1e-12)


# several parameters


def frequencies(m1, m2, k1, k2):
    total, product = k1 / m1 + k2 / m1 + k2 / m2, k1 * k2 / (m1 * m2)
    root = math.sqrt(total**2 - 4 * product)
    return math.sqrt((total - root) / 2), math.sqrt((total + root) / 2)


@pytest.mark.sweep
@pytest.mark.parametrize("route", ["letters", "search"])
def test_two_springs_for_two_frequencies(route, monkeypatch):
    if route == "search":
        monkeypatch.setattr(search, "candidates", lambda *args: None)
    text = scene(CARS, "m1: 2 kg, m2: 1 kg", "k1: omega[1] = 10 rad/s", "k2: omega[2] = 40 rad/s")
    found = settled(problem(text))
    pairs = list(zip(values(found, "k1"), values(found, "k2"), strict=True))
    assert len(pairs) == 2 and pairs == sorted(pairs)
    for k1, k2 in pairs:
        assert frequencies(2, 1, k1, k2) == pytest.approx((10, 40), rel=1e-12)
    assert value(found, "omega[1]") == pytest.approx(10, rel=1e-13)
    assert value(found, "omega[2]") == pytest.approx(40, rel=1e-13)


def test_two_frequencies_too_near_one_another():
    text = scene(CARS, "m1: 2 kg, m2: 1 kg", "k1: omega[1] = 10 rad/s", "k2: omega[2] = 11 rad/s")
    assert "no admissible values of k1 and k2 give omega[1] = 10 rad/s and omega[2] = 11 rad/s" in refused(text)


def test_a_spring_and_a_damper():
    found = settled(problem(scene(BLOCK, "m: 2 kg", "k: omega_d[1] = 12 rad/s", "c: zeta[1] = 0.8")))
    assert values(found, "k") == [800.0] and values(found, "c") == [64.0]


@pytest.mark.sweep
def test_a_spring_and_a_damper_of_two_degrees():
    text = scene(CARS, "m1: 2 kg, m2: 1 kg, k1: 900 N/m", "k2: omega[2] = 40 rad/s", "c: zeta[2] = 0.3",
                 dampers="dampers: {d: {c: c, between: [a, b]}}")
    found = settled(problem(text))
    assert holds(found) < 1e-11
    assert values(found, "k2") == pytest.approx([2300 * 1600 / 3900] * len(values(found, "k2")), rel=1e-9)


@pytest.mark.sweep
def test_three_parameters():
    text = scene(CARS, "m1: 2 kg", "k1: K[x,x] = 1 kN/m", "k2: K[x,y] = -300 N/m", "m2: omega[1]*omega[2] = 200 s^-2")
    found = settled(problem(text))
    assert [values(found, name) for name in ("k1", "k2", "m2")] == [[700.0], [300.0], [pytest.approx(2.625, rel=1e-12)]]


# equilibrium


FALL = """
parameters: {{{parameters}}}
gravity: g
bodies: {{rod: {{shape: rod, mass: m, from: [0, 0], to: [L, 0], pin: {{at: [0, 0], by: phi}}}}}}
points: {{B: {{body: rod, at: [L, 0]}}}}
springs: {{s: {{k: k, preload: N, between: [B, [L, h]]}}}}
choose:
  {choose}
"""


def test_a_preload_that_balances():
    found = settled(problem(scene(FALL, "m: 2 kg, L: 1 m, h: 0.5 m, g: 9.81 m/s^2, k: 500 N/m", "N: equilibrium")))
    assert values(found, "N") == [9.81] and forms(found, "N") == ["m*g/2"]
    assert found.configuration.equilibrium.drawn


def test_a_relation_in_letters():
    found = settled(problem(scene(FALL, "m: , L: , h: , g: , k: ", "N: equilibrium")))
    assert forms(found, "N") == ["m*g/2"]
    assert found.symbolic.balanced_as_drawn


def test_equilibrium_and_a_frequency_together():
    text = scene(FALL, "m: 2 kg, L: 1 m, h: 0.5 m, g: 9.81 m/s^2", "N: equilibrium", "k: omega[1] = 30 rad/s")
    found = settled(problem(text))
    assert values(found, "N") == [9.81]
    assert value(found, "omega[1]") == pytest.approx(30, rel=1e-13)
    assert values(found, "k") == pytest.approx([600.0], rel=1e-13)


def test_two_supports_carry_a_plate():
    text = """
    parameters: {m: 6 kg, L: 2 m, g: 10 m/s^2, e: 0.3 m}
    gravity: g
    coordinates: [y, phi]
    bodies: {beam: {shape: rod, mass: m, from: [0, 0], to: [L, 0], move: [0, y, phi]}}
    energies: {V: -A*(y - L/2*phi) - B*(y + (L/2 - e)*phi)}
    choose:
      A: equilibrium
      B: equilibrium
    """
    found = settled(problem(text))
    assert values(found, "A") == pytest.approx([60 * 0.7 / 1.7]) and values(found, "B") == pytest.approx([60 / 1.7])


def test_a_pull_of_the_wrong_sense_is_named():
    text = scene(PENDULUM, "m: 2 kg, L: 1 m, a: -30 deg, g: 9.81 m/s^2", "F: equilibrium")
    message = refused(text)
    assert "the conditions need F = " in message and "not positive" in message
    either = settled(problem(text.replace("g: 9.81", "F: {sign: any}, g: 9.81")))
    assert values(either, "F") == pytest.approx([-19.62 / math.sqrt(3)])


def test_a_place_of_equilibrium():
    """A block hung on a spring sags by m g/k."""
    text = """
    parameters: {m: 2 kg, g: 9.81 m/s^2}
    gravity: g
    bodies: {b: {mass: m, at: [0, 0], slide: {along: [0, 1], by: y}}}
    springs: {s: {k: k, between: [[0, 1 m], b]}}
    choose: {k: "equilibrium[y] = -3 cm"}
    """
    found = settled(problem(text))
    assert values(found, "k") == pytest.approx([2 * 9.81 / 0.03], rel=1e-13)
    assert forms(found, "k") == ["100*m*g/3"]
    assert found.configuration.equilibrium.values["y"] == pytest.approx(-0.03, rel=1e-12)


@pytest.mark.sweep
def test_an_equilibrium_off_the_drawing():
    """The place of a nonlinear equilibrium, found by the scene itself."""
    text = scene(FALL, "m: 2 kg, L: 1 m, h: 0.5 m, g: 9.81 m/s^2, N: 0 N", "k: equilibrium[phi] = -10 deg")
    found = settled(problem(text), True)
    k, = values(found, "k")
    phi = math.radians(-10)
    x, y = math.cos(phi), math.sin(phi)
    length = math.hypot(1 - x, 0.5 - y)
    pull = k * (length - 0.5) / length
    assert pull * (x * (0.5 - y) - y * (1 - x)) == pytest.approx(2 * 9.81 * 0.5 * x, rel=1e-9)
    assert found.configuration.equilibrium.values["phi"] == pytest.approx(phi, rel=1e-9)


def test_a_force_that_holds_a_rod():
    text = """
    parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2}
    gravity: g
    points: {tip: {body: rod, at: [L, 0]}}
    bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [L, 0], pin: {at: [0, 0], by: phi}}}
    forces: {F: {at: tip, force: [0, P]}}
    choose: {P: equilibrium}
    """
    assert forms(settled(problem(text)), "P") == ["m*g/2"]


def test_a_counterweight_on_a_rope():
    text = """
    parameters: {m1: 2 kg, g: 9.81 m/s^2, r: 0.1 m}
    gravity: g
    bodies:
      a: {mass: m1, at: [-r, -1 m], slide: {along: [0, 1], by: y1}}
      drum: {mass: 1 kg, shape: disc, radius: r, at: [0, 0], pin: {by: phi}}
      b: {mass: m2, at: [r, -1 m], slide: {along: [0, 1], by: y2}}
    constraints: {hoist: {rope: [a, {over: drum}, b]}}
    springs: {s: {k: 100 N/m, between: [b, [r, -2 m]]}}
    choose: {m2: equilibrium}
    """
    assert forms(settled(problem(text)), "m2") == ["m1"]


@pytest.mark.sweep
def test_a_linkage_in_balance():
    text = """
    parameters: {m: 2 kg, g: 9.81 m/s^2}
    gravity: g
    bodies:
      a: {shape: rod, mass: m, from: [0, 0], to: [0.3 m, 0.9 m], pin: {at: [0, 0], by: p}}
      b: {shape: rod, mass: m, from: [2 m, 0], to: [1.8 m, 0.8 m], pin: {at: [2 m, 0], by: q}}
    points: {A: {body: a, at: [0.3 m, 0.9 m]}, B: {body: b, at: [1.8 m, 0.8 m]}}
    constraints: {bar: {link: [A, B]}}
    springs: {s: {k: k, between: [A, [0.3 m, 2 m]], preload: N}}
    choose: {k: "omega[1] = 9 rad/s", N: equilibrium}
    """
    found = settled(problem(text))
    assert found.configuration.equilibrium.drawn and value(found, "omega[1]") == pytest.approx(9, rel=1e-12)
    # virtual work: the link keeps (B − A)·(δB − δA) = 0
    ax, ay, bx, by, lx, ly = 0.3, 0.9, -0.2, 0.8, 1.5, -0.1
    ratio = (lx * -ay + ly * ax) / (lx * -by + ly * bx)                 # δq/δp
    lifted = 0.5 * ax + 0.5 * bx * ratio                                # of both weights, δy/δp
    assert values(found, "N") == pytest.approx([2 * 9.81 * lifted / ax], rel=1e-12)


def test_a_scene_that_is_driven():
    text = """
    parameters: {m: 2 kg, k: 800 N/m, F0: 3 N, Omega: 4 rad/s}
    bodies: {b: {mass: m, slide: x}}
    springs: {s: {k: k, between: [ground, b]}}
    dampers: {d: {c: c, between: [ground, b]}}
    forces: {F: {at: b, force: F0*sin(Omega*t) + (5 N) - P}}
    choose: {c: "zeta[1] = 1", P: equilibrium}
    """
    found = settled(problem(text))
    assert values(found, "c") == [80.0] and values(found, "P") == [5.0]


# the limit of stability


@pytest.mark.parametrize("route", ["letters", "search"])
def test_a_mast_between_springs(route, monkeypatch):
    if route == "search":
        monkeypatch.setattr(search, "candidates", lambda *args: None)
    found = settled(problem(scene(MAST, HANGING, "k: stability limit")))
    assert values(found, "k") == pytest.approx([2 * 9.81 / 4], rel=1e-9)
    for factor, stable in ((0.999, False), (1.001, True)):
        other = problem(scene(MAST, f"{HANGING}, k: {factor * 4.905!r} N/m", "").replace("choose:\n  \n", ""))
        assert value(other, "stable") is stable


def test_a_mast_in_letters():
    found = settled(problem(scene(MAST, "m: , L: , g: ", "k: stability limit")))
    assert forms(found, "k") == ["m*g/(4*L)"]


def test_the_first_of_two_that_falls():
    """Two upright pendulums joined by a spring: the pair falls together at kt = m g L, not where they fall apart."""
    text = """
    parameters: {m: 2 kg, L: 1 m, g: 10 m/s^2, q: 30 N*m/rad}
    gravity: g
    bodies:
      a: {mass: m, at: [0, L], pin: {at: [0, 0], by: phi}}
      b: {mass: m, at: [3 m, L], pin: {at: [3 m, 0], by: psi}}
    springs:
      s: {torsion: kt, between: [ground, a]}
      t: {torsion: kt, between: [ground, b]}
      u: {torsion: q, between: [a, b]}
    choose: {kt: stability limit}
    """
    found = settled(problem(text))
    assert values(found, "kt") == pytest.approx([20.0], rel=1e-12)


def test_what_is_always_stable_is_said():
    text = scene(MAST, HANGING, "k: stability limit").replace("to: [0, L]", "to: [0, -L]").replace(
        "at: [0, L]", "at: [0, -L]").replace("[-L, L]", "[-L, -L]").replace("[L, L]", "[L, -L]")
    assert "the equilibrium is stable for all of them" in refused(text)


def test_a_load_that_buckles():
    """A rigid column with a torsion spring at its foot under a dead load P: P = kt/L."""
    text = """
    parameters: {m: 2 kg, L: 1.5 m, kt: 600 N*m/rad}
    bodies: {column: {shape: rod, mass: m, from: [0, 0], to: [0, L], pin: {at: [0, 0], by: phi}}}
    springs: {foot: {torsion: kt, between: [ground, column]}}
    energies: {V: P*L*cos(phi)}
    choose: {P: stability limit}
    """
    assert values(settled(problem(text)), "P") == [400.0]


# refusals


@pytest.mark.parametrize(("choose", "words"), [
    ("c: omega[1] = 20 rad/s", "this holds whatever c is"),
    ("c: omega[1] = 21 rad/s", "omega[1] is 20 at all"),
    ("c: zeta[2] = 1", "there is no damped mode 2"),
    ("c: equilibrium", "whatever c is"),
    ("c: stability limit", "stable at all")])
def test_infeasible(choose, words):
    assert words in refused(scene(BLOCK, GIVEN, choose))


@pytest.mark.parametrize("first", [2, 3, 5])
@pytest.mark.parametrize("second", [2, 3, 5])
@pytest.mark.parametrize("power", [1, 2, 3])
def test_one_for_two_conditions_is_refused_where_they_disagree(first, second, power):
    """(P − a) = 0 along x and Pⁿ = bⁿ along y."""
    text = f"""
    parameters: {{m: 2 kg}}
    bodies: {{b: {{mass: m, at: [0, 0], move: [x, y, 0]}}}}
    energies: {{V: (P - {first} N)*x + (P^{power}/(1 N^{power}) - {second ** power})*(1 N)*y}}
    choose: {{P: equilibrium}}
    """
    if first == second:
        assert values(settled(problem(text)), "P") == pytest.approx([first], rel=1e-9)
    else:
        told = refused(text)
        assert "no value of P" in told and ("makes the drawn position an equilibrium" in told or power > 1)


def test_what_samples_tell_is_not_called_a_law():
    """ω₁ of the first mass stays 20 rad/s wherever it was tried; letters of two modes do not prove it."""
    text = """
    parameters: {m: 2 kg, k: 800 N/m}
    bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
    springs: {s: {k: k, between: [ground, a]}, r: {k: 2*k, between: [ground, b]}}
    dampers: {d: {c: c, between: [ground, b]}}
    choose: {c: "omega[1] = 20 rad/s"}
    """
    told = refused(text)
    assert "this holds at all" in told and "values of c tried from" in told and "whatever" not in told


def test_a_value_and_a_condition_contradict_one_another():
    with pytest.raises(SpecError) as caught:
        problem(scene(BLOCK, GIVEN + ", c: 3 N*s/m", "c: zeta[1] = 1"))
    assert "'c' is chosen, but has a value already" in str(caught.value)


@pytest.mark.sweep
def test_no_closed_form_is_said_and_numbers_help():
    text = scene(CARS, "m1: , m2: , k1: , k2: ", "c: zeta[1] = 0.05", dampers="dampers: {d: {c: c, between: [a, b]}}")
    assert "no closed form of c was found" in refused(text)
    found = settled(problem(text.replace("m1: , m2: , k1: , k2: ", TWO)))
    assert holds(found) < 1e-12


# where it is looked for


def test_natural_scales():
    spec = problem(scene(BLOCK, GIVEN, "c: zeta[1] = 1")).spec
    assert natural_scale(spec, "c") == pytest.approx(40, rel=0.5)
    bare = problem(scene(BLOCK, "m: 2, k: 800", "c: zeta[1] = 1"))
    assert values(settled(bare), "c") == [80.0]


@pytest.mark.parametrize("size", [1e-9, 1e-4, 1.0, 1e5, 1e9])
def test_units_do_not_matter(size, monkeypatch):
    """The same scene in other masses, lengths and times: found by the search over many decades."""
    monkeypatch.setattr(search, "candidates", lambda *args: None)
    text = scene(BLOCK, f"m: {2 * size!r} kg, k: {800 * size!r} N/m", "c: zeta[1] = 1")
    assert values(settled(problem(text)), "c") == pytest.approx([80 * size], rel=1e-10)


def test_angles_are_looked_for_within_a_turn():
    letters = problem(scene(PENDULUM, "m: 2 kg, L: 1 m, F: 5 N, g: 9.81 m/s^2", "a: equilibrium"))
    span = admissible(letters, "a")
    assert (span.low, span.high) == (0.0, 2 * math.pi)


# answers, cases, commands


FILE = """
title: Critical damping
parameters: {m: 2 kg, k: 800 N/m}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
dampers: {d: {c: c, between: [ground, b]}}
choose:
  c: zeta[1] = 1
answers:
  c: 2*sqrt(k*m)
  c/m: 40 s^-1
  zeta[1]: 1
cases:
  soft:
    parameters: {k: 200 N/m}
    answers: {c: 40 N*s/m}
  given:
    parameters: {c: 4 N*s/m}
    answers: {"zeta[1]": 1/20}
  other:
    choose: {c: "zeta[1] = 0.5"}
    answers: {c: 40 N*s/m}
"""


def verdicts(text):
    return {(v.case or "") + v.answer.asked.text: v.agrees for v in check(problem(text))}


def test_answers_and_cases():
    assert verdicts(FILE) == dict.fromkeys(["c", "c/m", "zeta[1]", "softc", "givenzeta[1]", "otherc"], True)
    wrong = verdicts(FILE.replace("c: 2*sqrt(k*m)", "c: 2.001*sqrt(k*m)").replace("{c: 40 N*s/m}", "{c: 40.5 N*s/m}"))
    assert [key for key, agrees in wrong.items() if not agrees] == ["c", "softc", "otherc"]


@pytest.mark.sweep
def test_answers_in_letters_are_compared_at_several_values():
    letters = FILE.partition("cases:")[0].replace("m: 2 kg, k: 800 N/m", "m: , k: ").replace("  c/m: 40 s^-1\n", "")
    assert verdicts(letters) == {"c": True, "zeta[1]": True}
    assert verdicts(letters.replace("2*sqrt(k*m)", "sqrt(k*m)"))["c"] is False


def test_the_second_solution_can_be_asked_for():
    text = scene(CARS, "m1: 2 kg, m2: 1 kg", "k1: omega[1] = 10 rad/s", "k2: omega[2] = 40 rad/s") + """
answers:
  k1: 310.8 N/m
  k1[2]: 3089 N/m
  k2[2]: 103.6 N/m
  k1[2]*k2[2]: k1*k2
"""
    assert verdicts(text) == dict.fromkeys(["k1", "k1[2]", "k2[2]", "k1[2]*k2[2]"], True)
    found = check(problem(text.replace("k1[2]: 3089", "k1[3]: 3089")))
    assert [v.refusal.message for v in found if v.refusal] == ["there is no solution 3 for k1: there are 2"]


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text(FILE)
    return str(path)


def printed(capsys, *args):
    code = run(list(args))
    out, err = capsys.readouterr()
    assert not err and code == 0
    return out


@pytest.mark.parametrize("command", ["solve", "frequencies", "equations"])
def test_commands_say_what_was_chosen(command, file, capsys):
    out = printed(capsys, command, file)
    assert "Chosen\n  c so that ζ₁ = 1\n  c = 2·√(m·k) = 80 N·s/m\n  checked by substitution" in out
    assert out.count("Chosen") == 3
    if command == "solve":
        assert "critically damped" in out and "Given\n  m = 2 kg   k = 800 N/m\n" in out
    assert "80·ẋ" in out or command == "frequencies"


@pytest.mark.sweep
def test_check_of_a_file(file, capsys):
    assert "6 answers agree" in printed(capsys, "check", file)


def test_a_setting_replaces_the_condition(file, capsys):
    out = printed(capsys, "solve", file, "--set", "c=30 N*s/m", "--case", "soft")
    assert "Chosen" not in out and "c = 30 N·s/m" in out


def test_json(file, capsys):
    data = json.loads(printed(capsys, "frequencies", file, "--json"))
    entry, = data["chosen"]
    assert entry == {"parameter": "c", "condition": "zeta[1] = 1", "values": [80.0], "closed_forms": ["2*sqrt(m*k)"],
                     "residuals": [0.0], "limit_points": [False], "counts_for": [[]]}
    assert data["damped"][0]["zeta"] == 1.0
    assert data["cases"]["soft"]["chosen"][0]["values"] == [40.0]
    assert "chosen" not in data["cases"]["given"]


@pytest.mark.sweep
def test_more_digits_need_a_closed_form(tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text(scene(BLOCK, "m: 2 kg, k: 700 N/m", "c: zeta[1] = 1/3"))
    data = json.loads(printed(capsys, "frequencies", str(path), "--json", "--digits", "30"))
    assert data["damped"][0]["zeta"] == "0.333333333333333333333333333333"
    path.write_text(scene(CARS, TWO.replace("m2: 1 kg, ", ""), "m2: omega[2] = 3*omega[1]"))
    assert run(["frequencies", str(path), "--digits", "30"]) == 4
    assert "needs a closed form" in capsys.readouterr().err


def test_a_case_that_cannot_be_chosen_leaves_the_others(tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text(FILE.replace('choose: {c: "zeta[1] = 0.5"}', 'choose: {c: "omega[1] = 3 rad/s"}'))
    assert run(["frequencies", str(path)]) == 4
    out, err = capsys.readouterr()
    assert out.count("Chosen") == 2 and "omega[1] is 20 at all" in err


def test_a_file_without_answers_is_tried(tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    path.write_text(scene(BLOCK, GIVEN, "c: omega[1] = 3 rad/s"))
    assert run(["check", str(path)]) == 4
    assert "at all" in capsys.readouterr().err


ZIEGLER = """
parameters: {{{parameters}}}
bodies:
  a: {{mass: 2*m, at: [0, l], pin: {{at: [0, 0], by: p}}}}
  b: {{mass: m, at: [0, 2*l], pin: {{at: a, by: q}}}}
springs: {{s: {{torsion: k, between: [ground, a]}}, t: {{torsion: k, between: [a, b]}}}}
{dampers}
forces: {{F: {{at: b, force: [0, -P], carrier: b}}}}
choose:
  {choose}
"""
COLUMN = "m: 1 kg, l: 1 m, k: 10 N*m"
JOINTS = "dampers: {d: {torsion: c, between: [ground, a]}, e: {torsion: c, between: [a, b]}}"


def test_flutter_of_an_undamped_column_begins_at_its_published_load():
    """Ziegler 1952: P l/k = 7/2 − √2."""
    found = settled(problem(scene(ZIEGLER, COLUMN, "P: stability limit")))
    assert values(found, "P")[0] == pytest.approx(10 * (3.5 - math.sqrt(2)), rel=1e-12)
    assert forms(found, "P")[0] is not None


@pytest.mark.sweep
def test_damping_lowers_the_load_at_which_flutter_begins():
    """Herrmann & Jong 1965: 41/28 + c²/(2 m l² k) for equal dampers."""
    for c in (0.01, 0.1, 1.0):
        text = scene(ZIEGLER, f"{COLUMN}, c: {c} N*m*s", "P: stability limit", dampers=JOINTS)
        assert values(settled(problem(text)), "P")[0] == pytest.approx(10 * (41 / 28 + c * c / 20), rel=1e-10)


def test_scales_are_settled_at_the_first_place_that_tells(monkeypatch):
    """Where both sides of an equation are there at one place, no other is looked at: one before the search, one at its
    solution."""
    places, measure = [], ConditionSystem._measure
    monkeypatch.setattr(ConditionSystem, "_measure", lambda self, one: places.append(one) or measure(self, one))
    found = settled(problem(
        "parameters: {m: 2 kg, k: 800 N/m, c: }\nbodies: {b: {mass: m, slide: x}}\nsprings: {s: {k: k, stretch: x}}\n"
        "dampers: {d: {c: c, stretch: x}}\nchoose: {c: \"zeta[1] = 0.1\"}\n"))
    assert found.choice.value("c", 1) == 8.0 and len(places) == 2
