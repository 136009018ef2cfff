"""Frequency responses of scenes with members: against closed forms in mpmath, by reciprocity, and their zeros against
the frequencies of the same member held where it is driven."""

import math

import mpmath
import numpy as np
import pytest
from support.scenes import problem

from vibcli.analyses.frequency_response.evaluate import frf, sloped
from vibcli.base.errors import PhysicsError
from vibcli.results.precise_member_response import PreciseMemberCurve

CANTILEVER = """
    parameters: {L: 1.2 m, EI: 2400 N*m^2, mu: 3 kg/m, r: %s}
    beams: {arm: {length: L, EI: EI, mass_per_length: mu, drag: r, left: clamped%s}}
    points: {tip: {body: arm, at: L}}
    forces: {drive: {at: tip, force: 1 N*sin(30 rad/s*t)}}
"""
TWO = """
    parameters: {L: 1.2 m}
    beams:
      arm: {segments: [{length: 0.5 m, EI: 2400 N*m^2, mass_per_length: 3 kg/m}, {length: 0.7 m, EI: 900 N*m^2,
            mass_per_length: 2 kg/m, drag: 3 N*s/m^2}], left: clamped, right: {k: 5e3 N/m, torsion: 10 N*m/rad},
            attached: [{at: 0.3 m, mass: 1 kg}, {at: 0.8 m, c: 4 N*s/m},
                       {at: 1 m, oscillator: {mass: 0.5 kg, k: 800 N/m, c: 1 N*s/m}}]}
    points: {one: {body: arm, at: 0.4 m}, two: {body: arm, at: L}}
    forces: {at_one: {at: one, force: 1 N*sin(30 rad/s*t)}, at_two: {at: two, force: 1 N*cos(3 rad/s*t)}}
"""
PLACES = {"": "", "many": ", attached: [{at: 0.1 m, k: 0 N/m}, {at: 0.5 m, k: 0 N/m}, {at: 1 m, k: 0 N/m}]"}
ROOT = math.sqrt(2400 / 3) / 1.2**2
FIRST = 1.875104068711961166**2 * ROOT
HELD = 4.730040744862704**2 * ROOT      # of the piece held at both ends, where D has a pole


TRUSS = """
    parameters: {a: 1 m, EA: 5 MN, mu: 2 kg/m}
    bodies: {top: {mass: 10 kg, at: [a/2, a], move: [x, y, 0]}}
    bars:
      l: {from: [0, 0], to: [a/2, a], EA: EA, mass_per_length: mu, left: clamped, right: {pinned: top}}
      r: {from: [a, 0], to: [a/2, a], EA: EA, mass_per_length: mu, left: clamped, right: {pinned: top}}
    dampers: {d: {between: [[a/2, 0], top], c: 20 N*s/m}}
    """


def curve(text, signal="arm.u(L)", driver="drive"):
    return problem(text).frequency_response(signal, driver)


def tip(Omega, drag=0.0, number=complex):
    """(sin z cosh z − cos z sinh z)/(EI β³ (1 + cos z cosh z)), z = βL, β⁴ = −(μ s² + r s)/EI."""
    with mpmath.workdps(40):
        s, L = mpmath.mpc(0, Omega), mpmath.mpf("1.2")
        beta = (-(3 * s * s + mpmath.mpf(drag) * s) / 2400) ** mpmath.mpf("0.25")
        z = beta * L
        return number((mpmath.sin(z) * mpmath.cosh(z) - mpmath.cos(z) * mpmath.sinh(z))
                      / (2400 * beta**3 * (1 + mpmath.cos(z) * mpmath.cosh(z))))


@pytest.mark.parametrize("drag", [0.0, 2.0])
@pytest.mark.parametrize("places", ["", "many"])
def test_cantilever_at_its_tip(places, drag):
    """Within the bound at any frequency, at that of a held piece and within 1e-9 of a pole too."""
    found = curve(CANTILEVER % (f"{drag} N*s/m^2", PLACES[places]))
    rng = np.random.default_rng(3)
    Omega = np.concatenate([10 ** rng.uniform(-2, 5, 40), HELD * np.array([1 - 1e-9, 1.0]),
                            FIRST * (1 + np.array([1e-9, -1e-6]))])
    H = frf(found.transfer, Omega)
    exact = np.array([tip(at, drag) for at in Omega])
    bounds = np.array([found.transfer.error(at) for at in Omega])
    assert (np.abs(H - exact) <= bounds).all()
    assert (bounds[:42] <= 1e-6 * np.abs(exact[:42])).all()
    assert np.abs(H[40:42] / exact[40:42] - 1).max() < 1e-12


