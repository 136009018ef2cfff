"""Coordinates of small motions at an instant to any number of digits, by another way than the floats go."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath

    from vibcli.results.problem import Problem

GUARD = 30


def precise_value(problem: "Problem", name: str, primes: int, time: "Fraction", digits: int) -> "mpmath.mpf":
    """A coordinate (1 prime: its velocity, 2: its acceleration) at a time given as a Fraction, an mpmath number correct
    to `digits`."""
    import mpmath

    from vibcli.analyses.excitation.decompose import forcing_of
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.high_precision import precise_value as value_of
    from vibcli.mechanics.high_precision import equilibrium_to, system_to
    from vibcli.symbolic.evaluation import multiprecision

    scene, names = problem.scene, problem.scene.coordinates
    if name not in names:
        raise PhysicsError(f"'{name}' is no independent coordinate: more digits are found of these alone",
                           "ask for " + " or ".join(names[:3]))
    if not (problem.system.is_linear or problem.configuration.equilibrium.drawn):
        raise PhysicsError("more digits are found where the drawn position is the equilibrium, or the scene is linear",
                           "draw it in equilibrium")
    M, C, G, K = system_to(problem.configuration, digits + GUARD).matrices()
    n, i = len(names), names.index(name)
    with mpmath.workdps(digits + GUARD):
        arithmetic = multiprecision()
        values = problem.numeric.values(arithmetic)
        near = problem.configuration.equilibrium
        rest = drawn(problem, values) if near.drawn else equilibrium_to(problem.numeric, near, values, arithmetic)
        q, v = start(problem, values, rest)
        nodes = problem.symbolic.excitation if scene.timed else {}
        forcing = forcing_of(nodes, scene.time, values, n, precise=True, work=problem.work)
        damping = [[C.get((j, k), 0) + G.get((j, k), 0) for k in range(n)] for j in range(n)]
        found = value_of(_full(M, n), damping, _full(K, n), forcing, [q[each] - rest[each] for each in names],
                         [v[each] for each in names], LinearOutput(q={i: 1}), time, digits + GUARD // 2, primes)
        return found + (rest[name] if not primes else 0)


def drawn(problem: "Problem", values: "Mapping[str, mpmath.mpf]") -> "dict[str, mpmath.mpf]":
    """{coordinate: number} as drawn."""
    from vibcli.symbolic.evaluation import evaluate, multiprecision

    known = problem.scene.drawn
    return dict(zip((q.name for q in known), evaluate(list(known.values()), multiprecision(), values), strict=True))


def start(problem: "Problem", values: "Mapping[str, mpmath.mpf]",
          rest: "Mapping[str, float | mpmath.mpf]") -> "tuple[dict[str, mpmath.mpf], dict[str, mpmath.mpf]]":
    """({coordinate: number}, {coordinate: velocity}) at t = 0."""
    import mpmath

    from vibcli.language.sections.initial import RELEASED
    from vibcli.symbolic.evaluation import evaluate, multiprecision

    if problem.configuration.preloaded is not None:
        raise PhysicsError("the equilibrium from which a force lets go is not found to more digits",
                           "give the start as values")
    record, scene = problem.spec.get("initial"), problem.scene
    given = {key: evaluate([scene.lower(expression)], multiprecision(), values)[0]
             for key, expression in (record.items() if record is not None else ()) if key != RELEASED}
    return ({name: given.get(name, rest[name]) for name in scene.coordinates},
            {name: given.get(name + "'", mpmath.mpf(0)) for name in scene.coordinates})


def _full(matrix, n):
    return [[matrix.get((j, k), 0) for k in range(n)] for j in range(n)]
