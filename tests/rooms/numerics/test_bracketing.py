"""Zeros of a function in many intervals at once: to rounding, in few rounds, whatever the function is like."""

import numpy as np
import pytest

from vibcli.numerics.bracketing import zeros_between


class Counted:
    """A function, and how many places it was asked at in each round."""

    def __init__(self, function):
        self.function, self.rounds = function, []

    def __call__(self, x):
        self.rounds.append(len(x))
        return self.function(x)


SHAPES = {
    "smooth": (lambda x: np.cos(x) - x, 0.7390851332151607, 0.0, 1.5, 10),
    "flat": (lambda x: (x - 1.25)**9, 1.25, 0.0, 3.0, 150),
    "steep": (lambda x: np.tanh(1e6 * (x - 0.3)), 0.3, -1.0, 1.0, 60),
    "signs": (lambda x: np.sign(x - 1 / 3), 1 / 3, 0.0, 1.0, 60),
    "pole at an end": (lambda x: 1 / x - 4, 0.25, 0.0, 7.0, 60),
}


@pytest.mark.parametrize("name", SHAPES)
def test_a_zero_of_a_function_of_any_shape(name):
    function, at, low, high, most = SHAPES[name]
    asked = Counted(function)
    with np.errstate(all="ignore"):
        (found,) = zeros_between(asked, np.array([low]), np.array([high]))
    assert found == pytest.approx(at, rel=1e-15 if name != "flat" else 1e-14, abs=0)
    assert len(asked.rounds) <= most


def test_a_hundred_zeros_of_the_sine():
    k = np.arange(1, 101)
    asked = Counted(np.sin)
    found = zeros_between(asked, (k - 0.4) * np.pi, (k + 0.3) * np.pi)
    assert np.abs(found - k * np.pi).max() <= 2.0**-51 * 100 * np.pi
    assert len(asked.rounds) <= 12 and sum(asked.rounds) <= 1000


def test_zeros_on_stairs_are_found_in_few_rounds():
    """Stairs as rounding makes them, of which one lies on the zero but for a thousandth."""
    k = np.arange(1, 101)
    asked = Counted(lambda x: np.floor(np.sin(x) * 2.0**44) + 1e-3)
    found = zeros_between(asked, (k - 0.4) * np.pi, (k + 0.3) * np.pi)
    assert np.abs(found - k * np.pi).max() <= 2.0**-44 + 2.0**-51 * 100 * np.pi
    assert len(asked.rounds) <= 20 and sum(asked.rounds) <= 1200


def test_each_interval_has_its_level():
    level = np.array([0.1, 0.5, 0.9])
    found = zeros_between(np.sin, np.zeros(3), np.full(3, 1.5), level)
    assert found == pytest.approx(np.arcsin(level), rel=1e-15)


def test_no_value_counts_as_a_zero():
    """Where a function has no value, the place is taken as the one that is sought."""
    found = zeros_between(lambda x: np.where(np.abs(x - 0.5) < 0.01, np.nan, x - 0.5), np.zeros(1), np.ones(1))
    assert found == pytest.approx(0.5, abs=0.01)


def test_no_interval_no_zero():
    assert len(zeros_between(np.sin, np.zeros(0), np.zeros(0))) == 0
