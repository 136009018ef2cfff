"""The rule of Dormand and Prince: its order and error estimate; polynomials of fifth degree between steps, and those of
Gauss's rules within."""

from math import cos, sin

import numpy as np
import pytest

from vibcli.numerics.collocation_rule import rule
from vibcli.numerics.dormand_prince import END, A, C, stepper
from vibcli.numerics.hermite import quintic


def force(t, x, y, u, v):
    """Of x = sin t, y = e^(−t/2), each by a nonlinear equation of both, that they solve."""
    return -x + (u - cos(t)) * y, y / 4 + (v + y / 2) * x


def exact(t):
    y = np.exp(-t / 2)
    return (sin(t), float(y)), (cos(t), float(-y / 2))


def stepped(h):
    q, v = exact(0.3)
    return stepper(2)(force, 0.3, h, q, v, force(0.3, *q, *v), (1.0,) * 4)


def test_stages_stand_where_their_rows_say():
    assert np.allclose([sum(row.values()) for row in A], C, atol=1e-14)
    assert len(A) == END + 1 and C[END] == 1


def test_the_order_is_eight_and_the_estimate_falls_as_it():
    errors, estimates = [], []
    for h in (0.8, 0.4):
        error, q, v, a = stepped(h)
        true = exact(0.3 + h)
        errors.append(max(abs(np.array([*q, *v]) - [*true[0], *true[1]])))
        estimates.append(error)
        assert a == force(0.3 + h, *q, *v)
    assert 2.0**7.5 < errors[0] / errors[1] < 2.0**11
    assert estimates[0] > errors[0] and estimates[1] > errors[1]


def test_polynomials_of_fifth_degree_go_through_both_ends_of_a_step():
    random, times = np.random.default_rng(5), np.array([0.3, 0.7, 1.5])
    powers = [np.polynomial.Polynomial(random.normal(size=6)) for _ in range(2)]
    rows = (np.array([one.deriv(k)(times) for one in powers]).T for k in range(3))
    at = np.array([[0.3, 0.4, 0.7], [0.9, 1.2, 1.5]])
    for k, found in enumerate(quintic(times, *rows)(at)):
        assert np.allclose(found, np.stack([one.deriv(k)(at) for one in powers], axis=1), rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("radau", [False, True])
def test_values_within_a_part_of_a_window_are_those_of_its_polynomials(radau):
    chosen = rule(9, radau)
    values = np.vander(chosen.c, 9).T
    assert np.allclose(chosen.within(values, 0.7), np.vander(0.7 * chosen.c, 9).T, atol=1e-12)
    assert np.array_equal(chosen.basis_at(chosen.c), chosen.basis_at(chosen.c.copy()))
    assert np.abs(chosen.basis_at(chosen.c) - chosen.basis(2 * chosen.c - 1)).max() < 1e-14
