"""Motions under long records against their exact exponentials in many digits, and against the path of short ones."""

import subprocess
import sys
from fractions import Fraction
from operator import mul

import numpy as np
import pytest
from mpmath import mp, mpf
from support.responses import EPS

from vibcli import load
from vibcli.analyses.excitation import assembly
from vibcli.analyses.excitation.decompose import forcing_of
from vibcli.analyses.excitation.forcing import TooOften
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.analyses.excitation.recorded_forcing import RecordedForcing
from vibcli.analyses.transient.linear_response import linear_motion
from vibcli.analyses.transient.recorded_errors import RecordedErrors
from vibcli.analyses.transient.recorded_pieces import RecordedPieces
from vibcli.analyses.transient.segments_held import highest, passing
from vibcli.symbolic.expression import Table
from vibcli.symbolic.sampled_functions import Samples

COUNT = 5200
TWO = np.array([[2.0, 0.0], [0.0, 1.0]]), np.array([[1100.0, -300.0], [-300.0, 300.0]])
ALIKE = {       # M, C, K
    "light": (TWO[0], 0.001 * TWO[1], TWO[1]), "undamped": (TWO[0], 0 * TWO[1], TWO[1]),
    "general": (TWO[0], np.array([[3.0, -1.0], [-1.0, 1.0]]), TWO[1]),
    "critical": (np.eye(2), np.diag([2.0, 0.4]), np.diag([1.0, 40.0])),
    "drift": (TWO[0], np.array([[0.2, -0.2], [-0.2, 0.2]]), np.array([[300.0, -300.0], [-300.0, 300.0]])),
    "dragged": (TWO[0], np.diag([0.5, 0.2]), np.array([[300.0, -300.0], [-300.0, 300.0]])),
    "stiff": (np.eye(2), np.diag([5e3, 0.1]), np.diag([1e6, 9.0])),
}
UNITS, BITS = 2**10, 160


def record(steps, kind="walk", seed=1):
    """Samples at times that doubles hold; steps: even or uneven."""
    dice = np.random.default_rng(seed)
    lengths = np.full(COUNT - 1, 16) if steps == "even" else dice.integers(3, 40, COUNT - 1)
    times = np.append(0, np.cumsum(lengths)) / UNITS
    values = np.cumsum(dice.normal(size=COUNT)) if kind == "walk" else np.sin(13.37 * times) + 0.01 * dice.normal(
        size=COUNT)
    values[[0, -1]] = 0.0
    return Samples(times.tolist(), values.tolist())


def forcing(samples, shares, text=lambda table, call: call):
    """Of the record, times a share, on each channel."""
    table = Table()
    table.records["ag"] = samples
    table.time = table.variable("t")
    node = text(table, table.call("ag", table.time))
    return forcing_of({i: node * share for i, share in shares.items()}, table.time, {}, 2)


def motion_of(matrices, given, start=(0.01, -0.02)):
    return linear_motion(*matrices, given, np.array(start), np.zeros(2))


