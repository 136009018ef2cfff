"""Motions in time of a beam that holds a mass and a spring next to each other: what both put on it is what its shears
jump by, and as they come together its motion is that of both at one place."""

import mpmath
import numpy as np
import pytest
from mpmath import mp, mpf
from support.scenes import problem

from vibcli.analyses.continuous.short_pieces import relative_coordinates
from vibcli.analyses.continuous.unit_responses import UnitLoads, motions_squared
from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput
from vibcli.language.signals_of_places import with_places
from vibcli.mechanics.factored_system import PlacedPiece
from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.pieces.relative import cantilever, relative_fields
from vibcli.quantities.expression import measure
from vibcli.results import damped_modal_response, modal_response
from vibcli.symbolic.parser import parse

SCENE = """
    parameters: {{a: 0.5 m, e: {apart} m, k: 5000 N/m, m: 0.3 kg, mu: 1 kg/m}}
    beams:
      b: {{length: 1 m, EI: 100 N*m^2, mass_per_length: mu, left: clamped,
           attached: [{{at: a, mass: m}}, {{at: a + e, k: k}}{tip}]}}
    points: {{tip: {{body: b, at: 1 m}}}}
    forces: {{f: {{at: tip, force: 10 N*sin(20 rad/s*t)}}}}
    """
DAMPED = ", {at: 1 m, c: 3 N*s/m}"


def beam(apart, tip=DAMPED):
    return problem(SCENE.format(apart=apart, tip=tip))


def value(one, text):
    return measure(one, with_places(parse(text), one.spec.members))


@pytest.fixture(autouse=True)
def _few_modes(monkeypatch):
    monkeypatch.setattr(damped_modal_response, "MANY", 128)
    monkeypatch.setitem(modal_response.MOST, False, 32)
    monkeypatch.setattr(modal_response, "FIRST", 32)


@pytest.mark.sweep
@pytest.mark.parametrize("apart, tip", [("1e-5", DAMPED), ("1e-3", "")])
def test_shears_jump_by_what_is_held(apart, tip):
    one = beam(apart, tip)
    parts = [value(one, text) for text in (
        "b.shear(a)(0.1 s)", "b.shear(a + e)(0.1 s)", "b.u(a + e)(0.1 s)", "b.u''(a)(0.1 s)")]
    weights = 1.0, -1.0, -5000.0, -float(apart)     # of μ ∫ ü dx between them
    jump = sum(weight * float(found) for weight, (found, _) in zip(weights, parts, strict=True))
    room = sum(abs(weight * float(found) * error) for weight, (found, error) in zip(weights, parts, strict=True))
    assert abs(jump) <= room + 2e-3 * float(apart) * abs(float(parts[3][0])) and room < 1e-2


OTHERS = {"mass": "{at: PLACE, mass: 0.3 kg}", "spring": "{at: PLACE, k: 5000 N/m}",
          "held": "{at: PLACE, support: pinned}", "damper": "{at: PLACE, c: 2 N*s/m}",
          "turned": "{at: PLACE, torsion: 300 N*m}",
          "tuned": "{at: PLACE, oscillator: {mass: 0.3 kg, k: 5000 N/m, c: 1 N*s/m}}"}
JUMPS = {"mass": lambda x: 0.3 * x["u''"], "spring": lambda x: 5000 * x["u"]}


@pytest.mark.sweep
@pytest.mark.parametrize("apart, left, right, tip", [
    (1e-8, "mass", "spring", DAMPED), (1e-8, "spring", "spring", ""),
    (1e-8, "spring", "held", DAMPED), (1e-5, "mass", "held", ""), (1e-8, "held", "spring", DAMPED),
    (1e-5, "spring", "tuned", ""), (1e-8, "spring", "damper", ""), (1e-8, "spring", "turned", DAMPED)])
def test_what_stands_between_them_is_borne_by_all_else(apart, left, right, tip):
    """The shear between two places next to each other is known by what it jumps by there, whatever modes are left out;
    and the moment grows by it."""
    one = problem(f"""
        parameters: {{a: 0.5 m, e: {apart!r} m, mu: 1 kg/m}}
        beams:
          b: {{length: 1 m, EI: 100 N*m^2, mass_per_length: mu, left: clamped,
               attached: [{OTHERS[left].replace("PLACE", "a")}, {OTHERS[right].replace("PLACE", "a + e")}{tip}]}}
        points: {{tip: {{body: b, at: 1 m}}}}
        forces: {{f: {{at: tip, force: 10 N*sin(20 rad/s*t)}}}}
        """)
    motion = one.response.motion(64)
    last = float(motion.transfer.pieces[1].piece.length)

    def at(piece, x, along, rates=0):
        place = FieldPoint(piece, x, along, rates)
        return motion.values(LinearOutput(0.0, {}, {}, {}, {}, {place: 1.0}), np.array([0.1]))[0]

    shears = [100 * at(piece, x, 3) for piece, x in ((0, 0.5), (1, 0.0), (1, last), (2, 0.0))]
    moments = [100 * at(1, x, 2) for x in (0.0, last)]
    slack = apart * max(abs(at(1, 0.0, 0, 2)), abs(at(1, last, 0, 2)))    # μ ∫ ü dx
    for kind, place, before, after in ((left, (1, 0.0), *shears[:2]), (right, (2, 0.0), *shears[2:])):
        if kind in JUMPS:
            jump = JUMPS[kind]({"u": at(*place, 0), "u''": at(*place, 0, 2)})
            assert abs(before - after - jump) < 1e-9
    assert abs(shears[2] - shears[1]) < 2 * slack + 1e-9
    assert abs(moments[1] - moments[0] - last * shears[1]) < last * slack + 1e-12


