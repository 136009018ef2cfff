"""Inputs and outputs of the small oscillations in letters."""

from vibcli.algebra.calculus import gradient, substitute
from vibcli.algebra.copied import copied
from vibcli.algebra.normal import textbook
from vibcli.errors import NotInLetters
from vibcli.mechanics.inputs import in_powers, named_input
from vibcli.mechanics.lagrange import matrices_in_letters
from vibcli.mechanics.linearisation import at_position
from vibcli.mechanics.outputs import tension
from vibcli.mechanics.signals import displacement


def coefficients(problem, signal, driven_by):
    """b, c, d as [{i: node}] of the powers of s, nodes of the opened scene; d has the one entry 0."""
    opened, place = problem.opened, _place(problem)
    chosen = named_input(problem, driven_by)
    if any(isinstance(weight, complex) for weight in chosen.weights.values()):
        raise NotInLetters(f"what turns as '{driven_by}' does has no amplitudes in letters here",
                           "ask for them in numbers")
    scene, n = opened.scene, opened.n
    M, C, G, K = matrices_in_letters(at_position(opened.form, place))
    columns = {j: [{}, {}, {}] for j in chosen.weights}
    for power, matrices in enumerate(((K,), (C, G), (M,))):
        for matrix in matrices:
            for (i, j), node in matrix.items():
                if i < n and j in columns:
                    columns[j][power][i] = columns[j][power].get(i, scene.table.zero) - node
    q, v, a = _slopes(problem, signal, place)
    weights = _exact(problem, chosen)
    b = in_powers(columns, weights, chosen.turns)
    direct = {j: [{0: part[j]} if j in part else {} for part in (q, v, a)] for j in columns}
    return b, [{i: node for i, node in part.items() if i < n} for part in (q, v, a)], in_powers(direct, weights,
                                                                                              chosen.turns)


def _place(problem):
    """{symbol: node} of the equilibrium in letters."""
    scene = problem.opened.scene
    rest = dict.fromkeys((*scene.v, *scene.a), scene.table.zero)
    if problem.balanced_as_drawn or problem.is_linear:
        return {**rest, **scene.drawn_position}
    if problem.equilibrium_letters is None:
        raise NotInLetters("the equilibrium of this scene is not found in letters", "give numbers with --set")
    settled = problem.equilibrium_letters.values
    nodes = dict(zip((q.name for q in settled), copied(list(settled.values()), scene.table), strict=True))
    return {**rest, **scene.drawn_position, **{q: nodes[q.name] for q in scene.q if q.name in nodes}}


def _slopes(problem, signal, place):
    """∂y/∂q, ∂y/∂q̇, ∂y/∂q̈ as {i: node}."""
    scene, bare = problem.opened.scene, signal.rstrip("'")
    node = displacement(scene, bare)
    if node is None and bare.partition(".")[0] in (problem.spec.get("springs") or {}) and bare.endswith(".force"):
        node = tension(scene, bare.partition(".")[0])
    if node is None:
        raise NotInLetters(f"the amplitude of '{signal}' is not found in letters", "ask for it in numbers")
    slopes = gradient(node)
    row = {i: textbook(x) for i, q in enumerate(scene.q) if q in slopes
           for x in substitute([slopes[q]], place) if not x.is_zero}
    return [row if power == len(signal) - len(bare) else {} for power in range(3)]


def _exact(problem, chosen):
    """The shares of the input coordinates as nodes: a line along an axis."""
    if any(weight not in (-1.0, 0.0, 1.0) for weight in chosen.weights.values()):
        raise NotInLetters("the line of this input is along no axis", "name its component, as in drive.x")
    return {j: problem.opened.scene.table.number(int(weight)) for j, weight in chosen.weights.items()}
