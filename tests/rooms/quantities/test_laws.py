"""Laws as a whole, law[s](D) and law[s, d^3]: against mpmath's derivatives of roots, series of SymPy, closed forms."""

import re

import mpmath
import pytest
import sympy

import vibcli
from vibcli.cli.program import run

UNITS = {"m": "kg", "k1": "N/m", "k2": "N/m", "g": "N/m^3", "h": "N/m^5", "q": "N/m^2", "D": "m", "c1": "N*s/m",
         "c2": "N*s^3/m^3", "kappa": "N*m"}
VALUES = {"m": 2, "k1": 300, "k2": 200, "g": 50000, "h": 3000000, "q": 1000, "D": 0.1, "c1": 3, "c2": 5, "kappa": 30}
NESTED = """
bodies: {block: {mass: 1 kg, slide: x}}
springs:
  s:
    series:
      - {k: 500 N/m}
      - parallel: [{law: 9e4 N/m^3*d^3}, {series: [{k: 500 N/m}, {law: 500 N/m*d + 9e4 N/m^3*d^3}]}]
    between: [ground, block]
forces: {pull: {at: block, force: 20 N}}
"""
CHAIN = [{"k": "k1"}, {"law": "k2*d + g*d^3"}]


def asked(asks, letters=False, kind="springs", body=None, **element):
    names = set(re.findall(r"[A-Za-z]\w*", repr((element, asks)))) | {"m"}
    values = {name: {"unit": unit} if letters else f"{VALUES[name]} {unit}" for name, unit in UNITS.items()
              if name in names}
    model = vibcli.load({"parameters": values, "bodies": {"block": body or {"mass": "m", "slide": "x"}},
                         kind: {"s": {**element, "between": ["ground", "block"]}},
                         "answers": {ask: "1 N*m" if body else unit_of(ask, kind) for ask in asks}})
    return [model[ask] for ask in asks]


def unit_of(ask, kind):
    n = 0 if "(" in ask else min(12, int(ask.partition("^")[2].strip("]") or 1))
    return f"1 N*s^{n}/m^{n}" if kind == "dampers" and n else f"1 N/m^{n}" if n else "1 N"


def inner(D, laws):
    """The force of parts in series, to the digits at work: laws of one inner deflection each, the first k1 d."""
    d = mpmath.findroot(lambda d: 300 * (D - d) - laws(d), D * 0.6)
    return laws(d)


@pytest.mark.parametrize(("parts", "law"), [
    (CHAIN, lambda d: 200 * d + 50000 * d**3), ([{"k": "k1"}, {"law": "g*d^3 + h*d^5"}],
                                                lambda d: 50000 * d**3 + 3000000 * d**5)])
def test_the_force_at_a_deflection(parts, law):
    found, = asked(["law[s](D)"], series=parts)
    with mpmath.workdps(40):
        exact = inner(mpmath.mpf("0.1"), law)
        assert abs(found.value - exact) <= found.error <= 1e-14 * exact


def test_coefficients_against_derivatives_of_the_root():
    powers = range(1, 10)
    found = asked([f"law[s, d^{n}]" for n in powers], series=CHAIN)
    with mpmath.workdps(60):
        exact = mpmath.taylor(lambda D: inner(D, lambda d: 200 * d + 50000 * d**3) if D else mpmath.mpf(0), 0, 9)
        for n, one in zip(powers, found, strict=True):
            off = abs(one.value - exact[n])
            assert off <= one.error + 1e-9 * (n % 2 == 0) and off <= 1e-12 * abs(exact[n]) + 1e-9


@pytest.mark.sweep
def test_coefficients_in_letters_against_a_reversion_by_hand():
    """D = F/k1 + d(F), d = F/k2 − g F³/k2⁴ + 3 g² F⁵/k2⁷ − …"""
    k1, k2, g, D, a, b, c = sympy.symbols("k1 k2 g D a b c")
    F = a * D + b * D**3 + c * D**5
    whole = sympy.expand(F / k1 + F / k2 - g * F**3 / k2**4 + 3 * g**2 * F**5 / k2**7 - D)
    exact = {}
    for n, unknown in ((1, a), (3, b), (5, c)):
        exact[n] = sympy.solve(whole.coeff(D, n).subs({a: exact.get(1, a), b: exact.get(3, b)}), unknown)[0]
    for n, one in zip((1, 3, 5), asked([f"law[s, d^{n}]" for n in (1, 3, 5)], letters=True, series=CHAIN), strict=True):
        found = sympy.sympify(str(one.expression).replace("^", "**"), {"k1": k1, "k2": k2, "g": g})
        assert sympy.simplify(found - sympy.simplify(exact[n])) == 0


