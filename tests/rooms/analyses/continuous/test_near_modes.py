"""Motions of beams with modes next to one another: what rounds in them is below its bound, and the bound near it."""

import mpmath
import numpy as np
import pytest
from support.exact_modes import ExactModes
from support.scenes import problem

from vibcli.analyses.continuous.modal_reads import Read
from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput

COUNT, OMEGA, TIMES = 8, 20.0, np.linspace(0.01, 3, 5)
BEAM = "EI: 100 N*m^2, mass_per_length: 1 kg/m"
LOAD = "forces: {f: {at: r, force: 1 N*sin(20 rad/s*t)}}"


def supports(place, apart):
    """A clamped beam with two supports next to each other: next to a clamp between its halves."""
    return problem(f"""
        parameters: {{a: {place} m, e: {apart} m}}
        beams: {{b: {{length: 1 m, {BEAM}, left: clamped, right: clamped,
                      attached: [{{at: a, support: pinned}}, {{at: a + e, support: pinned}}]}}}}
        points: {{r: {{body: b, at: 0.3 m}}}}
        {LOAD}
        """)


def turned(place, apart):
    """The same, a moment on one of the supports."""
    return problem(f"""
        parameters: {{a: {place} m, e: {apart} m}}
        beams: {{b: {{length: 1 m, {BEAM}, left: clamped, right: clamped,
                      attached: [{{at: a, support: pinned}}, {{at: a + e, support: pinned}}]}}}}
        points: {{r: {{body: b, at: a}}}}
        forces: {{f: {{at: r, moment: 1 N*m*sin(20 rad/s*t)}}}}
        """)


def tied(other, k):
    """Two cantilevers whose tips a weak spring ties."""
    return problem(f"""
        beams:
          one: {{length: 0.6 m, {BEAM}, left: clamped}}
          two: {{length: {other} m, {BEAM}, left: clamped}}
        points: {{p: {{body: one, at: 0.6 m}}, q: {{body: two, at: {other} m}}, r: {{body: one, at: 0.35 m}}}}
        springs: {{tie: {{k: {k} N/m, between: [p, q]}}}}
        {LOAD}
        """)


def tuned(mass):
    """A beam that carries a small oscillator of the frequency of its first mode."""
    return problem(f"""
        parameters: {{m: {mass} kg, L: 1 m, EI: 100 N*m^2, mu: 1 kg/m}}
        beams: {{b: {{length: L, EI: EI, mass_per_length: mu, left: pinned, right: pinned,
                      attached: [{{at: 0.4 m, oscillator: {{mass: m, k: m*pi^4*EI/(mu*L^4)}}}}]}}}}
        points: {{r: {{body: b, at: 0.3 m}}}}
        {LOAD}
        """)


@pytest.mark.sweep
@pytest.mark.parametrize("one, near", [
    (lambda: supports(0.5, "1e-5"), 4), (lambda: supports(0.4137, "1e-8"), 0), (lambda: turned(0.4137, "1e-8"), 0),
    (lambda: tied(0.55, "1e-8"), 0), (lambda: tuned("1e-9"), 1), (lambda: tuned("1e-14"), 1)])
def test_what_rounds_is_bounded_everywhere(one, near):
    one = one()
    motion, exact, found = one.response.motion(COUNT), ExactModes(one, COUNT), []
    assert COUNT - len(set(motion.modes.basis.numbers.tolist())) == near
    for number, placed in enumerate(exact.elements.pieces):
        for share in (0, mpmath.mpf(3) / 8, 1):
            for along in range(4):
                place = FieldPoint(number, placed.piece.length * share, along)
                true = exact.under_a_sine(place, loaded(motion), OMEGA, TIMES)
                output = LinearOutput(0.0, {}, {}, {}, {}, {place._replace(x=float(place.x)): 1.0})
                if np.abs(true).max() > 1e-25:
                    off = np.abs(motion.values(output, TIMES) - true)
                    found.append((off / rounded(motion, output)).max())
    assert max(found) < 1 and min(found) > 1e-5 and np.median(found) > 1e-4


def loaded(motion):
    return next(wave.channel for segment in motion.forcing.segments(1.0) for wave in segment.waves)


def rounded(motion, output):
    """What rounding is said to leave, without what modes left out add."""
    stretch, *_ = next(iter(motion._placed(TIMES)))
    said = motion._rounded(Read(motion, output, 0), stretch, np.zeros(len(motion.states.rates)))
    return np.array([said(t) for t in TIMES])
