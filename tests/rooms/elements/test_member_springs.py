"""Pieces at rest against the transfer matrix of their differential equation: exp of a companion matrix, in mpmath."""

import random

import mpmath
import pytest
from support.scenes import problem

from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable

DIGITS = 60


def transfer(order, length, bending, tension, foundation):
    """(u, u′, …) at the right end by those at the left one, B u⁗ − N u″ + k u = 0 or N u″ = k u."""
    companion = mpmath.zeros(order)
    for i in range(order - 1):
        companion[i, i + 1] = 1
    companion[order - 1, 0] = foundation / tension if order == 2 else -foundation / bending
    if order == 4:
        companion[3, 2] = tension / bending
    return mpmath.expm(companion * length)


def static_stiffness(order, length, bending, tension, foundation):
    """Forces on the ends by end values (u₀, u_l), of beams (u₀, θ₀, u_l, θ_l)."""
    with mpmath.workdps(DIGITS):
        length, bending, tension, foundation = map(mpmath.mpf, (length, bending, tension, foundation))
        across = transfer(order, length, bending, tension, foundation)
        half = order // 2
        force = mpmath.zeros(half, order)       # Q = N u′ − B u‴ and M = B u″ at a cut, on what lies to its left
        force[0, 1] = tension
        if order == 4:
            force[0, 3], force[1, 2] = -bending, bending
        shown = mpmath.zeros(order)
        for i in range(half):
            shown[i, i] = 1
            shown[half + i, :] = across[i, :]
        loads = mpmath.zeros(order)
        loads[:half, :] = -force
        loads[half:, :] = force * across
        return (loads * shown**-1).tolist()


CASES = [(kind, sign, k) for kind in ("bar", "string", "shaft") for sign, k in ((1, 0), (1, 3))]
CASES += [("beam", sign, k) for sign in (0, 1, -1) for k in (0, 3)]
CASES += [("beam", 1e-3, 0), ("beam", -1e-3, 0), ("beam", 1e-9, 0), ("beam", 40, 0), ("beam", 40, 3), ("beam", -8, 1)]


@pytest.mark.parametrize(("kind", "sign", "k"), CASES)
def test_the_springs_of_a_piece_are_its_equation_at_rest(kind, sign, k):
    draw = random.Random(f"{kind}{sign}{k}")
    length, stiff = draw.uniform(0.5, 2), draw.uniform(1, 4)
    tension, foundation = sign * draw.uniform(0.5, 1.5), k * draw.uniform(0.5, 5)
    section = {"bars": "EA", "shafts": "GIo", "beams": "EI", "strings": "preload"}[kind + "s"]
    given = [f"length: {length!r}", f"{section}: {stiff!r}", f"foundation: {foundation!r}"]
    if kind == "beam":
        given.append(f"preload: {tension!r}")
    inertia = "inertia" if kind == "shaft" else "mass"
    found = problem(f"{kind}s: {{part: {{{', '.join(given)}, attached: [{{at: 0, {inertia}: 1}}]}}}}\n")
    scene, elements = found.scene, found.configuration.linear_system
    order = 4 if kind == "beam" else 2
    assert len(scene.q) == order and not elements.pieces
    exact = static_stiffness(order, length, stiff if order == 4 else 0, tension if order == 4 else stiff, foundation)
    K = elements.stiffness_array()
    for i in range(order):
        for j in range(order):
            size = max(abs(float(exact[i][j])), 1e-3 * abs(float(exact[0][0])))
            assert K[i, j] == pytest.approx(float(exact[i][j]), abs=2e-12 * size)


COLUMN = {"L": 1.2, "EI": 2000.0, "g": 9.81, "M": 30.0}


def column(sign, values):
    """A light beam down (-) or up from its clamp, with a mass at its end."""
    given = ", ".join(f"{name}: {values.get(name, '')}" for name in COLUMN)
    return problem(f"""
        gravity: g
        parameters: {{{given}}}
        beams: {{c: {{from: [0, 0], to: [0, {sign}L], EI: EI, left: clamped, attached: [{{at: L, mass: M}}]}}}}
        """)


@pytest.mark.parametrize("sign", "-+")
def test_a_light_beam_under_the_weight_of_a_mass_is_written_with_the_functions_of_textbooks(sign):
    with mpmath.workdps(DIGITS):
        L, EI, g, M = map(mpmath.mpf, COLUMN.values())
        p = mpmath.sqrt(M * g / EI)
        exact = float(mpmath.sqrt(g * p / (p * L - mpmath.tanh(p * L) if sign == "-" else mpmath.tan(p * L) - p * L)))
    valued = column(sign, COLUMN)
    assert float(valued.modal.modes[0].omega) == pytest.approx(exact, rel=4e-15)
    shown = [valued.symbolic.energies["V"], *valued.symbolic.equations.full, *valued.symbolic.equations.linear]
    assert max(abs(node.coefficient) for node in reachable(shown) if node.coefficient) < 100
    K = valued.configuration.linear_system.stiffness_array()
    for found in (valued, column(sign, {})):
        for (i, j), node in found.symbolic.matrices[3].items():
            assert evaluate([node], Floats, COLUMN)[0] == pytest.approx(K[i, j], rel=1e-12)
