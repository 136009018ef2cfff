"""The rule of Dormand and Prince: its order, polynomials and error estimate; polynomials of Gauss's rules within."""

from math import cos, sin

import numpy as np
import pytest

from vibcli.numerics.collocation_rule import rule
from vibcli.numerics.dormand_prince import END, STAGE_MATRIX, STAGES, A, C, stepper, weights


def force(t, x, y, u, v):
    """Of x = sin t, y = e^(−t/2), each by a nonlinear equation of both, that they solve."""
    return -x + (u - cos(t)) * y, y / 4 + (v + y / 2) * x


def exact(t):
    y = np.exp(-t / 2)
    return (sin(t), float(y)), (cos(t), float(-y / 2))


def stepped(h):
    step, dense = stepper(2)
    q, v = exact(0.3)
    found = step(force, 0.3, h, q, v, force(0.3, *q, *v), (1.0,) * 4)
    return found, np.array([*found[3], *dense(force, 0.3, h, q, v, found[3])])


def test_stages_stand_where_their_rows_say():
    assert np.allclose(STAGE_MATRIX.sum(axis=1), C, atol=1e-14)
    assert len(A) == STAGES and C[END] == 1


def test_the_order_is_eight_and_the_estimate_falls_as_it():
    errors, estimates = [], []
    for h in (0.8, 0.4):
        (error, q, v, stages), _ = stepped(h)
        true = exact(0.3 + h)
        errors.append(max(abs(np.array([*q, *v]) - [*true[0], *true[1]])))
        estimates.append(error)
        assert stages[END] == force(0.3 + h, *q, *v)
    assert 2.0**7.5 < errors[0] / errors[1] < 2.0**11
    assert estimates[0] > errors[0] and estimates[1] > errors[1]


@pytest.mark.parametrize("x", [0.0, 0.13, 0.5, 0.87, 1.0])
def test_its_polynomials_hold_between_the_ends(x):
    h = 0.2
    _, stages = stepped(h)
    q, v = (np.array(part) for part in exact(0.3))
    speeds = v + h * STAGE_MATRIX @ stages
    b = h * weights(np.array([x]))[0]
    true = exact(0.3 + x * h)
    assert np.abs(q + b @ speeds - true[0]).max() < 1e-11
    assert np.abs(v + b @ stages - true[1]).max() < 1e-11


@pytest.mark.parametrize("radau", [False, True])
def test_values_within_a_part_of_a_window_are_those_of_its_polynomials(radau):
    chosen = rule(9, radau)
    values = np.vander(chosen.c, 9).T
    assert np.allclose(chosen.within(values, 0.7), np.vander(0.7 * chosen.c, 9).T, atol=1e-12)
    assert np.array_equal(chosen.basis_at(chosen.c), chosen.basis_at(chosen.c.copy()))
    assert np.abs(chosen.basis_at(chosen.c) - chosen.basis(2 * chosen.c - 1)).max() < 1e-14