def pieces(apart):
    coefficients = {"bending": 100.0, "inertia": 1.0, "tension": 0.0, "gradient": 0.0, "drag": 0.0, "foundation": 0.0}
    spans = [(0.0, 0.5), (0.5, apart), (0.5 + apart, 0.5 - apart)] if apart else [(0.0, 0.5), (0.5, 0.5)]
    ends = [({}, {}), *(({i: 1.0}, {i + 1: 1.0}) for i in range(0, 2 * len(spans), 2))]
    return [PlacedPiece("b", start, Piece(length=length, **coefficients), (*ends[k], *ends[k + 1]), [])
            for k, (start, length) in enumerate(spans)]


def squares(apart):
    """Of unit loads at the tip and at the mass, and of a kink there."""
    placed = pieces(apart)
    n, spring = 2 * len(placed), 2 if apart else 0
    M, K, forces = np.zeros((n, n)), np.zeros((n, n)), np.zeros((n, 3))
    M[0, 0], K[spring, spring] = 0.3, 5000.0
    forces[n - 2, 0] = forces[0, 1] = 1.0
    loads = UnitLoads(forces, {(0, 3): np.array([0.0, 0.0, 1e-3])})
    return motions_squared(K, M, placed, loads, np.array([10.0, 100.0, 1000.0]))


def test_motions_of_unit_loads_tend_to_those_of_one_place():
    found, both = 2 * squares(1e-5) - squares(2e-5), squares(0)
    assert np.allclose(found, both, rtol=1e-7, atol=0)


def grown(length, s):
    """How u … u‴ go on along a beam."""
    powers = mp.matrix(4, 4)
    for i in range(3):
        powers[i, i + 1] = 1
    powers[3, 0] = -s * s / 100
    return mp.expm(powers * length)


@pytest.mark.parametrize("s", [300j + 1, 5000j + 10])
def test_fields_of_a_short_piece(s):
    piece = pieces(1e-5)[1].piece
    with mpmath.workdps(60):
        S = mpmath.mpc(s)
        start = mp.matrix([2, 3, -5, 7])
        end, inside = grown(mpf(piece.length), S) * start, grown(mpf(piece.length) * mpf("0.3"), S) * start
        motions = [start[0], start[1], end[0] - start[0] - mpf(piece.length) * start[1], end[1] - start[1]]
        S = mp.matrix(cantilever(piece._make(map(mpf, piece))).tolist())
        bends = [*motions[:2], *(S * mp.matrix(motions[2:]))]
        found = relative_fields(piece, piece.reaction(np.array([s])), np.array([list(map(complex, bends))]),
                                np.array([0.3 * piece.length]))[0]
        off = [abs(complex(x) - y) / abs(complex(x)) for x, y in zip(inside, found, strict=True)]
    assert max(off) < 1e-14


@pytest.mark.sweep
def test_answers_at_one_frequency_within_a_short_piece():
    one, s = beam("1e-5"), np.array([40j + 3, 300j])
    transfer = one.response._transfer
    assert relative_coordinates(transfer.pieces).short
    bends = [transfer.at(LinearOutput(0.0, {}, {}, {}, {}, {FieldPoint(number, x, 2, 0): 1.0}), s)
             for number, x in ((0, 0.5), (1, 0.0))]
    assert np.allclose(bends[0][4], bends[1][4], rtol=1e-10, atol=0)
    shears = [transfer.at(LinearOutput(0.0, {}, {}, {}, {}, {FieldPoint(number, x, 3, 0): 100.0}), s)
              for number, x in ((0, 0.5), (1, 0.0))]
    moved = transfer.at(LinearOutput(0.0, {}, {}, {}, {}, {FieldPoint(0, 0.5, 0, 0): 1.0}), s)
    assert np.allclose(shears[1][4], (shears[0] - 0.3 * s**2 * moved)[4], rtol=1e-8, atol=0)
