"""H(iΩ) = cᵀ (K + iΩ C − Ω² M)⁻¹ b + d to any number of digits, from the exact data."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import mpmath
from mpmath import mp

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.inputs_outputs.inputs import direct_part, in_powers, named_input
from vibcli.mechanics.inputs_outputs.outputs import linear_row
from vibcli.mechanics.precise_configuration import PreciseConfiguration
from vibcli.results.precise_signals import agreed
from vibcli.results.precise_work import MOST, require_quick

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

PRICE = 4e-5        # steps of a million products, of a complex elimination of one coordinate, by n³


def precise_response(problem: "Problem", signal: str, driver: str, omega: "Callable[[], mpmath.mpf]", digits: int,
                     most: float = MOST) -> "mpmath.mpc":
    """H of a signal to a unit of an input, to so many digits of |H|; omega: gives Ω at the working precision."""
    require_quick(PRICE * len(problem.scene.coordinates) ** 3, digits, problem.work, most)
    size = abs(problem.frequency_response(signal, driver).at(float(omega()))[0])
    re, im = agreed(lambda: _parts(problem, signal, driver, omega()), digits, size)
    return mpmath.mpc(re, im)


def _parts(problem, signal, driver, Omega):
    configuration, s = PreciseConfiguration(problem.configuration), mp.mpc(0, Omega)
    row, chosen = linear_row(configuration, signal), named_input(configuration, driver)
    if chosen.carried:
        raise PhysicsError("more digits of a response to a load that turns with what is driven are not found",
                           "leave --digits out")
    n, (M, C, G, K) = len(problem.scene.coordinates), configuration.matrices
    dynamic = mp.matrix(n, n)
    for matrix, factor in ((M, s * s), (C, s), (G, s), (K, mp.mpf(1))):
        for (i, j), x in matrix.items():
            dynamic[i, j] += factor * x
    b = in_powers(configuration.with_inputs.columns, chosen.weights, chosen.turns)
    try:
        found = mp.lu_solve(dynamic, mp.matrix([_at([part.get(i, 0) for part in b], s) for i in range(n)]))
    except ZeroDivisionError:
        raise PhysicsError("the input drives an undamped mode at its natural frequency", "ask at another one") from None
    H = _at(direct_part(row, chosen), s) + mp.fsum(
        s**power * x * found[i] for power, part in enumerate((row.q, row.v, row.a)) for i, x in part.items() if i < n)
    return [mp.re(H), mp.im(H)]


def _at(coefficients: Any, s):
    return mp.fsum(mp.mpmathify(c) * s**power for power, c in enumerate(coefficients))
