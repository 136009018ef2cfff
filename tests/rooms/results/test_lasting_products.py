"""Means of squares and products of what vibrates freely, by closed forms: u(L) of a bar that is pulled and let go runs
evenly between ±a, and ⟨u(L) u(x)⟩ of a cantilever, φₙ(L)² = 4/(μL), is 2P²/L ∫ G(L, ξ) G(ξ, x) dξ."""

import mpmath
import pytest
from support.motions import problem

from vibcli.base.errors import PhysicsError
from vibcli.language.signals_of_places import with_places
from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

BAR = """
parameters: {L: 1 m, a: 1 mm}
bars: {rod: {length: L, EA: 3 kN, mass_per_length: 1 kg/m, left: clamped}}
initial: {rod.u: a*x/L}
"""
BEAM = """
parameters: {L: 1 m, a: 1 cm}
beams: {arm: {length: L, EI: 24 N*m^2, mass_per_length: 0.4 kg/m, left: clamped}}
initial: {arm.u: a*(x/L)^2*(3 - x/L)/2}
"""


def compared(scene, text, value):
    found, error = measure(scene, with_places(parse(text), scene.spec.members))
    assert found == pytest.approx(value, rel=1e-12), text
    assert abs(found - value) <= error * abs(found) <= 1e-11 * abs(found), text


@pytest.mark.sweep
def test_functions_of_what_waves_bring_back():
    scene = problem(BAR)
    for text, value in {"mean(rod.u(L)^2)": 1e-6 / 3, "mean(abs(rod.u(L)))": 5e-4, "mean(rod.u(L)^4)": 1e-12 / 5,
                        "rms(rod.u(L)^2)": 1e-6 / 5**0.5, "mean(rod.u(L)*rod.u(L/2))": 11e-6 / 48}.items():
        compared(scene, text, value)


@pytest.mark.sweep
def test_squares_and_products_of_what_goes_by_modes():
    scene, force = problem(BEAM), 3 * 24 * 0.01

    def green(x, xi):
        x, xi = max(x, xi), min(x, xi)
        return xi**2 * (3 * x - xi) / (6 * 24)

    def expected(x):
        return float(2 * force**2 * mpmath.quad(lambda xi: green(1, xi) * green(x, xi), [0, x, 1]))
    assert expected(1) == pytest.approx(33e-4 / 70, rel=1e-14)
    for text, value in {"arm.u(L)^2": expected(1), "arm.u(L)*arm.u(L/2)": expected(0.5),
                        "(2*arm.u(L) - arm.u(L/2))*arm.u(L) + 1 cm^2": 2 * expected(1) - expected(0.5) + 1e-4}.items():
        compared(scene, f"mean({text})", value)
    for text in ("mean(arm.u(L)^4)", "mean(abs(arm.u(L)))"):
        with pytest.raises(PhysicsError, match="sums of squares and of products of two signals"):
            measure(scene, with_places(parse(text), scene.spec.members))
