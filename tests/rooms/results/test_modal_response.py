"""Motions in time of scenes with beams by modes: against series of their own, Laplace transforms and energies."""

from textwrap import dedent

import numpy as np
import pytest
from scipy.optimize import brentq
from support.scenes import problem

from vibcli.analyses.continuous import modal_motion, modal_states, uncounted_modes
from vibcli.analyses.continuous.mode_basis import ModeBasis
from vibcli.base.errors import NoBound, PhysicsError
from vibcli.language.signal_names import LEFT_OF
from vibcli.language.signals_of_places import with_places
from vibcli.results import modal_response
from vibcli.results.internal_forces import forces_in_time
from vibcli.results.modal_response import ModalResponse
from vibcli.results.modal_signals import ModalSignal
from vibcli.results.wave_response import WaveResponse
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import NameRef

CANTILEVER = dedent("""\
    parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}
    beams:
      arm: {length: L, EI: EI, mass_per_length: mu, left: clamped, right: free}
    """)
PULLED = "points: {tip: {body: arm, at: L}}\nforces: {pull: {at: tip, force: 1 N}}\ninitial: {released: pull}\n"
TIMES = np.array([0.0, 0.05, 0.37, 0.8, 2.5])


def signal(scene, text):
    return scene.response.signal(with_places(parse(text), scene.spec.members))


def roots(count):
    """βL of a cantilever, cos βL cosh βL = −1."""
    def equation(b):
        return np.cos(b) + 1 / np.cosh(b)

    return np.array([brentq(equation, (j - 1) * np.pi + 1e-9, j * np.pi, xtol=1e-15) if 1 < j < 14 else
                     1.875104068711961 if j == 1 else (j - 0.5) * np.pi for j in range(1, count + 1)])


def shape(b, x):
    """That of a cantilever, 2 at its end but for the sign: written with what fades from both ends."""
    e = np.exp(-b)
    ratio = (1 + 2 * np.cos(b) * e + e * e) / (1 - e * e + 2 * np.sin(b) * e)
    growing = (1 - ratio) / 2 * np.exp(np.minimum(b * x, 300.0))
    large = b > 20
    growing = np.where(large, -(np.cos(b) - np.sin(b)) * np.exp(-b * (1 - x)), growing)
    return growing + (1 + ratio) / 2 * np.exp(-b * x) - np.cos(b * x) + ratio * np.sin(b * x)


def series(x, b, weights, times):
    return (shape(b, x) * weights) @ np.cos(np.outer(b * b, times))


@pytest.mark.sweep
@pytest.mark.parametrize("x", [0.5, 1.0])
def test_a_cantilever_let_go_is_the_sum_of_its_modes(x):
    scene = problem(CANTILEVER + PULLED)
    assert isinstance(scene.response, ModalResponse)
    found, b = signal(scene, f"arm.u({x}*L)"), roots(4000)
    expected = series(x, b, shape(b, 1.0) / b**4, TIMES)
    off = np.abs(found.values(TIMES) - expected)
    assert off.max() <= 1e-10 / 3
    assert (off <= [found.error(t) + 1e-13 for t in TIMES]).all()
    grid = np.linspace(0.0, 5.0, 3001)
    time, highest = found.extreme(0.0, 5.0, 1)
    near = time + np.linspace(-2e-3, 2e-3, 4001)
    assert highest >= series(x, b[:60], shape(b, 1.0)[:60] / b[:60]**4, grid).max() - 1e-6
    assert highest == pytest.approx(found.values(near[near >= 0]).max(), abs=1e-11)


@pytest.mark.sweep
def test_a_load_that_begins_and_one_that_oscillates():
    """η̈ + b⁴ η = φ f by hand, of each mode."""
    b = roots(4000)
    step = signal(problem(CANTILEVER + "points: {mid: {body: arm, at: L/2}}\n"
                          "forces: {push: {at: mid, force: 1 N*step(t - 0.05 s)}}\n"), "arm.u(0.3*L)")
    late = np.maximum(TIMES - 0.05, 0.0)
    expected = (shape(b, 0.3) * shape(b, 0.5) / b**4) @ (1 - np.cos(np.outer(b * b, late)))
    assert np.abs(step.values(TIMES) - expected).max() <= 1e-11
    shaken = signal(problem(CANTILEVER + "points: {mid: {body: arm, at: L/2}}\n"
                            "forces: {push: {at: mid, force: 1 N*sin(5 rad/s*t)}}\n"), "arm.u(0.3*L)")
    own = np.sin(5 * TIMES) - 5 / b[:, None]**2 * np.sin(np.outer(b * b, TIMES))
    expected = (shape(b, 0.3) * shape(b, 0.5) / (b**4 - 25)) @ own
    assert np.abs(shaken.values(TIMES) - expected).max() <= 1e-13


