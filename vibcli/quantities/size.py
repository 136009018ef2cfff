"""How large quantities of a kind become: what their rounding is measured by."""

from vibcli.base.errors import PhysicsError
from vibcli.quantities.expression import measure, number_of
from vibcli.quantities.quantity import IN_FREQUENCY


def size_of(problem, tree):
    """The largest value that a quantity of this kind has: what its rounding is measured by."""
    head = tree.head
    if head in ("phase", "arg", "overshoot", "decrement", "cycles_to"):
        return 1.0
    if head in IN_FREQUENCY:
        inner = tree if head in ("frf", "transmissibility") else tree.args[0]
        return abs(measure(problem, inner)[0]) if inner.args else 0.0
    if head in ("argmax", "argmin", "zero", "time_to", "beat_period", "period"):
        return problem.response.until
    signal, end = problem.response.signal(tree.args[0]), _end(problem, tree)
    return max(abs(signal.extreme(0.0, end, sense)[1]) for sense in (1, -1))


def _end(problem, tree):
    """Until when the motion is looked at; of a value whose motion has no known end, until its instant and for a
    second."""
    try:
        return problem.response.until
    except PhysicsError:
        if tree.head != "value":
            raise
        return max(number_of(problem, tree.args[1]), 1.0)
