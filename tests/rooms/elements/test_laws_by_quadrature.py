"""Energies of laws that no rule integrates: bends within bends in closed form, all others by quadrature."""

import mpmath
import pytest

import vibcli
from vibcli.symbolic.antiderivatives import from_zero
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision
from vibcli.symbolic.expression import Table
from vibcli.symbolic.integrals_of_laws import by_quadrature
from vibcli.symbolic.parser import parse
from vibcli.symbolic.running_errors import RunningErrors
from vibcli.symbolic.semantics import lower

VALUES = {"a": 0.7, "b": 1.9, "f": 1.3, "k": 2.6, "y": 0.45}
NESTED = ["max(-y, min(x, y))", "k*x + max(-y, min(f*x, y))", "max(abs(x) - a, 0)", "abs(abs(x) - a)",
          "f*min(max(x, -a), b)", "max(0, 3*f - abs(2*x - a))", "max(min(x - a, b) - y, 0)", "max(-(y/2), min(k*x, y))"]
SMOOTH = ["k*x*exp(-abs(x)/a)", "k*x/sqrt(1 + (x/a)^2)", "k*a*sign(x)*log(1 + abs(x)/a)", "f*sin(x/a)*exp(x/b)",
          "x*max(-y, min(x, y))", "k*x*exp(-sqrt(abs(x)/a))", "sqrt(abs(abs(x) - a))*x",
          "k*x*exp(-((x - b)/(a/1000))^2)"]
PLACES = (-4.2, -0.6, 1e-5, 0.31, 2.8)


def law_of(written):
    table = Table()
    x, letters = table.variable("x"), {name: table.parameter(name) for name in VALUES}
    return x, lower(parse(written), table, lambda name, primes, tree: {"x": x, **letters}[name])


def by_mpmath(law, end):
    arithmetic = multiprecision()
    known = {name: mpmath.mpf(value) for name, value in VALUES.items()}
    a, b, f, k, y = (known[name] for name in "abfky")
    bends = (a, b, y, y / f, y / k, y / 2 / k, a / 2, 3 * f / 2 + a / 2, 3 * f / 2 - a / 2, a + b, a + y,
             *(b + j * a / 1000 for j in (-9, -3, 0, 3, 9)))
    inner = (s for p in bends for s in (-p, p) if min(0, end) < s < max(0, end))
    places = sorted({mpmath.mpf(0), mpmath.mpf(end), *inner})
    found = mpmath.quad(lambda s: evaluate([law], arithmetic, {**known, "x": s})[0], places)
    return found if end > 0 else -found


@pytest.mark.parametrize("written", NESTED)
def test_bends_within_bends_are_integrated_in_closed_form(written):
    x, law = law_of(written)
    energy = from_zero(law, x)
    force = gradient(energy)[x]
    for end in PLACES:
        values = {**VALUES, "x": end}
        assert evaluate([energy], Floats, values)[0] == pytest.approx(float(by_mpmath(law, end)), rel=1e-13, abs=1e-14)
        assert evaluate([force], Floats, values)[0] == pytest.approx(evaluate([law], Floats, values)[0], abs=1e-14)


@pytest.mark.sweep
@pytest.mark.parametrize("written", SMOOTH)
def test_energies_by_quadrature_are_right_within_their_bounds(written):
    x, law = law_of(written)
    assert from_zero(law, x) is None
    energy = by_quadrature("V", law, x)
    assert gradient(energy)[x] is law
    for end in PLACES:
        with mpmath.workdps(25):
            wanted = by_mpmath(law, end)
            found, = evaluate([energy], RunningErrors(Floats), {**VALUES, "x": end})
            assert abs(found.value - wanted) <= found.error + 1e-300
            assert found.error <= 1e-5 * abs(wanted) + 1e-300
            if "1000" not in written:
                assert found.error <= 1e-10 * abs(wanted) or "sqrt(abs(abs" in written
                exact, = evaluate([energy], multiprecision(), {**VALUES, "x": mpmath.mpf(end)})
                assert exact / wanted == pytest.approx(1, rel=1e-15)


