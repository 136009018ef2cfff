"""What stands next to each other on a beam, against transfer matrices in 60 digits."""

from textwrap import dedent

import mpmath
import pytest
from mpmath import mp, mpf
from support.scenes import problem

from vibcli.base.errors import NoEquilibrium
from vibcli.language.signals_of_places import with_places
from vibcli.quantities.expression import measure
from vibcli.symbolic.parser import parse

SCENE = """
    parameters: {{e: {apart} m, W: {Omega} rad/s}}
    beams:
      wing: {{length: 1 m, EI: 20 N*m^2, mass_per_length: 2 kg/m, left: clamped,
              attached: [{{at: 0.3 m, mass: 0.2 kg}}, {{at: 0.3 m + e, k: 100 N/m}}, {{at: 0.5 m, c: 0.3 N*s/m}}]}}
    points: {{a: {{body: wing, at: 0.5 m}}, b: {{body: wing, at: 0.5 m + e}}}}
    forces: {{drive: {{at: a, force: 1 N*sin(W*t)}}}}
    """


def scene(apart, Omega=10):
    return problem(dedent(SCENE.format(apart=apart, Omega=Omega)))


def measured(one, text):
    return measure(one, with_places(parse(text), one.spec.members))


def piece(length, s):
    """How u, u′, u″, u‴ go on along a piece."""
    grown = mp.matrix(4, 4)
    for i in range(3):
        grown[i, i + 1] = 1
    grown[3, 0] = -2 * s * s / 20
    return mp.expm(grown * length)


def spot(Z):
    """What holds a place with the force Z u."""
    jump = mp.eye(4)
    jump[3, 0] = -Z / 20
    return jump


def deflection(apart, s):
    """u at 0.5 m under a unit force there: clamped where it begins, free where it ends."""
    e = mpf(apart)
    before = (spot(mpf("0.3") * s) * piece(mpf("0.2") - e, s) * spot(100) * piece(e, s) * spot(mpf("0.2") * s * s)
              * piece(mpf("0.3"), s))
    behind = piece(mpf("0.5"), s)
    whole, load = behind * before, behind * mp.matrix([0, 0, 0, mpf(1) / 20])
    bends = mp.lu_solve(whole[2:4, 2:4], -load[2:4])
    return before[0, 2] * bends[0] + before[0, 3] * bends[1]


@pytest.mark.parametrize("apart, Omega", [("1e-3", "170"), ("6e-5", "3"), ("2e-9", "170")])
def test_frequency_response(apart, Omega):
    with mpmath.workdps(60):
        exact = deflection(apart, mpmath.mpc(0, Omega))
        found, error = measured(scene(apart), f"frf[wing.u(0.5 m), drive]({Omega} rad/s)")
        assert abs(found - exact) <= error * abs(exact)
        assert error < 1e-11


@pytest.mark.parametrize("apart", ["0.01", "1e-6"])
def test_steady_state(apart):
    with mpmath.workdps(40):
        exact = abs(deflection(apart, mpmath.mpc(0, 10)))
        found, error = measured(scene(apart), "amplitude(wing.u(0.5 m))")
        assert abs(found - exact) <= error * exact and error < 1e-9


@pytest.mark.sweep
@pytest.mark.parametrize("apart", ["0.01", "1e-6"])
def test_peak(apart):
    with mpmath.workdps(40):
        one = scene(apart)
        value, error = measured(one, "peak[1](frf[wing.u(0.5 m), drive]).value")
        place = mpf(measured(one, "peak[1](frf[wing.u(0.5 m), drive]).Omega")[0])
        exact, *beside = (abs(deflection(apart, mpmath.mpc(0, place * (1 + off)))) for off in (0, -1e-6, 1e-6))
        assert abs(value - exact) <= 2 * error * exact + 1e-12 * exact and max(beside) < exact


@pytest.mark.sweep
@pytest.mark.parametrize("apart", ["1e-3", "1e-6"])
def test_natural_frequencies_in_floats(apart):
    """Of the bare beam with its mass and spring: the determinant of transfer matrices changes its sign within them."""
    one = problem(dedent(SCENE.format(apart=apart, Omega=10)).replace(", {at: 0.5 m, c: 0.3 N*s/m}", ""))
    for mode in one.modal.modes.first(9):
        with mpmath.workdps(60):
            slack = mpf(float(mode.error)) + 2e-15
            low, high = (_determinant(mpf(apart), mpf(float(mode.omega)) * (1 + side * slack))
                         for side in (-1, 1))
        assert low * high < 0 and mode.error < 1e-12
    assert mode.motion.system.digits is None and mode.index == 9


def _determinant(e, omega):
    s = mpmath.mpc(0, omega)
    whole = (piece(mpf("0.7") - e, s) * spot(100) * piece(e, s) * spot(mpf("0.2") * s * s) * piece(mpf("0.3"), s))
    return mpmath.re(mpmath.det(whole[2:4, 2:4]))


@pytest.mark.sweep
@pytest.mark.parametrize("apart", [1e-5, 1e-6, 1e-8])
def test_equilibrium(apart):
    """A spring takes R = k u off the tip load F of a cantilever: by superposition."""
    one = problem(f"""
        beams: {{b: {{length: 1 m, EI: 100 N*m^2, mass_per_length: 1 kg/m, left: clamped,
                    attached: [{{at: 0.5 m, mass: 1 kg}}, {{at: 0.5 m + {apart} m, k: 5 kN/m}}]}}}}
        points: {{tip: {{body: b, at: 1 m}}}}
        forces: {{load: {{at: tip, force: 10 N}}}}
        """)
    a = 0.5 + apart
    under = a**2 * (3 - a) / 600
    R = 10 * under / (1 / 5000 + a**3 / 300)
    for text, exact in (("b.u(1 m)", 10 / 300 - R * under), ("b.moment(0 m)", 10 - R * a)):
        found, error = measured(one, f"equilibrium[{text}]")
        assert abs(found - exact) <= (error + 1e-14) * abs(exact)


@pytest.mark.sweep
def test_what_nothing_holds_is_still_refused():
    """A free beam under a load, with places next to each other."""
    one = problem("""
        beams: {b: {length: 1 m, EI: 100 N*m^2, mass_per_length: 1 kg/m,
                    attached: [{at: 0.5 m, mass: 1 kg}, {at: 0.50001 m, k: 5 kN/m}]}}
        points: {tip: {body: b, at: 1 m}}
        forces: {load: {at: tip, force: 10 N}}
        """)
    with pytest.raises(NoEquilibrium):
        one.configuration.at_rest  # noqa: B018
