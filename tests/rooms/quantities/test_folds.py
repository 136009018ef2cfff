"""Limit points of equilibria over a parameter, against closed forms of snap-through, buckling and pull-in."""

from functools import cache

import mpmath
import pytest
from mpmath import mpf
from support.motions import problem

from vibcli import loads
from vibcli.api.values import given_expression
from vibcli.base.errors import PhysicsError
from vibcli.quantities.expression import measure
from vibcli.results.problem import Problem

TRUSS = """
parameters: {k: 2000 N/m, b: 0.4 m, h: 0.15 m, P: {value: 1 N, sign: any}, m: 1 kg}
bodies: {apex: {mass: m, at: [0, h], slide: {along: [0, 1], by: y}}}
springs:
  left: {k: k, between: [[-b, 0], apex]}
  right: {k: k, between: [[b, 0], apex]}
forces: {load: {at: apex, force: [0, -P]}}
"""
FREE_TRUSS = TRUSS.replace("slide: {along: [0, 1], by: y}", "move: [x, y]").replace("[0, -P]", "[0.03*P, -P]")
COLUMN = """
parameters: {L: 1 m, k: 30 N/m, s: 0.05, P: 1 N, m: 1 kg}
bodies: {rod: {shape: rod, mass: m, from: [0, 0], to: [0, L], pin: {at: [0, 0], by: phi}}}
points: {top: {body: rod, at: [0, L]}}
energies: {V: k*L^2*(sin(phi) - s)^2/2}
forces: {load: {at: top, force: [0, -P]}}
"""
PENDULUM = """
parameters: {L: 1 m, M: 1 N*m, m: 1 kg, g: 10 m/s^2}
gravity: g
bodies: {bob: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi}}}
forces: {drive: {body: bob, moment: M}}
"""
TOGGLE = """
parameters: {L: 0.5 m, alpha: 0.6, k: 800 N/m, P: 2 N, m: 0.1 kg}
points:
  A: {body: first, at: [L*cos(alpha), L*sin(alpha)]}
  B: {body: second, at: [2*L*cos(alpha), 0]}
bodies:
  first: {shape: rod, mass: m, from: [0, 0], to: [L*cos(alpha), L*sin(alpha)], pin: {at: [0, 0], by: phi}}
  second: {shape: rod, mass: m, from: [L*cos(alpha), L*sin(alpha)], to: [2*L*cos(alpha), 0],
           pin: {at: A, carrier: first, by: psi}}
  ram: {mass: m, at: [2*L*cos(alpha), 0], slide: x}
springs: {s: {k: k, between: [[3 m, 0], ram]}}
forces: {push: {at: A, force: [0, -P]}}
constraints: {hinge: {join: [B, ram]}}
"""
BLOCK = """
parameters: {k: 100 N/m, F: 1 N, a: 0.1 m, m: 1 kg}
bodies: {block: {mass: m, slide: x}}
energies: {V: %s}
forces: {load: {at: block, force: F}}
"""
BENT = """
parameters: {k: 100 N/m, F: 1 N, a: 0.1 m, m: 1 kg}
bodies: {block: {mass: m, slide: x}}
springs: {s: {law: "%s", between: [ground, block]}}
forces: {load: {at: block, force: F}}
"""


known = cache(problem)


def asked(text, what):
    return measure(known(text), given_expression(what, "it").tree)


def agrees(text, what, exact, bound=1e-15):
    found, error = asked(text, what)
    assert abs(found - exact) <= (error + 2.0**-52) * abs(exact), (found, exact, error)
    assert error <= bound


@pytest.mark.sweep
def test_a_truss_that_snaps_through():
    """P = 2 k (l₀ − l) √(l² − b²)/l is extreme where l³ = b² l₀."""
    with mpmath.workdps(40):
        b, h = mpf("0.4"), mpf("0.15")
        free = mpmath.hypot(b, h)
        length = mpmath.cbrt(b**2 * free)
        height = mpmath.sqrt(length**2 - b**2)
        load = 4000 * (free - length) / length * height
        agrees(TRUSS, "fold[1, P]", load)
        agrees(TRUSS, "fold[2, P]", -load)
        agrees(TRUSS, "fold[1, P](y)", height - h)
        agrees(TRUSS, "fold[2, P](apex.y)", -height - h)
        agrees(TRUSS, "fold[1, P](left.force)", 2000 * (length - free))
        agrees(TRUSS, "fold[1, k]", 2000 / load)
        precise = Problem(known(TRUSS).spec, digits=30)
        found, error = measure(precise, given_expression("fold[1, P]", "it").tree)
        assert abs(found - load) <= error * load <= 1e-29


