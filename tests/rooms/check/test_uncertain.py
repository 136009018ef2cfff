"""Verdicts that the bound of what is found leaves open: found anew to more digits, else uncertain, never a tick."""

import json
import random
from fractions import Fraction

import mpmath
import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.check import comparison
from vibcli.check.comparison import verdict
from vibcli.check.verdicts import check
from vibcli.cli.program import run
from vibcli.results.modal_signals import ModalSignal

MASS = """
parameters: {m: 2 kg, k: 800 N/m}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
"""


def test_a_bound_that_grows_turns_no_cross_into_a_tick():
    """Nor a tick into a cross: what is decided stays so or becomes uncertain."""
    draw, seen = random.Random(1), set()
    for _ in range(2000):
        expected, found = draw.uniform(-1, 1), draw.uniform(-1, 1)
        tolerance = draw.choice([0.0, 1e-9, 0.1, 1.0]) * abs(found - expected) * draw.choice([0.5, 1.0, 2.0])
        errors = sorted([0.0, *(10 ** draw.uniform(-12, 1) for _ in range(8))])
        said = [verdict(expected, found, error, tolerance).agrees for error in errors]
        assert said[0] is not None
        assert set(said) <= {said[0], None}
        assert said == sorted(said, key=lambda one: one is None)
        seen.add((said[0], said[-1]))
    assert {(True, None), (False, None)} <= seen


def test_a_verdict_holds_for_any_number_within_the_bound():
    draw = random.Random(2)
    for _ in range(2000):
        true, error, tolerance = draw.uniform(-1, 1), 10 ** draw.uniform(-6, 0), 10 ** draw.uniform(-6, 0)
        found, expected = true + draw.uniform(-1, 1) * error, true + draw.uniform(-2, 2) * tolerance
        said = verdict(expected, found, error, tolerance).agrees
        assert said in (None, abs(true - expected) <= tolerance)


def found_within(monkeypatch, errors):
    """What is found in floats and to more digits, as {digits: (value, absolute error)}; the rest as it is."""
    plain, asked = comparison.bounded, []

    def bounded(problem, expression):
        if expression.text != "omega[1]":
            return plain(problem, expression)
        asked.append(problem.digits)
        if errors.get(problem.digits) is None:
            raise PhysicsError("no more digits of it are found")
        return errors[problem.digits]

    monkeypatch.setattr(comparison, "bounded", bounded)
    return asked


WIDE, EDGE = (20.0, 0.1), "20.05"       # half a unit of the last digit: 0.005
CASES = [
    ({None: (20.0, 1e-9)}, "20.0", True, 1), ({None: (20.0, 1e-9)}, "20.1", False, 1),
    ({None: WIDE, 25: (20.049, 1e-20)}, EDGE, True, 2), ({None: WIDE, 25: (20.04, 1e-20)}, EDGE, False, 2),
    ({None: WIDE, 25: (20.045, 0.01), 50: (20.046, 1e-30)}, EDGE, True, 3),
    ({None: WIDE, 25: (20.045, 0.01), 50: (20.045, 1e-3)}, EDGE, None, 3),
    ({None: WIDE, 25: (30.0, 1e-20)}, EDGE, None, 2), ({None: WIDE, 25: WIDE}, EDGE, None, 2),
    ({None: WIDE}, EDGE, None, 2),
    ({None: (20.04, 0.006)}, "20.0", True, 1), ({None: (20.04, 0.02)}, "20.0", None, 2),
    ({None: (20.0, 1e-5)}, "20", None, 2), ({None: (20.0, 0.1)}, "20", None, 2),
    ({None: (20.0 + 1e-7, 1e-5)}, "20", None, 2), ({None: (20.0 + 1e-7, 1e-9)}, "20", False, 1),
    ({None: (20.0, 8e-14)}, "20.0000000000000", None, 2), ({None: (20 + 1e-13, 8e-14)}, "20.0000000000000", None, 2)]


@pytest.mark.parametrize(("found", "expected", "agrees", "times"), CASES)
def test_what_is_open_is_found_anew_to_more_digits(monkeypatch, found, expected, agrees, times):
    asked = found_within(monkeypatch, found)
    one, = check(problem(MASS + f"answers: {{'omega[1]': {expected} rad/s}}\n"))
    assert one.agrees is agrees
    assert len(asked) == times
    assert (one.refusal is not None) == (agrees is None)


TURNED = """
parameters: {m: 3 kg, L: 0.7 m, g: 9.81 m/s^2, F: 4 N}
gravity: g
points: {A: {body: rod, at: [0, -L]}}
bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [0, -L], pin: {at: [0, 0], by: phi}}}
forces: {P: {at: A, force: [F, 0]}}
"""


