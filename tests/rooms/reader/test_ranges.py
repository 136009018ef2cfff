"""Ranges of varied parameters: exact decimals of the unit as written; radians may stand for degrees."""

from fractions import Fraction

import pytest
from support.scenes import problem

from vibcli.base.errors import SpecError

SCENE = ("parameters: {{rho: 1000 kg/m^3, A: 4 cm^2, L: 0.9 m, a: 30 deg, g: 9.81 m/s^2}}\n"
         "coordinates: {{x: along it}}\nenergies: {{T: rho*A*L*x'^2/2, V: rho*A*g*sin(a)*x^2}}\n"
         "answers:\n  omega[1]: sqrt(2*g*sin(a)/L)\nvariants: {{parameters: {{a: {{{written}}}}}}}\n")


def values(written):
    axis, = problem(SCENE.format(written=written)).spec.get("variants").axes
    return [value.number for value in axis["a"]]


@pytest.mark.parametrize(("written", "found"), [
    ("from: 20 deg, to: 40 deg, step: 5 deg", [20, 25, 30, 35, 40]),
    ("from: 0.1 deg, to: 0.7 deg, step: 0.3 deg", [Fraction(1, 10), Fraction(4, 10), Fraction(7, 10)]),
    ("from: 20 deg, to: 0.6981317007977318 rad, step: 10 deg", [20, 30, 40]),
])
def test_steps_are_exact_in_the_unit_as_written(written, found):
    assert values(written) == found


def test_radians_that_stand_for_degrees_reach_their_end():
    found = values("from: 0.4363323129985824, to: 1.117010721276371, step: 0.05235987755982988")
    assert len(found) == 14 and found[-1] == Fraction("1.117010721276371")


@pytest.mark.parametrize(("written", "last"), [
    ("from: 20 deg, to: 41 deg, step: 5 deg", "40 deg"),
    ("from: 20 deg, to: 40.00000001 deg, step: 5 deg", "40 deg"),
    ("from: 0.1, to: 1, step: 0.29999999999", "0.99999999997"),
    ("from: 0.1, to: 0.2, step: 1e13", "0.1"),
])
def test_steps_that_miss_their_end_are_refused(written, last):
    with pytest.raises(SpecError) as refusal:
        values(written)
    diagnostic, = refusal.value.diagnostics
    assert diagnostic.message.startswith("the steps miss") and diagnostic.hint == f"the last one is {last}"
