"""Frequency responses of scenes with members to many digits: the equations of their power series under a load.

A (q, a) = (b, 0) with the matrix of reference/members.py at z = Ω² and with dampers, H = cᵀ q + d.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.members import START, equations, require_plain
from vibcli.evidence.reference.settled import DIGITS, TrueValues, settled
from vibcli.mechanics.inputs_outputs.inputs import direct_part, in_powers, named_input
from vibcli.mechanics.inputs_outputs.outputs import linear_row
from vibcli.mechanics.precise_configuration import PreciseConfiguration

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import FactoredSystem
    from vibcli.results.problem import Problem


class LoadedMembers(NamedTuple):
    """The element data, and b, c, d by powers of s: {coordinate: number} of each, but for d numbers."""

    elements: "FactoredSystem"
    b: list
    c: list
    d: list


def transfer(problem: "Problem", signal: str, driver: str) -> LoadedMembers:
    """Of a signal to a unit of an input, at the working precision; PhysicsError of members that lose energy."""
    configuration = PreciseConfiguration(problem.configuration)
    elements = problem.configuration.precise_system(mpmath.mp.dps)
    require_plain(elements)
    if any(placed.piece.drag or placed.retardation for placed in elements.pieces):
        raise PhysicsError("no reference is found of frequency responses of members that lose energy themselves")
    row, chosen = linear_row(configuration, signal), named_input(configuration, driver)
    if chosen.carried:
        raise PhysicsError("no reference is found of a load that turns with what is driven")
    return LoadedMembers(elements, list(in_powers(configuration.with_inputs.columns, chosen.weights, chosen.turns)),
                          [row.q, row.v, row.a], [mpmath.mpmathify(x) for x in direct_part(row, chosen)])


def in_floats(exact: LoadedMembers) -> LoadedMembers:
    """The same in floats."""
    b, c = ([{i: float(x) for i, x in entries.items()} for entries in part] for part in (exact.b, exact.c))
    return LoadedMembers(exact.elements.each(float), b, c, [float(x) for x in exact.d])


def at(exact: LoadedMembers, Omega: Any) -> Any:
    """H at s = iΩ."""
    s = mpmath.mpc(0, Omega)
    A = equations(exact.elements, mpmath.mpf(Omega) ** 2, s)
    right = mpmath.zeros(A.rows, 1)
    for power, entries in enumerate(exact.b):
        for i, x in entries.items():
            right[i] += s**power * x
    q = mpmath.lu_solve(A, right)
    return sum(s**power * (sum(x * q[i] for i, x in entries.items()) + d)
               for power, (entries, d) in enumerate(zip(exact.c, exact.d, strict=True)))


def value(problem: "Problem", signal: str, driver: str, Omega: Callable[[], Any]) -> TrueValues:
    """H at a frequency, which is evaluated at the working precision."""
    return settled(lambda: ([at(transfer(problem, signal, driver), Omega())], None), DIGITS, START)
