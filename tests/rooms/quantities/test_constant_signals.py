"""What does not change in time has no instant at which it is largest."""

import pytest
from support.scenes import problem

import vibcli
from vibcli.api.reports import report, solution
from vibcli.base.errors import PhysicsError
from vibcli.quantities.response import _of_what_changes
from vibcli.report.formats import text
from vibcli.results.escalation import BoundedExtreme
from vibcli.symbolic.syntax import QuantityRef

HAULED = """
parameters: {m: 2 kg, M: 3 kg, J: 0.01 kg*m^2, r: 0.1 m, t1: 0.4 s, g: 9.81 m/s^2}
gravity: g
bodies:
  a: {mass: m, at: [-r, -1 m], slide: {along: [0, 1], by: y}}
  drum: {inertia: J, at: [0, 0], pin: {by: phi}}
  b: {mass: M, at: [r, -1 m], slide: {along: [0, -1], by: z}}
constraints: {rope: {rope: [a, {over: drum, radius: r}, b]}}
motion: full
find: [{response: {of: [y, rope.force.1], until: t1}}]
"""


def test_a_force_that_does_not_change_is_so_always():
    """Two weights over a drum fall with one acceleration (M − m)g/(m + M + J/r²): the rope pulls m(g + a)."""
    found = problem(HAULED)
    told = text.render([report(found, solution(found)).document()], None)
    pull = 2 * 9.81 * (1 + 1 / 6)
    row = next(line for line in told.splitlines() if line.strip().startswith("rope.force.1 [N]"))
    assert row.split()[2:] == [f"{pull:.6g}", "always"] * 2


@pytest.mark.sweep
def test_no_instant_of_it_stands_out():
    model = vibcli.load("problems/2_lagrange/sledge_hauled_up_by_a_falling_weight.yaml")
    with pytest.raises(PhysicsError, match=r"'rope\.force\.2' does not change"):
        model["argmax(rope.force.2)"]
    assert model["argmax(s)"].value == pytest.approx(1.2)


@pytest.mark.parametrize(("instant", "error"), [(0.0, 0.0), (1.2, 0.0), (0.5, 1.2)])
def test_nor_does_one_of_what_rounds_most_at_an_end(instant, error):
    class Still:
        def error_of_time(self, t):
            return error

        def values(self, times):
            return 500.0 + 1e-13 * times

        def bounded_extreme(self, start, end, sense):
            return BoundedExtreme(instant, 500.0 + sense * 1e-13, error, 1e-10)

    with pytest.raises(PhysicsError, match="'still' does not change"):
        _of_what_changes(QuantityRef(0, 0, "argmax(still)", "argmax"), Still(), 1.2, instant)
