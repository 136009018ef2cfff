"""Motions whose forces bend, jump or stick with them, and forces of ropes, threads and supports along them, beside
closed forms."""

import mpmath
import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.evidence.subjects.motions import of_motion, period

RUBBED = """
bodies: {b: {mass: 1 kg, slide: x}}
springs: {s: {k: 25 N/m, between: [ground, b]}}
dampers: {f: {friction: 2 N, between: [ground, b]}}
initial: {x: 50 cm}
motion: full
find: [{response: {until: 2 s}}]
answers: {"zero[4](x')": 0, "x(2 s)": 0, "f.force(2 s)": 0, "min(f.force)": 0}
"""
PUSHED = """
bodies: {b: {mass: 1 kg, slide: x}}
dampers: {f: {friction: 3 N, breakaway: 4 N, between: [ground, b]}}
forces: {F: {at: b, force: (2 N/s)*t}}
initial: {x: 0}
motion: full
find: [{response: {until: 4 s}}]
answers: {"x(1 s)": 0, "x(3 s)": 0, "f.force(1 s)": 0, "f.force(3 s)": 0}
"""
BENT = """
bodies: {b: {mass: 1 kg, slide: x}}
springs: {s: {law: "%s", between: [ground, b]}}
initial: {x: 0.5 m}
motion: full
find: [{response: {until: 3 s}}]
answers: {"period(x)": 0, "max(x')": 0}
"""
THREAD = """
parameters: {m: 1 kg, L: 1 m, g: 9.81 m/s^2}
gravity: g
bodies: {a: {mass: m, at: [0, -L], move: [x, y, 0]}}
constraints: {thread: {link: [[0, 0], a]}}
initial: {x: 0.8 m}
motion: full
find: [{response: {until: 2 s}}]
answers: {"max(thread.force)": 0, "thread.force(0 s)": 0}
"""
OVER_A_PEG = """
parameters: {k: 60 N/m, g: 9.81 m/s^2}
gravity: g
bodies:
  crate: {mass: 4 kg, at: [0, 0], slide: x}
  weight: {mass: 2 kg, at: [2 m, -1 m], slide: {along: [0, -1], by: y}}
springs: {s: {k: k, between: [[-2 m, 0], crate]}}
constraints: {rope: {rope: [crate, {over: [2 m, 0]}, weight]}}
motion: full
initial: {x: %s}
find: [{response: {until: 2 s}}]
answers: {"max(rope.force)": 0, "argmax(rope.force)": 0, "crate.reaction.y(1 s)": 0}
"""


def found(text):
    """The values of the answers of a scene, as the reference finds them."""
    one = problem(text)
    trees = [answer.asked.tree for answer in one.spec.answers]
    return [(period if tree.head == "period" else of_motion)(one, tree).true.values[0] for tree in trees]


def close(values, exact, digits=28):
    return all(abs(x - y) <= mpmath.mpf(10) ** -digits for x, y in zip(values, exact, strict=True))


@pytest.mark.sweep
def test_dry_friction_takes_as_much_of_each_swing_and_holds_at_last():
    """x = ±R/k + A cos ωt, each half swing R/k = 8 cm about another place, from 50 to −34, 18 and −2 cm."""
    with mpmath.workdps(40):
        assert close(found(RUBBED), [3 * mpmath.pi / 5, mpmath.mpf("-0.02"), mpmath.mpf("0.5"), -2])


@pytest.mark.sweep
def test_what_sticks_gives_way_where_a_load_passes_what_it_holds():
    """From t = 2 s on, a = 2 t − 3: x = t³/3 − 3 t²/2 + 2 t − 2/3."""
    with mpmath.workdps(40):
        assert close(found(PUSHED), [0, mpmath.mpf(5) / 6, 2, 3])


@pytest.mark.sweep
@pytest.mark.parametrize(("law", "T", "v"), [
    ("(4 N)*sign(d)", lambda: 4 * mpmath.sqrt(2 * mpmath.mpf("0.5") / 4), 2),
    ("(4 N/m)*d + (5 N/m)*max(d, 0 m)", lambda: mpmath.pi * (mpmath.mpf(1) / 3 + mpmath.mpf(1) / 2), mpmath.mpf("1.5")),
    ("(4 N/m)*abs(d)*sign(d)", lambda: mpmath.pi, 1)])
def test_springs_that_bend_and_jump(law, T, v):
    with mpmath.workdps(40):
        assert close(found(BENT % law), [T(), v])


@pytest.mark.sweep
def test_the_force_of_a_thread():
    """m g (3 − 2 cos α) at the lowest place, m g cos α at the start, sin α = 0.8."""
    with mpmath.workdps(40):
        weight = mpmath.mpf("9.81")
        assert close(found(THREAD), [weight * mpmath.mpf("1.8"), weight * mpmath.mpf("0.6")])


@pytest.mark.sweep
def test_the_force_of_a_rope_and_where_it_would_push():
    """M (g − ÿ) of x = x₀ + A cos ωt, ω² = 10 s⁻², is largest where it turns first, after half a swing."""
    with mpmath.workdps(40):
        g, rest = mpmath.mpf("9.81"), 2 * mpmath.mpf("9.81") / 60
        assert close(found(OVER_A_PEG % "0 m"), [2 * (g + 10 * rest), mpmath.pi / mpmath.sqrt(10), 4 * g])
    with pytest.raises(PhysicsError, match="the reference finds that a rope goes slack"):
        found(OVER_A_PEG % "-1.5 m")
