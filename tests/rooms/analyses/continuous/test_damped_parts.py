"""Damped modes of scenes of which parts move without one another: strings with drag beside others without."""

import numpy as np
import pytest
from support.scenes import problem

from vibcli.analyses.continuous.damped_parts import DampedPart, StillPart, damped_parts
from vibcli.analyses.continuous.damped_series import damped_series, within_region
from vibcli.analyses.continuous.dynamic_matrix import dynamic_matrix
from vibcli.base.errors import PhysicsError
from vibcli.results.damped_modal_response import DampedModalResponse

STRINGS = """\
parameters: {L: 1 m, T: 100 N, mu: 0.01 kg/m, c: 0.3 N*s/m^2, m: 0.2 kg, k: 50 N/m}
bodies: {slider: {mass: m, slide: x}}
springs: {s: {k: k, between: [slider, ground]}}
strings:
  felt: {length: L, preload: T, mass_per_length: mu, drag: c, left: pinned, right: pinned}
  one: {length: L, preload: T, mass_per_length: mu, left: pinned, right: pinned}
  other: {length: L, preload: T, mass_per_length: mu, left: pinned, right: pinned}
motion: small
"""


@pytest.fixture(scope="module")
def strings():
    return problem(STRINGS)


@pytest.mark.sweep
def test_each_part_has_its_own(strings):
    """λ = −c/2μ ± i √(ω² − (c/2μ)²) of the one with drag, ± iω twice, ω = 100 nπ, and ± i √(k/m)."""
    known = [1j * np.sqrt(250.0), *(1j * 100 * n * np.pi for n in (1, 1, 2, 2))]
    known += [-15 + 1j * np.sqrt((100 * n * np.pi) ** 2 - 225) for n in (1, 2)]
    found = [mode.eigenvalue for mode in strings.modal.damped.first(7)]
    assert found == pytest.approx(sorted(known, key=lambda s: (round(abs(s), 6), -s.real)), rel=1e-12)


@pytest.mark.sweep
def test_as_many_as_are_counted_move_by_themselves(strings):
    damped = strings.modal.damped
    damped.first(7)
    series = damped_series(within_region(damped.region), 40)
    assert {type(part) for part in series.parts} == {DampedPart, StillPart}
    n = int(series.radius / (100 * np.pi))
    assert len(series.rates) == 1 + 3 * n and np.sum(series.rates.real < -14) == n
    assert all(len(group.shapes) == len(group.numbers) for group in series.groups)


def test_what_is_tied_is_one_part(strings):
    system = strings.configuration.linear_system
    tied = system.with_parts(pieces=[one._replace(rows=({}, {0: 1.0})) for one in system.pieces])
    part, = damped_parts(tied, dynamic_matrix(tied))
    assert isinstance(part, DampedPart) and part.coordinates == [0]


def test_a_refusal_is_kept(strings, monkeypatch):
    counted = []

    def refused(self, count):
        counted.append(count)
        raise PhysicsError("no", "why")

    monkeypatch.setattr(DampedModalResponse, "_found", refused)
    response = DampedModalResponse(strings)
    for _ in range(2):
        with pytest.raises(PhysicsError, match="no") as told:
            response.motion(32)
        assert told.value.hint == "why"
    assert counted == [32]


BESIDE = """\
parameters: {{L: 1 m, EI: 100 N*m^2, mu: 1 kg/m, c: 2 N*s/m, m: 0.5 kg}}
motion: small
beams:
  arm: {{length: L, EI: EI, mass_per_length: mu, left: clamped,
    attached: [{{at: 0.5 m, mass: m}}, {{at: 0.5 m + {}, c: c}}]}}
"""


def within(gap):
    system = problem(BESIDE.format(gap)).configuration.linear_system
    part, = damped_parts(system, dynamic_matrix(system))
    roots = part.roots(300.0, 1, (), 0.0, 0.0)
    assert part.zeros_within(300.0) == 4 == 2 * len(roots) and max(root.error for root in roots) < 1e-11
    return [root.value for root in roots]


@pytest.mark.sweep
def test_places_next_to_each_other_are_nearly_one():
    for a, b, c in zip(*map(within, ("0 m", "1e-5 m", "1e-3 m")), strict=True):
        assert b - a == pytest.approx((c - a) * 1e-2, rel=0.05, abs=1e-9 * abs(a))


@pytest.mark.sweep
def test_what_is_missed_is_looked_for_in_gaps(monkeypatch):
    """A free shaft with a damper at 2/5 of it: waves pass its parts in 2 and 3 fifths of a time L/c₀, so that its roots
    repeat themselves, five by five, at Im λ + 5π c₀/L."""
    scene = problem("shafts: {line: {length: 1 m, GIo: 100 N*m^2, inertia_per_length: 0.5 kg*m, "
                    "attached: [{at: 0.4 m, c: 3 N*m*s}]}}\n")
    monkeypatch.setattr("vibcli.analyses.continuous.damped_series.EFFORTS", (1,))
    scene.modal.damped.first(12)
    rates = damped_series(within_region(scene.modal.damped.region), 430).rates
    rates = rates[np.argsort(rates.imag)]
    again = 5 * np.pi * np.sqrt(200.0)
    assert rates[5:].imag - rates[:-5].imag == pytest.approx(np.full(len(rates) - 5, again), rel=1e-11)
