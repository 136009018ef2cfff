"""Displacements of beams after a jump of the velocity of what holds them, to 1e-10 of the largest, at instants and the
largest of all: against series of their own, of 40,000 modes, which fall like n⁻³.

    φ = a cos bx + d sin bx + e^{−bx} + q e^{−b(1−x)},   S = φ‴(1)/b³,   S = −m b φ(1) or i (c/b) φ(1),   λ = i b²
"""

from pathlib import Path

import numpy as np
import pytest
from support.modes_found_once import modes_found_once  # noqa: F401

import vibcli
from vibcli.analyses.continuous.remainder import remainder
from vibcli.results.enough_modes import first_modes

PROBLEMS = Path(__file__).parents[3] / "problems"
SCENE = """\
parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}
bodies: {base: {slide: 1 m*sin(2 rad/s*t)}}
beams:
  arm: {length: L, EI: EI, mass_per_length: mu, left: {clamped: base}%s}
"""
START = """\
parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}
beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: clamped, attached: [{at: L, c: 0.5 N*s/m}]}}
initial: {arm.u': 1 m/s}
"""
MANY = 40_000
BARE = "", 0.0, 0.0, 1.875, 0.5
MASS = ", attached: [{at: L, mass: 0.5 kg}]", 0.5, 0.0, 1.41996, 0.75
DAMPER = ", attached: [{at: L, c: 0.5 N*s/m}]", 0.0, 0.5, 1.875, 0.5
pytestmark = pytest.mark.usefixtures("modes_found_once")


def _parts(b):
    """a, d, q, S and φ(1)."""
    e = np.exp(-b)
    q = (np.sin(b) - np.cos(b) - e) / (1 + e * (np.cos(b) + np.sin(b)))
    a, d = -1 - q * e, 1 - q * e
    return a, d, q, a * np.sin(b) - d * np.cos(b) - e + q, a * np.cos(b) + d * np.sin(b) + e + q


class Series:
    """w(x, t) of a cantilever on a base that moves by sin 2t, and carries m or a damper c at its tip; MANY modes."""

    def __init__(self, m, c, first, less):
        b = np.append(first, (np.arange(2, MANY + 1) - less) * np.pi) + 0j
        off, step = np.ones_like(b), 1e-6
        while abs(off).max() > 1e-7:        # the next would leave what rounds: slopes are good to 1e-5
            off = self._off(b, m, c) * step * 2 / (self._off(b + step, m, c) - self._off(b - step, m, c))
            b = b - off
        assert (np.diff(b.real) > 2.2).all() and np.abs(np.diff(b.real[9:]) / np.pi - 1).max() < 1e-2
        self.a, self.d, self.q, S, end = _parts(b)
        self.b, self.rates, e = b, 1j * b**2, np.exp(-b)
        slope = -self.a * np.sin(b) + self.d * np.cos(b) - e + self.q
        square = (3 * end * S / b + end**2 - 2 * slope * S) / 4
        N = 2 * self.rates * (square + m * end**2) + c * end**2
        G = (S + self.d + 1 - self.q * e) / b + m * end
        self.begin, self.sine, self.cosine = -2 * G / N, 4 * G / N, -2 * c * end / N

    @staticmethod
    def _off(b, m, c):
        *_, S, end = _parts(b)
        return S + (m * b - 1j * c / b) * end

    def at(self, x, t):
        """sin 2t + w(x, t)."""
        phi, grown = self._phi(x), np.exp(self.rates * t)
        ahead, back = ((np.exp(s * t) - grown) / (s - self.rates) for s in (2j, -2j))
        own = self.begin * grown + self.sine * (ahead - back) / 2j + self.cosine * (ahead + back) / 2
        return np.sin(2 * t) + 2 * (phi * own)[::-1].sum().real

    def of_speed(self, x, t):
        """What it does on a base at rest that starts with 1 m/s all along: −½ of what the jump to 2 m/s does."""
        return -(self._phi(x) * self.begin * np.exp(self.rates * t))[::-1].sum().real

    def _phi(self, x):
        b = self.b
        return self.a * np.cos(b * x) + self.d * np.sin(b * x) + np.exp(-b * x) + self.q * np.exp(-b * (1 - x))


