"""The slowest mode of members beside their limits of stability: a mast under what it buckles by."""

import math
from fractions import Fraction

import pytest
from support.scenes import problem

from vibcli.inverse import settled
from vibcli.inverse.conditions import HOLDS, ConditionSystem
from vibcli.inverse.slowest_mode import slowest

SEGMENTS = (3.0, 30e3, 6.0), (3.0, 20e3, 4.0), (3.0, 10e3, 3.0)     # length, EI, mass per length, from the clamp on
MAST = """
parameters: {M: , g: 9.81 m/s^2}
gravity: g
beams:
  mast:
    from: [0, 0]
    to: [0, 9 m]
    left: clamped
    attached: [{at: 9 m, mass: M}]
    segments:
""" + "\n".join(f"      - {{length: {one} m, EI: {two} N*m^2, mass_per_length: {three} kg/m}}"
                for one, two, three in SEGMENTS)
BUCKLES = 64.4190585645229


def slope_at_the_clamp(mass):
    """θ there of a mast whose free end has θ = 1: EI θ″ + N(s) θ = 0, s downwards, by power series in each segment."""
    slope, moment, load = 1.0, 0.0, 9.81 * mass
    for length, bending, inertia in reversed(SEGMENTS):
        c = [slope, moment / bending]
        for k in range(60):
            c.append(-(load * c[k] + (9.81 * inertia * c[k - 1] if k else 0.0)) / (bending * (k + 1) * (k + 2)))
        slope = sum(a * length**k for k, a in enumerate(c))
        moment = bending * sum(k * a * length ** (k - 1) for k, a in enumerate(c) if k)
        load += 9.81 * inertia * length
    return slope


@pytest.mark.sweep
def test_what_vanishes_there_changes_its_sign_and_is_small_beside_what_stays():
    mast = problem(MAST)
    assert slope_at_the_clamp(BUCKLES * (1 - 1e-13)) > 0 > slope_at_the_clamp(BUCKLES * (1 + 1e-13))
    below, above = (slowest(mast.sharing({"M": Fraction(BUCKLES * (1 + side * 1e-6))})) for side in (-1, 1))
    assert below[1] > 0 > above[1]
    assert below[1] / below[2] == pytest.approx(0.0086e-6, rel=0.01)
    assert below[1] / below[2] == pytest.approx(-above[1] / above[2], rel=1e-5)


@pytest.mark.sweep
def test_two_that_grow_are_beyond_all_limits():
    """What stays plays no part in its size, so that it is no nearer to a limit where more grow."""
    _, value, size = slowest(problem(MAST).sharing({"M": Fraction(1500)}))
    assert value == -size


@pytest.mark.sweep
def test_a_member_without_coordinates_buckles_between_its_ends():
    found = problem("""
        parameters: {L: 2 m, EI: 1 kN*m^2}
        beams: {b: {length: L, EI: EI, mass_per_length: 3 kg/m, preload: -P, left: clamped, right: clamped}}
        choose: {P: stability limit}
        """)
    system, limit = ConditionSystem(found), math.pi**2 * 1000
    below, above = (system.misfits([limit * factor])[0] for factor in (1 - 1e-12, 1 + 1e-12))
    assert -HOLDS < above < 0 < below < HOLDS
    first, second = found.with_values({"P": Fraction(limit)}).modal.modes.first(2)
    assert first.rigid and second.omega > 0
    assert found.with_values({"P": Fraction(limit * (1 + 1e-9))}).modal.modes.first(1)[0].growth_rate > 0


@pytest.mark.sweep
def test_a_pressed_beam_at_its_chosen_limit_neither_swings_nor_grows():
    """Though the number of P is rounded; ω₂² = 4·(4 − 1)·π⁴·EI/(μL⁴)."""
    found = settled(problem("""
        parameters: {L: 1 m, EI: 300 N*m^2, mu: 1 kg/m}
        beams: {b: {length: L, EI: EI, mass_per_length: mu, preload: -P, left: pinned, right: pinned}}
        choose: {P: stability limit}
        """))
    first, second = found.modal.modes.first(2)
    assert first.omega == 0.0 and first.growth_rate is None and found.modal.stability.stable
    assert second.omega == pytest.approx(math.pi**2 * (12 * 300) ** 0.5, rel=1e-12)
