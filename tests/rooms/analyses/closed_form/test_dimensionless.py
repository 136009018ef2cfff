"""|H| of one degree by r = Ω/ω and ζ is |H|, of loads, unbalances and bases."""

import math
import random

import pytest
from support.scenes import problem

from vibcli.analyses.closed_form.dimensionless import BASE, CONSTANT, SQUARE, dimensionless
from vibcli.notation.plain import plain
from vibcli.report.formats.formula import formula as written
from vibcli.report.sections.symbolic_response import ratio_lines
from vibcli.symbolic.evaluation import Floats, evaluate

BLOCK = """
parameters: {{m: , k: , c: , F: , e: , Omega: }}
bodies: {{block: {{mass: m, slide: x}}{bodies}}}
springs: {{s: {{k: k, between: [{base}, block]}}}}
dampers: {{d: {{c: c, between: [{base}, block]}}}}
{forces}
"""
LOAD = BLOCK.format(bodies="", base="ground", forces="forces: {L: {at: block, force: F*sin(Omega*t)}}").replace(
    "e: , ", "")
SHAKEN = BLOCK.format(bodies=", base: {slide: e*sin(Omega*t)}", base="base", forces="").replace("F: , ", "")
TURNING = BLOCK.format(bodies="", base="ground",
                       forces="forces: {L: {at: block, force: F*e*Omega^2*sin(Omega*t)}}")
FACTORS = {CONSTANT: lambda r, zeta: 1.0, SQUARE: lambda r, zeta: r * r,
           BASE: lambda r, zeta: math.sqrt(1 + (2 * zeta * r) ** 2)}


def size(found, values):
    """The amplitude by gain, r and ζ."""
    omega, gain = evaluate([found.omega, found.gain], Floats, values)
    zeta = 0.0 if found.zeta is None else evaluate([found.zeta], Floats, values)[0]
    r = values["Omega"] / omega
    return gain * FACTORS[found.above](r, zeta) / math.hypot(1 - r * r, 2 * zeta * r)


@pytest.mark.parametrize("damped", [True, False])
@pytest.mark.parametrize(("text", "above"), [(LOAD, CONSTANT), (SHAKEN, BASE), (TURNING, SQUARE)])
def test_it_is_the_amplitude(text, above, damped):
    if not damped:
        text, above = text.replace("dampers:", "# ").replace("c: , ", ""), CONSTANT if above == BASE else above
    steady = problem(text).symbolic_steady_state("x").formula
    found, draw = dimensionless(steady), random.Random(5)
    assert found.above == above and (found.zeta is None) is not damped
    for _ in range(20):
        values = {name: draw.uniform(0.2, 3) for name in ("m", "k", "c", "F", "e", "Omega")}
        assert abs(size(found, values)) == pytest.approx(
            abs(evaluate([steady.amplitude], Floats, values)[0]), rel=1e-12)


def test_as_a_textbook_writes_it():
    found = problem(LOAD.replace("k: ,", "r: ,").replace("k: k", "k: r"))
    lines = [written(one.parts, plain) for one in ratio_lines(found, found.symbolic_steady_state("x").formula, "X")]
    assert lines == ["X = F/r·1/√((1 − η²)² + (2·ζ·η)²)", "with η = Ω/ω,  ω = √(r/m),  ζ = c/(2·√(m·r))"]
