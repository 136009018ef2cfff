"""Quantities in letters, as sides of conditions: omega[1] of one degree, K[x, x], equilibrium[s.stretch], J[disc]."""

from vibcli.base.errors import NotInLetters
from vibcli.inverse.symbolic_response_conditions import response_of, size_of
from vibcli.language.signals import coordinate_name
from vibcli.mechanics.inputs_outputs.displacements import displacement
from vibcli.mechanics.symbolic_equilibrium_linear import equilibrium_in_letters
from vibcli.quantities.expression import lowered
from vibcli.quantities.matrices import centre_node, inertia_node
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.radicals import root
from vibcli.symbolic.semantics import quantities_in
from vibcli.symbolic.syntax import QuantityRef


def side(problem, expression):
    """A side of a condition as an expression of the parameters."""
    scene = problem.scene
    found = {tree.text: quantity_in_letters(problem, tree) for tree in quantities_in(expression.tree)}
    return lowered(expression, scene.table, lambda name, primes, tree: found[name] if isinstance(tree, QuantityRef)
                   else scene.parameters.nodes[name])


def one_degree(problem):
    """M, C, K of a scene with one coordinate."""
    if len(problem.scene.q) != 1:
        raise NotInLetters("this is found in letters for one degree of freedom")
    M, C, _, K = problem.symbolic.matrices
    zero = problem.scene.table.zero
    return [matrix.get((0, 0), zero) for matrix in (M, C, K)]


def quantity_in_letters(problem, tree):
    """A quantity as an expression of the parameters; NotInLetters where it is found in numbers."""
    head, indices, attribute = tree.head, tree.indices, tree.component
    scene = problem.scene
    response = response_of(problem, tree)
    if response is not None:
        return size_of(problem, response)
    if head == "J":
        return inertia_node(scene, indices)
    if head == "centre":
        return centre_node(scene, indices, attribute)
    if head == "equilibrium" and len(indices) == 1:
        return _at_rest(problem, indices[0])
    if head in ("M", "C", "G", "K") and not tree.args:
        matrix = dict(zip("MCGK", problem.symbolic.matrices, strict=True))[head]
        names = [coordinate_name(problem.spec, index) for index in indices]
        if set(names) <= set(scene.coordinates):
            return matrix.get(tuple(map(scene.coordinates.index, names)), scene.table.zero)
    if indices != ("1",) or tree.args:
        raise NotInLetters(f"'{tree.text}' is found in numbers")
    return _of_one_mode(problem, head)


def _at_rest(problem, text):
    """A coordinate, place, turn, stretch or tension in equilibrium."""
    scene, text = problem.scene, coordinate_name(problem.spec, text) or text
    name, _, part = text.partition(".")
    node = displacement(scene, text)
    if node is None and part == "force" and name in (problem.spec.get("springs") or {}):
        node = scene.force_of(name)
    if node is None:
        raise NotInLetters(f"'{text}' in equilibrium is found in numbers")
    values, zero = equilibrium_in_letters(problem.symbolic), scene.table.zero
    rest = dict.fromkeys((*scene.v, scene.time), zero) | {q: values[q.name] for q in scene.q}
    found, = substitute([node], rest)
    if found.mask:
        raise NotInLetters(f"'{text}' in equilibrium is found in numbers")
    return textbook(found)


def _of_one_mode(problem, head):
    """Frequencies and damping of a scene with one coordinate."""
    m, c, k = one_degree(problem)
    omega, table = root(textbook(k / m), [problem.scene.sample]), problem.scene.table
    forms = {"omega": lambda: omega, "frequency": lambda: omega / (2 * table.pi),
             "period": lambda: 2 * table.pi / omega, "zeta": lambda: c / (2 * m * omega),
             "omega_d": lambda: table.sqrt(textbook(k / m - c * c / (4 * m * m)))}
    if head not in forms:
        raise NotInLetters(f"'{head}' is found in numbers")
    return forms[head]()