@pytest.mark.sweep
def test_fields_at_the_start():
    """∫ φ u dx by Gauss's rule, of displacements whose moment does not fit the free end and of velocities."""
    b, (at, weights) = roots(400), np.polynomial.legendre.leggauss(20)
    at, weights = ((np.arange(100)[:, None] + (1 + at) / 2) / 100).ravel(), np.tile(weights / 200, 100)
    shapes = np.array([shape(b, x) for x in at]).T
    for text, field, rate in (("arm.u: 1 mm*(x/(1 m))^2", 1e-3 * at**2, 0), ("arm.u': 1 m/s*sin(2*x/(1 m))",
                                                                           np.sin(2 * at), 1)):
        found = signal(problem(CANTILEVER + f"initial: {{{text}}}\n"), "arm.u(0.7*L)")
        turning = np.outer(b * b, TIMES)
        curve = np.sin(turning) / b[:, None]**2 if rate else np.cos(turning)
        expected = (shape(b, 0.7) * (shapes @ (weights * field))) @ curve
        assert np.abs(found.values(TIMES) - expected).max() <= (1e-9 if rate else 1e-7) * np.abs(expected).max()


@pytest.mark.sweep
def test_shears_without_a_bound_are_refused():
    scene = problem(CANTILEVER + PULLED)
    with pytest.raises(PhysicsError, match="no bound"):
        signal(scene, "arm.shear(0 m)").values(TIMES)
    moment = signal(scene, "arm.moment(0 m)")
    assert 1e-5 < moment.error(0.37) < 1e-2
    assert abs(moment.values(np.array([0.0]))[0] - 1) <= moment.error(0.0)


@pytest.mark.sweep
def test_shears_of_a_beam_whose_modes_are_damped_evenly():
    """η̈ + 2ζω η̇ + ω² η = 0 by hand; what is left out fades soon after the start."""
    zeta, b = 0.02, roots(600)
    scene, late = problem(CANTILEVER + PULLED + "damping: {modal: 2 %}\n"), TIMES[1:]
    found, still = signal(scene, "arm.shear(0 m)"), np.sqrt(1 - zeta**2)
    turning = np.outer(b * b, late)
    curve = np.exp(-zeta * turning) * (np.cos(still * turning) + zeta / still * np.sin(still * turning))
    ratio = (np.cosh(np.minimum(b, 300)) + np.cos(b)) / (np.sinh(np.minimum(b, 300)) + np.sin(b))
    expected = (-2 * b**3 * ratio * shape(b, 1.0) / b**4) @ curve
    off = np.abs(found.values(late) - expected)
    assert (off <= [found.error(t) + 1e-8 for t in late]).all()
    assert max(found.error(t) for t in late) <= 1e-6
    with pytest.raises(PhysicsError, match="no bound"):
        found.values(np.array([0.0]))


def test_bounds_right_after_a_jump_follow_what_is_left_out(monkeypatch):
    """Of a bar, damped evenly, whose force falls as 1/n: Σ e^{−ζωτ}/n over n > N is less than ln(1 + 1/(ζωτ))."""
    monkeypatch.setattr(modal_response, "MOST", {True: 256, False: 256})
    scene = problem("parameters: {L: 1 m, EA: 1 N, mu: 1 kg/m}\n"
                    "bars: {rod: {length: L, EA: EA, mass_per_length: mu, left: clamped}}\n"
                    "points: {tip: {body: rod, at: L}}\nforces: {push: {at: tip, force: 1 N*step(t)}}\n"
                    "damping: {modal: 1 %}\n")
    found = signal(scene, "rod.force(L/2)")
    for t in (1e-5, 1e-3, 0.1):
        assert np.abs(found.values(np.array([t]))) <= found.error(t) <= 4 * np.log1p(1 / (0.01 * 256 * np.pi * t))


