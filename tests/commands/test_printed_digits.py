"""No printed number has more digits than its bound supports: an error moves its last digit by one at most."""

import cmath
import math
import random
import re
from decimal import Decimal
from pathlib import Path

import mpmath
import pytest
from support.scenes import kept_problem_of, problem

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.high_precision import equilibrium_to
from vibcli.notation.numbers import FEWER, figure
from vibcli.report.sections.mode_tables import damped_row, mode_row, polar, shapes
from vibcli.symbolic.evaluation import multiprecision

ROOT = Path(__file__).parents[2]
FILES = sorted([*(ROOT / "problems").glob("*/*.yaml"), *(ROOT / "vibcli" / "examples").glob("*.yaml")])
NUMBER = re.compile(r"-?\d+(\.\d+)?(e-?\d+)?")


def digits(text):
    return len(Decimal(text).normalize().as_tuple().digits)


def allowed(error):
    """Digits of which the last is wrong by one at most, for any first digit."""
    return 6 if not error else max(1, min(6, math.floor(-math.log10(error))))


def assert_supported(text, value, error):
    assert text.endswith(FEWER) == (allowed(error) < 6), f"{text} with the error {error:.1e}"
    text = text.removesuffix(FEWER)
    assert NUMBER.fullmatch(text), text
    assert digits(text) <= allowed(error), f"{text} with the error {error:.1e}"
    assert float(text) == pytest.approx(value, rel=0.51 * 10.0 ** (1 - allowed(error)))


def test_figures():
    draw = random.Random(46)
    for _ in range(2000):
        value, error = 10 ** draw.uniform(-30, 30), 10 ** draw.uniform(-9, 0)
        text = figure(value, error)
        assert_supported(text, value, error)
        if allowed(error) > 1:
            assert 10.0 ** (math.floor(math.log10(value)) + 1 - allowed(error)) >= 0.999 * error * value


def rows_supported(found):
    """How many numbers of the tables of modes have digits that their bounds support; AssertionError for others."""
    count = 0
    for mode in found.modal.modes:
        if mode.omega:
            omega = float(mode.omega)
            for text, value in zip(mode_row(mode)[1:4], (omega, omega / math.tau, math.tau / omega), strict=True):
                assert_supported(text, value, mode.error)
                count += 1
    for mode in found.modal.damped or ():
        if not mode.omega_d:
            continue
        omega_d, (of_decay, of_swing) = float(mode.omega_d), mode.bounds
        for text, value, error in zip(damped_row(mode)[1:7], (mode.omega, mode.zeta, omega_d, omega_d / math.tau,
                                                              math.tau / omega_d, mode.decay),
                                      (mode.error, of_decay, of_swing, of_swing, of_swing, of_decay), strict=True):
            if value:
                assert_supported(text, float(value), float(error))
                count += 1
    return count


@pytest.mark.sweep
def test_tables_of_all_problems():
    counts = []
    for path in FILES[::2]:
        found = kept_problem_of(path)
        if found.numeric.has_free_symbols or found.spec.choices:
            continue
        try:
            counts.append(rows_supported(found))
        except PhysicsError:
            continue
    assert len(counts) > 50 and sum(counts) > 400


def test_amplitudes_of_shapes_are_read_back():
    draw = random.Random("shapes")
    names = ["x1", "x2", "x3", "x4", "x5", "x6"]
    for _ in range(100):
        found = [[draw.choice([0.0, 1e-15, 1.0, -1.0, draw.uniform(-1, 1) * 10 ** draw.uniform(-9, 3)]) for _ in names]
                 for _ in range(3)]
        table, _ = shapes(names, [1, 2, 3], found)
        for i, (_, *row) in enumerate(table.rows):
            assert [float(text) for text in row] == pytest.approx([shape[i] for shape in found], rel=5.1e-6, abs=1e-12)
        turned = [[cmath.rect(size, draw.choice([0.0, math.pi, draw.uniform(-3, 3)])) for size in shape]
                  for shape in found]
        table, _ = shapes(names, [1, 2, 3], turned, polar)
        for i, (_, *row) in enumerate(table.rows):
            parts = [[float(part.strip(" °").replace("−", "-")) for part in f"{text}∠0".split("∠")[:2]] for text in row]
            assert [cmath.rect(size, math.radians(angle)) for size, angle in parts] == pytest.approx(
                [shape[i] for shape in turned], rel=1.5e-3)