@pytest.mark.sweep
def test_two_degrees():
    """r = 0 and det K = 0 of the truss with a free apex, by hand."""
    def length(x, y, side):
        return mpmath.sqrt((x - side * mpf("0.4")) ** 2 + (mpf("0.15") + y) ** 2)

    def forces(x, y, P):
        rx, ry = -P * mpf("0.03"), P
        for side in (-1, 1):
            one = length(x, y, side)
            pull = 2000 * (one - mpmath.hypot(mpf("0.4"), mpf("0.15"))) / one
            rx += pull * (x - side * mpf("0.4"))
            ry += pull * (mpf("0.15") + y)
        return rx, ry

    def extended(x, y, P):
        (a, b), (c, d) = ([mpmath.diff(lambda *z, i=i: forces(*z, P)[i], (x, y), n) for n in ((1, 0), (0, 1))]
                          for i in (0, 1))
        return (*forces(x, y, P), (a * d - b * c) / 10**6)

    with mpmath.workdps(30):
        x, y, P = mpmath.findroot(extended, (mpf("1e-4"), mpf("-0.0653"), mpf("15.19")))
        agrees(FREE_TRUSS, "fold[1, P]", P)
        agrees(FREE_TRUSS, "fold[1, P](y)", y)
        agrees(FREE_TRUSS, "fold[1, P](x)", x, 1e-12)


@pytest.mark.sweep
@pytest.mark.parametrize("s", ["0.05", "-0.3", "1e-6"])
def test_an_imperfect_column(s):
    """P = k L (1 − |s|^(2/3))^(3/2), where sin³φ = s."""
    with mpmath.workdps(30):
        root = mpmath.sign(mpf(s)) * mpmath.cbrt(abs(mpf(s)))
        text = COLUMN.replace("s: 0.05", f"s: {s}")
        agrees(text, "fold[1, P]", 30 * (1 - root**2) ** mpf("1.5"))
        agrees(text, "fold[1, P](phi)", mpmath.asin(root))


@pytest.mark.sweep
def test_loops_are_closed_on_the_way():
    """P = 4 k L (cos φ − cos α) tan φ is extreme where cos³φ = cos α."""
    with mpmath.workdps(30):
        c = mpmath.cos(mpf("0.6"))
        agrees(TOGGLE, "fold[1, P]", 4 * 800 * mpf("0.5") * (1 - c ** (mpf(2) / 3)) ** mpf("1.5"))
        agrees(TOGGLE, "fold[1, P](x)", mpmath.cbrt(c) - c, 1e-13)


@pytest.mark.sweep
def test_signs_and_images():
    """M = m g L sin φ: after a quarter of a turn; a turn on it is the same."""
    agrees(PENDULUM, "fold[1, M]", 10)
    agrees(PENDULUM, "fold[1, M](phi)", mpmath.pi / 2)
    agrees(PENDULUM, "fold[1, m]", mpf("0.1"))
    agrees(PENDULUM.replace("M: 1 N*m", "M: -1 N*m"), "fold[1, M]", -10)
    with pytest.raises(PhysicsError, match=r"no fold 2 of 'M': only 1 is met .* from −10 N·m to 10 N·m") as error:
        asked(PENDULUM, "fold[2, M]")
    assert "`sign: any`" in error.value.hint
    agrees(PENDULUM.replace("M: 1 N*m", "M: {value: 1 N*m, sign: any}"), "fold[2, M]", -10)


