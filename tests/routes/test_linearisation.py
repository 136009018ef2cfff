"""Small oscillations against the full equations, in every scene: with E(q, q̇, q̈, t) = 0 of Lagrange's method,

    M = ∂E/∂q̈      C + G = ∂E/∂q̇      K = ∂E/∂q      in equilibrium, and E = 0 there.

What drives a scene is left out of both: displacements that come and go are held, and of E the terms that still hold the
time are left to the excitation.
"""

from pathlib import Path

import pytest
from support.scenes import kept_instances_of, kept_problem_of

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.mechanics.energies import dissipation, kinetic, potential
from vibcli.mechanics.given_damping import given_numbers
from vibcli.mechanics.lagrange import equation_of
from vibcli.mechanics.linearise import without_time
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.running_errors import UNIT, Rounded, RunningErrors, error_in

ROOT = Path(__file__).parents[2]
FILES = sorted([*ROOT.glob("problems/*/*.yaml"), *ROOT.glob("vibcli/examples/*.yaml"),
                *ROOT.glob("vibcli/templates/*.yaml"), *ROOT.glob("tests/trials/*.yaml")])
MOST = 6                # coordinates
FEWEST, LOOKED, COMPARED = 0.8, [], []


def numeric_problems(path):
    scene = kept_problem_of(path)
    for case in ("", *scene.spec.cases):
        try:
            numeric = next(iter(kept_instances_of(path, case)), None)
            found = numeric is not None and 0 < len(numeric.scene.q) <= MOST and numeric.configuration.equilibrium
        except (PhysicsError, SpecError):
            continue
        if found:
            yield numeric


def full_equations(one):
    """[E_i] of the scene at rest; (q, v, a)."""
    scene = one.scene.resting
    T, V, Phi = kinetic(scene), potential(scene), dissipation(scene)
    return scene, [equation_of(scene, i, T, V, Phi) for i in range(len(scene.q))]


def given_damping(configuration):
    """What `damping:` adds to C; where members are damped as a whole that of the coordinates, α M + β K of them."""
    if not configuration.coupled:
        return configuration.given_damping().each(float).matrices()[1]
    alpha, beta = given_numbers(configuration, Floats)["proportional"]
    M, _, _, K = configuration.linear_system.with_parts(pieces=[]).matrices()
    return {pair: alpha * M.get(pair, 0.0) + beta * K.get(pair, 0.0) for pair in {*M, *K}}


def rounding(nodes, values):
    """What rounds in these at most, where values are known to a rounding."""
    arithmetic = RunningErrors(Floats)
    place = {name: Rounded(x, UNIT * abs(x)) for name, x in values.items()}
    return max(map(error_in, evaluate(nodes, arithmetic, place)), default=0.0)


def compare(one):
    scene, equations = full_equations(one)
    try:
        M, C, G, K = one.configuration.linear_system.matrices()
    except PhysicsError as error:
        assert any(word in error.message for word in ("kink", "dead centre", "a force jumps"))
        return
    if one.spec.get("damping") is not None:        # acts beside the full equations
        given = given_damping(one.configuration)
        C = {pair: x - given.get(pair, 0.0) for pair, x in C.items()}
    values = {**one.configuration.at_rest, **dict.fromkeys((a.name for a in scene.a), 0.0)}
    n, size = len(scene.q), dict.fromkeys("qva", 0.0)
    for kind, symbols, parts in (("a", scene.a, (M,)), ("v", scene.v, (C, G)), ("q", scene.q, (K,))):
        nodes = [gradient(equation).get(x, scene.table.zero) for equation in equations for x in symbols]
        if any(node.mask & scene.time.mask for node in nodes):
            place = {x: scene.table.number(0) for x in (*scene.v, *scene.a)}
            nodes = [without_time(scene, node) for node in substitute(nodes, place)]
        found = evaluate(nodes, Floats, values)
        wanted = [sum(part.get((i, j), 0.0) for part in parts) for i in range(n) for j in range(n)]
        size[kind] = max(map(abs, (*found, *wanted)))
        slack = 1e-9 * size[kind] + 1e-13 * max(size.values()) + rounding(nodes, values)
        assert found == pytest.approx(wanted, rel=1e-9, abs=slack), (one.spec.get("title"), kind)
    COMPARED.append(one)


@pytest.mark.sweep
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_matrices_are_the_slopes_of_the_full_equations(path):
    for one in numeric_problems(path):
        LOOKED.append(one)
        compare(one)


def test_most_scenes_were_compared():
    assert len(COMPARED) >= FEWEST * len(LOOKED), (len(COMPARED), len(LOOKED))