@pytest.mark.sweep
def test_a_cubic_part_alone_governs_where_all_are_soft_enough():
    """F = g u³, D = u + g u³/k: F = g D³ − 3 g²/k D⁵ + 12 g³/k² D⁷"""
    found = asked(["law[s, d]", "law[s, d^3]", "law[s, d^5]", "law[s, d^7]"], letters=True,
                  series=[{"k": "k1"}, {"law": "g*d^3"}])
    assert [str(one.expression) for one in found] == ["0", "g", "-3*g^2/k1", "12*g^3/k1^2"]


def test_cardanos_formula():
    found, = asked(["law[s](D)"], letters=True, series=CHAIN)
    values = {"k1": 300, "k2": 200, "g": 50000, "sqrt": mpmath.sqrt, "mpf": mpmath.mpf}
    with mpmath.workdps(30):
        text = str(found.expression).replace("^", "**").replace("(1/3)", "(mpf(1)/3)")
        exact = inner(mpmath.mpf("0.1"), lambda d: 200 * d + 50000 * d**3)
        assert abs(eval(text, {**values, "D": mpmath.mpf("0.1")}) / exact - 1) < 1e-25


@pytest.mark.sweep
def test_more_digits_of_a_nested_chain(tmp_path, capsys):
    (tmp_path / "chain.yaml").write_text(NESTED)
    assert run(["frequencies", "--digits", "25", str(tmp_path / "chain.yaml")]) == 0
    with mpmath.workdps(40):
        e = mpmath.findroot(lambda e: 500 * e + 9e4 * e**3 + 9e4 * (2 * e + 180 * e**3)**3 - 20, 0.02)
        pair, inside = 2 * e + 180 * e**3, 500 + 3 * 9e4 * e**2
        beside = 1 / (1 / mpmath.mpf(500) + 1 / inside) + 3 * 9e4 * pair**2
        omega = mpmath.sqrt(1 / (1 / mpmath.mpf(500) + 1 / beside))
        assert mpmath.nstr(omega, 24) in capsys.readouterr().out


def test_equal_duffing_springs_and_powers():
    found = asked(["law[s, d]", "law[s, d^3]"], letters=True, series=[{"law": "k1*d + g*d^3"}] * 4)
    assert [str(one.expression) for one in found] == ["k1/4", "g/64"]


def test_dampers_torsion_and_single_laws():
    found = asked(["law[s, v]", "law[s, v^3]"], letters=True, kind="dampers",
                  series=[{"c": "c1"}, {"law": "c1*v + c2*v^3"}])
    assert [str(one.expression) for one in found] == ["c1/2", "c2/16"]
    turning, = asked(["law[s](0.5 rad)"], body={"inertia": "m*1 m^2", "turn": "phi"}, torsion=True,
                     law="kappa*sinh(d)")
    assert turning.value == pytest.approx(float(30 * mpmath.sinh(0.5)), rel=1e-15)
    stop = asked(["law[s](3 cm)", "law[s](-3 cm)"], k="k1", acts="compression", gap="1 cm")
    assert [one.value for one in stop] == [0.0, pytest.approx(-6.0, rel=1e-15)]


@pytest.mark.parametrize(("parts", "why"), [
    ([{"k": "k1"}, {"law": "q*d*abs(d)"}], "a kink of abs"),
    ([{"law": "g*d^3"}, {"law": "h*d^5"}], "a broken power"),
    ([{"k": "k1"}, {"law": "q*sign(d)*abs(d)^1.5*1 m^0.5"}], "a (kink|jump) of|a broken power")])
def test_laws_without_a_series_are_said_to_have_none(parts, why):
    with pytest.raises(vibcli.PhysicsError, match=f"no series about zero deflection: it .*({why})"):
        asked(["law[s, d]"], series=parts)


@pytest.mark.parametrize(("ask", "why"), [
    ("law[s, v]", "the law of 's' is a function of d"), ("law[t, d]", "no spring or damper 't'"),
    ("law[s](2 s)", "expected a deflection"), ("law[s, d^13]", "expected a power of the deflection")])
def test_what_cannot_be_asked(ask, why):
    with pytest.raises(vibcli.SpecError, match=why):
        asked([ask], series=CHAIN)
