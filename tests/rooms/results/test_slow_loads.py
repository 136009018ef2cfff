"""Extremes of members under loads that swing, or die out, much more slowly than what they act on: looked at as long as
the loads last, held against sums over modes with the steady part in closed form, and against limits at rest."""

import numpy as np
import pytest
from mpmath import findroot, mp
from support.modes_found_once import modes_found_once  # noqa: F401

import vibcli
from vibcli.analyses.continuous import travelling_waves_march
from vibcli.base.errors import PhysicsError
from vibcli.results import modal_response

pytestmark = pytest.mark.usefixtures("modes_found_once")
TIP = "points: {tip: {body: b, at: 2 m}}\nforces: {f: {at: tip, force: 10 N*%s}}\n"
BAR = "bars: {b: {length: 2 m, EA: 4 MN, mass_per_length: 3 kg/m, left: clamped}}\n" + TIP
BEAM = "beams: {b: {length: 2 m, EI: 4 kN*m^2, mass_per_length: 3 kg/m, left: clamped}}\n" + TIP
DAMPED = BEAM.replace("left: clamped", "left: clamped, right: {c: 3 N*s/m}")
DRAGGED = BAR.replace("left: clamped", "left: clamped, drag: 3 N*s/m^2")
PLANE = BEAM.replace("{length: 2 m,", "{from: [0, 0], to: [2 m, 0], EA: 4 MN,").replace("10 N*%s", "[0 N, 10 N*%s]")
STRING = ("strings: {b: {length: 2 m, mass_per_length: 3 kg/m, left: pinned, right: {k: 1 kN/m}, preload: 100 N}}\n"
          + TIP)
SPREAD = "beams: {b: {length: 2 m, EI: 4 kN*m^2, mass_per_length: 3 kg/m, left: clamped}}\n" \
         "forces: {f: {body: b, per_length: 5 N/m*%s}}\n"
SLOW = 0.3      # rad/s
SOME = {True: 4096, False: 4096}        # modes, of which so few tell already what is near its limit at rest


def _bar(count):
    """(ω, steady amplitude over F) of the tip: tan(ΩL/c)/(EA Ω/c)."""
    c = np.sqrt(4e6 / 3)
    return (np.arange(count) + 0.5) * np.pi * c / 2, 2 / 6, np.tan(SLOW * 2 / c) / (4e6 * SLOW / c)


def _beam(count):
    """The same by the roots of cos βL cosh βL = −1: L³/(3EI) and what inertia adds."""
    roots = np.array([float(findroot(lambda x: mp.cos(x) + 1 / mp.cosh(x), (n + 0.5) * mp.pi + (0.3 if not n else 0)))
                      for n in range(count)])
    omega, share = (roots / 2) ** 2 * np.sqrt(4e3 / 3), 4 / 6
    return omega, share, 8 / 12e3 + share * (1 / (omega**2 - SLOW**2) - 1 / omega**2).sum()


@pytest.mark.sweep
@pytest.mark.parametrize(("scene", "modes", "count"), [(BAR, _bar, 200), (BEAM, _beam, 40)])
def test_the_largest_of_a_slow_swing(scene, modes, count):
    omega, share, steady = modes(count)
    free = share * SLOW / omega / (omega**2 - SLOW**2)

    def tip(t, later):
        """At instants some time later: sin ω(t + τ) = sin ωt cos ωτ + cos ωt sin ωτ."""
        (s, c), (sine, cosine) = ((np.sin(part), np.cos(part)) for part in (np.outer(t, omega), np.outer(omega, later)))
        return 10 * (steady * np.sin(SLOW * np.add.outer(t, later)) - (s * free) @ cosine - (c * free) @ sine)
    found, instant = (vibcli.loads(scene % f"sin({SLOW} rad/s*t)")[f"{head}(b.u(2 m))"].value
                      for head in ("max", "argmax"))
    assert tip(np.array([instant]), np.zeros(1))[0, 0] == pytest.approx(found, rel=1e-9)
    span, seen = np.sqrt(8 * free.sum() / steady), 0        # beyond that it is not so large
    for swing in range(10):
        middle = (2 * swing + 0.5) * np.pi
        grid = np.linspace(middle - span, middle + span, 40_000).reshape(200, 200) / SLOW
        seen = max(seen, tip(grid[:, 0], grid[0] - grid[0, 0]).max())
    assert -1e-12 * found < found - seen < 1e-6 * found


