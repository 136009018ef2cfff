"""Extremes and zeros of functions of linear outputs: what dense samples of a formula by hand show is found, however
long the time that is looked at."""

from functools import cache

import numpy as np
import pytest
from support.scenes import problem, value

from vibcli.analyses.transient.composition import Composition
from vibcli.analyses.transient.sampled_extremes import SampledSearch
from vibcli.base.errors import PhysicsError
from vibcli.base.work import Work
from vibcli.results import precise_instants

M, K, X0 = 1.0, 100.0, 0.5
FUNCTIONS = {        # of x [m], x' [m/s] and x'' [m/s^2]
    "x*x'": lambda x, v, a: x * v,
    "x*x*x'": lambda x, v, a: x * x * v,
    "x*x''": lambda x, v, a: x * a,
    "T": lambda x, v, a: M * v * v / 2,
    "V": lambda x, v, a: K * x * x / 2,
    "abs(x)-abs(x'*0.1 s)": lambda x, v, a: abs(x) - abs(0.1 * v),
    "max(x, x'*0.2 s)*x": lambda x, v, a: np.maximum(x, 0.2 * v) * x,
    "x/(1 m+x)": lambda x, v, a: x / (1 + x),
    "exp(-x/(1 m))*cos(x'/(1 m/s))": lambda x, v, a: np.exp(-x) * np.cos(v),
    "(x^2+(x'*0.1 s)^2)^(1/2)": lambda x, v, a: np.sqrt(x * x + 0.01 * v * v),
    "atan(x'/(1 m/s))*tanh(x/(1 m))": lambda x, v, a: np.arctan(v) * np.tanh(x),
    "x-0.1 m*sign(x)": lambda x, v, a: x - 0.1 * np.sign(x),
    "ramp(x)*x'": lambda x, v, a: np.maximum(x, 0) * v,
}


def scene(c, until, more=""):
    return problem(f"""
    bodies: {{b: {{mass: 1 kg, slide: x}}}}
    springs: {{s: {{k: 100 N/m, between: [ground, b]}}}}
    dampers: {{d: {{c: {c} N*s/m, between: [ground, b]}}}}
    initial: {{x: 0.5 m}}
    find: [{{response: {{until: {until} s}}}}]
{more}""")


def by_hand(c, t):
    """(x, x', x'') of x(0) = x₀ at rest: x₀ e^{−δt}(cos ω_d t + δ/ω_d sin ω_d t)."""
    d = c / 2
    w = np.sqrt(K - d * d)
    x = X0 * np.exp(-d * t) * (np.cos(w * t) + d / w * np.sin(w * t))
    v = -X0 * np.exp(-d * t) * K / w * np.sin(w * t)
    return x, v, -K * x - c * v


@cache
def dense(c):
    """(instants, the motion at them) of the first seconds, all that a damped motion has."""
    t = np.linspace(0, 6, 600_001)
    return t, by_hand(c, t)


def peaks(function, c, sense):
    """The largest of dense samples."""
    t, motion = dense(c)
    y = sense * function(*motion)
    return sense * y.max(), t[y.argmax()]


@pytest.mark.sweep
@pytest.mark.parametrize("name", FUNCTIONS)
def test_extremes_are_those_of_dense_samples(name):
    one = scene(1, 1e5)
    for which, sense in (("max", 1), ("min", -1)):
        best, at = peaks(FUNCTIONS[name], 1.0, sense)
        found, instant = (value(one, f"{head}({name})") for head in (which, "arg" + which))
        assert sense * (found - best) >= -1e-12                     # none is missed
        if abs(found) > 1e-12:                                      # what dies out does so beyond the samples
            assert found == pytest.approx(best, rel=5e-6, abs=1e-4 if "sign" in name or "abs" in name else 1e-9)
        if abs(found) > 1e-9:
            assert instant == pytest.approx(at, abs=2e-5)


def test_an_extreme_and_its_instant_are_found_to_more_digits_once(monkeypatch):
    searched, rivals = [], precise_instants._rivals
    monkeypatch.setattr(precise_instants, "_rivals", lambda *asked: searched.append(asked[5]) or rivals(*asked))
    one = scene(1, 1)
    assert [value(one, f"{head}(T)") for head in ("min", "argmin")] == [0.0, 0.0]
    assert searched == [-1]


@pytest.mark.parametrize("name", ["x*x'", "x*x''", "abs(x)-abs(x'*0.1 s)", "ramp(x)*x'-0.01 m^2/s"])
def test_passages_are_all_of_those_of_dense_samples(name):
    function = FUNCTIONS.get(name, lambda x, v, a: np.maximum(x, 0) * v - 0.01)
    t = np.linspace(1e-6, 4, 400_001)
    y = function(*by_hand(1.0, t))
    at = t[:-1][np.sign(y[:-1]) != np.sign(y[1:])]
    found = scene(1, 4000).response.signal(_tree(name)).zeros(0.0, 4.0)
    assert len([x for x in found if x > 1e-6]) == len(at)
    assert [x for x in found if x > 1e-6] == pytest.approx(at, abs=2e-5)


