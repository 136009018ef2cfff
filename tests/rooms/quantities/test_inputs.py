"""What can drive a scene."""

from support.scenes import problem

from vibcli.api.reports import report
from vibcli.quantities.signal_dimensions import inputs
from vibcli.report.formats import text

PULLED = """
parameters: {m: 3 kg, k: 500 N/m, P: 40 N}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
forces: {pull: {at: b, force: P}}
find: [frequency_response]
"""


def test_a_force_that_has_let_go_drives_nothing():
    """The frequency response is that to the coordinate then, unless another input is named."""
    assert inputs(problem(PULLED).spec) == ["pull", "x"]
    released = problem(PULLED + "initial: {released: pull}\n")
    assert inputs(released.spec) == ["x"]
    told = text.render([report(released, ("frequency_response",)).document()], None)
    assert "Frequency response of x to x" in told