def test_what_a_sudden_load_brings_begins_at_zero(monkeypatch):
    """The moment at the clamp passes zero without end just after: all of that is one zero."""
    monkeypatch.setattr(modal_response, "MOST", {True: 256, False: 256})
    scene = problem(CANTILEVER + "points: {tip: {body: arm, at: L}}\nforces: {push: {at: tip, force: 1 N*step(t)}}\n")
    for name in ("arm.moment(0 m)", "arm.u(L/2)"):
        assert signal(scene, name).first_zeros(3.0, 1) == [0.0]


@pytest.mark.sweep
def test_zeros_and_products():
    scene = problem(CANTILEVER + PULLED)
    end = signal(scene, "arm.u(L)")
    found = end.zeros(0.0, 3.0)
    assert len(found) == 3
    assert np.abs(end.values(np.array(found))).max() <= 1e-12
    assert end.error_of_zero(found[0]) <= 1e-9
    time, lowest = end.extreme(0.0, 3.0, -1)
    grid = np.linspace(0, 3, 4001)
    assert lowest <= end.values(grid).min() + 1e-12
    assert end.values(np.array([time]))[0] == pytest.approx(lowest, abs=1e-13)
    square = signal(scene, "arm.u(L)*arm.u(L)")
    assert square.extreme(0.0, 3.0, 1)[1] == pytest.approx(1 / 9, rel=1e-9)


BARS = {"free": ("""\
    parameters: {L: 1 m, E: 1 Pa, A: 1 m^2, rho: 1 kg/m^3}
    bars:
      rod: {length: L, E: E, A: A, rho: rho, attached: [{at: L, mass: 0.7 kg}]}
    points: {tip: {body: rod, at: L}}
    forces: {push: {at: tip, force: 1 N*(t/(1 s))^2*exp(-t/(0.5 s))}}
    initial: {rod.u': 0.2 m/s*x/L}
    """, ("rod.u(L)", "rod.u(0.2*L)", "rod.u'(L)", "rod.force(L/2)")), "stepped": ("""\
    parameters: {L: 1 m, E: 1 Pa, A: 1 m^2, rho: 1 kg/m^3}
    bars:
      rod: {length: L, E: E, A: A, rho: rho, left: clamped, segments: [{length: 0.4*L}, {length: 0.6*L, A: 3 m^2}]}
    points: {tip: {body: rod, at: L}}
    forces: {push: {at: tip, force: 1 N*sin(7 rad/s*t)}}
    """, ("rod.u(L)", "rod.u(0.2*L)")), "shaken": ("""\
    parameters: {L: 3 m, N: 90 N, mu: 0.1 kg/m}
    bodies: {hand: {slide: 2 cm*sin(4 rad/s*t)}}
    strings:
      cord: {length: L, preload: N, mass_per_length: mu, left: {clamped: hand}, right: clamped}
    """, ("cord.u(L/3)", "cord.u(0.9*L)"))}


@pytest.mark.sweep
@pytest.mark.parametrize("kind", BARS)
def test_modes_agree_with_waves_within_their_bounds(kind):
    text, names = BARS[kind]
    scene, times = problem(text), np.array([0.03, 0.37, 1.93])
    for name in names:
        tree = with_places(parse(name), scene.spec.members)
        expected = WaveResponse(scene).signal(tree).values(times)
        found = ModalResponse(scene).signal(tree)
        off = np.abs(found.values(times) - expected)
        assert off.max() <= 1e-4 * np.abs(expected).max()
        assert (off <= [found.error(t) + 1e-13 for t in times]).all()


@pytest.mark.sweep
def test_drag_along_a_pinned_beam_on_a_foundation():
    """η̈ + c/μ η̇ + (π⁴ + k) η = 0 of a half sine, which is a mode; it decays with e^{−ct/2μ}."""
    scene = problem("""\
        parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}
        beams:
          arm: {length: L, EI: EI, mass_per_length: mu, drag: 3 N*s/m^2, foundation: 20 N/m^2, left: pinned,
                right: pinned}
        initial: {arm.u: 2 mm*sin(pi*x/L)}
        """)
    found = signal(scene, "arm.u(0.3*L)")
    turning = np.sqrt(np.pi**4 + 20 - 1.5**2)
    curve = np.exp(-1.5 * TIMES) * (np.cos(turning * TIMES) + 1.5 / turning * np.sin(turning * TIMES))
    assert np.abs(found.values(TIMES) - 2e-3 * np.sin(0.3 * np.pi) * curve).max() <= 1e-15
    bend = signal(scene, "arm.moment(0.5*L)")
    assert np.abs(bend.values(TIMES) + 2e-3 * np.pi**2 * curve).max() <= bend.error(0.0) <= 1e-9


