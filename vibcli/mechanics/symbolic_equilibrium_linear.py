"""Equilibrium in letters: does a condition vanish, and where is the equilibrium of a linear scene?"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from vibcli.base.errors import NoEquilibrium, NotInLetters
from vibcli.language.parameter_samples import sample_values
from vibcli.mechanics.autonomous import steady
from vibcli.mechanics.equilibrium.no_equilibrium import ALONE
from vibcli.mechanics.linearisation import at_position, residual_terms
from vibcli.mechanics.linearise import linearise
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.mechanics.static_preload import solve_linear
from vibcli.mechanics.symbolic_matrices import stiffness_at_rest
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from vibcli.mechanics.linearisation import Linearisation
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SAMPLES = range(20, 28)     # attempts to draw a scene with other sample values


def vanishes(scene: "Scene", terms: "Sequence[Node]") -> bool:
    """Is the sum of these expressions zero: by expansion, or at several unrelated sets of values?"""
    total = scene.table.total(terms)
    if is_zero(total):
        return True
    for attempt in range(3):
        values = scene.parameters.values(Floats, sample_values(scene.parameters.free, attempt + 50))
        numbers = evaluate(terms, Floats, values)
        if not abs(sum(numbers)) <= 1e-13 * sum(map(abs, numbers)):
            return False
    return True


def equilibrium_in_letters(symbolic: "SymbolicSystem") -> "dict[str, Node]":
    """{coordinate: expression} of the equilibrium: drawn, or that of linear equations; else PhysicsError."""
    scene, start = symbolic.scene, symbolic.start
    if symbolic.balanced_as_drawn and start is None:
        return scene.drawn_coordinates
    if symbolic.equilibrium is not None:
        settled = symbolic.equilibrium.values
        return {q.name: settled[q] for q in scene.q}
    if not symbolic.system.is_linear:
        raise NotInLetters("the drawn position is not an equilibrium, and the equilibrium of this nonlinear scene is "
                           "not found in letters",
                           "draw it in equilibrium (`preload: static` helps), or give numbers with --set")
    form = symbolic.system.linearisation
    graded = next((piece.owner for piece in form.pieces if piece.piece.order == 4 and not piece.piece.gradient.is_zero),
                  None)
    if graded is not None:
        raise NotInLetters(f"how '{graded}' bends under a tension that varies along it is not found in letters",
                           "give numbers with --set")
    K = stiffness_at_rest(form)
    n, zero = len(scene.q), scene.table.zero
    residual = symbolic.system.drawn_residual if start is None else residual_terms(
        at_position(symbolic.system.linearisation, {**scene.drawn_position, **start}))
    load = [textbook(scene.table.total(terms)) for terms in residual]
    held = [i for i in range(n) if any((i, j) in K for j in range(n))]
    for i in range(n):
        if i not in held and not load[i].is_zero:
            name = scene.coordinates[i]
            hint = "add the spring that carries the load" + ALONE
            raise NoEquilibrium(f"no equilibrium: nothing holds '{name}'", hint, scene.spec.origin(name).where)
    rows = [[K.get((i, j), zero) for j in held] + [-load[i]] for i in held]
    try:
        shift = dict(zip(held, solve_linear(rows, zero), strict=True))
    except ZeroDivisionError:
        raise NotInLetters("the equilibrium of this scene is not unique in letters",
                           "give numbers with --set") from None
    if n == 1:
        from vibcli.symbolic.common_denominator import single as simplest
    else:
        from vibcli.symbolic.rational_functions import factored as simplest
    place = list(scene.drawn_coordinates.values()) if start is None else [start[q] for q in scene.q]
    return {name: simplest(place[i] + shift[i]) if i in shift else place[i] for i, name in enumerate(scene.coordinates)}


def drawn_stable(scene: "Scene") -> "Scene":
    """The scene drawn with sample values for which it is stable, where there are such: signs are read off there."""
    for start in SAMPLES:
        if not _falls_as_drawn(scene):
            break
        scene = scene.drawn_anew(start)
    return scene


def _falls_as_drawn(scene: "Scene") -> bool:
    """Has K a negative diagonal entry in the drawn position, at the sample values of the symbols?"""
    values = {**dict.fromkeys((node.name for node, _ in scene.static_preloads), 0.0), **scene.sample}
    try:
        form = _alone(steady(scene.vibrating, linearise(scene.vibrating)))
        numbers = in_numbers(at_position(form, scene.vibrating.drawn_position), Floats, values)
    except ZeroDivisionError:  # said where the drawn position is asked for
        return False
    return any(value < 0 for (i, j), value in numbers.elements.stiffness().items() if i == j)


def _alone(form: "Linearisation") -> "Linearisation":
    """What of a Linearisation the diagonal of K is made of."""
    def diagonal(entries: "Mapping[tuple[int, int], Node]") -> "dict[tuple[int, int], Node]":
        return {pair: node for pair, node in entries.items() if pair[0] == pair[1]}

    curved = [(force, entries, {}) for force, curvature, _ in form.curved if (entries := diagonal(curvature))]
    return form._replace(inertias=[], dampers=[], curved=curved, M={}, C={}, G={}, drag={}, residual=[],
                         K=list(map(diagonal, form.K)))
