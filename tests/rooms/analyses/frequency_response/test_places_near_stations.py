"""Frequency responses at places next to others on a beam, against the closed form of a pinned beam."""

import mpmath
import pytest
from support.scenes import problem

from vibcli.language.signals_of_places import with_places
from vibcli.results.frequency_response import FrequencyResponse
from vibcli.symbolic.parser import parse

BEAM = """
    beams: {bridge: {length: 18 m, EI: 4.5e8 N*m^2, mass_per_length: 900 kg/m, left: pinned, right: pinned%s}}
    points: {engine: {body: bridge, at: 6 m}}
    forces: {drive: {at: engine, force: 3 kN*sin(30 rad/s*t)}}
"""
ORDERS = {"u": 0, "slope": 1, "moment": 2, "shear": 3}


def expected(part, x):
    """F/(2 EI β³)·(sin sin/sin − sinh sinh/sinh) and its derivatives by x on its own side of the force, F = 1."""
    L, a, EI = 18, mpmath.mpf(6), mpmath.mpf("4.5e8")
    beta, order = (900 * mpmath.mpf(30) ** 2 / EI) ** mpmath.mpf("0.25"), ORDERS[part]
    near, far, sign = (x, L - a, 1) if x < a else (L - x, a, (-1) ** order)
    hyperbolic = (mpmath.sinh if order % 2 == 0 else mpmath.cosh)(beta * near)
    circular = [mpmath.sin, mpmath.cos, lambda z: -mpmath.sin(z), lambda z: -mpmath.cos(z)][order](beta * near)
    found = (circular * mpmath.sin(beta * far) / mpmath.sin(beta * L)
             - hyperbolic * mpmath.sinh(beta * far) / mpmath.sinh(beta * L))
    return sign * found / (2 * EI * beta**3) * beta**order * (EI if order > 1 else 1)


@pytest.mark.parametrize("apart", ["-1e-11", "1e-9", "-1e-7", "-1e-6", "1e-6", "1e-4", "1e-3", "0.01", "0.3", "-0.3",
                                   "-3", "-5.9"])
@pytest.mark.parametrize("part", ORDERS)
def test_no_digits_are_lost_next_to_a_station(part, apart):
    with mpmath.workdps(40):
        x = 6 + mpmath.mpf(apart)
        right = expected(part, x)
        value, error = FrequencyResponse(problem(BEAM % ""), f"bridge.{part}({mpmath.nstr(x, 20)} m)", "drive").at(30.0)
        assert abs(value - right) <= error * abs(value)
        assert abs(value / right - 1) < 2e-12 and error < 1e-10


@pytest.mark.parametrize("apart", ["0.001", "1e-5", "1e-7"])
def test_stations_near_each_other_are_no_resonance(apart):
    one, other = (FrequencyResponse(problem(BEAM % f", attached: [{{at: 6 m + {far} m, k: 1 kN/m}}]"),
                                    "bridge.moment(9 m)", "drive").at(30.0) for far in (apart, "0"))
    assert one[0] == pytest.approx(other[0], rel=float(apart))
    assert one[1] < 1e-11


@pytest.mark.parametrize("x", ["17.9999999999", "17.9999999", "1e-10"])
def test_the_rounding_of_a_place_is_part_of_the_error(x):
    with mpmath.workdps(40):
        right = expected("u", mpmath.mpf(x))
        value, error = FrequencyResponse(problem(BEAM % ""), f"bridge.u({x} m)", "drive").at(30.0)
        assert abs(value - right) <= error * abs(value)
        assert error < 1e-3


@pytest.mark.sweep
@pytest.mark.parametrize("x", ["5.99999999", "6.0000001", "5.99999"])
def test_motions_in_time_next_to_a_station_are_those_there(x):
    scene = problem(BEAM % "")
    near, there = (scene.response.signal(with_places(parse(f"bridge.u({place} m)"), scene.spec.members))
                   for place in (x, "6"))
    assert near.values([0.31])[0] == pytest.approx(there.values([0.31])[0], rel=1e-5)
    assert near.error(0.31) < 1e-10 * abs(there.values([0.31])[0])