def exact(matrices, samples, shares, marks, start=(0.01, -0.02)):
    """(number, (q, q̇, q̈)) at samples: ż = A z + b f by the exponential of the system with f and ḟ, step by step, in
    whole multiples of 2^−BITS: steps are whole multiples of 1/UNITS."""
    M, C, K = (mp.matrix(matrix.tolist()) for matrix in matrices)
    inverse = M**-1
    A = mp.zeros(6)
    A[0, 2] = A[1, 3] = A[4, 5] = 1
    push = inverse * mp.matrix([mpf(shares.get(i, 0)) for i in range(2)])
    left, drag = inverse * K, inverse * C
    for i in range(2):
        A[2 + i, 4] = push[i]
        for j in range(2):
            A[2 + i, j], A[2 + i, 2 + j] = -left[i, j], -drag[i, j]
    once = [[whole(x) for x in row] for row in mp.expm(A / UNITS).tolist()]
    known, rates = [[[whole(i == j) for j in range(6)] for i in range(6)]], A.tolist()[2:4]
    values, state = [whole(value) for value in samples.values], [whole(start[0]), whole(start[1]), 0, 0]
    for k in range(marks[-1] + 1):
        if k in marks:
            z = [mp.ldexp(x, -BITS) for x in state]
            yield k, (z[:2], z[2:], [mp.fdot(row, [*z, mpf(samples.values[k]), 0]) for row in rates])
        count = int((samples.times[k + 1] - samples.times[k]) * UNITS)
        while len(known) <= count:
            known.append([times(row, zip(*once, strict=True)) for row in known[-1]])
        z = [*state, values[k], (values[k + 1] - values[k]) * UNITS // count]
        state = times(z, known[count][:4])


def whole(value):
    """A number as a multiple of 2^−BITS."""
    return int(mp.nint(mp.ldexp(value, BITS)))


def times(values, rows):
    return [sum(map(mul, values, row)) >> BITS for row in rows]


@pytest.mark.sweep
@pytest.mark.parametrize("steps", ["even", "uneven"])
@pytest.mark.parametrize("system", ALIKE)
def test_states_are_those_of_the_exponential(system, steps):
    """Within their bounds, and 4 eps ωt of the largest so far."""
    samples, shares = record(steps, "tone" if system == "undamped" else "walk"), {0: 1.0, 1: -2.5}
    motion = motion_of(ALIKE[system], forcing(samples, shares))
    assert isinstance(motion.pieces(np.inf), RecordedPieces)
    fastest = max(abs(node) for block in motion.blocks for node in block.nodes)
    with mp.workdps(40):
        for until, parts in exact(ALIKE[system], samples, shares, (1, 63, 64, 65, 1000, COUNT - 3)):
            t = samples.times[until]
            for kind, values in zip("qva", parts, strict=True):
                for i, value in enumerate(values):
                    output = LinearOutput(**{kind: {i: 1.0}})
                    off = float(abs(mpf(float(motion.values(output, [t])[0])) - value))
                    bound = motion.errors(output, np.array([t]))[0]
                    size = np.abs(motion.values(output, np.linspace(0, t, 500))).max()
                    assert off <= bound, (until, kind, i)
                    assert off <= 4 * EPS * max(1.0, fastest * t) * max(size, float(abs(value))), (until, kind, i)
                    assert bound <= 1e-8 * size or system in ("drift", "dragged", "stiff")


def test_bounds_are_rarely_far_off():
    samples = record("even")
    motion = motion_of(ALIKE["light"], forcing(samples, {0: 1.0}))
    t = samples.times[-3]
    assert isinstance(motion.pieces(np.inf).errors, RecordedErrors)
    with mp.workdps(40):
        (_, ((value, _), *_)), = exact(ALIKE["light"], samples, {0: 1.0}, (COUNT - 3,))
        off = float(abs(mpf(float(motion.values(LinearOutput(q={0: 1.0}), [t])[0])) - value))
    assert off <= motion.errors(LinearOutput(q={0: 1.0}), np.array([t]))[0] <= 1e6 * EPS * abs(float(value)) + 1e4 * off


# the path of short records

OUTPUTS = [LinearOutput(q={1: 1.0}), LinearOutput(0.3, v={0: 1.0}), LinearOutput(a={1: 1.0}, q={0: 2.0}),
           LinearOutput(a={0: 1.0}, channels={0: -0.5})]
TEXTS = {
    "alone": lambda table, call: call,
    "beside a sine": lambda table, call: call + table.call("sin", table.time * 7) * 3 + 2,
    "beside what dies out": lambda table, call: call + table.call("exp", table.time * -1) * 3 + table.time,
    "later": lambda table, call: call + table.call("ag", table.time - table.number(Fraction(7, 10))) * 2,
    "in a window": lambda table, call: call * (table.call("step", table.time - 1) - table.call("step", table.time - 3)),
}


def both(monkeypatch, matrices, text, samples):
    found = []
    for least in (10**9, 1):
        monkeypatch.setattr(assembly, "LENGTHY", least)
        found.append(motion_of(matrices, forcing(samples, {0: 1.0, 1: 2.0}, text)))
    assert [isinstance(motion.pieces(np.inf), RecordedPieces) for motion in found] == [False, True]
    return found


def short(count=300, jump=True, seed=4):
    dice = np.random.default_rng(seed)
    values = np.cumsum(dice.normal(size=count))
    values[100:110] = values[99]
    values[[0, -1]] = (values[[0, -1]] if jump else 0.0)
    return Samples(np.cumsum(dice.uniform(0.004, 0.03, count)).tolist(), values.tolist())


@pytest.mark.sweep
@pytest.mark.parametrize("system", ["light", "critical", "drift", "dragged"])
@pytest.mark.parametrize("text", TEXTS)
def test_long_records_move_as_short_ones(system, text, monkeypatch):
    one, other = both(monkeypatch, ALIKE[system], TEXTS[text], short())
    times = np.sort(np.random.default_rng(2).uniform(0, 6, 300))
    for output in OUTPUTS:
        for order in range(3):
            x, y = (motion.values(output, times, order) for motion in (one, other))
            assert np.abs(x - y).max() <= 1e-11 * np.abs(x).max()
        for sense in ("max", "min"):
            (t, x), (u, y) = (motion.extreme(output, 0.2, 5.9, sense) for motion in (one, other))
            assert x == pytest.approx(y, rel=1e-11, abs=1e-13)
            assert t == pytest.approx(u, rel=1e-6)
        zeros = [motion.zeros(output, 0.1, 5.0) for motion in (one, other)]
        assert len(zeros[0]) == len(zeros[1]) and np.allclose(*zeros, rtol=1e-9)
        ends = [motion.errors(output, np.array([5.0]))[0] for motion in (one, other)]
        assert ends[1] <= 100 * ends[0] and ends[0] <= 1000 * ends[1]


@pytest.mark.parametrize("text", ["alone", "beside a sine", "later"])
def test_what_lasts_and_what_dies_out(text, monkeypatch):
    one, other = both(monkeypatch, ALIKE["general"], TEXTS[text], short(jump=False))
    times = np.linspace(0.0, 9.0, 50)
    for part in ("steady", "transient"):
        x, y = (getattr(motion, part).values(OUTPUTS[0], times) for motion in (one, other))
        assert np.abs(x - y).max() <= 1e-11 * max(np.abs(x).max(), 1e-3)
    x, y = (motion.final(OUTPUTS[0]) if text != "beside a sine" else 0.0 for motion in (one, other))
    assert x == pytest.approx(y, abs=1e-12)


def test_what_follows_its_load_at_once(monkeypatch):
    """Springs alone: no block has a state."""
    samples, none = short(), np.zeros((2, 2))
    one, other = both(monkeypatch, (none, none, np.diag([50.0, 20.0])), TEXTS["alone"], samples)
    assert not other.blocks
    t = samples.times[40]
    assert other.values(OUTPUTS[0], [t])[0] == pytest.approx(2 * samples.values[40] / 20, rel=1e-14)
    assert one.extreme(OUTPUTS[0], 0, 4, "max") == other.extreme(OUTPUTS[0], 0, 4, "max")
    assert other.errors(OUTPUTS[0], np.array([t]))[0] == pytest.approx(one.errors(OUTPUTS[0], np.array([t]))[0])


def test_blows_of_rates_of_records(monkeypatch):
    """The second rate strikes at each sample."""
    samples = short(jump=False)

    def rates(table, call):
        from vibcli.symbolic.derivatives import gradient

        return gradient(gradient(call)[table.time])[table.time]

    one, other = both(monkeypatch, ALIKE["critical"], rates, samples)
    times = np.array([0.05, 1.0, 2.0, 5.5])
    x, y = (motion.values(OUTPUTS[0], times) for motion in (one, other))
    assert np.abs(x - y).max() <= 1e-11 * np.abs(x).max()
    x, y = (motion.extreme(OUTPUTS[1], 0, 5, "max")[1] for motion in (one, other))
    assert x == pytest.approx(y, rel=1e-11)


SCENE = """
records: {ag: {file: a.csv, unit: N}, u: {file: a.csv, unit: mm}}
bodies:
  cart: {mass: 3 kg, at: [0, 0], slide: {along: [1, 0], by: u(t)}}
  b: {mass: 2 kg, at: [0, 1 m], slide: {along: [1, 0], by: x, carrier: cart}}
  c: {mass: 1 kg, at: [0, 1 m], slide: {along: [1, 0], by: y, carrier: cart}}
springs: {s: {k: 800 N/m, stretch: x}, r: {k: 300 N/m, stretch: y - x}}
dampers: {d: {c: 3 N*s/m, stretch: x}}
forces:
  f: {at: c, force: [ag(t - 0.3 s), 0]}
  g: {at: b, force: [2*ag(t) + 3 N*sin(7 rad/s*t), 0]}
motion: small
find: [{response: {until: 9 s}}]
"""
ASKED = ("max(abs(x))", "argmax(abs(x))", "min(x*y)", "max(y')", "argmin(y)", "max(s.force)", "y''(3.21 s)",
         "max(max(x, 2*y))", "steady(x)(2 s)", "transient(x)(2 s)", "max(T)")


@pytest.mark.sweep
def test_what_is_asked_of_a_scene_is_found_alike(monkeypatch, tmp_path):
    samples = short(jump=False)
    (tmp_path / "a.csv").write_text("".join(f"{t!r},{a!r}\n" for t, a in zip(samples.times, samples.values,
                                                                           strict=True)))
    (tmp_path / "scene.yaml").write_text(SCENE)
    found = []
    for least in (10**9, 1):
        monkeypatch.setattr(assembly, "LENGTHY", least)
        scene = load(tmp_path / "scene.yaml")
        found.append([scene[text].value for text in ASKED])
    assert found[1] == pytest.approx(found[0], rel=1e-9)


# what is passed over

def test_few_segments_are_searched():
    samples = record("even")
    motion = motion_of(ALIKE["light"], forcing(samples, {0: 1.0}))
    pieces, output, ends = motion.pieces(np.inf), OUTPUTS[0], (0.0, samples.times[-1])
    for sign in (1.0, -1.0):
        part, = highest(pieces, output, ends, sign, 0.0)
        assert len(part[1]().whole) <= 20
    parts, leaps = passing(pieces, output, ends)
    found = motion.zeros(output, *ends)
    assert len(found) <= sum(len(part().whole) for part in parts) <= 2 * len(found) + 10 and not len(leaps)


def test_what_forces_share_is_held_once():
    given = forcing(record("even"), {0: 1.0, 1: -2.5})
    assert isinstance(given, RecordedForcing) and len(given.starts) == COUNT
    assert [wave.shares for wave in given.waves] == [{0: 1.0, 1: -2.5}] * 2


def test_breaks_that_forces_share_count_once(monkeypatch):
    monkeypatch.setattr(assembly, "MOST_SAMPLES", COUNT)
    forcing(record("even"), {0: 1.0, 1: -2.5})
    monkeypatch.setattr(assembly, "MOST_SAMPLES", COUNT - 1)
    with pytest.raises(TooOften, match=f"{COUNT} stretches of time, and {COUNT - 1} are the most"):
        forcing(record("even"), {0: 1.0, 1: -2.5})


@pytest.mark.sweep
def test_what_is_not_held_as_arrays_is_followed_as_before():
    given = forcing(record("even"), {0: 1.0}, lambda table, call: call * table.call("sin", table.time))
    assert not given.recorded and len(given.pieces) == COUNT


CHILD = """
import sys
import numpy as np
from vibcli.analyses.excitation.linear_output import LinearOutput
from rooms.analyses.transient.test_long_records import ALIKE, forcing, motion_of, record
before = set(sys.modules)
motion = motion_of(ALIKE["light"], forcing(record("even"), {0: 1.0}))
motion.extreme(LinearOutput(q={0: 1.0}), 0.0, 80.0), motion.errors(LinearOutput(q={0: 1.0}), np.array([80.0]))
print(sorted(name for name in set(sys.modules) - before if name.split(".")[0] in ("scipy", "sympy", "matplotlib")))
"""


@pytest.mark.sweep
def test_no_scipy_is_needed():
    done = subprocess.run([sys.executable, "-c", CHILD], capture_output=True, text=True, timeout=120, check=False,
                          cwd="tests")
    assert done.stdout.strip() == "[]", done.stderr
