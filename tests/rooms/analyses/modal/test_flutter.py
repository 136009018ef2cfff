"""Flutter and divergence of known systems: a column under a following load, an aerofoil, dampers that push."""

import math
import random
from fractions import Fraction
from types import SimpleNamespace

import mpmath
import pytest
from support import families
from support.spectra import compared, relative, unit_masses

from vibcli.analyses.modal.damped import damped
from vibcli.analyses.modal.mode_sequence import Modes
from vibcli.analyses.modal.modes import damped_modes, natural_modes
from vibcli.analyses.modal.stability import stability
from vibcli.analyses.modal.undamped import Mode
from vibcli.mechanics.factored_system import FactoredSystem
from vibcli.report.sections.mode_tables import damped_row, mode_row, repeated

ULP = 2.0 ** -53


@pytest.fixture(autouse=True)
def many_digits():
    with mpmath.workdps(100):
        yield


def ziegler(load, c=0.0, number=float, dead=False):
    """Ziegler's column: masses 2m and m on two links l with joints k and dampers c, m = l = k = 1, in the angles.

    The load follows the upper link, or keeps its direction (`dead`).
    """
    one, p = number(1), number(load)
    joints = {0: one}, {0: -one, 1: one}
    masses = [(2 * one, {0: one}), (one, {0: one, 1: one})]
    K = {(0, 0): -p, (1, 1): -p} if dead else {(0, 0): -p, (0, 1): p}
    return FactoredSystem(2, masses, [(one, row) for row in joints], [(number(c), row) for row in joints if c],
                              K={at: x for at, x in K.items() if x})


def test_zieglers_column():
    """Flutter from P l/k = 7/2 − √2 to 7/2 + √2, then divergence (Ziegler 1952; Bolotin 1963, sect. 2.2)."""
    low, high = 7 / mpmath.mpf(2) - mpmath.sqrt(2), 7 / mpmath.mpf(2) + mpmath.sqrt(2)
    cases = ((0.5, ["oscillation"] * 2), (float(low) - 1e-15, ["oscillation"] * 2), (float(low) + 1e-15, ["flutter"]),
             (3.0, ["flutter"]), (float(high) - 2e-15, ["flutter"]), (float(high) + 2e-15, ["divergence"] * 2),
             (7.0, ["divergence"] * 2))
    for load, kinds in cases:
        modes, p = natural_modes(ziegler(load)), mpmath.mpf(load)
        assert [mode.kind for mode in modes] == kinds
        root = mpmath.sqrt(4 * p * p - 28 * p + 41)
        for mode, exact in compared(modes, [(7 - 2 * p + sign * root) / 4 for sign in (-1, 1)]):
            assert relative(mode, exact) <= mode.error <= 1.2e-16


def test_small_damping_lowers_the_limit_of_zieglers_column():
    """P l/k = 41/28 + c²/2 with equal dampers, by Routh's condition on 2λ⁴ + 7cλ³ + (7 + c² − 2P)λ² + 2cλ + 1."""
    for c in (1e-6, 1e-3, 0.1, 0.5):
        limit = Fraction(41, 28) + Fraction(c) ** 2 / 2
        for step, kind in ((-1e-12, "oscillation"), (1e-12, "flutter")):
            elements = ziegler(float(limit) + step, c)
            assert [mode.kind for mode in damped(elements)] == [kind, "oscillation"]
            assert [mode.kind for mode in natural_modes(elements)] == ["oscillation"] * 2


def test_a_dead_load_buckles_the_same_column():
    """Divergence at P l/k = (3 − √5)/2, K being symmetric."""
    limit = (3 - math.sqrt(5)) / 2
    for load, kind in ((limit - 1e-14, "oscillation"), (limit + 1e-14, "divergence")):
        elements = ziegler(load, dead=True)
        assert not elements.circulatory
        assert [mode.kind for mode in natural_modes(elements)] == [kind, "oscillation"]


def aerofoil(q):
    """Heave and pitch of an aerofoil with a lift q α ahead of its elastic axis and its mass behind it."""
    return FactoredSystem(2, M={(0, 0): 1.0, (0, 1): 0.25, (1, 0): 0.25, (1, 1): 0.5},
                              K={(0, 0): 1.0, (0, 1): q, (1, 1): 3.0 - q / 2})


def test_binary_flutter_and_divergence_of_an_aerofoil():
    """det(K − sM) = 7/16 s² − (7 − 3q/2)/2 s + 3 − q/2: flutter between the roots of its discriminant, divergence where
    the stiffness in pitch is lost, q > 6 (Fung 1955, ch. 6)."""
    middle, half = mpmath.mpf(35) / 9, mpmath.sqrt(mpmath.mpf(217) / 81)
    low, high = float(middle - half), float(middle + half)
    for q, kind in ((0.5, "oscillation"), (low - 1e-14, "oscillation"), (low + 1e-14, "flutter"), (4.0, "flutter"),
                    (high - 1e-14, "flutter"), (high + 1e-14, "divergence"), (7.0, "divergence")):
        modes, p = natural_modes(aerofoil(q)), mpmath.mpf(q)
        squares = mpmath.polyroots([mpmath.mpf(7) / 16, -(7 - 1.5 * p) / 2, 3 - p / 2], maxsteps=400, extraprec=400)
        assert modes[0].kind == kind
        assert all(relative(mode, exact) <= mode.error <= 1.2e-16 for mode, exact in compared(modes, squares))
    assert [mode.kind for mode in natural_modes(aerofoil(7.0))] == ["divergence", "oscillation"]


