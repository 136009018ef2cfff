"""Conditions in letters: expressions that vanish where they hold, for candidates in closed form.

A frequency of one mode is put into det(K − ω² M) = 0, a limit of stability into det K = 0, the damping ratio of one
degree into C² = 4 ζ² K M. These also hold for another mode, or with another sign: candidates are tried afterwards.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.inverse.conditions import summed
from vibcli.inverse.symbolic_quantity_conditions import equal_heights, response_is, side
from vibcli.mechanics.static_preload import pivots, solve_linear
from vibcli.quantities.in_letters import response_of
from vibcli.quantities.modal import one_degree
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.equations.elimination import solve_equations
from vibcli.symbolic.equations.univariate import Candidates, depends, polynomial, solve_equation
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import called_functions
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.quadratic_roots import determinant
from vibcli.symbolic.rationals import ONE, ZERO
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.reader.sections.choose import Condition
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

LARGEST = 4
SQUARES = {"omega": lambda x, pi: x * x, "frequency": lambda x, pi: 4 * pi * pi * x * x,
           "period": lambda x, pi: 4 * pi * pi / (x * x), "growth_rate": lambda x, pi: -(x * x)}


def candidates(problem: "Problem", thorough: bool) -> Candidates | None:
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


def independent(problem: "Problem") -> bool:
    """Do letters prove that the conditions do not depend on what is chosen? Only of one degree of freedom: of several,
    what is a property of one mode may become that of another."""
    scene = problem.scene
    if len(scene.q) != 1:
        return False
    unknowns = [scene.parameters.nodes[name] for name in problem.spec.choices]
    meant = definitions(scene, unknowns)
    try:
        nodes = [node for record in problem.spec.choices.values() for node in _vanishing(problem, record["so"])]
    except (NotInLetters, PhysicsError, ZeroDivisionError):
        return False
    return not any(depends(node, unknowns) for node in substitute(nodes, meant))


def determined_alone(problem: "Problem") -> tuple[str, Candidates, str]:
    """(chosen name, its Candidates, name of the entry) of a condition in letters that holds one unknown, to which all
    solutions are known; None of none."""
    scene = problem.scene
    unknowns = [scene.parameters.nodes[name] for name in problem.spec.choices]
    meant = definitions(scene, unknowns)
    for entry, record in problem.spec.choices.items():
        try:
            nodes = [] if record["so"].is_balance else _vanishing(problem, record["so"])
        except (NotInLetters, PhysicsError, ZeroDivisionError):
            continue
        for node in substitute(nodes, meant):
            held = [x for x in unknowns if depends(node, (x,))]
            found = solve_equation(node, held[0], scene) if len(held) == 1 else None
            if found is not None and found.complete and not found.always:
                return held[0].name, found, entry
    return None


def definitions(scene: "Scene", unknowns: "Sequence[Node]") -> "dict[Node, Node]":
    """{node: expression} of the parameters that are defined by the unknowns, these alone standing in it."""
    found = {}
    for name in scene.parameters.order:
        node = scene.parameters.definitions.get(name)
        if node is not None:
            node, = substitute([node], found)
            if depends(node, unknowns):
                found[scene.parameters.nodes[name]] = node
    return found


def balanced(problem: "Problem") -> "dict[str, Node] | None":
    """({name: expression} of the parameters chosen for equilibrium, in which its conditions are linear); None where
    they are not. PhysicsError where the conditions leave one of them open."""
    scene = problem.scene
    names = [name for name, record in problem.spec.choices.items() if record["so"].is_balance]
    unknowns = [scene.parameters.nodes[name] for name in names]
    meant = definitions(scene, unknowns)
    sums = substitute([summed(scene.table, terms) for terms in problem.system.drawn_residual], meant)
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
    if called_functions(found):
        return None
    return {names[j]: textbook(node) for j, node in zip(picked, found, strict=True)}


def _row(node: "Node", unknowns: "Sequence[Node]") -> "list[Node]":
    """[∂node/∂x of each unknown, the rest] where the node is linear in all of them, else None."""
    row, zero = [], node.table.zero
    for x in unknowns:
        terms = polynomial(node, x) if depends(node, (x,)) else {ZERO: node}
        if terms is None or set(terms) - {ZERO, ONE} or depends(terms.get(ONE, zero), unknowns):
            return None
        row.append(terms.get(ONE, zero))
    return [*row, substitute([node], dict.fromkeys(unknowns, zero))[0]]


def _vanishing(problem: "Problem", condition: "Condition") -> "list[Node]":
    """Expressions that vanish where a condition holds."""
    if condition.is_balance:
        return [summed(problem.scene.table, terms) for terms in problem.system.drawn_residual]
    if "equilibrium" in problem.spec.sections or not problem.symbolic.linearisable:
        require_no_modes(condition)
    if condition.word:
        return [_limit(problem)]
    for one, other in ((condition.left, condition.right), (condition.right, condition.left)):
        tree = one.tree     # of a mode about the only equilibrium: omega[1], neither omega[1, 2] nor period(x)
        head = tree.head if isinstance(tree, QuantityRef) and len(tree.indices) == 1 and not tree.args else None
        heights = equal_heights(problem, tree, other.tree)
        if heights is not None:
            return [heights]
        response = response_of(problem, tree)
        if response is not None:
            return response_is(problem, response, side(problem, other))
        if head in SQUARES:
            value = side(problem, other)
            return [_characteristic(problem, SQUARES[head](value, problem.scene.table.pi))]
        if head == "zeta":
            value, (m, c, k) = side(problem, other), one_degree(problem)
            if m.is_zero:
                raise NotInLetters("without inertia there is no damping ratio")
            return [c * c - 4 * value * value * k * m]
        if head == "decay":
            value, (m, c, k) = side(problem, other), one_degree(problem)
            return [k - c * value if m.is_zero else c - 2 * m * value]
    return [side(problem, condition.left) - side(problem, condition.right)]


def _limit(problem: "Problem") -> "Node":
    """det K, and of two degrees under follower forces also the discriminant of det(K − λM), which vanishes where
    flutter begins."""
    M, C, _, K = problem.symbolic.matrices
    still = _characteristic(problem, problem.scene.table.zero)
    follows = any(K.get(pair[::-1]) is not node for pair, node in K.items())
    if not follows and not any(term.weight.mask for term in problem.scene.forces):
        return still
    if C or len(problem.scene.q) != 2:
        raise NotInLetters("where flutter begins is found in letters for two degrees without damping")
    zero = problem.scene.table.zero
    (a, b), (c, d) = ([[matrix.get((i, j), zero) for matrix in (M, K)] for i in (0, 1)] for j in (0, 1))
    mixed = a[0] * d[1] + a[1] * d[0] - b[0] * c[1] - b[1] * c[0]
    return still * textbook(mixed * mixed - 4 * (a[0] * d[0] - b[0] * c[0]) * still)


def require_no_modes(condition: "Condition") -> None:
    """Without the matrices in letters only what is read off the drawing is known."""
    if condition.word or any(tree.head not in ("J", "centre") for side in condition.sides
                             for tree in side.parts.quantities):
        raise NotInLetters("the small oscillations of this scene are not known in letters")


def _characteristic(problem: "Problem", square: "Node") -> "Node":
    """det(K − λ M) in letters."""
    M, _, G, K = problem.symbolic.matrices
    n, zero = len(problem.scene.q), problem.scene.table.zero
    if n > LARGEST or G:
        raise NotInLetters(f"frequencies are chosen in letters for {LARGEST} degrees that no gyroscopic terms couple")
    return determinant([[K.get((i, j), zero) - square * M.get((i, j), zero) for j in range(n)] for i in range(n)])
