"""Damped modes of members by ratios of their modes beside dampers: against closed sums over all modes in mpmath."""

import mpmath
import numpy as np
import pytest
from support.scenes import problem

BAR = """
bars:
  rod: {{length: 1 m, EA: 1 N, mass_per_length: 1 kg/m, left: clamped, right: {{c: {c} N*s/m}}}}
damping: {{modal: {zeta}}}
"""


def frequency_equation(zeta, c):
    """1 + s c Σ 2/(ω² + 2ζωs + s²) over ω = (n + ½)π, the sum by digamma functions."""
    turn = mpmath.mpf(zeta) + mpmath.sqrt(mpmath.mpc(mpmath.mpf(zeta)**2 - 1))

    def value(s):
        a, b = s * turn, s / turn
        apart = mpmath.digamma(0.5 + b / mpmath.pi) - mpmath.digamma(0.5 + a / mpmath.pi)
        return 1 + 2 * s * mpmath.mpf(c) * apart / (mpmath.pi * (b - a))

    return value


@pytest.mark.sweep
@pytest.mark.parametrize(("zeta", "c"), [("0.02", "0.3"), ("0.3", "1.5"), ("1.3", "0.3")])
def test_those_of_a_bar_are_the_roots_of_its_frequency_equation(zeta, c):
    modes = problem(BAR.format(zeta=zeta, c=c)).modal.damped
    with mpmath.workdps(30):
        value = frequency_equation(zeta, c)
        for mode in modes.numbered(1, 4):
            told = mpmath.mpc(mode.eigenvalue)
            root = mpmath.findroot(value, (told, told * (1 + mpmath.mpf(10)**-8)), tol=1e-40)
            assert abs(root - told) <= mode.error * abs(root) < 1e-12


@pytest.mark.sweep
def test_their_number_is_that_of_zeros_and_poles_of_the_frequency_equation():
    modes = problem(BAR.format(zeta="0.85", c="0.3")).modal.damped
    modes.numbered(1, 4)
    radius = modes.region.radius
    s = radius * np.exp(2j * np.pi * np.arange(401) / 400)
    value = frequency_equation("0.85", "0.3")
    values = np.array([complex(value(mpmath.mpc(x))) for x in s])
    turns = round(np.angle(values[1:] / values[:-1]).sum() / (2 * np.pi))
    poles = 2 * int(((np.arange(50) + 0.5) * np.pi < radius).sum())
    assert modes.region.count == turns + poles


def test_modes_with_a_node_at_the_damper_keep_their_ratio():
    scene = """
strings:
  cord: {length: 1 m, preload: 1 N, mass_per_length: 1 kg/m, left: clamped, right: clamped,
         attached: [{at: 0.5 m, c: 0.5 N*s/m}]}
damping: {modal: [2 %, 3 %]}
"""
    found = problem(scene).modal.damped.numbered(1, 4)
    assert [float(found[k].omega) for k in (1, 3)] == pytest.approx([2 * np.pi, 4 * np.pi], rel=1e-14)
    assert [found[k].zeta for k in (1, 3)] == pytest.approx([0.03, 0.03], rel=1e-12)
    assert found[0].zeta > 0.15


def test_a_free_bar_keeps_one_motion_at_rest():
    scene = BAR.replace("left: clamped, ", "").format(zeta="2 %", c="0.3")
    modes = problem(scene).modal.damped
    found = modes.numbered(1, 3)
    assert [found[0].eigenvalue, found[1].eigenvalue.imag] == [0, 0]
    assert modes.region.count == 2 + 2 * sum(1 for one in modes.region.modes if one.omega_d)


@pytest.mark.sweep
def test_two_terms_of_a_series_are_proportional_damping():
    rest = BAR.replace("damping: {{modal: {zeta}}}", "damping: {damping}").replace("{{", "{").replace("}}", "}")
    rest = rest.replace("{c}", "0.3")
    first, fourth = 0.5 * np.pi, 3.5 * np.pi
    alpha, beta = np.linalg.solve([[1, first**2], [1, fourth**2]], [2 * 0.01 * first, 2 * 0.02 * fourth])
    one = problem(rest.replace("{damping}", "{caughey: {1: 1 %, 4: 2 %}}")).modal.damped.numbered(1, 4)
    proportional = f"{{proportional: [{float(alpha)!r} s^-1, {float(beta)!r} s]}}"
    other = problem(rest.replace("{damping}", proportional)).modal.damped
    for mode, known in zip(one, other.numbered(1, 4), strict=True):
        assert complex(mode.eigenvalue) == pytest.approx(complex(known.eigenvalue), rel=1e-12)


def test_units_are_arbitrary():
    stiff = BAR.replace("EA: 1 N", "EA: 1e18 N").replace("N*s/m", "GN*s/m").format(zeta="2 %", c="0.3")
    plain = BAR.format(zeta="2 %", c="0.3")
    one, other = (problem(scene).modal.damped.numbered(1, 2)[1] for scene in (stiff, plain))
    assert complex(one.eigenvalue) == pytest.approx(1e9 * complex(other.eigenvalue), rel=1e-12)
    assert abs(one.shape[0]) == pytest.approx(abs(other.shape[0]), rel=1e-12)


def test_shapes_have_unit_modal_mass():
    mode = problem(BAR.format(zeta="0.5", c="1.5")).modal.damped.numbered(2, 2)[0]
    s, omega = complex(mode.eigenvalue), (np.arange(20000) + 0.5) * np.pi
    size = 2 * (abs(omega**2 + omega * s + s * s)**-2.0).sum()
    moved = (complex(frequency_equation("0.5", "1.5")(mpmath.mpc(s))) - 1) / (1.5 * s)
    assert abs(mode.shape[0]) == pytest.approx(abs(moved) / size**0.5, rel=1e-11)