def test_a_beam_on_a_shaken_base_moves_with_it():
    """u = s + w with η̈ + b⁴ η = −s̈ ∫ φ dx by hand; at first it rests while its base has a velocity."""
    scene = problem("""\
        parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m, Y: 1 mm}
        bodies: {base: {slide: Y*sin(2 rad/s*t)}}
        beams:
          arm: {length: L, EI: EI, mass_per_length: mu, left: {clamped: base}}
        """)
    b, found = roots(400), signal(scene, "arm.u(L)")
    carried = 2 / b * (1 + np.exp(-2 * b) + 2 * np.cos(b) * np.exp(-b)) / (
        1 - np.exp(-2 * b) + 2 * np.sin(b) * np.exp(-b))
    own = 4 * (np.sin(2 * TIMES) - 2 / b[:, None]**2 * np.sin(np.outer(b * b, TIMES))) / (b**4 - 4)[:, None]
    begun = -2 * np.sin(np.outer(b * b, TIMES)) / b[:, None]**2
    expected = np.sin(2 * TIMES) + (shape(b, 1.0) * carried) @ (own + begun)
    assert np.abs(found.values(TIMES) - 1e-3 * expected).max() <= 1e-10


@pytest.mark.sweep
def test_a_field_on_a_shaken_base_adds_the_motion_that_it_starts_on_one_at_rest():
    scene = CANTILEVER.replace("mu: 1 kg/m}", "mu: 1 kg/m, a: 1 mm}").replace("clamped,", "HELD,")
    driven = scene.replace("HELD", "{clamped: base}") + "bodies: {base: {slide: a*sin(2 rad/s*t)}}\n"
    still, field = scene.replace("HELD", "clamped"), "initial: {arm.u: a*(x/L)^2}\n"
    both, alone, free = (signal(problem(text), "arm.u(L)") for text in (driven + field, driven, still + field))
    assert np.abs(both.values(TIMES) - alone.values(TIMES) - free.values(TIMES)).max() <= 1e-12


@pytest.mark.sweep
def test_values_after_a_jump_of_the_velocity_of_a_base_are_read_of_many_modes():
    """The same with 200,000 modes, −2 Σ φ G sin(b² t)/b² falling like b⁻³: to 1e-10 of the largest, as is told."""
    scene = problem("""\
        parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m, Y: 1 mm}
        bodies: {base: {slide: Y*sin(2 rad/s*t)}}
        beams:
          arm: {length: L, EI: EI, mass_per_length: mu, left: {clamped: base}}
        """)
    b, t = np.concatenate([roots(40), (np.arange(40, 200_000) + 0.5) * np.pi]), 0.7
    carried = 2 / b * (1 + np.exp(-2 * b) + 2 * np.cos(b) * np.exp(-b)) / (
        1 - np.exp(-2 * b) + 2 * np.sin(b) * np.exp(-b))
    own = 4 * (np.sin(2 * t) - 2 / b**2 * np.sin(b * b * t)) / (b**4 - 4) - 2 * np.sin(b * b * t) / b**2
    whole = signal(scene, "arm.u(L)")
    found, largest = whole.read_at(t), np.abs(whole.values(np.linspace(0, 3, 100))).max()
    expected = 1e-3 * (np.sin(2 * t) + (shape(b, 1.0) * carried * own)[::-1].sum())
    assert abs(found.values(np.array([t]))[0] - expected) <= found.error(t) <= 1e-10 * largest


