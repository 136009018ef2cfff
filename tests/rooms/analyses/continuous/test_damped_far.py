"""Damped modes far up by their number: closed forms, roots by mpmath, and the same as those found with all below."""

import math
import random

import mpmath
import pytest
from support.scenes import problem

from tests.rooms.analyses.continuous.test_damped_modes import bar, exact, member, source
from tests.support.random_members import random_members
from vibcli.analyses.continuous import damped_source
from vibcli.mechanics.factored_system import FactoredSystem
from vibcli.numerics.pieces.piece import Piece


@pytest.mark.sweep
@pytest.mark.parametrize("r", [0.01, 0.5, 0.99, 1.001, 1.5, 4.0])
def test_a_bar_with_an_end_damper(r):
    modes, near = source(bar(r)), max(1e-13, 2e-15 / abs(1 - r))
    found = modes.numbered(990, 995)
    for mode, value in zip(found, exact(r, 995)[989:], strict=True):
        assert abs(mode.eigenvalue - value) <= near * abs(value)
    proof = modes.proof(990, 995)
    for radius, count in ((proof.inner, proof.below), (proof.radius, proof.count)):
        assert count == sum(2 if value.imag else 1 for value in exact(r, 1100) if abs(value) < radius)
    assert modes.count(100.0) == sum(abs(value) <= 100.0 for value in exact(r, 60))


@pytest.mark.sweep
def test_all_up_to_far():
    found = source(bar(0.5)).numbered(1, 700)
    assert [mode.index for mode in found] == list(range(1, 701))
    for mode, value in zip(found, exact(0.5, 700), strict=True):
        assert abs(mode.eigenvalue - value) <= 1e-13 * abs(value)


@pytest.mark.sweep
def test_a_cantilever_with_a_damper_by_mpmath():
    """EI = μ = L = 1: b³ (1 + cos b cosh b) + c s (sin b cosh b − cos b sinh b) = 0, s = i b²."""
    system = FactoredSystem(2, dampers=[(0.5, {0: 1.0})], pieces=[
        member(Piece(1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0), {}, {}, {0: 1.0}, {1: 1.0})])

    def equation(b):
        cos, sin, tanh, one = mpmath.cos(b), mpmath.sin(b), mpmath.tanh(b), mpmath.sech(b)
        return b * (one + cos) + mpmath.mpc(0, 0.5) * (sin - cos * tanh)

    with mpmath.workdps(30):
        for mode in source(system).numbered(300, 303):
            b = mpmath.findroot(equation, (mode.index - mpmath.mpf(1) / 2) * mpmath.pi)
            value = mpmath.mpc(0, 1) * b * b
            assert abs(value - mode.eigenvalue) <= mode.error * abs(value) <= 1e-13 * abs(value)
            assert abs(value.real - mode.eigenvalue.real) <= 1e-6


@pytest.mark.sweep
@pytest.mark.parametrize("seed", [0, 24, 42])
def test_as_those_found_with_all_below(seed, monkeypatch):
    draw, system = random.Random(seed), random_members(seed)
    if not system.n:
        return
    dampers = [(10 ** draw.uniform(-2, 2), {draw.randrange(system.n): 1.0}) for _ in range(2)]
    pieces = [one._replace(piece=one.piece._replace(drag=draw.choice((0.0, 0.3)))) for one in system.pieces]
    system = system.with_parts(dampers=dampers, pieces=pieces)
    near = source(system).numbered(1, 24)
    monkeypatch.setattr(damped_source, "NEAR", 10)
    far = source(system)
    for one, other in zip([*far.numbered(20, 24), *far.numbered(1, 18)], [*near[19:], *near[:18]], strict=True):
        assert one.index == other.index
        assert abs(one.eigenvalue - other.eigenvalue) <= 4 * (one.error + other.error) * abs(one.eigenvalue)
    assert far.count(float(near[22].omega) * (1 + 1e-9)) >= 23


@pytest.mark.sweep
def test_eigenvalues_that_decay_without_swinging_are_numbered():
    """A heavily damped body of little mass on a bar: a real λ far up, near −c/m."""
    piece = Piece(1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0)
    system = FactoredSystem(1, [(0.01, {0: 1.0})], dampers=[(3.0, {0: 1.0})], pieces=[member(piece, {}, {0: 1.0})])
    found = source(system).numbered(61, 70)

    def equation(s):
        return (0.01 * s + 3) * mpmath.tanh(s) + 1

    real = mpmath.findroot(equation, -400)
    assert real < -100
    counted = [mpmath.findroot(equation, mpmath.mpc(-0.3, k * math.pi + 0.2)) for k in range(1, 75)]
    sizes = sorted(float(abs(s)) for s in {mpmath.nstr(s, 10): s for s in [*counted, real]}.values())
    lowest = [mode.omega for mode in source(system).numbered(1, 3)]
    start = next(i for i, size in enumerate(sizes) if abs(size - lowest[-1]) < 1e-8 * size)
    for mode in found:
        assert sizes[start + mode.index - 3] == pytest.approx(mode.omega, rel=1e-9)


@pytest.mark.sweep
def test_a_mode_beside_one_in_which_all_ends_rest_is_found():
    scene = """
strings:
  s: {length: 1 m, preload: 1 N, mass_per_length: 1 kg/m, left: clamped, right: clamped,
      attached: [{at: 0.533 m, oscillator: {mass: 5 kg, k: 1e5 N/m, c: 0.5 N*s/m}}]}
"""
    found = problem(scene).modal.damped.numbered(995, 1005)
    near = [mode for mode in found if abs(mode.omega - 1000 * math.pi) < 0.5]
    assert len(near) == 2
