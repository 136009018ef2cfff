"""Loads along members by travelling waves: against the waves of a rod that feels its weight at once, against transfer
functions, reflection by reflection, in mpmath, at resonance, and against modes within their bounds."""

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from vibcli.language.signals_of_places import with_places
from vibcli.results.modal_response import ModalResponse
from vibcli.results.wave_response import WaveResponse
from vibcli.symbolic.parser import parse

G, LENGTH, SPEED = 9.81, 3.0, 5000.0
ROD = """
    parameters: {L: 3 m, EA: 50 MN, mu: 2 kg/m, g: 9.81 m/s^2}
    bars: {rod: {length: L, EA: EA, mass_per_length: mu, left: clamped}}
    forces: {weight: {body: rod, per_length: mu*g*step(t)}}
    """
SCENES = {
    "a pulse on a part of a bar with a mass and a spring": ("""
        parameters: {L: 2 m, EA: 3 MN, mu: 4 kg/m, q: 50 N/m}
        bars: {rod: {length: L, EA: EA, mass_per_length: mu, left: clamped, right: {k: 200 kN/m},
                     attached: [{at: 1.3 m, mass: 2 kg}]}}
        forces: {w: {body: rod, per_length: q*sin(pi*x/L)*(step(t - 1 ms) - step(t - 2.3 ms)), from: 0.3 m, to: 1.7 m}}
        """, 0.02, ("rod.u(0.9 m)", "rod.force(0.2 m)", "rod.force(1.5 m)")),
    "a sine that leaps along a string that starts with a field": ("""
        parameters: {L: 1 m, T: 100 N, mu: 0.02 kg/m, q: 5 N/m}
        strings: {cord: {length: L, preload: T, mass_per_length: mu, left: clamped, right: clamped}}
        forces: {w: {body: cord, per_length: "q*x^2/L^2*(1 + step(t - 1.5 ms))*sin(900 rad/s*t)"}}
        initial: {cord.u: 1e-3*x*(L - x)/L}
        """, 0.03, ("cord.u(0.37 m)", "cord.slope(0.71 m)")),
    "what bends without end on half of a free bar": ("""
        parameters: {L: 1 m, EA: 1e5 N, mu: 2 kg/m, q: 5 N/m}
        bars: {rod: {length: L, EA: EA, mass_per_length: mu}}
        forces: {w: {body: rod, per_length: q*abs(sin(900 rad/s*t)), to: L/2}}
        """, 0.02, ("rod.u(0.37 m)", "rod.force(0.71 m)")),
    "what fades to nothing at the end of a string": ("""
        parameters: {L: 1 m, T: 1e5 N, mu: 2 kg/m, q: 3 N/m}
        strings: {cord: {length: L, preload: T, mass_per_length: mu, left: clamped}}
        forces:
          v: {body: cord, per_length: "q*(1 - x/L)^3*(t/(1 ms))^3*exp(-t/(1 ms))", from: 0.2 m, to: 0.7 m}
          w: {body: cord, per_length: "q*(1 - x/L)^3*step(t - 1 ms)*(t/(1 ms) - 1)*sin(2000 rad/s*t)"}
        """, 0.012, ("cord.u(0.514 m)", "cord.slope(0.154 m)")),
    "a ramp and a step along two bars and a body": ("""
        parameters: {L: 1 m, EA: 1e5 N, mu: 2 kg/m, q: 5 N/m}
        bars:
          rod: {length: L, EA: EA, mass_per_length: mu, left: clamped, right: {pinned: b}}
          bar: {length: L, EA: 2*EA, mass_per_length: mu, left: {pinned: b}}
        bodies: {b: {mass: 1 kg, slide: z}}
        forces: {w: {body: bar, per_length: q*(1 + x/L)*ramp(t)/(1 ms)}, v: {body: rod, per_length: -2*q*step(t)}}
        """, 0.02, ("rod.u(0.37 m)", "rod.force(0.71 m)", "bar.u(0.5 m)", "bar.force(0.5 m)", "z")),
}


def values(response, signal, times):
    return np.array(response.signal(parse(signal)).values(times))


def test_a_rod_feels_its_weight():
    """u(x) = f(t) − f(t − x/c) with f = g t²/2 up to the first echo; beyond it from the static shape by images."""
    times = np.linspace(0.0, 3.9, 40) * LENGTH / SPEED
    response = problem(ROD).response
    assert isinstance(response, WaveResponse)
    for x in (0.4, 1.1, 2.9):
        u = shown(x) - (shown(x - SPEED * times) + shown(x + SPEED * times)) / 2
        np.testing.assert_allclose(values(response, f"rod.u({x} m)", times), u, rtol=0, atol=1e-14 * abs(u).max())
        force = 50e6 * (slope(x) - (slope(x - SPEED * times) + slope(x + SPEED * times)) / 2)
        np.testing.assert_allclose(values(response, f"rod.force({x} m)", times)[1:-1], force[1:-1], rtol=0,
                                   atol=1e-13 * 2 * G * LENGTH * 2)