def _tree(text):
    from vibcli.symbolic.parser import parse
    return parse(text)


def test_bounds_hold_all_values_of_a_stretch():
    """The property that all rests on: between the ends of any cell value, slope and curvature lie within the bounds."""
    rng = np.random.default_rng(3)
    for name in FUNCTIONS:
        whole = scene(1, 5).response.signal(_tree(name)).along(5.0)
        early = rng.uniform(0, 4, 200)
        late = early + 10.0 ** rng.uniform(-6, 0, 200)
        jet = whole.jet(np.zeros(200, int), early, late)
        for share in (0.0, 0.3, 0.71, 1.0):
            y = whole.at(np.zeros(200, int), early + share * (late - early))
            slack = 1e-12 * np.maximum(1, np.abs(y))
            assert (y >= jet.value.low - slack).all() and (y <= jet.value.high + slack).all(), name
        chord = (whole.at(np.zeros(200, int), late) - whole.at(np.zeros(200, int), early)) / (late - early)
        slack = 1e-13 / (late - early) + 1e-9
        assert (chord >= jet.slope.low - slack).all() and (chord <= jet.slope.high + slack).all(), name
        assert isinstance(whole, Composition)


@pytest.mark.sweep
def test_a_load_of_high_frequency():
    one = scene(1, 100, "    forces: {P: {at: b, force: 5 N*sin(1e4 rad/s*t)}}").response
    signal, t = one.signal(_tree("x'*x''")), np.linspace(0, 0.7, 100_001)
    y, step = signal.values(t), np.linspace(0, t[1], 21)
    beside = t[y > 0.8 * y.max(), None] + [*-step, *step]       # a waving product of 90 samples in each of its waves
    assert signal.extreme(0.0, 100.0, 1)[1] >= signal.values(beside[beside >= 0]).max() * (1 - 1e-12)


@pytest.mark.sweep
def test_the_first_of_equal_peaks_of_a_steady_state():
    text = "    forces: {P: {at: b, force: 5 N*square(7 rad/s*t)}}"
    for c in (0.5, 1, 3):
        one = scene(c, 60, text)
        for name in ("x", "x*x", "x*x'"):
            assert 0 <= value(one, f"argmax(steady({name}))") < 2 * np.pi / 7


@pytest.mark.sweep
def test_a_touch_of_zero_counts_in_small_motions_as_in_full_ones():
    small, full = scene(1, 2), scene(1, 2, "    motion: full")
    for i in range(1, 6):
        for name in ("T", "x*x'", "V"):
            assert value(small, f"zero[{i}]({name})") == pytest.approx(value(full, f"zero[{i}]({name})"), abs=1e-7)
    assert value(small, "zero[2](T)") == pytest.approx(np.pi / np.sqrt(99.75), abs=1e-7)


@pytest.mark.sweep
def test_what_changes_sign_only_by_jumps():
    one = scene(1, 3)
    assert value(one, "max(sign(x))") == 1.0 and value(one, "min(sign(x))") == -1.0
    assert value(one, "zero[1](sign(x))") == pytest.approx(value(one, "zero[1](x)"), abs=1e-12)


@pytest.mark.sweep
def test_samples_are_refined_until_they_resolve():
    def burst(t):
        return np.exp(-((t - 123.456) / 0.4) ** 2) * np.cos(900 * t) + np.sin(t / 3)
    dense = np.linspace(122, 125, 3_000_001)
    found = SampledSearch(burst, 0.0, 4000.0, Work()).extreme(1)
    assert found[1] >= burst(dense).max() - 1e-12 or abs(found[1] - 1) < 1e-9
    with pytest.raises(PhysicsError, match="given up after") as refused:
        SampledSearch(lambda t: np.sin(1e6 * t), 0.0, 1e5, Work())
    assert "--patience 10" in refused.value.hint


def test_what_is_asked_of_the_same_stretches_is_found_once(monkeypatch):
    """Slope and curvature of a stretch come from one jet; arrays that were written over are other stretches."""
    signal = scene(0.5, 3).response.signal(problem("bodies: {b: {mass: 1 kg, slide: x}}\nanswers: {max(x*x'): 1 m^2/s}"
                                                   ).spec.answers[0].asked.tree.args[0])
    found, made = signal.along(3.0), []
    real = found._found
    monkeypatch.setattr(found, "_found", lambda which, *where: made.append(which) or real(which, *where))
    segment, early, late = np.zeros(3, int), np.array([0.0, 0.5, 1.0]), np.array([0.1, 0.6, 1.1])
    slope, curvature = found.terms(None, 1), found.terms(None, 2)
    one, other = slope.bound(segment, early, late), curvature.bound(segment, early, late)
    assert made == ["jet"]
    early += 0.05
    assert not np.array_equal(slope.bound(segment, early, late), one)
    assert not np.array_equal(curvature.bound(segment, early, late), other)
    assert made == ["jet", "jet"]
