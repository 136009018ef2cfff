"""What motions come to in the end, beside closed forms."""

import mpmath
import pytest
from support.scenes import problem

from vibcli.base.errors import PhysicsError
from vibcli.evidence.asked import subjects
from vibcli.evidence.reference.long_after import limit
from vibcli.evidence.reference.motion import small

DRIVEN = """
bodies:
  cart: {slide: "%s"}
  b: {mass: 2 kg, slide: x}
springs: {s: {k: 50 N/m, between: [cart, b]}}
dampers: {d: {c: 4 N*s/m, between: [ground, b]}}
answers: {%s}
"""


def found(motion, answers):
    one = problem(DRIVEN % (motion, answers))
    return list(subjects(one, [answer.asked for answer in one.spec.answers]))


@pytest.mark.sweep
def test_behind_what_moves_on():
    """Behind u = v t it stays by c v/k; behind u = a t²/2 by (c a t + m a)/k − c² a/k²."""
    at_speed = found("(3 m/s)*t", "final(cart.x - x): 1 m, final(x'): 1 m/s, steady(x)(0 s): 1 m, "
                     "final(cart.x' - x'): 0")
    faster = found("(2 m/s^2)*t^2/2", "steady(x)(3 s): 1 m, final(x''): 1 m/s^2, final(x): 1 m")
    with mpmath.workdps(50):
        lag = mpmath.mpf(12) / 50
        exact = [lag, 3, -lag, 0, 9 - mpmath.mpf(28) / 50 + mpmath.mpf(32) / 2500, 2]
        for each, x in zip([*at_speed, *faster[:2]], exact, strict=True):
            answer = each.ours()
            assert abs(each.true.values[0] - x) < 1e-34, each.asked
            assert each.error(answer.values, each.true) <= answer.bound < 1e-10
    assert not hasattr(faster[2], "true")


def test_what_keeps_on_swinging_comes_to_nothing_that_is_found():
    one = problem(DRIVEN % ("(3 cm)*sin(t/(1 s))", "x(1 s): 0"))
    motion = small(one)
    with pytest.raises(PhysicsError, match="powers of the time"):
        limit(motion, motion.coordinate("x"), 1.0)