def shown(x):
    """The shape in which the rod rests under its weight, odd about its clamp and even about its free end."""
    sign, y = image(x)
    return sign * G / SPEED**2 * (LENGTH * y - y * y / 2)


def slope(x):
    """Its derivative."""
    x = np.asarray(x, float)
    period = np.mod(x + LENGTH, 4 * LENGTH)
    _, y = image(x)
    return np.where(period < 2 * LENGTH, 1, -1) * G / SPEED**2 * (LENGTH - y)


def image(x):
    """(sign, place on the rod) that a place beyond its ends mirrors."""
    x = np.mod(np.asarray(x, float), 4 * LENGTH)
    sign, x = np.where(x < 2 * LENGTH, 1, -1), np.mod(x, 2 * LENGTH)
    return sign, np.minimum(x, 2 * LENGTH - x)


@pytest.mark.sweep
@pytest.mark.parametrize("text, until, signals", SCENES.values(), ids=SCENES)
def test_modes_agree_within_their_bounds(text, until, signals):
    one = problem(f"{text}find: [{{response: {{of: [{', '.join(signals)}], until: {until} s}}}}]")
    times = np.linspace(until / 40, until, 13)
    modes = ModalResponse(one)
    assert isinstance(one.response, WaveResponse)
    for signal in signals:
        found, other = values(one.response, signal, times), modes.signal(parse(signal))
        bounds = np.array([other.error(t) for t in times])
        assert abs(found).max() > 0 and (abs(found - other.values(times)) <= bounds).all()


@pytest.mark.sweep
def test_a_wave_that_is_square_is_a_sum_of_steps():
    """Half a period is a tenth of the way: so many leaps are on the rod at once."""
    period, until = 0.2 * LENGTH / SPEED, 3.5 * LENGTH / SPEED
    response = problem(ROD.replace("step(t)", f"square(2*pi*t/({period!r} s))")
                       + f"find: [{{response: {{of: [rod.u(L)], until: {until!r} s}}}}]").response
    times = np.linspace(0.0, until, 40)
    later = np.maximum(times[:, None] - np.arange(0, until, period / 2), 0.0)
    signs = 2.0 * (-1.0) ** np.arange(later.shape[1])
    signs[0] = 1.0
    for x in (0.4, 2.9):
        u = ((shown(x) - (shown(x - SPEED * later) + shown(x + SPEED * later)) / 2) * signs).sum(axis=1)
        np.testing.assert_allclose(values(response, f"rod.u({x} m)", times), u, rtol=0, atol=1e-14 * shown(LENGTH))


def test_at_resonance_it_grows():
    """u = g t sin(Ωt) sin(πx/2L)/(2Ω) of a rod under μg sin(πx/2L) cos(Ωt), Ω = πc/2L; a shape of one mode alone."""
    speed = np.pi * SPEED / (2 * LENGTH)
    response = problem(ROD.replace("step(t)", f"sin(pi*x/(2*L))*cos({speed!r} rad/s*t)")
                       + "find: [{response: {of: [rod.u(L)], until: 10 ms}}]").response
    times = np.linspace(0.0, 0.01, 40)
    for x in (0.4, 2.9):
        shape, swung = G * np.sin(np.pi * x / (2 * LENGTH)) / 2, np.sin(speed * times) / speed
        u, rate = shape * times * swung, shape * (swung + times * np.cos(speed * times))
        for signal, exact in ((f"rod.u({x} m)", u), (f"rod.u'({x} m)", rate)):
            np.testing.assert_allclose(values(response, signal, times), exact, rtol=0, atol=1e-13 * abs(exact).max())


def test_a_blow_along_a_rod_gives_it_a_velocity():
    """J δ(t) on the left half of a free bar: u̇ = J/μ there, and a front J/(2μ)·Z of force runs from its middle."""
    response = problem("""
        parameters: {L: 1 m, EA: 8 N, mu: 2 kg/m, J: 3 N*s/m}
        bars: {rod: {length: L, EA: EA, mass_per_length: mu}}
        forces: {blow: {body: rod, per_length: J*impulse(t - 1 s), to: L/2}}
        """).response
    rate, force = (with_places(parse(text), response.problem.spec.members) for text in ("rod.u'(0.3 m)",
                                                                                        "rod.force(0.7 m)"))
    found = response.signal(rate).values(np.array([0.9, 1.05, 1.15]))
    np.testing.assert_allclose(found, [0.0, 1.5, 0.75], rtol=0, atol=1e-14)
    assert response.signal(force).leaps(1.12) == [pytest.approx((1.1, 0.0, -3.0), abs=1e-13)]


