"""Everything at rest with bounds of its errors: what positions, stretches and matrices about it may be off by.

An equilibrium that was searched for is off by K⁻¹ r at most, to first order, where r is what is left of the forces
together with their rounding; along what nothing holds it is where it was put.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.mechanics.factored_system import summed
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.running_errors import UNIT, Rounded, RunningErrors, error_in, number_in

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration

SINGULAR = 1e-12        # relative: what holds a direction less is taken for rounding
FAR = 1e-9              # beyond it more than first order counts
LARGEST, NOMINAL = 200, 1e-12       # coordinates; relative, of what is not looked into: where it is singular the place
                                    # was found by other means


def bounded_rest(configuration: "Configuration") -> tuple[RunningErrors, dict[str, Any]]:
    """(arithmetic, {symbol: number with its bound}) of everything at rest, at t = 0."""
    arithmetic = RunningErrors(Floats)
    values = configuration.numeric.values(arithmetic)
    exact = dict.fromkeys((configuration.scene.time.name, *(v.name for v in configuration.scene.v)), 0.0)
    return arithmetic, {**values, **exact, **_position(configuration, arithmetic, values)}


def _position(configuration: "Configuration", arithmetic: RunningErrors,
              values: dict[str, Rounded]) -> dict[str, Rounded]:
    """{coordinate: number with its bound}."""
    found, jumps = configuration.equilibrium.values, configuration.equilibrium.jumps
    if jumps is not None:
        return jumps.bounded(arithmetic, values)
    if configuration.equilibrium.drawn:
        drawn = {q.name: node for q, node in configuration.scene.resting.drawn.items()}
        return dict(zip(drawn, evaluate(list(drawn.values()), arithmetic, values), strict=True))
    if configuration.sources[0] is None or len(configuration.scene.coordinates) > LARGEST:
        return {name: Rounded(x, NOMINAL * abs(x)) for name, x in found.items()}
    if configuration.scene.resting.loops is not None:
        return _by_more_digits(configuration, found)
    away = _distance(configuration, arithmetic, {**values, **found})
    if any(not x <= FAR * (1 + abs(found[name])) for name, x in away.items()):
        return _by_more_digits(configuration, found)
    return {name: Rounded(x, away.get(name, 0.0) + UNIT * abs(x)) for name, x in found.items()}


def _distance(configuration: "Configuration", arithmetic: RunningErrors,
              values: dict[str, float | Rounded]) -> dict[str, float]:
    """{coordinate: how far it is off at most}: |K⁻¹| of what may be left of the forces."""
    import numpy as np

    numbers = in_numbers(configuration.system.linearisation, arithmetic, values)
    left = np.array([abs(number_in(r)) + error_in(r) for r in numbers.residual], dtype=float)
    K = np.zeros((len(left), len(left)))
    for (i, j), x in numbers.elements.stiffness().items():
        K[i, j] = number_in(x)
    sizes = np.sqrt(np.maximum(abs(K).max(axis=1), abs(K).max(axis=0)))
    sizes[sizes == 0] = 1.0
    flexibility = np.linalg.pinv(K / np.outer(sizes, sizes), rcond=SINGULAR)
    return dict(zip(configuration.scene.coordinates, 2 * (abs(flexibility) @ (left / sizes)) / sizes, strict=True))


def _by_more_digits(configuration: "Configuration", found: Mapping[str, float]) -> dict[str, Rounded]:
    """By how much the position differs from that to more digits: of closed loops, whose lengths hang on each other, and
    next to folds."""
    import mpmath

    from vibcli.base.errors import PhysicsError
    from vibcli.mechanics.high_precision import ROUNDED

    try:
        _, precise = configuration.precise_rest(ROUNDED)
    except PhysicsError:
        return {name: Rounded(x, NOMINAL * abs(x)) for name, x in found.items()}
    with mpmath.workdps(ROUNDED):
        return {name: Rounded(x, UNIT * abs(x) + float(abs(precise[name] - x))) for name, x in found.items()}


def bounded_matrices(configuration: "Configuration") -> "list[dict[tuple[int, int], Rounded]]":
    """M, C, G, K of small oscillations, each {(i, j): number with its bound}; those about an equilibrium that was
    searched for are added from data that are correctly rounded."""
    closed = configuration.scene.loops is not None or "atan2" in configuration.scene.table.called
    if configuration.system.is_linear or (configuration.equilibrium.drawn and not closed):
        arithmetic, values = configuration.bounded_rest
        found = in_numbers(configuration.reference_form, arithmetic, values).elements.matrices()
        return _with_given_damping(configuration, found)
    return configuration.linear_system.each(lambda x: Rounded(x, UNIT * abs(x))).matrices()


def _with_given_damping(configuration: "Configuration",
                        matrices: list[dict[tuple[int, int], Rounded]]) -> list[dict[tuple[int, int], Rounded]]:
    """The same with what `damping:` adds to C, whose data are correctly rounded."""
    if configuration.spec.get("damping") is None:
        return matrices
    M, C, G, K = matrices
    more = configuration.given_damping().each(float).each(lambda x: Rounded(x, UNIT * abs(x))).matrices()[1]
    return [M, summed(C, more), G, K]