def test_energies_by_quadrature_change_with_letters_as_differences_of_them_do():
    table = Table()
    x, a = table.variable("x"), table.variable("a")
    law = x * table.call("exp", -(x * x + a) ** 2)
    energy = by_quadrature("V", law, x)
    slope, bend = gradient(energy)[a], gradient(gradient(energy)[a])[a]
    values = {"x": 1.2, "a": 0.4}

    def at(node, moved=0.0):
        return evaluate([node], Floats, {**values, "a": values["a"] + moved})[0]
    assert at(slope) == pytest.approx((at(energy, 1e-5) - at(energy, -1e-5)) / 2e-5, rel=1e-8)
    assert at(bend) == pytest.approx((at(slope, 1e-5) - at(slope, -1e-5)) / 2e-5, rel=1e-8)
    exact = mpmath.quad(lambda s: s * mpmath.exp(-(s * s + 0.4) ** 2), [0, 1.2])
    assert at(energy) == pytest.approx(float(exact), rel=1e-14)


SCENE = """
parameters: {m: 2 kg, k: 800 N/m, a: 3 cm, x0: 5 cm}
bodies: {block: {mass: m, slide: x}}
springs: {s: {law: "LAW", between: [ground, block]}}
initial: {x: x0}
motion: full
"""


@pytest.mark.sweep
def test_the_period_of_a_law_without_a_rule_is_that_of_quadrature():
    """F = k d e^(−|d|/a): V = k a² (1 − (1 + u) e^(−u)), u = |d|/a."""
    model = vibcli.loads(SCENE.replace("LAW", "k*d*exp(-abs(d)/a)"))

    def V(q):
        u = q / 0.03
        return 800 * 0.03**2 * (1 - (1 + u) * mpmath.exp(-u))
    with mpmath.workdps(30):
        end = mpmath.mpf("0.05")
        wanted = 4 * mpmath.quad(lambda s: 2 * s / mpmath.sqrt(V(end) - V(end - s * s)), [0, mpmath.sqrt(end)],
                                 method="gauss-legendre")
    assert model["period(x)"].value == pytest.approx(float(wanted), rel=1e-14)
    assert model["s.energy(0 s)"].value == pytest.approx(float(V(mpmath.mpf("0.05"))), rel=1e-14)
    assert model["s.force(0 s)"].value == pytest.approx(40 * float(mpmath.exp(mpmath.mpf(-5) / 3)), rel=1e-14)


def test_the_energy_of_a_law_in_equilibrium_counts_from_where_it_is_undeformed():
    """k d e^(−d/a) = P at d = −a W(−P/(k a))."""
    model = vibcli.loads(SCENE.replace("LAW", "k*d*exp(-abs(d)/a)").replace("motion: full", "forces: {F: {at: block, "
                         "force: 6 N}}").replace("initial: {x: x0}", "").replace(", x0: 5 cm", ""))
    with mpmath.workdps(20):
        u = -mpmath.lambertw(mpmath.mpf(-6) / 24)
        assert model["equilibrium[x]"].value == pytest.approx(float(u * 3 / 100), rel=1e-14)
        assert model["equilibrium[s.energy]"].value == pytest.approx(
            float(mpmath.mpf("0.72") * (1 - (1 + u) * mpmath.exp(-u))), rel=1e-13)


def test_a_saturating_spring_swings_in_arcs_and_parabolas():
    """F = k max(−y, min(d, y)), let go at X > y: from X to y in √(2 (X − y) m/(k y)), then with ω to 0."""
    model = vibcli.loads(SCENE.replace("LAW", "k*max(-a, min(d, a))"))
    omega, X, y = 20.0, 0.05, 0.03
    flat = (2 * (X - y) / (omega**2 * y)) ** 0.5
    speed = omega**2 * y * flat
    assert model["period(x)"].value == pytest.approx(
        4 * (flat + float(mpmath.atan(omega * y / speed)) / omega), rel=1e-14)