@pytest.mark.parametrize("places", ["", "many"])
def test_more_digits(places):
    """To 36 of 40 digits, at a frequency of a held piece too; of the moment as the floats have it."""
    scene = problem(CANTILEVER % ("2 N*s/m^2", PLACES[places]))
    with mpmath.workdps(40):
        for Omega in (mpmath.mpf(700), mpmath.mpf(HELD)):
            exact = tip(Omega, 2.0, mpmath.mpmathify)
            found, = PreciseMemberCurve(scene, "arm.u(L)", "drive").at(Omega)
            assert abs(found / exact - 1) < 1e-36
        moment, = PreciseMemberCurve(scene, "arm.moment'(0.7 m)", "drive").at(mpmath.mpf(700))
    floats = frf(scene.frequency_response("arm.moment'(0.7 m)", "drive").transfer, 700.0)
    assert complex(moment) == pytest.approx(floats, rel=1e-11)


def test_slopes():
    """dH/ds is the difference quotient, of places within a piece and of forces too."""
    Omega = np.array([3.0, 70.0, 512.0, 2900.0])
    for signal in ("arm.u(L)", "arm.moment(0.2 m)", "arm.shear(0.9 m)", "arm.u'(0.77 m)"):
        found = curve(TWO, signal, "at_one").transfer
        far, near = ([frf(found, Omega * (1 + sign * step)) for sign in (1, -1)] for step in (2e-4, 1e-4))
        slope = (8 * (near[0] - near[1]) - (far[0] - far[1])) / (12e-4j * Omega)
        assert np.abs(sloped(found, Omega)[1] / slope - 1).max() <= 1e-5


def test_reciprocity():
    Omega = np.geomspace(1.0, 2e4, 200)
    there, back = curve(TWO, "arm.u(0.4 m)", "at_two"), curve(TWO, "arm.u(L)", "at_one")
    one, two = frf(there.transfer, Omega), frf(back.transfer, Omega)
    assert np.abs(one / two - 1).max() <= 1e-12


def test_zeros_beside_gyroscopic_terms():
    """Two bars with a mass each at their ends, these tied by ±h: x rests under a force on it where the other bar swings
    alone, EA β = m ω² tan βL, and where its own is at rest at both ends, βL = nπ."""
    ends = "length: 1 m, mass_per_length: 1 kg/m, left: clamped"
    found = curve(f"""
        parameters: {{h: 4 N*s/m, F: 1 N, W: 3 rad/s}}
        bodies: {{b: {{mass: 1 kg, slide: x}}, c: {{mass: 1 kg, slide: y}}}}
        bars:
          r: {{{ends}, EA: 3 kN, right: {{pinned: b}}}}
          q: {{{ends}, EA: 5 kN, right: {{pinned: c}}}}
        matrices: {{C: [[0, -h], [h, 0]]}}
        forces: {{drive: {{at: b, force: F*sin(W*t)}}}}
    """, "x").transfer.zeros(0.0, 400.0)
    alone = [math.sqrt(5000) * float(mpmath.findroot(lambda z: z * mpmath.tan(z) - 1, near)) for near in (0.86, 3.43)]
    held = [math.sqrt(3000) * n * math.pi for n in (1, 2)]
    assert found.imag == pytest.approx(sorted(alone + held), rel=1e-12) and not found.real.any()


def test_bar_with_an_end_damper():
    """u = sin(kx)/(EA k cos kL + iΩ c sin kL) and EA u′, k = Ω √(ρA/EA)."""
    text = """
        parameters: {L: 2 m, EA: 4e6 N, mu: 8 kg/m, c: 900 N*s/m}
        bars: {rod: {length: L, EA: EA, mass_per_length: mu, left: clamped, right: {c: c}}}
        points: {tip: {body: rod, at: L}}
        forces: {drive: {at: tip, force: 1 N*sin(30 rad/s*t)}}
    """
    Omega = np.array([1.0, 300.0, 1500.0, 7777.0])
    k = Omega * math.sqrt(8 / 4e6)
    below = 4e6 * k * np.cos(2 * k) + 900j * Omega * np.sin(2 * k)
    for x in (0.0, 0.7, 2.0):
        wanted = np.sin(k * x) / below, 4e6 * k * np.cos(k * x) / below
        for part, value in zip(("u", "force"), wanted, strict=True):
            if part == "force" or x:
                H = frf(curve(text, f"rod.{part}({x} m)").transfer, Omega)
                assert np.abs(H - value).max() <= 1e-12 * np.abs(value).max()