def twenty(value, units):
    """Twenty digits of a number, the last moved by so many units."""
    unit = mpmath.mpf(10) ** (mpmath.floor(mpmath.log10(abs(value))) - 19)
    return mpmath.nstr(value + units * unit, 20, strip_zeros=False, min_fixed=-9)


@pytest.mark.parametrize("units", [0, 2, -3])
def test_twenty_digits_are_compared_as_twenty(units):
    """tan φ = 2F/(m g), K = m g L cos φ/2 + F L sin φ, J = m L²/12: none is known to twenty digits in floats."""
    with mpmath.workdps(40):
        m, L, g, F = (mpmath.mpf(x.numerator) / x.denominator for x in map(Fraction, ("3", "0.7", "9.81", "4")))
        phi = mpmath.atan(2 * F / (m * g))
        K = m * g * L / 2 * mpmath.cos(phi) + F * L * mpmath.sin(phi)
        true = {"equilibrium[phi]": (phi, "rad"), "K[phi,phi]": (K, "N*m"), "M[phi,phi]": (m * L**2 / 3, "kg*m^2"),
                "J[rod]": (m * L**2 / 12, "kg*m^2"), "equilibrium[A.x]": (L * mpmath.sin(phi), "m"),
                "K[phi,phi]^2/1 N^2/1 m^2 - M[phi,phi]^2/1 kg^2/1 m^4": (K**2 - (m * L**2 / 3) ** 2, "")}
        lines = [f"  {name}: {twenty(value, units)} {unit}\n" for name, (value, unit) in true.items()]
    found = check(problem(TURNED + "answers:\n" + "".join(lines)))
    assert len(found) == 6
    assert all(one.agrees is (units == 0) for one in found), [one.answer.asked.text for one in found]


def test_an_ulp_of_rounding_at_an_edge_is_settled():
    """√(k/m) = 20.05 exactly, on the edge of what 20.1 and 20.0 say, and of what is written to no more digits."""
    scene = MASS.replace("800 N/m", "804.005 N/m")
    for text in ("20.1", "20.0", "20.05", "20.0500000000000", "20.050000000000001", "{value: 20 rad/s, rtol: 0.25 %}"):
        value = text if text[0] == "{" else f"{text} rad/s"
        one, = check(problem(scene + f"answers: {{'omega[1]': {value}}}\n"))
        assert one.agrees is True, text


# the command

ROUGH = "{value: 20 rad/s, rtol: 1 %}"


def scene(folder, name, expected, more=""):
    path = folder / name
    path.write_text(MASS + f"answers: {{'omega[1]': {expected}}}\n" + more)
    return str(path)


@pytest.fixture
def files(tmp_path, monkeypatch):
    """Scenes whose answer agrees, differs and is uncertain; one of which the answer is refused; one that is invalid."""
    found_within(monkeypatch, {None: (20.0, 0.01)})
    refused = tmp_path / "refused.yaml"
    refused.write_text(MASS + "answers: {'zeta[1]': 0.1}\n")
    return {"agrees": scene(tmp_path, "a.yaml", ROUGH), "differs": scene(tmp_path, "d.yaml", "21.0 rad/s"),
            "uncertain": scene(tmp_path, "u.yaml", "20.000 rad/s"), "refused": str(refused),
            "invalid": scene(tmp_path, "i.yaml", "20.0 km")}


@pytest.mark.parametrize(("names", "code"), [
    (["uncertain"], 4), (["agrees", "uncertain"], 4), (["uncertain", "differs"], 4), (["uncertain", "invalid"], 3),
    (["uncertain", "refused"], 4), (["agrees", "differs"], 1), (["agrees"], 0)])
@pytest.mark.parametrize("more", [[], ["--json"], ["--quiet"]])
def test_exit_codes(files, names, code, more, capsys):
    assert run(["check", *more, *(files[name] for name in names)]) == code


def test_what_is_printed(files, tmp_path, capsys):
    assert run(["check", "--quiet", files["agrees"], files["uncertain"]]) == 4
    out, err = capsys.readouterr()
    assert "? omega[1]: uncertain: expected 20.000 rad/s, found 20 ± 0.01  [line 5]" in out
    assert "✓" not in out
    assert "✗" not in out
    assert out.splitlines()[-1] == "1 answer agrees, 1 is uncertain in 2 files"
    assert "u.yaml:5:23: error: omega[1] is known to be 20 ± 0.01: the answer has more digits" in err
    assert "write fewer digits, or give a tolerance" in err


def test_in_json_it_is_neither(files, capsys):
    run(["check", "--json", files["uncertain"], files["agrees"]])
    uncertain, agrees = (entry["answers"][0] for entry in json.loads(capsys.readouterr().out))
    assert (uncertain["agrees"], uncertain["found"], uncertain["error"]) == (None, 20.0, pytest.approx(0.01))
    assert agrees["agrees"] is True


