"""Conditions in letters: expressions that vanish where they hold, for candidates in closed form.

A frequency of one mode is put into det(K − ω² M) = 0, a limit of stability into det K = 0, the damping ratio of one
degree into C² = 4 ζ² K M. These also hold for another mode, or with another sign: candidates are tried afterwards.
"""

from vibcli.algebra.calculus import substitute
from vibcli.algebra.evaluate import Floats, evaluate
from vibcli.algebra.meaning import quantities_in
from vibcli.algebra.normal import textbook
from vibcli.algebra.quadratic import determinant
from vibcli.algebra.rationals import ONE, ZERO
from vibcli.algebra.roots import root
from vibcli.analyses.elimination import solve_equations
from vibcli.analyses.solving import depends, polynomial, solve_equation
from vibcli.asking import coordinate_name
from vibcli.elements.choose import BALANCE
from vibcli.errors import PhysicsError
from vibcli.inverse.letters_of_responses import equal_heights, response_is, response_of, size_of
from vibcli.inverse.system import summed
from vibcli.measured import centre_node, inertia_node, lowered
from vibcli.mechanics.preload import pivots, solve_linear
from vibcli.mechanics.symbolic import equilibrium_in_letters

LARGEST = 4
SQUARES = {"omega": lambda x, pi: x * x, "frequency": lambda x, pi: 4 * pi * pi * x * x,
           "period": lambda x, pi: 4 * pi * pi / (x * x), "growth_rate": lambda x, pi: -(x * x)}


class NotInLetters(Exception):
    """The condition has no expression in letters."""


def candidates(problem, thorough):
    """The Candidates in letters for all chosen parameters of a problem; None where there are none."""
    scene = problem.scene
    unknowns = [scene.parameters.nodes[name] for name in problem.spec.choices]
    meant = definitions(scene, unknowns)
    nodes = []
    try:
        for record in problem.spec.choices.values():
            found = [substitute([node], meant)[0] for node in _vanishing(problem, record["so"])]
            nodes += [node for node in found if depends(node, unknowns)]
    except (NotInLetters, PhysicsError, ZeroDivisionError):
        return None
    return solve_equations(nodes, unknowns, scene, thorough) if len(nodes) >= len(unknowns) else None


def determined_alone(problem):
    """(chosen name, its Candidates, name of the entry) of a condition in letters that holds one unknown, to which all
    solutions are known; None of none."""
    scene = problem.scene
    unknowns = [scene.parameters.nodes[name] for name in problem.spec.choices]
    meant = definitions(scene, unknowns)
    for entry, record in problem.spec.choices.items():
        try:
            nodes = [] if record["so"].word == BALANCE else _vanishing(problem, record["so"])
        except (NotInLetters, PhysicsError, ZeroDivisionError):
            continue
        for node in substitute(nodes, meant):
            held = [x for x in unknowns if depends(node, (x,))]
            found = solve_equation(node, held[0], scene) if len(held) == 1 else None
            if found is not None and found.complete and not found.always:
                return held[0].name, found, entry
    return None


def definitions(scene, unknowns):
    """{node: expression} of the parameters that are defined by the unknowns, these alone standing in it."""
    found = {}
    for name in scene.parameters.order:
        node = scene.parameters.definitions.get(name)
        if node is not None:
            node, = substitute([node], found)
            if depends(node, unknowns):
                found[scene.parameters.nodes[name]] = node
    return found


def balanced(problem):
    """({name: expression} of the parameters chosen for equilibrium, in which its conditions are linear); None where
    they are not. PhysicsError where the conditions leave one of them open."""
    scene = problem.scene
    names = [name for name, record in problem.spec.choices.items() if record["so"].word == BALANCE]
    unknowns = [scene.parameters.nodes[name] for name in names]
    meant = definitions(scene, unknowns)
    sums = substitute([summed(scene.table, terms) for terms in problem.drawn_residual], meant)
    rows = [_row(node, unknowns) for node in sums if depends(node, unknowns)]
    if not all(rows):
        return None
    numbers = [evaluate(row[:-1], Floats, scene.sample) for row in rows]
    lines, picked = pivots(numbers)
    if len(picked) < len(names):
        free = next(name for j, name in enumerate(names) if j not in picked)
        raise PhysicsError(f"the conditions of equilibrium of the drawn position do not fix '{free}'",
                           f"choose no more than {len(lines)} for equilibrium" if lines else
                           "no force that acts in the drawn position depends on it", problem.spec.choices[free].where)
    found = solve_linear([[rows[i][j] for j in picked] + [-rows[i][-1]] for i in lines], scene.table.zero)
    return {names[j]: textbook(node) for j, node in zip(picked, found, strict=True)}


def _row(node, unknowns):
    """[∂node/∂x of each unknown, the rest] where the node is linear in all of them, else None."""
    row, zero = [], node.table.zero
    for x in unknowns:
        terms = polynomial(node, x) if depends(node, (x,)) else {ZERO: node}
        if terms is None or set(terms) - {ZERO, ONE} or depends(terms.get(ONE, zero), unknowns):
            return None
        row.append(terms.get(ONE, zero))
    return [*row, substitute([node], dict.fromkeys(unknowns, zero))[0]]