@pytest.mark.sweep
def test_dampers_that_push():
    one = [(1.0, {0: 1.0})]
    mode, = damped(FactoredSystem(1, one, [(1.0, {0: 1.0})], [(-0.5, {0: 1.0})]))
    assert mode.kind == "flutter" and mode.growth_rate == 0.25
    assert mode.omega_d == pytest.approx(math.sqrt(15) / 4, rel=4 * ULP) and mode.zeta == -0.25
    fast, slow = sorted(damped(FactoredSystem(1, one, [(1.0, {0: 1.0})], C={(0, 0): -2.5})),
                        key=lambda mode: -mode.growth_rate)
    assert (fast.growth_rate, slow.growth_rate) == (2.0, 0.5) and fast.kind == slow.kind == "divergence"
    for seed in range(20):
        elements = families.damped_chain(random.Random(seed), 4, 100.0, 10 ** random.Random(seed).uniform(-8, 2))
        mirrored = FactoredSystem(4, elements.inertias, elements.springs,
                                      [(-c, row) for c, row in elements.dampers])
        values, others = ([mode.eigenvalue for mode in damped(e)] for e in (elements, mirrored))
        assert sorted((-x.real, x.imag) for x in others) == sorted((x.real, x.imag) for x in values)


def is_stable(elements):
    modes = Modes(natural_modes(elements))
    found = damped_modes(elements, lambda: modes)
    return stability(SimpleNamespace(configuration=SimpleNamespace(element_data=elements), modes=modes, zero_modes={},
                                     damped=found and Modes(found))).stable


def test_stable_is_what_does_not_grow():
    assert is_stable(ziegler(2.0)) and not is_stable(ziegler(2.1))
    assert is_stable(ziegler(1.4, 0.01)) and not is_stable(ziegler(1.5, 0.01))
    assert not is_stable(ziegler(7.0)) and not is_stable(ziegler(1.0, dead=True))
    one, stiff = [(1.0, {0: 1.0})], [(4.0, {0: 1.0})]
    assert not is_stable(FactoredSystem(1, one, stiff, [(-0.1, {0: 1.0})]))
    assert not is_stable(FactoredSystem(1, one, stiff, C={(0, 0): -0.1}))
    assert is_stable(FactoredSystem(1, one, stiff, [(0.1, {0: 1.0})]))
    held = {"K": {(0, 0): -1.0, (1, 1): -1.0}, "G": {(0, 1): 3.0, (1, 0): -3.0}}
    assert is_stable(FactoredSystem(2, unit_masses(2), **held))
    assert not is_stable(FactoredSystem(2, unit_masses(2), dampers=[(0.1, {0: 1.0}), (0.1, {1: 1.0})], **held))
    rotor = {(0, 0): 1.0, (1, 1): 1.0, (0, 1): 0.1, (1, 0): -0.1}     # internal damping turns with the shaft
    for c, stands in ((0.09, False), (0.11, True)):
        assert is_stable(FactoredSystem(2, unit_masses(2), K=rotor, C={(0, 0): c, (1, 1): c})) == stands


def test_rows_of_the_report():
    flutter, = natural_modes(ziegler(3.0))
    assert mode_row(flutter)[1] == "0.691776" and mode_row(flutter)[-1] == "flutter: grows as exp(0.478073·t)"
    fast, slow = natural_modes(ziegler(7.0))
    assert mode_row(fast)[1] == "–" and mode_row(fast)[-1].startswith("unstable: grows as exp(") and not slow.omega
    assert not repeated([flutter, flutter]) and Mode(1, 0.0, None, None, None, 0.0).rigid
    elements = ziegler(3.0, 0.01)
    assert [damped_row(mode)[-1] for mode in damped(elements)] == ["flutter", ""]
    assert {damped_row(mode)[-1] for mode in damped(ziegler(7.0, 0.01))} == {"unstable", "real eigenvalue"}


def test_digits_settle_what_floats_leave_open():
    """The growth rate at a load d above the limit is √d/2 and terms of higher order."""
    asked, above = [], mpmath.mpf(10) ** -25

    def precise(dps):
        asked.append(dps)
        with mpmath.workdps(dps):
            return ziegler(7 / mpmath.mpf(2) - mpmath.sqrt(2) + above, number=mpmath.mpf)

    floats = ziegler(3.5 - math.sqrt(2))
    mode, = natural_modes(floats, precise=precise)
    assert asked == [60] and mode.kind == "flutter" and mode.error <= 1.2e-16
    more, = natural_modes(floats, precise=precise, digits=30)
    assert more.error <= mpmath.mpf(10) ** -30
    assert abs(mode.growth_rate - more.growth_rate) <= mode.error * more.growth_rate
    assert abs(more.growth_rate / (mpmath.sqrt(above) / 2) - 1) <= 1e-20