def test_cases_and_folders(files, tmp_path, capsys):
    folder = tmp_path / "below"
    folder.mkdir()
    scene(folder, "cases.yaml", ROUGH,
          "cases:\n  sharp: {answers: {'omega[1]': 20.000 rad/s}}\n  far: {answers: {'omega[1]': 21.0 rad/s}}\n")
    assert run(["check", str(folder)]) == 4
    out = capsys.readouterr().out
    assert "? sharp: omega[1]" in out
    assert "✗ far: omega[1]" in out
    assert "1 answer agrees, 1 differs, 1 is uncertain in 1 file" in out


def test_the_advice_works(files, tmp_path):
    """Fewer digits, or a tolerance."""
    assert run(["check", scene(tmp_path, "fewer.yaml", "20.0 rad/s")]) == 0
    assert run(["check", files["agrees"]]) == 0


HINGE = """
parameters: {m: 3 kg, L: 0.7 m, g: 9.81 m/s^2}
gravity: g
bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [0, -L], pin: {at: [0, 0], by: phi}}}
initial: {phi: 0.3}
motion: full
"""


@pytest.mark.parametrize(("asked", "agrees"), [("phi(1 s) - phi(1 s)*(1 + 1e-17): 0", None),
                                               ("phi(1 s) - phi(1 s)*(1 + 1e-17) + 1: 1.00", True)])
def test_the_advice_for_what_is_nothing_works(monkeypatch, asked, agrees):
    """0 ± 0.001 is not known to be 0; beside something it is."""
    def bounded(problem, expression):
        found, error = plain(problem, expression)
        return (found, 1e-3) if "phi" in expression.text else (found, error)

    plain = comparison.bounded
    monkeypatch.setattr(comparison, "bounded", bounded)
    one, = check(problem(HINGE + f"answers: {{{asked}}}\n"))
    assert one.agrees is agrees
    assert agrees or "as in x + 1 mm: 1.00 mm" in one.refusal.hint


def test_numbers_that_are_the_same_float_are_told_apart(tmp_path, capsys):
    """cos 2 to 24 digits is −0.416146836547142386997568; the answer is 1.3e-20 off."""
    scene = tmp_path / "scene.yaml"
    scene.write_text(MASS.replace("800", "8") + "initial: {x: 1 m}\n"
                     "answers: {x(1 s): {value: -0.41614683654714238699 m, rtol: 1e-20}}\n")
    assert run(["check", str(scene)]) == 1
    said = capsys.readouterr().out
    assert "expected -0.41614683654714238699, found -0.4161468365471423869976" in said and "off by 0" not in said


@pytest.mark.sweep
def test_what_is_found_as_zero_is_no_other_number_but_within_its_bound(monkeypatch):
    """At its start a motion by modes is 0 with a bound; numbers within it were said to differ. How large a signal
    becomes may be searched for in vain."""
    scene = problem("""
        beams: {arm: {length: 1 m, EI: 2 N*m^2, mass_per_length: 0.5 kg/m, left: clamped, right: clamped}}
        points: {P: {body: arm, at: 0.5 m}}
        forces: {push: {at: P, force: 1 N*step(t)}}
        find: [{response: {until: 1 ms}}]
        answers:
          {arm.u(0.3 m)(0 s): 0 m, arm.u(0.4 m)(0 s): 1e-20 m, arm.u(0.2 m)(0 s): 1e-3 m, arm.slope(0.5 m)(1 ms): 0}
        """)

    def in_vain(*_):
        raise PhysicsError("the search is given up")

    monkeypatch.setattr(ModalSignal, "extreme", in_vain)
    assert [one.agrees for one in check(scene)] == [True, None, False, True]


def test_what_counts_as_zero_is_told_without_the_many_modes_of_a_value(monkeypatch):
    """The largest of a signal, of which zero is a share, was searched for by as many modes as a value is read by."""
    scene = problem("""
        beams: {arm: {length: 1 m, EI: 2 N*m^2, mass_per_length: 0.5 kg/m, left: clamped}}
        forces: {push: {body: arm, per_length: 1 N/m*step(t)}}
        find: [{response: {until: 1 s}}]
        answers: {arm.u'(0 m)(0.1 s): 0 m/s, arm.u'(1 m)(0.1 s): 0 m/s}
        """)
    read = []
    monkeypatch.setattr(ModalSignal, "read_at", lambda self, _: self.coarse)
    monkeypatch.setattr(ModalSignal, "extreme", lambda self, *_: (0.0, float(read.append(self._finest) or 1.0)))
    assert [one.agrees for one in check(scene)] == [True, False]
    assert read == [None] * len(read) != []
