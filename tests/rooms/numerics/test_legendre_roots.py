"""Roots of many Legendre series: those of companion matrices, those that nearly coincide, those at the ends."""

import mpmath
import numpy as np
import pytest
from numpy.polynomial import legendre, polynomial

from vibcli.numerics import legendre_roots
from vibcli.numerics.legendre_roots import coming_to, numbered_roots, overshoot, roots, sampled, slopes


def of_roots(*places, count=40):
    """The Legendre series, of so many terms, that vanishes at some places."""
    return np.pad(legendre.poly2leg(polynomial.polyfromroots(places)), (0, count - len(places) - 1))


@pytest.mark.parametrize("decay", [0.3, 0.6, 1.0])
def test_they_are_those_of_a_companion_matrix(decay, monkeypatch):
    series = np.random.default_rng(4).normal(size=(150, 40)) * decay ** np.arange(40)
    taken, companion = [], legendre_roots._of_companion
    monkeypatch.setattr(legendre_roots, "_of_companion", lambda one: taken.append(1) or companion(one))
    found = roots(series)
    assert decay == 1.0 or len(taken) < 15      # what is not resolved is not told by signs
    for row, places in zip(series, found, strict=True):
        expected = [x.real for x in legendre.legroots(row) if abs(x.imag) < 1e-9 and abs(x.real) <= 1]
        assert len(places) == len(expected)
        assert np.abs(places - np.sort(expected)).max(initial=0.0) < 1e-9


@pytest.mark.parametrize("apart", [1e-2, 1e-4, 1e-6])
def test_two_that_nearly_coincide_are_both_found(apart):
    (found,) = roots(of_roots(0.3, 0.3 + apart, 0.9)[None])
    assert np.abs(found - [0.3, 0.3 + apart, 0.9]).max() < 1e-8
    (found,) = roots((of_roots(0.3, 0.3 + 1e-6, 0.9) - of_roots(0.3, 0.3, 0.9))[None])      # 1e-6 (0.3 - x)(x - 0.9)
    assert np.abs(found - [0.3, 0.9]).max() < 1e-8


def test_roots_to_the_last_digits_and_at_the_ends():
    found = roots(np.array([np.eye(40)[39], of_roots(-1.0, 0.5), of_roots(1.0 + 1e-13, -0.5)]))
    with mpmath.workdps(30):
        exact = mpmath.polyroots(mpmath.taylor(lambda x: mpmath.legendre(5, x), 0, 5)[::-1], maxsteps=200)
    assert np.abs(roots(np.eye(40)[5:6])[0] - sorted(map(float, exact))).max() < 4e-16
    assert len(found[0]) == 39 and np.abs(found[0] - np.sort(legendre.leggauss(39)[0])).max() < 1e-15
    assert np.abs(found[1] - [-1.0, 0.5]).max() < 1e-15 and np.abs(found[2] - [-0.5, 1.0]).max() < 1e-12


def test_what_vanishes_or_does_not_reach_zero_has_none():
    found = roots(np.array([[0.0, 0, 0], [2.0, 1, 0], [1e-300, 0, 0], [0.0, 1, 0]]))
    assert [len(one) for one in found] == [0, 0, 0, 1]
    assert not len(roots(np.zeros((0, 40))))


@pytest.mark.parametrize("decay", [0.3, 0.8, 1.0])
def test_no_series_is_larger_than_its_samples_tell(decay):
    """Whatever its coefficients: 1.2 % of its range beyond them."""
    series = np.random.default_rng(1).normal(size=(50, 40)) * decay ** np.arange(40)
    dense, values = series @ legendre.legvander(np.linspace(-1, 1, 20_001), 39).T, sampled(series)
    middle, reach = 0.5 * (values.max(axis=1) + values.min(axis=1)), 0.5 * np.ptp(values, axis=1)
    assert (dense.max(axis=1) <= middle + reach * overshoot(40)).all() and overshoot(40) < 1.012


@pytest.mark.parametrize("decay", [0.3, 0.6, 0.9])
def test_no_maximum_that_comes_to_a_level_is_passed_over(decay):
    """In few cells all turns are found that come to it, those that all rows have alike among them."""
    series = np.random.default_rng(7).normal(size=(40, 40)) * decay ** np.arange(40)
    series = np.concatenate([series, series[:5] * (1 - 1e-15)])
    rates, x = slopes(series), np.linspace(-1, 1, 20_001)
    dense = series @ legendre.legvander(x, 39).T
    for part in (0.0, 0.02, 0.5):
        level = dense.max() - part * np.ptp(dense)
        cells = coming_to(level, series, sampled(series))
        rows, places = numbered_roots(rates, cells)
        every = [(k, place) for k, some in enumerate(roots(rates)) for place in some
                 if legendre.legval(place, series[k]) >= level]
        for k, place in every:
            assert np.abs(places[rows == k] - place).min(initial=1.0) < 1e-9
        assert (part == 0.5 or cells.mean() < 0.01) and (np.diff(rows) >= 0).all()


def test_roots_begin_a_step_from_their_last_digits(monkeypatch):
    steps, polished = [], legendre_roots._polished
    monkeypatch.setattr(legendre_roots, "_polished", lambda *args: steps.append(
        np.abs(polished(*args) - args[2]).max(initial=0.0)) or polished(*args))
    roots(np.random.default_rng(4).normal(size=(150, 40)) * 0.4 ** np.arange(40))
    assert len(steps) == 1 and steps[0] < 1e-10