def test_modes_of_a_string_that_rest_at_every_place_of_a_grid():
    scene = problem("""\
        parameters: {L: 3 m, N: 90 N, mu: 0.1 kg/m}
        strings:
          cord: {length: L, preload: N, mass_per_length: mu, left: clamped, right: clamped}
        """)
    basis = ModeBasis(scene.modal.modes.first(128), scene.configuration.linear_system.pieces)
    for mode in (64, 128):
        found = basis.field(0, np.array([0.9, 2.2]))[:, mode - 1]
        expected = np.sin(mode * np.pi * np.array([0.9, 2.2]) / 3)
        assert found[0] * expected[1] == pytest.approx(found[1] * expected[0], rel=1e-9)


def test_what_rests_under_a_steady_load_has_its_extremes_at_once():
    scene = problem(CANTILEVER + PULLED.replace("initial: {released: pull}\n", ""))
    tip = signal(scene, "arm.u(L)")
    assert tip.extreme(0.0, 50.0, 1) == (0.0, pytest.approx(1 / 3, rel=1e-12))
    assert tip.extreme(0.0, 50.0, -1)[1] == pytest.approx(1 / 3, rel=1e-12)
    assert tip.zeros(0.0, 50.0) == []


@pytest.mark.sweep
@pytest.mark.parametrize(("rest", "end", "name"), [
    ("forces: {push: {at: tip, force: 1 N*(step(t - 0.1 s) - step(t - 0.3 s))}}\n", 1.5, "arm.u(L)"),
    ("forces: {push: {at: tip, force: 1 N*(step(t) + step(t - 1 s))}}\ndamping: {modal: 5 %}\n", 1.2,
     "arm.moment(0 m)")])
def test_no_error_lifts_a_motion_above_its_extreme(rest, end, name, monkeypatch):
    """What modes left out add is looked at on the whole window: at its instant alone an extreme knows less of it."""
    monkeypatch.setattr(ModalResponse, "limit", 4096)
    scene = problem(CANTILEVER + "points: {tip: {body: arm, at: L}}\n" + rest)
    times = np.concatenate([np.linspace(0.0, end, 60), np.geomspace(1e-7, end, 40)])
    found = signal(scene, name)
    values, errors = found.values(times), np.array([found.error(t) for t in times])
    for sense in (1, -1):
        top = found.extreme(0.0, end, sense)
        off = found.error_of_extreme(0.0, end, top, sense)
        assert found.error(top[0]) <= off
        assert (sense * values + errors <= sense * top[1] + off * (1 + 1e-9)).all()


@pytest.mark.sweep
def test_an_extreme_of_what_has_no_bound_at_first_is_not_told():
    scene = problem(CANTILEVER + "damping: {modal: 5 %}\ninitial: {arm.u: 0.1*x^2/L}\n")
    found = signal(scene, "arm.moment(0 m)")
    top = 0.1219, float(found.values(np.array([0.1219]))[0])
    assert found.error(top[0]) < 1e-6
    with pytest.raises(NoBound, match="no bound"):
        found.error_of_extreme(0.0, 1.0, top, 1)


@pytest.mark.sweep
@pytest.mark.parametrize("load", ["1 N*step(t) + 0.5 N*cos(7 rad/s*t)", "1 N*(step(t) - step(t - 0.1 s))"])
def test_the_bound_of_modes_that_creep_holds(load):
    """Of few modes against many, in displacements, rates and moments."""
    scene = problem(CANTILEVER + "points: {tip: {body: arm, at: L}}\nforces: {push: {at: tip, force: " + load + "}}\n"
                    "damping: {caughey: {1: 1 %, 2: 2 %, 3: 8 %}}\n")
    times = np.geomspace(1e-5, 2.0, 30)
    for name, order in (("arm.u(L)", 0), ("arm.u(L)", 1), ("arm.moment(0 m)", 0)):
        many = signal(scene, name)
        few = scene.response.motion(32)
        off = np.abs(few.values(many.reads, times, order) - scene.response.motion(512).values(many.reads, times, order))
        bounds = np.array([few.bound(many.reads, t, order) for t in times])
        assert (off <= bounds + 1e-13).all()
        assert off.max() >= bounds.max() / 1e5


def test_what_a_load_does_to_each_mode_is_found_once(monkeypatch):
    """However often the motion is looked at: once of each load, and the same numbers."""
    found = []

    def counted(states, stroke):
        found.append(stroke)
        return modal_states.parts(states, stroke)

    monkeypatch.setattr(modal_motion, "parts", counted)
    scene = problem(CANTILEVER + PULLED.replace("1 N}", "1 N*sin(3 rad/s*t)}").split("initial")[0])
    tip = signal(scene, "arm.u(L)")
    first = tip.values(TIMES)
    strokes = len(found)
    assert strokes
    assert (tip.values(TIMES) == first).all()
    tip.values(0.5 * TIMES)
    assert len(found) == strokes