@pytest.mark.sweep
@pytest.mark.parametrize(("scene", "at_rest"), [(BAR, 5e-6), (DRAGGED, 5e-6), (BEAM, 1 / 150), (DAMPED, 1 / 150),
                                                (PLANE, 1 / 150), (STRING, 10 / 1050)])
@pytest.mark.parametrize(("load", "most"), [("sin(0.01 rad/s*t)", 1), ("(1-cos(0.02 rad/s*t))", 2),
                                            ("(exp(-t/(100 s))-exp(-t/(50 s)))", 0.25)])
def test_as_slow_as_to_be_at_rest(scene, at_rest, load, most, monkeypatch):
    if scene is STRING and "exp" in load:       # its waves are too many: that is seen of a tenth of them, too
        monkeypatch.setattr(travelling_waves_march, "MOST", 600)
    monkeypatch.setattr(modal_response, "FINEST", SOME)
    found = vibcli.loads(scene % load)["max(b.u(2 m))"].value
    assert found == pytest.approx(most * at_rest, rel=2e-3)


@pytest.mark.sweep
def test_slow_loads_along_what_also_bends_and_slow_supports(monkeypatch):
    """What a tip is pulled along by does not move the modes that bend, the first ones; a base carries all."""
    monkeypatch.setattr(modal_response, "FINEST", SOME)
    along = vibcli.loads(PLANE.replace("[0 N, 10 N*%s]", "[10 N*%s, 0 N]") % "sin(0.01 rad/s*t)")
    assert along["max(tip.x)"].value == pytest.approx(5e-6, rel=1e-4)
    driven = "bodies: {base: {slide: 10 mm*sin(0.01 rad/s*t)}}\n" + BEAM.split("points")[0].replace(
        "left: clamped", "left: {clamped: base}")
    assert vibcli.loads(driven)["max(b.u(2 m))"].value == pytest.approx(1e-2, rel=1e-3)


@pytest.mark.sweep
def test_moments_smallest_values_and_loads_along_it():
    one = vibcli.loads(BEAM % "sin(0.01 rad/s*t)")
    assert one["max(b.moment(0 m))"].value == pytest.approx(20, rel=2e-3)
    assert one["min(b.u(2 m)-b.u(1 m))"].value == pytest.approx(-(8 - 2.5) / 12e3 * 10, rel=2e-3)
    spread = vibcli.loads(SPREAD % "sin(0.01 rad/s*t)")
    assert spread["max(b.u(2 m))"].value == pytest.approx(5 * 2**4 / (8 * 4e3), rel=2e-3)


def test_waves_under_loads_that_cancel_at_first():
    """u(L, t) = (1/Z) ∫ F before a wave comes back; F = 10(1 − cos Ωt) holds no digits as a difference."""
    found = vibcli.loads(BAR % "(1-cos(0.02 rad/s*t))")["b.u(2 m)(1 ms)"].value
    assert found == pytest.approx(10 * 0.02**2 * 1e-3**3 / 6 / np.sqrt(12e6), rel=1e-10)


@pytest.mark.parametrize("asked", ["max(b.u(2 m))", "max(b.u(2 m)*b.u(1 m))"])
def test_what_is_too_long_to_be_searched_is_told_before_it_is(asked):
    one = vibcli.loads(BEAM % "step(t)" + "find: [{response: {until: 1e7 s}}]\n")
    with pytest.raises(PhysicsError, match="search along a motion by modes is given up after 2000 steps"):
        one[asked]
