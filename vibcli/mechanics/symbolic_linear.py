"""Inputs and outputs of the small oscillations in letters."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.errors import NotInLetters
from vibcli.language.signal_names import signal_name
from vibcli.mechanics.inputs_outputs.displacements import displacement
from vibcli.mechanics.inputs_outputs.inputs import in_powers, named_input
from vibcli.mechanics.linearisation import at_position
from vibcli.mechanics.linearise import without_time
from vibcli.mechanics.support_forces import PARTS, along_the_axis
from vibcli.mechanics.symbolic_matrices import matrices_in_letters
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.rationals import ONE
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import NameRef
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.inputs_outputs.base_excitation import SystemWithInputs
    from vibcli.mechanics.inputs_outputs.inputs import Input
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import Product, Sum, SyntaxTree

    Tree = NameRef | Sum | Product
    Part = dict[int, float | Node]


def coefficients(symbolic: "SymbolicSystem", signal: str,
                 driven_by: str) -> "tuple[list[Part], list[dict[int, Node]], list[Part]]":
    """b, c, d as [{i: node}] of the powers of s, nodes of the opened scene; d has the one entry 0."""
    opened, place = symbolic.configuration.with_inputs, place_in_letters(symbolic)
    chosen = named_input(symbolic.configuration, driven_by)
    if chosen.carried or any(isinstance(weight, complex) for weight in chosen.weights.values()):
        raise NotInLetters(f"what turns as '{driven_by}' does has no amplitudes in letters here",
                           "ask for them in numbers")
    if "per_length" in (symbolic.spec.get("forces") or {}).get(driven_by, ()):
        raise NotInLetters(f"responses to a load along a member, as to '{driven_by}', are found in numbers",
                           "give numbers with --set")
    scene, n = opened.scene, opened.n
    M, C, G, K = matrices_in_letters(at_position(opened.form, place))
    columns = {j: [{}, {}, {}] for j in chosen.weights}
    for power, matrices in enumerate(((K,), (C, G), (M,))):
        for matrix in matrices:
            for (i, j), node in matrix.items():
                if i < n and j in columns:
                    columns[j][power][i] = columns[j][power].get(i, scene.table.zero) - node
    q, v, a = _slopes(symbolic.configuration, signal, place)
    weights = _exact(symbolic.configuration, chosen)
    b = in_powers(columns, weights, chosen.turns)
    direct = {j: [{0: part[j]} if j in part else {} for part in (q, v, a)] for j in columns}
    return b, [{i: node for i, node in part.items() if i < n} for part in (q, v, a)], in_powers(direct, weights,
                                                                                              chosen.turns)


def outputs(symbolic: "SymbolicSystem", signal: "str | Tree") -> "tuple[list[dict[int, Node]], Node]":
    """(c, direct): [{i: node}] of the powers of s for a signal, or of the tree of a sum of signals, and what driven
    displacements u(t) do to it at once, a function of the time in the scene."""
    if isinstance(signal, str):
        return _outputs_of(symbolic, signal)
    rows, direct = [{}, {}, {}], symbolic.scene.table.zero
    for name, factor in _summed(symbolic, signal).items():
        parts, at_once = _outputs_of(symbolic, name)
        weight, = copied([factor], symbolic.configuration.with_inputs.scene.table)
        for found, part in zip(rows, parts, strict=True):
            for i, node in part.items():
                found[i] = textbook(found.get(i, node.table.zero) + weight * node)
        direct = direct + factor * at_once
    return rows, direct


def _summed(symbolic: "SymbolicSystem", tree: "SyntaxTree") -> "dict[str, Node]":
    """{name of a signal: its factor}, nodes of the scene; NotInLetters of what is no sum of signals."""
    table, known = symbolic.scene.table, symbolic.scene.parameters.nodes
    names: dict[str, Node] = {}

    def symbol(name: str, primes: int, part: "SyntaxTree") -> "Node":
        if name in known and not primes:
            return known[name]
        if not isinstance(part, NameRef):
            raise NotInLetters("parts of signals are found in numbers", "give numbers with --set")
        return names.setdefault(name + "'" * primes, table.variable(f"signal {name}" + "'" * primes))

    node = lower(tree, table, symbol)
    factors = {name: gradient(node).get(one, table.zero) for name, one in names.items()}
    if not is_zero(node - table.sum(*((factors[name] * one, ONE) for name, one in names.items()))):
        raise NotInLetters("of signals sums alone are found in letters, each with a factor that is fixed",
                           "give numbers with --set")
    return factors


def _outputs_of(symbolic: "SymbolicSystem", signal: str) -> "tuple[list[dict[int, Node]], Node]":
    opened, table = symbolic.configuration.with_inputs, symbolic.scene.table
    place = place_in_letters(symbolic)
    rows, direct = _slopes(symbolic.configuration, signal, place), _in_time(symbolic, signal, place)
    for j, opening in enumerate(opened.scene.inputs.values(), opened.n):
        moved = opening.node
        for part in rows if moved is not None else ():
            if j in part:
                direct = direct + copied([part[j] * moved], table)[0]
            moved = opened.scene.rate(moved)
    return [{i: node for i, node in part.items() if i < opened.n} for part in rows], direct


def _in_time(symbolic: "SymbolicSystem", signal: str, place: "Mapping[Node, Node]") -> "Node":
    """What of a signal depends on the time in equilibrium: places that are driven without being small."""
    opened, name = symbolic.configuration.with_inputs, signal_name(signal)
    still = {symbol: node for symbol, node in place.items() if symbol is not opened.scene.time}
    at, = substitute([_node(opened, name.still.text)], still)
    if not at.mask & opened.scene.time.mask:
        return symbolic.scene.table.zero
    at = at - without_time(opened.scene, at)
    for _ in range(name.primes):
        at = opened.scene.rate(at)
    return copied([at], symbolic.scene.table)[0]


def place_in_letters(symbolic: "SymbolicSystem") -> "dict[Node, Node]":
    """{symbol: node} of the equilibrium in letters."""
    scene = symbolic.configuration.with_inputs.scene
    rest = dict.fromkeys((*scene.v, *scene.a), scene.table.zero)
    if symbolic.balanced_as_drawn or symbolic.system.is_linear:
        return {**rest, **scene.drawn_position}
    if symbolic.equilibrium is None:
        raise NotInLetters("the equilibrium of this scene is not found in letters", "give numbers with --set")
    settled = symbolic.equilibrium.values
    nodes = dict(zip((q.name for q in settled), copied(list(settled.values()), scene.table), strict=True))
    return {**rest, **scene.drawn_position, **{q: nodes[q.name] for q in scene.q if q.name in nodes}}


def _slopes(configuration: "Configuration", signal: str, place: "dict[Node, Node]") -> "list[dict[int, Node]]":
    """∂y/∂q, ∂y/∂q̇, ∂y/∂q̈ as {i: node}."""
    scene, name = configuration.with_inputs.scene, signal_name(signal)
    node = _node(configuration.with_inputs, name.still.text)
    if node is None:
        raise NotInLetters(f"the amplitude of '{signal}' is not found in letters", "ask for it in numbers")
    slopes = gradient(node)
    rows = [{i: textbook(x) for i, q in enumerate(kind) if q in slopes
             for x in substitute([slopes[q]], place) if not x.is_zero} for kind in (scene.q, scene.v, scene.a)]
    primes = name.primes
    if any(rows[3 - primes:]):
        raise NotInLetters(f"the amplitude of '{signal}' is not found in letters", "ask for it in numbers")
    return [{}] * primes + rows[:3 - primes]


def _node(opened: "SystemWithInputs", text: str) -> "Node":
    """A signal as a function of the coordinates and velocities of the opened scene; None where it is not known."""
    name, part, *_ = signal_name(text)
    found = displacement(opened.scene, text)
    if found is None and part == "force" and name != "ground":
        return _force(opened, name)
    return _on_the_ground(opened, part) if found is None and name == "ground" and part in PARTS else found


def _force(opened: "SystemWithInputs", name: str) -> "Node | None":
    """The force of a spring or a linear damper; None of another element."""
    known = name in (opened.configuration.spec.get("springs") or {}) or opened.scene.terms_of(name, "dampers")
    return opened.scene.force_of(name) if known else None


def _on_the_ground(opened: "SystemWithInputs", kind: str) -> "Node | None":
    """Σ of what springs and dampers exert on the ground of a scene with one axis; None of other scenes."""
    total = opened.scene.table.zero
    for record in opened.configuration.spec.connections:
        sign = along_the_axis(opened, record, kind) if "between" in record else None
        force = _force(opened, record.name) if sign else opened.scene.table.zero
        if sign is None or force is None:
            return None
        total = total + sign * force
    return total


def _exact(configuration: "Configuration", chosen: "Input") -> "dict[int, Node]":
    """The shares of the input coordinates as nodes: a line along an axis."""
    if any(weight not in (-1.0, 0.0, 1.0) for weight in chosen.weights.values()):
        raise NotInLetters("the line of this input is along no axis", "name its component, as in drive.x")
    return {j: configuration.with_inputs.scene.table.number(int(weight)) for j, weight in chosen.weights.items()}
