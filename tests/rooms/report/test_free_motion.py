"""What a solution tells unasked of a motion from its start: the period of a wide swing; where dry friction ends it."""

import math
import random
import re

import mpmath
import pytest
from support.scenes import problem

from vibcli.api.reports import report, solution
from vibcli.report.formats.text import section_lines

BLOCK = """
parameters: {{m: {m!r} kg, k: {k!r} N/m, F: {F!r} N, x0: {x0!r} m}}
bodies: {{block: {{mass: m, slide: x}}}}
springs: {{s: {{k: k, between: [ground, block]}}}}
dampers: {{rub: {{friction: F, between: [ground, block]}}}}
initial: {{x: x0}}
"""
ROD = """
parameters: {m: 2 kg, L: 0.8 m, g: 9.81 m/s^2}
gravity: g
bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [0, -L], pin: {at: [0, 0], by: phi}}}
initial: {phi: ANGLE}
motion: full
"""


def told(text, title):
    """The lines of the section of a solution."""
    found = problem(text)
    return "\n".join(section_lines([one for one in report(found, solution(found)).sections if one.title == title]))


def slid(m, k, F, x0):
    """(half cycles, place, instant) by hand: each takes π√(m/k), and a half cycle turns at 2F/k less."""
    x, count = x0, 0
    while k * abs(x) > F:
        x = -(abs(x) - 2 * F / k) * math.copysign(1, x)
        count += 1
    return count, x, count * math.pi * math.sqrt(m / k)


@pytest.mark.sweep
def test_where_friction_brings_a_block_to_rest():
    draw = random.Random(11)
    for _ in range(8):
        m, k, F = draw.uniform(0.5, 5), draw.uniform(100, 2000), draw.uniform(2, 20)
        x0 = draw.uniform(-15, 15) * F / k
        count, place, instant = slid(m, k, F, x0)
        text = told(BLOCK.format(m=m, k=k, F=F, x0=x0), "Motion under dry friction")
        if not count:
            assert "it stays where it starts" in text
            continue
        numbers = re.search(r"after (\d+) half cycles?, t = (\S+) s, at x = (\S+) m", text).groups()
        assert int(numbers[0]) == count
        assert float(numbers[1]) == pytest.approx(instant, rel=1e-5)
        assert float(numbers[2].replace("−", "-")) == pytest.approx(place, rel=1e-5, abs=1e-9)


@pytest.mark.sweep
def test_a_motion_that_hardly_rubs_is_given_up():
    assert re.search(r"it still moves after \S+ s and \d+ half cycles",
                     told(BLOCK.format(m=1.0, k=400.0, F=0.01, x0=1.0), "Motion under dry friction"))


@pytest.mark.sweep
def test_the_period_of_a_wide_swing():
    T0 = 2 * math.pi * math.sqrt(2 * 0.8 / (3 * 9.81))
    for degrees in (10, 120, 179):
        text = told(ROD.replace("ANGLE", f"{degrees} deg"), "Period of the swing")
        T = 2 / math.pi * float(mpmath.ellipk(math.sin(math.radians(degrees) / 2) ** 2)) * T0
        found, f, ratio, small = map(float, re.search(
            r"T = (\S+) s, f = (\S+) Hz: (\S+) times that of small oscillations, (\S+) s", text).groups())
        assert found == pytest.approx(T, rel=1e-5) and f == pytest.approx(1 / T, rel=1e-5)
        assert ratio == pytest.approx(T / T0, rel=1e-4) and small == pytest.approx(T0, rel=1e-5)


@pytest.mark.parametrize("text", [
    ROD.replace("initial: {phi: ANGLE}\n", ""), ROD.replace("motion: full\n", "").replace("ANGLE", "2"),
    ROD.replace("ANGLE", "2") + "dampers: {d: {torsion: (1 N*m)*(1 s), between: [ground, rod]}}\n"])
def test_no_period_without_a_start_in_small_oscillations_or_with_a_damper(text):
    assert not told(text, "Period of the swing")


def test_what_has_no_energy_is_shared_by_no_mode():
    """Displaced along a rigid motion and let go, it stays; beside what vibrates its mode has no share."""
    loose = "bodies: {a: {mass: 100 kg, slide: x}, b: {mass: 1 kg, slide: y}}\n" \
            "springs: {s: {k: 2 N/m, between: [ground, a]}}\ninitial: {y: 0.1 m"
    still, moved = ("\n".join(section_lines(report(problem(loose + more), ["response"]).sections))
                    for more in ("}\n", ", x: 1 mm}\n"))
    assert "y = 0.1" in still and "share in the energy" not in still
    assert "share in the energy: mode 1: 0 %, mode 2: 100 %" in moved
