"""Natural modes followed by their shapes: they cross where nothing couples them, and veer where something does."""

import numpy as np
import pytest

from vibcli.results.branches import NaturalModesAt, followed


def two(coupling):
    """The NaturalModesAt of unit masses on k and 100 N/m, tied by a spring, as a function of k."""
    def at(k):
        values, vectors = np.linalg.eigh(np.array([[k + coupling, -coupling], [-coupling, 100 + coupling]]))
        return NaturalModesAt(k, np.sqrt(values), vectors)

    return at


@pytest.mark.parametrize("count", [3, 8, 101])
def test_they_cross(count):
    spectra = [two(0.0)(k) for k in np.linspace(50, 171, count)]
    found = followed(spectra, two(0.0))
    one, = found.meetings
    assert one.crosses and one.branches == (1, 2) and one.value == pytest.approx(100, rel=1e-11)
    assert found.branches[0].tolist() == [1, 2] and found.branches[-1].tolist() == [2, 1]


@pytest.mark.parametrize("coupling", [1.0, 1e-3, 1e-6])
@pytest.mark.parametrize("count", [4, 30, 301])
def test_they_veer(coupling, count):
    found = followed([two(coupling)(k) for k in np.linspace(50, 171, count)], two(coupling))
    one, = found.meetings
    gap = 2 * (np.sqrt(100 + 2 * coupling) - 10) / (np.sqrt(100 + 2 * coupling) + 10)
    assert not one.crosses and one.value == pytest.approx(100, rel=3e-4)
    assert one.gap == pytest.approx(gap, rel=1e-3)
    assert all(label.tolist() == [1, 2] for label in found.branches)


def test_distant_frequencies_do_not_meet():
    found = followed([two(40.0)(k) for k in np.linspace(50, 171, 31)], two(40.0))
    assert found.meetings == []


def test_three_branches_of_which_two_cross():
    def at(k):
        omega = np.array([k, 10.0, 14.0])
        order = np.argsort(omega)
        return NaturalModesAt(k, omega[order], np.eye(3)[:, order])

    found = followed([at(k) for k in np.linspace(8, 17, 7)], at)
    assert [(one.branches, round(one.value, 9)) for one in found.meetings] == [((1, 2), 10.0), ((1, 3), 14.0)]
    assert found.branches[-1].tolist() == [2, 3, 1]


def test_what_has_no_modes_is_passed_over():
    spectra = [two(0.0)(k) for k in np.linspace(50, 171, 8)]
    found = followed([None, *spectra[:2], None, *spectra[2:]], two(0.0))
    assert found.branches[0] is None and found.branches[3] is None and len(found.meetings) == 1
