"""Modes without end: what is asked of them finds no more than it needs, and what walks through all is refused."""

from math import pi

import numpy as np
import pytest
from support.scenes import problem, value

from vibcli.analyses.modal.mode_sequence import Modes
from vibcli.analyses.modal.stability import stability
from vibcli.analyses.modal.undamped import Mode
from vibcli.api.model import Model
from vibcli.base.errors import PhysicsError
from vibcli.drawing.vibration import caption, mode

TWO = """
    bodies: {a: {mass: 2 kg, slide: x}, b: {mass: 2 kg, slide: y}}
    springs: {s: {k: 50 N/m, between: [ground, a]}, t: {k: 50 N/m, between: [a, b]}}
"""


class Rod:
    """Modes without end: some that grow, some rigid ones, and ω = i π for i from 1; `asked`: (first, last) so far."""

    def __init__(self, growing=0, rigid=0):
        self.growing, self.rigid, self.asked = growing, rigid, []

    def numbered(self, first, last):
        self.asked.append((first, last))
        return [self._mode(index) for index in range(first, last + 1)]

    def count(self, Omega):
        return self.growing + self.rigid + int(Omega / pi)

    def counted_above(self, mode):
        return mode.index

    def _mode(self, index):
        shape, beyond = np.array([1.0, (-1.0) ** index]), index - self.growing - self.rigid
        rates = (None, 1.0 / index) if index <= self.growing else (max(0, beyond) * pi, None)
        return Mode(index, *rates, shape, shape, 1e-16)


def indices(modes):
    return [one.index for one in modes]


@pytest.mark.parametrize(("growing", "rigid"), [(0, 0), (0, 1), (2, 0), (1, 3), (9, 4)])
def test_the_unstable_the_rigid_and_five_more_are_shown(growing, rigid):
    source = Rod(growing, rigid)
    assert indices(Modes((), source).shown()) == list(range(1, growing + rigid + 6))
    assert max(last for _, last in source.asked) == growing + rigid + 5


def test_no_more_is_found_than_is_asked_and_nothing_twice():
    source = Rod()
    modes = Modes((), source)
    assert modes[3].index == 4 and indices(modes[:3]) == [1, 2, 3] and indices(modes.first(2)) == [1, 2]
    assert source.asked == [(1, 4)]
    assert indices(modes.numbered(3, 6)) == [3, 4, 5, 6] and source.asked == [(1, 4), (5, 6)]
    assert indices(modes.up_to(9 * pi + 1)) == list(range(1, 10)) and source.asked[-1] == (7, 9)
    assert indices(modes.numbered(990, 1000)) == indices(modes.numbered(990, 1000)) == list(range(990, 1001))
    assert source.asked[3:] == [(990, 1000)]
    assert indices(modes.between(2000 * pi + 1, 13000 * pi + 1)) == list(range(2001, 13001))
    assert source.asked[4:] == [(2001, 12000), (12001, 13000)] and modes.between(1.0, 2.0) == []


def test_what_needs_all_of_them_is_refused():
    modes = Modes((), Rod())
    assert modes and not modes.finite
    for walk in (len, list, tuple, lambda m: m[-1], lambda m: m[2:], lambda m: m[:-1], lambda m: [*m],
                 lambda m: list(reversed(m)), lambda m: sorted(m)):
        with pytest.raises(PhysicsError, match="without end"):
            walk(modes)
    for ask in (lambda: modes.first(10**6), lambda: modes.up_to(1e9)):
        with pytest.raises(PhysicsError, match="at most 10000"):
            ask()


def test_finite_ones_are_a_list():
    known = Rod().numbered(1, 3)
    modes = Modes(known)
    assert (len(modes), list(modes), modes[-1], modes[1:], modes.shown()) == (3, known, known[2], known[1:], known)
    assert modes.first(7) == known and modes.numbered(2, 9) == known[1:] and modes.up_to(2 * pi) == known[:2]
    assert modes.between(1.5 * pi, 9 * pi) == known[1:]
    assert not Modes([]) and Modes(known) and modes.finite


def endless(text, **counts):
    """A problem whose modes are those of a rod."""
    scene, source = problem(text), Rod(**counts)
    scene.modal.__dict__["modes"] = Modes((), source, scene.modal.solved)
    return scene, source


def test_quantities_ask_for_what_they_name():
    scene, source = endless(TWO)
    assert value(scene, "omega[7]") == 7 * pi and source.asked == [(1, 7)]
    assert value(scene, "frequency[1000]") == pytest.approx(500.0) and source.asked == [(1, 7), (1000, 1000)]
    assert value(scene, "mode[2][y]") == 1.0 and value(scene, "period[1]") == 2.0
    assert value(scene, "modal_mass[1]") == 4.0 and len(source.asked) == 2


def test_pictures_and_stability_go_by_those_that_are_shown():
    scene, _ = endless(TWO, rigid=1)
    assert caption(mode(scene, 8)).startswith("mode 8: ω = 21.99")
    assert stability(endless(TWO)[0].modal).kind == "stable"
    assert stability(endless(TWO, growing=1)[0].modal).growth_rate == 1.0


def test_arrays_have_those_that_are_shown():
    found = Model(None, endless(TWO)[0], {})
    assert found.omega.tolist() == [i * pi for i in range(1, 6)] and found.modes.shape == (2, 5)


def test_shares_and_sensitivities_are_refused_by_name():
    with pytest.raises(PhysicsError, match="shares and sensitivities"):
        endless(TWO)[0].modal.result("sensitivities")