def test_a_matched_damper_leaves_the_deflection_at_rest():
    """After 2L/c nothing moves: u = q L²/(2EA) at the end, which the damper leaves free."""
    response = problem("""
        parameters: {L: 2 m, EA: 4 N, mu: 1 kg/m, q: 3 N/m}
        bars: {rod: {length: L, EA: EA, mass_per_length: mu, left: clamped, attached: [{at: L, c: 2 N*s/m}]}}
        forces: {w: {body: rod, per_length: "q*step(t - 1 s)"}}
        """).response
    end = response.signal(with_places(parse("rod.u(L)"), response.problem.spec.members))
    assert end.final() == pytest.approx(1.5, abs=1e-14)
    assert end.values(np.array([3.1, 7.0])) == pytest.approx([1.5, 1.5], abs=1e-14)


TWO, EA, MU, MASS, DAMPER, SPRING = 2, 3 * 10**6, 4, 2, 5000, 200000
SWING, DECAY = 900, mpmath.mpf(1000) / 3


@pytest.mark.sweep
@pytest.mark.parametrize("weight, image, since", [
    ("step(t - 1 ms)", lambda s: 1 / s, 0.001),
    ("exp(-t/(3 ms))*sin(900 rad/s*t)*t/(1 s)", lambda s: 2 * SWING * (s + DECAY) / ((s + DECAY)**2 + SWING**2)**2, 0),
    ("(1 ms)*impulse(t)", lambda s: mpmath.mpf(1) / 1000, 0)], ids=["step", "sine", "impulse"])
def test_a_mass_a_spring_and_a_damper_at_the_end(weight, image, since):
    """Under q (1 + x²/L²) g(t), by transfer functions of what was reflected n times."""
    until = 0.009
    response = problem(f"""
        parameters: {{L: 2 m, EA: 3 MN, mu: 4 kg/m, q: 50 N/m}}
        bars:
          rod: {{length: L, EA: EA, mass_per_length: mu, left: clamped, attached: [{{at: L, mass: 2 kg}},
                {{at: L, k: 200 kN/m}}, {{at: L, c: 5000 N*s/m}}]}}
        forces: {{w: {{body: rod, per_length: "q*(1 + x^2/L^2)*{weight}"}}}}
        find: [{{response: {{of: [rod.u(L)], until: {until} s}}}}]
        """).response
    end = response.signal(with_places(parse("rod.u(L)"), response.problem.spec.members))
    times = [0.0004, 0.0021, 0.0055, 0.0089]
    with mpmath.workdps(30):
        reference = np.array([float(reflected(image, mpmath.mpf(t) - mpmath.mpf(since))) for t in times])
    found = end.values(np.array(times))
    np.testing.assert_allclose(found, reference, rtol=0, atol=1e-13 * abs(reference).max())
    assert (abs(found - reference) <= [end.error(t) for t in times]).all()


def reflected(image, t):
    """u(L, t) for the Laplace transform of g, with 50 N/m (1 + x²/L²) along the rod."""
    c, Z = mpmath.sqrt(mpmath.mpf(EA) / MU), mpmath.sqrt(mpmath.mpf(EA) * MU)
    ends = [[50 * y for y in row] for row in ((2, 2 / mpmath.mpf(TWO), mpmath.mpf(2) / TWO**2),
                                              (1, 0, mpmath.mpf(2) / TWO**2))]
    total, way = mpmath.mpf(0), TWO / c
    for n in range(int(t / (2 * way)) + 1 if t > 0 else 0):
        def arrives(s, row, sign):
            own = MASS * s * s + DAMPER * s + SPRING
            series = sum(sign**k * y * (c / s)**(k + 1) for k, y in enumerate(row))
            return image(s) * series / (Z * s + own) * ((own - Z * s) / (own + Z * s))**n      # noqa: B023

        right, left = ends
        for delay, terms in ((2 * n, ((right, -1, 1),)), (2 * n + 1, ((left, -1, -1), (left, 1, -1))),
                             (2 * n + 2, ((right, 1, 1),))):
            if t > delay * way:
                total += sum(share * mpmath.invertlaplace(lambda s, row=row, sign=sign: arrives(s, row, sign),
                                                          t - delay * way, method="talbot", degree=50)
                             for row, sign, share in terms)
    return total