@pytest.mark.sweep
def test_values_need_no_sums_of_what_is_left_out_of_them(monkeypatch):
    """Whether what modes left out add has a bound is known without that bound, which is found where it is told."""
    one, found = problem("""
        beams:
          b: {length: 1 m, EI: 100 N*m^2, mass_per_length: 1 kg/m, left: clamped,
              attached: [{at: 0.5 m, k: 1 N/m}]}
        points: {tip: {body: b, at: 1 m}}
        forces: {f: {at: tip, force: 10 N*sin(20 rad/s*t)}}
        """), []
    summed = uncounted_modes.motions_squared
    monkeypatch.setattr(uncounted_modes, "motions_squared", lambda *given: found.append(given) or summed(*given))
    signals = [one.response.signal(with_places(parse(f"b.shear({x} m)"), one.spec.members)) for x in (0.0, 0.2, 0.7)]
    assert all(signal.values(np.array([0.1]))[0] for signal in signals)
    assert {len(pieces) for _, _, pieces, *_ in found} == {2}       # of loads alone: none of a piece parted at a place
    assert 0 < signals[1].error(0.1) < np.inf and len(found[-1][2]) == 3


@pytest.mark.sweep
def test_forces_along_a_piece_are_read_of_one_motion(monkeypatch):
    """Those at the ends of pieces as any others, by signals of their own."""
    scene = problem(CANTILEVER.replace("length: L", "from: [0, 0], to: [L, 0]").replace(
        "right: free", "attached: [{at: 0.4 m, mass: 1 kg}]") + dedent("""\
        gravity: 9.81 m/s^2
        forces: {blow: {body: arm, per_length: 1 N/m*sin(3 rad/s*t)}}
        """))
    places, asked, plain = np.array([0.13, 0.27, 0.4]), [], ModalResponse.signal
    monkeypatch.setattr(ModalResponse, "signal", lambda self, tree: asked.append(tree) or plain(self, tree))
    found = {force.part: force.stretches[0].values(places) for force in forces_in_time(scene, 0.2)[0]}
    for part in ("shear", "moment"):
        names = [f"arm.{part}({x} m{LEFT_OF * bool(x == 0.4)})" for x in places]
        single = [plain(scene.response, NameRef(0, len(name), name, 0)).values(np.array([0.2]))[0] for name in names]
        assert found[part] == pytest.approx(single, rel=1e-12)
    assert len(asked) < 20


def test_a_mean_is_known_better_than_values():
    """What modes left out add swings faster than those counted."""
    bar = "    bars: {arm: {length: L, EA: 1 N, mass_per_length: 1 kg/m, left: clamped, drag: 0.1 kg/m/s}}\n"
    scene = problem("parameters: {L: 1 m}\n" + dedent(bar) + "points: {tip: {body: arm, at: L}}\n"
                    "forces: {push: {at: tip, force: 1 N*step(t - 0.1 s)}}\n")
    reads = signal(scene, "arm.u(L)").reads
    few, many = (ModalSignal(scene.response.motion(count), reads) for count in (16, 512))
    at = 0.3 + 0.6 * (np.arange(8000) + 0.5) / 8000
    off = abs(few.values(at).mean() - many.values(at).mean())
    assert 0 < off <= few.error_of_mean(0.3, 0.9) < few.error(0.3) / 10


@pytest.mark.sweep
def test_a_start_at_zero_that_rounds_is_a_zero():
    """A cantilever let go under a force at its tip, where modes leave 3e-14 m of nothing, never comes back to zero."""
    scene = problem("parameters: {L: 1 m}\n"
                    "beams: {arm: {length: L, EI: 4 kN*m^2, mass_per_length: 3 kg/m, left: clamped}}\n"
                    "points: {tip: {body: arm, at: L}}\nforces: {push: {at: tip, force: 10 N}}\n"
                    "initial: {arm.u: 0*x}\n")
    assert signal(scene, "arm.u(L)").zeros(0.0, 0.2) == [0.0]