def test_shaken_clamp():
    """A cantilever on a base that is driven: u(L)/Y = (cos z + cosh z)/(1 + cos z cosh z)."""
    found = curve("""
        parameters: {L: 1.2 m, EI: 2400 N*m^2, mu: 3 kg/m}
        bodies: {base: {slide: 1 mm*sin(30 rad/s*t)}}
        beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: {clamped: base}}}
    """, driver="base")
    Omega = np.array([2.0, 50.0, 700.0])
    z = 1.2 * (3 * Omega**2 / 2400) ** 0.25
    wanted = (np.cos(z) + np.cosh(z)) / (1 + np.cos(z) * np.cosh(z))
    assert frf(found.transfer, Omega).real == pytest.approx(wanted, rel=1e-12)


@pytest.mark.sweep
def test_peaks_and_zeros_of_a_cantilever():
    """Driven at its tip it has the zeros of a beam that is pinned there, tan z = tanh z, and
    of both as many as are asked for."""
    found = curve(CANTILEVER % ("0 N*s/m^2", ""))
    z = [1.875104068711961, 4.694091132974175, 7.854757438237613, 10.99554073487547, 14.13716839104647]
    assert [peak.Omega for peak in found.marked] == pytest.approx([ROOT * x * x for x in z], rel=1e-13)
    assert all(peak.value is None for peak in found.marked)
    pinned = [float(mpmath.findroot(lambda x: mpmath.tan(x) - mpmath.tanh(x), (i + 0.25) * math.pi))
              for i in range(1, 5)]
    assert found.antiresonances == pytest.approx([ROOT * x * x for x in pinned], rel=1e-12)
    assert found.peak(12).Omega == pytest.approx(ROOT * (11.5 * math.pi) ** 2, rel=1e-12)
    assert found.antiresonance(12) == pytest.approx(ROOT * (12.25 * math.pi) ** 2, rel=1e-12)


@pytest.mark.sweep
def test_zeros_elsewhere_by_the_argument_principle():
    """Seen at x, a clamped bar that is driven at its end has no zero but those of sin(kx) that are no poles."""
    text = """
        bars: {rod: {length: 1 m, EA: 1 N, mass_per_length: 1 kg/m, left: clamped}}
        points: {tip: {body: rod, at: 1 m}}
        forces: {drive: {at: tip, force: 1 N*sin(3 rad/s*t)}}
    """
    for x in (0.37, 0.62, 0.9):
        found = curve(text, f"rod.u({x} m)")
        end = found.transfer.end
        zeros = np.arange(1, int(end * x / math.pi) + 1) * math.pi / x
        assert found.antiresonances == pytest.approx(zeros, rel=1e-12)
    assert len(curve(text, "rod.force(0 m)").antiresonances) == 0


@pytest.mark.sweep
def test_damped_peaks():
    """Each is a maximum that is higher than beside it, one to each natural frequency."""
    found = curve(TWO, "arm.u(L)", "at_two")
    assert len(found.marked) == len(found.natural)
    for number, peak in enumerate(found.marked, 1):
        beside = np.abs(frf(found.transfer, peak.Omega * np.array([1 - 1e-3, 1.0, 1 + 1e-3])))
        assert beside[1] == pytest.approx(peak.value, rel=1e-12) and beside[1] > max(beside[0], beside[2])
        assert found.error_of_peak(number)[0] < 1e-6 * peak.Omega


def test_forces_of_supports_are_refused():
    with pytest.raises(PhysicsError, match="is not found"):
        curve(TWO, "ground.force", "at_two")


