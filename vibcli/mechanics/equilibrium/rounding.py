"""What rounding leaves of forces that are in equilibrium, by interval arithmetic."""

import math

from vibcli.mechanics.linearisation import residual_terms
from vibcli.symbolic.evaluation import evaluate


def may_vanish(numeric, position):
    """May every force be zero in a position ({coordinate: float}), within the rounding of what it is computed from? The
    force of a stiff spring, k (ℓ − ℓ₀), is not known to the last digit of a small load."""
    from vibcli.symbolic.interval_arithmetic import Intervals, exact

    values = {name: exact(x) for name, x in (*numeric.floats.items(), *position.items())}
    rows = residual_terms(numeric.system.linearisation)
    try:
        found = iter(evaluate([term for row in rows for term in row], Intervals, values))
    except KeyError:            # of a function without bounds
        return False
    forces = [sum((next(found) for _ in row), exact(0.0)) for row in rows]
    return all(force.holds_zero() and math.isfinite(force.size) for force in forces)