@pytest.mark.sweep
def test_a_damped_beam_that_starts_with_a_speed_at_its_clamp():
    """Bound and error, at its tip: 1e-10 of the largest."""
    series, scene = Series(*DAMPER[1:]), vibcli.loads(START)
    most = max(abs(series.of_speed(1.0, t)) for t in np.linspace(0, 1, 41))
    found = scene["arm.u(L)(0.3 s)"]
    assert abs(found.value - series.of_speed(1.0, 0.3)) <= found.error <= 1e-10 * most


@pytest.mark.sweep
@pytest.mark.parametrize("case", [BARE, MASS, DAMPER])
def test_displacements_at_instants_and_the_largest_of_all(case):
    more, *rest = case
    series, scene = Series(*rest), vibcli.loads(SCENE % more)
    top, at = (scene[f"{head}(arm.u(0.6*L))"] for head in ("max", "argmax"))
    found = scene["arm.u(0.6*L)(0.7 s)"]
    close = 1e-10 * top.value
    assert abs(found.value - series.at(0.6, 0.7)) <= found.error <= close
    assert top.error <= 1e-9 * top.value
    assert abs(top.value - series.at(0.6, at.value)) <= close
    near = at.value + np.concatenate([np.linspace(-1, 1, 10) * width for width in (1e-8, 1e-6, 1e-4, 1e-2)])
    assert max(series.at(0.6, t) for t in near[near > 0]) <= top.value + close


@pytest.mark.sweep
def test_of_largest_values_that_are_equal_the_first_is_told():
    """A rod that begins to hang by its weight, whose end moves furthest at 2L/c, 6L/c …"""
    scene = vibcli.load(PROBLEMS / "8_continuous/rod_that_feels_its_weight_at_once.yaml")
    assert scene["argmax(rod.u(L))"].value == pytest.approx(6 / np.sqrt(206e9 / 7850), rel=1e-6)


@pytest.mark.sweep
def test_modes_next_to_those_of_held_pieces_are_found_in_blocks():
    """Of a beam that a heavy body ends each is next to one of the beam clamped there, which takes ten counts."""
    body = SCENE % ", attached: [{at: L, mass: 1 kg, inertia: 0.05 kg*m^2}]"
    modes = first_modes(vibcli.loads(body)._problem.modal.modes, 2049)
    omega = np.array([float(mode.omega) for mode in modes])
    near = (np.arange(1, 2050) - 0.5) * np.pi       # βL of high modes: those of the clamped beam before
    assert len(modes) == 2049 and np.abs(np.sqrt(omega[-500:]) - near[-500:]).max() < np.pi


@pytest.mark.parametrize("power", [3.0, 4.0])
def test_what_modes_left_out_add_is_told_by_octaves_that_fall_alike(power):
    n = np.arange(1, 200_000)
    sizes = np.abs(np.cos(0.6 * np.pi * n + 0.3)) / n**power
    rest = sizes[8192:].sum()
    assert rest <= remainder(sizes[:8192]) <= 1.4 * rest
    assert 2 * rest < remainder(np.where(n > 5000, 1.1, 1.0)[:8192] * sizes[:8192]) / 1.1      # they do not


def test_what_modes_left_out_add_is_told_where_nodes_make_octaves_alike():
    """Of a beam on pins, read at one place and pushed at another."""
    n = np.arange(1, 20_000)
    slow, fast = (np.abs(np.sin(0.505 * np.pi * n) * np.sin(0.973 * np.pi * n)) / n**power for power in (1, 2))
    assert fast[128:].sum() <= remainder(fast[:128]) < 1 and remainder(slow[:128]) == np.inf


def test_what_rounding_leaves_of_modes_has_a_bound():
    noise = 1e-19 * np.random.default_rng(1).random(256)
    assert remainder(noise) == np.inf and remainder(noise, 1e-19) < 1e-16


def test_an_octave_in_which_no_mode_is_felt_leaves_what_others_tell():
    sizes = np.arange(1.0, 20_000.0) ** -4
    sizes[32:64] = 0
    with np.errstate(all="raise"):
        assert sizes[128:].sum() <= remainder(sizes[:128]) <= 10 * sizes[128:].sum()
        assert remainder(np.where(np.arange(128) < 64, 0.0, sizes[:128])) == np.inf