@pytest.mark.sweep
def test_pull_in_and_a_force_that_softens():
    """k x = a F²/(2 (1 − x)²) at x = 1/3; F = k x exp(−x/a) at x = a."""
    pull = BLOCK.replace("a: 0.1 m", "a: 2 N*m^2/N^2, g0: 1 m").replace(
        "forces: {load: {at: block, force: F}}", "") % "k*x^2/2 - a*F^2/(2*(g0 - x))"
    agrees(pull.replace("N*m^2/N^2", "m^2/N"), "fold[1, F]", mpmath.sqrt(mpf(8) * 100 / (27 * 2)))
    soft = BLOCK % "-k*a*(x + a)*exp(-x/a)"
    agrees(soft, "fold[1, F]", 10 / mpmath.e)
    agrees(soft, "fold[1, F](x)", mpf("0.1"))


@pytest.mark.sweep
@pytest.mark.parametrize("slope", ["1.02", "1.5", "5"])
def test_where_forces_bend(slope):
    """The force falls beyond x = a: equilibria meet at the corner, F = k a."""
    agrees(BENT % f"k*d - {slope}*k*max(d - a, 0)", "fold[1, F]", 10, 1e-10)
    agrees(BENT % f"k*d - {slope}*k*max(d - a, 0)", "fold[1, F](x)", mpf("0.1"), 1e-6)


@pytest.mark.sweep
@pytest.mark.parametrize(("text", "what", "message", "hint"), [
    (COLUMN.replace("s: 0.05", "s: 0"), "fold[1, P]", "no fold 1 of 'P': none is met", "at 30 N other equilibria "
     "branch off, which is no fold"),
    (BENT % "k*d + k/a^2*d^3", "fold[1, F]", "no fold 1 of 'F': none is met", "times as large as it was"),
    (BENT % "k*d + a*k*sign(d - 1.3*a)/2", "fold[1, F]", "no fold 1 of 'F'", "forces jump there"),
    (TRUSS, "fold[1, m]", "the equilibrium does not depend on 'm'", "ask about a parameter"),
])
def test_there_is_none(text, what, message, hint):
    with pytest.raises(PhysicsError, match=message) as error:
        asked(text, what)
    assert hint in (error.value.hint or "")


@pytest.mark.sweep
def test_limit_points_next_to_each_other():
    """F = ∫ (x − 2)(x − 2.1)(x² + 1) dx has one pair of them, closer than a step."""
    slope = (1, mpf("-4.1"), mpf("5.2"), mpf("-4.1"), mpf("4.2"))
    force = [*(c / n for c, n in zip(slope, range(5, 0, -1), strict=True)), 0]
    law = " + ".join(f"({mpmath.nstr(c, 20)})*x^{n}/{n}" for c, n in zip(force[:-1], range(6, 1, -1), strict=True))
    text = "parameters: {F: 0.1, m: 1}\nbodies: {block: {mass: m, slide: x}}\n" + (
        f"energies: {{V: {law}}}\nforces: {{load: {{at: block, force: F}}}}\n")
    agrees(text, "fold[1, F]", mpmath.polyval(force, mpf("2.1")), 1e-13)
    agrees(text, "fold[2, F]", mpmath.polyval(force, 2), 1e-13)


@pytest.mark.sweep
def test_a_buckled_column_does_not_fold_where_it_becomes_straight():
    text = COLUMN.replace("(sin(phi) - s)", "phi").replace("s: 0.05, P: 1 N", "P: 35 N") + "equilibrium: {phi: 0.8}\n"
    with pytest.raises(PhysicsError, match="are followed from 30 N to") as error:
        asked(text, "fold[1, P]")
    assert "at 30 N other equilibria branch off" in error.value.hint


@pytest.mark.sweep
def test_the_place_of_a_branching_is_told_as_it_is():
    """P L = k_t of an upright rod on a torsion spring; the bisection of the step meets the singular place itself."""
    column = loads("parameters: {L: 1 m, kt: 10 N*m, P: 5 N, m: 1 kg}\n"
                   "bodies: {rod: {mass: m, at: [0, L], pin: {at: [0, 0], by: phi}}}\n"
                   "springs: {s: {torsion: kt, between: [ground, rod]}}\n"
                   "forces: {P: {at: rod, force: [0, -P]}}\n")
    with pytest.raises(PhysicsError) as refused:
        column["fold[1, P]"]
    assert "at 10 N other equilibria branch off" in refused.value.hint