def finite_elements(Omega, per_length=60):
    """u(L) to a force at 0.4 m of the scene TWO, by Hermite's cubics."""
    count, h = round(1.2 * per_length), 1 / per_length
    stiff = np.array([[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h], [-12, -6 * h, 12, -6 * h],
                      [6 * h, 2 * h * h, -6 * h, 4 * h * h]]) / h**3
    mass = np.array([[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h], [54, 13 * h, 156, -22 * h],
                     [-13 * h, -3 * h * h, -22 * h, 4 * h * h]]) * h / 420
    n, s = 2 * count + 3, 1j * Omega
    D = np.zeros((n, n), complex)
    for e in range(count):
        EI, mu, drag = (2400, 3, 0) if (e + 0.5) * h < 0.5 else (900, 2, 3)
        at = np.arange(2 * e, 2 * e + 4)
        D[np.ix_(at, at)] += EI * stiff + (mu * s * s + drag * s) * mass

    def u(x):
        return 2 * round(x * per_length)

    D[u(0.3), u(0.3)] += s * s
    D[u(0.8), u(0.8)] += 4 * s
    D[u(1.2), u(1.2)] += 5e3
    D[u(1.2) + 1, u(1.2) + 1] += 10
    D[np.ix_([u(1.0), n - 1], [u(1.0), n - 1])] += (800 + s) * np.array([[1, -1], [-1, 1]])
    D[n - 1, n - 1] += 0.5 * s * s
    load = np.zeros(n)
    load[u(0.4)] = 1.0
    return np.linalg.solve(D[2:, 2:], load[2:])[u(1.2) - 2]


def test_a_stepped_beam_against_finite_elements():
    found = curve(TWO, "arm.u(L)", "at_one").transfer
    for Omega in (2.0, 39.0, 123.0, 300.0):
        assert frf(found, Omega) == pytest.approx(finite_elements(Omega), rel=1e-6)


@pytest.mark.sweep
def test_points_by_elimination_without_exchanges_are_those_of_LU():
    """Many frequencies, through those at which pieces or parts of the beam resonate by themselves."""
    transfer = curve(TWO, "arm.moment(0.2 m)", "at_two").transfer
    s = 1j * np.linspace(0.5, 6000.0, 3001)
    quick = transfer.at(s, True)
    transfer.system.pattern = None
    slow = transfer.at(s, True)
    for one, two in zip(quick[:2], slow[:2], strict=True):
        assert np.abs(one / two - 1).max() < 1e-9


@pytest.mark.sweep
def test_zeros_beside_a_damper_at_the_driven_end_are_those_of_the_bar_held_there():
    scene = """
parameters: {L: 0.8 m, EA: 4 kN, mu: 0.6 kg/m}
bars:
  rod: {length: L, EA: EA, mass_per_length: mu, left: clamped, right: {c: 25 N*s/m}}
points: {end: {body: rod, at: L}}
forces: {shaker: {at: end, force: 1 N*cos(300 rad/s*t)}}
"""
    curve = problem(scene).frequency_response("rod.u(L)", "shaker")
    for n, Omega in enumerate(curve.antiresonances[:4], 1):
        exact = n * math.pi / 0.8 * math.sqrt(4000 / 0.6)
        assert abs(Omega - exact) <= curve.error_of_antiresonance(Omega) + 1e-15 * exact < 1e-12 * exact


@pytest.mark.sweep
def test_a_pole_that_turning_forces_alone_make():
    """Two free bars of one wave resistance, a mass at an end of each, pushed across what the other does: x and y turn
    about a rest that neither has without these forces, m ω + √(EAμ) tan ωL/c = h."""
    found = curve("""
        parameters: {h: 4 N*s/m}
        bodies: {b: {mass: 1 kg, slide: x}, c: {mass: 1 kg, slide: y}}
        bars:
          r: {length: 1 m, mass_per_length: 1 kg/m, EA: 3 kN, right: {pinned: b}}
          q: {length: 1 m, mass_per_length: 1 kg/m, EA: 3 kN, right: {pinned: c}}
        forces: {g1: {at: b, force: -h*y'}, g2: {at: c, force: h*x'}}
    """, "x", "g1")
    speed = 3000**0.5
    exact = float(mpmath.findroot(lambda w: w + speed * mpmath.tan(w / speed) - 4, 2))
    first, = found.transfer.poles(1.0, 3.0)
    assert first == pytest.approx(1j * exact, rel=1e-11)
    assert found.transfer.at(np.array([first.imag * 1j]))[2].all()


@pytest.mark.sweep
@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("text", [TRUSS, TRUSS.split("dampers")[0]], ids=["damped", "undamped"])
def test_what_symmetry_leaves_at_rest_has_no_peaks(text):
    """Of rounding neither resonances nor antiresonances are told; what is tied however weakly has them."""
    found = curve(text, "y", "x")
    assert found.peaks == [] and found.antiresonances == [] and found.transfer.counts("zeros")
    assert not found.undamped or len(curve(text.replace("to: [a/2, a], EA: EA", "to: [a/2, a], EA: (1 + 1e-10)*EA", 1),
                                           "y", "x").peaks) == 6
