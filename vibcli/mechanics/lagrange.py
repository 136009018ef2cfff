"""Lagrange's equations of the second kind in letters: d/dt ∂T/∂q̇ − ∂T/∂q + ∂Φ/∂q̇ + ∂V/∂q − Q = 0.

The small oscillations are those about the equilibrium, M q̈ + (C + G) q̇ + K q = 0, q being the deviation from it:
in letters where the equilibrium is the drawn position or plays no part, else with numbers for its place.
"""

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.energies import dissipation, generalised_force, kinetic, potential, rate
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.normal_form import TooLong, expanded, factors_of, reduced, textbook
from vibcli.symbolic.rationals import HALF, ONE

LETTERS = 16        # most coordinates for which equations are written in letters


class EquationsOfMotion:
    """full: left sides of the equations of motion, `names` their coordinates; `multipliers` {symbol: the constraint's
    name} and `conditions`, the left sides of the constraints, where loops are closed; M, C, G, K: matrices
    {(i, j): expression or float} of the small oscillations, their entries in letters or in numbers (`in_letters`);
    linear: left sides of their equations, drive: {i: Q(t)} of their right sides, left_out: {i: products
    that their left sides lack}; refusal: the PhysicsError of a scene that has no equilibrium, or None."""

    __slots__ = ("C", "G", "K", "M", "conditions", "drive", "full", "in_letters", "left_out", "linear", "multipliers",
                 "names", "refusal")


def equation_of(scene, i, T=None, V=None, Phi=None):
    """The left side of the equation of motion of coordinate i, as it comes from the energies."""
    T, V, Phi = T or kinetic(scene), V or potential(scene), Phi or dissipation(scene)
    q, v, zero = scene.q[i], scene.v[i], scene.table.zero
    momentum = rate(scene, gradient(T).get(v, zero))
    left = momentum - gradient(T).get(q, zero) + gradient(V).get(q, zero) + gradient(Phi).get(v, zero)
    return left + gyroscopic(scene, i) - generalised_force(scene, i)


def gyroscopic(scene, i):
    """Σ Gᵢⱼ q̇ⱼ of the skew part of a C that is given outright, which no dissipation function has."""
    if "C" not in scene.matrices:
        return scene.table.zero
    C = scene.matrices["C"]
    return scene.table.sum(*(((C[i][j] - C[j][i]) * v, HALF) for j, v in enumerate(scene.v[:len(C)]) if i < len(C)))


def full_equations(scene):
    """The left side of each equation of motion, simplified."""
    T, V, Phi = textbook(kinetic(scene)), potential(scene), dissipation(scene)
    return [textbook(equation_of(scene, i, T, V, Phi)) for i in range(len(scene.q))]


def _with_multipliers(scene, found):
    """Lagrange's equations of the first kind, … + Σ λ ∂G/∂q = 0, and the conditions G = 0 of a loose scene."""
    nodes = [textbook(constraint.node) for constraint in scene.constraints]
    found.conditions = [_primitive(node) for node in nodes]
    symbols = [scene.table.variable("lambda_" + constraint.name.replace(".", "_")) for constraint in scene.constraints]
    found.multipliers = {symbol: constraint.name for symbol, constraint in zip(symbols, scene.constraints, strict=True)}
    slopes = [gradient(node) for node in nodes]
    for i, q in enumerate(scene.q):
        ties = [(textbook(slope[q]) * symbol, ONE) for symbol, slope in zip(symbols, slopes, strict=True) if q in slope]
        found.full[i] = scene.table.sum((found.full[i], ONE), *ties)


def _primitive(node):
    """A condition without its common factor."""
    try:
        return factors_of(node.table, reduced(expanded(node)))[1][0]
    except (TooLong, IndexError):
        return node


def equations(symbolic):
    """The Equations of a problem; without an equilibrium only the full ones, and the refusal of the others."""
    found = EquationsOfMotion()
    scene, loose = symbolic.scene, symbolic.system.loose
    found.names, found.multipliers, found.conditions, found.drive = list(loose.coordinates), {}, [], {}
    found.left_out = {}
    found.full = full_equations(loose) if len(loose.q) <= LETTERS else []
    if loose is not scene and found.full:
        _with_multipliers(loose, found)
    found.M, found.C, found.G, found.K = [{}] * 4
    found.in_letters, found.linear, found.refusal = False, [], None
    try:
        _require_slope(symbolic.configuration)
        if scene.timed:
            found.drive = symbolic.excitation
            found.left_out = symbolic.left_out
        found.in_letters = len(scene.q) <= LETTERS and symbolic.linearisable
        if found.in_letters:
            found.M, found.C, found.G, found.K = symbolic.matrices
            found.linear = [_left_side(scene, found, i) for i in range(len(scene.q))]
        elif not symbolic.numeric.has_free_symbols:
            found.M, found.C, found.G, found.K = symbolic.configuration.linear_system.matrices()
    except PhysicsError as error:
        found.in_letters, found.refusal = False, error
    return found


def _require_slope(configuration):
    """Kinked where the forces have none at rest."""
    from vibcli.mechanics.nonsmooth import require_smooth, require_unheld

    require_unheld(configuration.system)
    if not configuration.numeric.has_free_symbols:
        require_smooth(configuration)


def _left_side(scene, found, i):
    terms = []
    for matrices, symbols in (((found.M,), scene.a), ((found.C, found.G), scene.v), ((found.K,), scene.q)):
        for j, symbol in enumerate(symbols):
            terms += [(matrix[i, j] * symbol, ONE) for matrix in matrices if (i, j) in matrix]
    return scene.table.sum(*terms)