LIGHT = """
bodies: {{a: {{mass: 1 kg, slide: x}}, b: {{mass: 1.7 kg, slide: y}}}}
springs: {{s: {{k: 4 N/m, between: [ground, a]}}, u: {{k: 3 N/m, between: [a, b]}}}}
dampers: {{d: {{c: {c} N*s/m, between: [ground, a]}}}}
"""
LOOSE = """
bodies: {{a: {{mass: 1 kg, slide: x}}, b: {{mass: 1.7 kg, slide: y}}}}
springs: {{s: {{k: 1e9 N/m, between: [a, b]}}, u: {{k: {k} N/m, between: [ground, a]}}}}
"""


@pytest.mark.parametrize("c", ["1e-15", "1e-13", "1e-11", "1e-9", "1e-7", "1e-3", "3.99999"])
def test_light_damping(c):
    """λ = iω − c φ²/2 to the first order in c."""
    found = problem(LIGHT.format(c=c))
    assert rows_supported(found) == 18
    with mpmath.workdps(40):
        roots = mpmath.polyroots([mpmath.mpf("1.7"), mpmath.mpf(c) * mpmath.mpf("1.7"), mpmath.mpf("14.9"),
                                  3 * mpmath.mpf(c), 12], maxsteps=200, extraprec=200)
        wanted = sorted((root for root in roots if root.imag > 0), key=abs)
    for mode, root in zip(found.modal.damped, wanted, strict=True):
        row = damped_row(mode)
        for text, value in ((row[1], abs(root)), (row[2], -root.real / abs(root)), (row[3], root.imag),
                            (row[4], root.imag / (2 * mpmath.pi)), (row[6], -root.real)):
            text = text.removesuffix(FEWER)
            assert abs(float(text) - value) <= 1.01 * 10.0 ** (1 - digits(text)) * abs(value)


@pytest.mark.parametrize("k", ["1e-6", "1e-4", "1e-2", "1", "1e3"])
def test_nearly_loose(k):
    found = problem(LOOSE.format(k=k))
    assert rows_supported(found) == 6
    with mpmath.workdps(40):
        k = mpmath.mpf(k)
        a, b, c = mpmath.mpf("1.7"), 10**9 * mpmath.mpf("2.7") + mpmath.mpf("1.7") * k, 10**9 * k
        lowest = mpmath.sqrt(2 * c / (b + mpmath.sqrt(b * b - 4 * a * c)))
    text = mode_row(found.modal.modes[0])[1]
    assert abs(float(text) - lowest) <= 1.01 * 10.0 ** (1 - digits(text)) * lowest


@pytest.mark.sweep
def test_equilibria_of_all_problems():
    """Those that are searched for, against 30 digits: the last that is printed is wrong by one at most."""
    count = 0
    for path in FILES:
        found = kept_problem_of(path)
        if found.numeric.has_free_symbols or found.spec.choices or not found.scene.q or found.system.is_linear:
            continue
        near = found.configuration.equilibrium
        if near.drawn:
            continue
        with mpmath.workdps(45):
            arithmetic = multiprecision()
            exact = equilibrium_to(found.numeric, near, found.numeric.values(arithmetic), arithmetic)
        for name in found.scene.coordinates:
            text = figure(found.configuration.equilibrium.values[name])
            assert abs(float(text) - exact[name]) <= 5.1e-6 * max(abs(exact[name]), 1e-9)
            count += 1
    assert count > 10


FOLD = """
parameters: {{m: 1 kg, k: 1 N, L: 1 m, p: {p}}}
coordinates: {{x: {{drawn: 0.5 m}}}}
energies: {{T: m*x'^2/2, V: k*L*((x/L)^3/3 - p*x/L)}}
"""


@pytest.mark.parametrize("p", ["1e-2", "1e-4", "1e-6", "1e-8"])
def test_an_equilibrium_near_a_fold(p):
    found = problem(FOLD.format(p=p))
    text = figure(found.configuration.equilibrium.values["x"])
    assert float(text) == pytest.approx(math.sqrt(float(p)), rel=1.01e-5)