def _vanishing(problem, condition):
    """Expressions that vanish where a condition holds."""
    if condition.word == BALANCE:
        return [summed(problem.scene.table, terms) for terms in problem.drawn_residual]
    if "equilibrium" in problem.spec.sections or not problem.linear_in_letters:
        require_no_modes(condition)
    if condition.word:
        return [_limit(problem)]
    for one, other in ((condition.left, condition.right), (condition.right, condition.left)):
        head = one.tree[4] if one.tree[0] == "quantity" else None
        heights = equal_heights(problem, one.tree, other.tree)
        if heights is not None:
            return [heights]
        response = response_of(problem, one.tree)
        if response is not None:
            return response_is(problem, response, _side(problem, other))
        if head in SQUARES:
            value = _side(problem, other)
            return [_characteristic(problem, SQUARES[head](value, problem.scene.table.pi))]
        if head == "zeta":
            value, (m, c, k) = _side(problem, other), _one_degree(problem)
            return [c * c - 4 * value * value * k * m]
        if head == "decay":     # over-damped: that of the slower eigenvalue
            value, (m, c, k) = _side(problem, other), _one_degree(problem)
            return [(c - 2 * m * value) * (m * value * value - c * value + k)]
    return [_side(problem, condition.left) - _side(problem, condition.right)]


def _limit(problem):
    """det K, and of two degrees under follower forces also the discriminant of det(K − λM), which vanishes where
    flutter begins."""
    M, C, _, K = problem.matrices_in_letters
    still = _characteristic(problem, problem.scene.table.zero)
    follows = any(K.get(pair[::-1]) is not node for pair, node in K.items())
    if not follows and not any(term.weight.mask for term in problem.scene.forces):
        return still
    if C or len(problem.scene.q) != 2:
        raise NotInLetters
    zero = problem.scene.table.zero
    (a, b), (c, d) = ([[matrix.get((i, j), zero) for matrix in (M, K)] for i in (0, 1)] for j in (0, 1))
    mixed = a[0] * d[1] + a[1] * d[0] - b[0] * c[1] - b[1] * c[0]
    return still * textbook(mixed * mixed - 4 * (a[0] * d[0] - b[0] * c[0]) * still)


def require_no_modes(condition):
    """Without the matrices in letters only what is read off the drawing is known."""
    if condition.word or any(tree[4] not in ("J", "centre") for side in condition.sides
                             for tree in quantities_in(side.tree)):
        raise NotInLetters


def _characteristic(problem, square):
    """det(K − λ M) in letters."""
    M, _, G, K = problem.matrices_in_letters
    n, zero = len(problem.scene.q), problem.scene.table.zero
    if n > LARGEST or G:
        raise NotInLetters
    return determinant([[K.get((i, j), zero) - square * M.get((i, j), zero) for j in range(n)] for i in range(n)])


def _one_degree(problem):
    """M, C, K of a scene with one coordinate."""
    if len(problem.scene.q) != 1:
        raise NotInLetters
    M, C, _, K = problem.matrices_in_letters
    zero = problem.scene.table.zero
    return [matrix.get((0, 0), zero) for matrix in (M, C, K)]


def _side(problem, expression):
    scene = problem.scene
    found = {tree[3]: _quantity(problem, tree) for tree in quantities_in(expression.tree)}
    return lowered(expression, scene.table, lambda name, primes, tree: found[name] if tree[0] == "quantity"
                   else scene.parameters.nodes[name])


def _quantity(problem, tree):
    """A quantity as an expression of the parameters."""
    head, indices, attribute = tree[4], tree[5], tree[6]
    scene = problem.scene
    response = response_of(problem, tree)
    if response is not None:
        return size_of(problem, response)
    if head == "J":
        return inertia_node(scene, indices)
    if head == "centre":
        return centre_node(scene, indices, attribute)
    if head == "equilibrium":
        return equilibrium_in_letters(problem)[coordinate_name(problem.spec, indices[0])]
    if head in ("M", "C", "G", "K"):
        matrix = dict(zip("MCGK", problem.matrices_in_letters, strict=True))[head]
        i, j = (scene.coordinates.index(coordinate_name(problem.spec, index)) for index in indices)
        return matrix.get((i, j), scene.table.zero)
    if indices != ("1",):
        raise NotInLetters
    return _of_one_mode(problem, head)


def _of_one_mode(problem, head):
    """Frequencies and damping of a scene with one coordinate."""
    m, c, k = _one_degree(problem)
    omega, table = root(textbook(k / m), [problem.scene.sample]), problem.scene.table
    forms = {"omega": lambda: omega, "frequency": lambda: omega / (2 * table.pi),
             "period": lambda: 2 * table.pi / omega, "zeta": lambda: c / (2 * m * omega),
             "omega_d": lambda: table.sqrt(textbook(k / m - c * c / (4 * m * m)))}
    if head not in forms:
        raise NotInLetters
    return forms[head]()
