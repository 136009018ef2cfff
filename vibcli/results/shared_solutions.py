"""What arrays find of a scene at many values of its parameters that share one derivation: where it rests, its modes.

A scene that does not rest as drawn is followed from the corners of blocks of the grid, at which it was solved by
itself. Nothing that arrays find is taken where at one of them they find something else.
"""

from collections.abc import Callable, Mapping, Sequence
from itertools import product
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.stacked_damped import StackedDamped
from vibcli.analyses.modal.stacked_modes import StackedModes
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.equilibrium.equilibrium import Equilibrium
from vibcli.mechanics.stacked_equilibria import StackedEquilibria
from vibcli.mechanics.stacked_matrices import StackedMatrices, stacked_matrices
from vibcli.symbolic.array_arithmetic import Arrays

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.mechanics.linearisation import Linearisation
    from vibcli.results.problem import Problem

    KnownModes = tuple[list[Mode] | None, list[DampedMode] | None]      # natural ones, damped ones

ALIKE = 1e-12               # relative: of frequencies found by arrays and by themselves at a corner
SMOOTH = {"sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp", "log", "power"}
TINY = 1e-5                 # of the figure: a displacement of which floats may know less than is told

Place = tuple[int, ...]
Block = tuple[tuple[int, int], ...]


class SharedSolution(NamedTuple):
    """(natural modes, damped ones or None) and the Equilibrium, each None where arrays do not find it."""

    modes: "KnownModes"
    equilibrium: Equilibrium | None


class SharedSolutions(NamedTuple):
    """What arrays find at places, {place: its number}: modes, and where each rests; known: at which, truths by number;
    values: {parameter: number, or array}; undamped: does nothing damp?"""

    numbers: dict[Place, int]
    natural: StackedModes
    damped: StackedDamped
    rests: "Sequence[Equilibrium | None]"
    known: np.ndarray
    values: "dict[str, Any]"
    undamped: bool

    def at(self, place: Place) -> SharedSolution | None:
        """That of one place; None where arrays do not settle it."""
        i = self.numbers[place]
        if not self.known[i]:
            return None
        damped = self.damped.modes(i) if self.damped.settled[i] else None
        return SharedSolution((self.natural.modes(i), damped), self.rests[i])


def shared_solutions(base: "Problem", corners: "Mapping[Place, Problem]", blocks: Sequence[Block],
                     given: "Mapping[Place, Mapping[str, Fraction]]") -> SharedSolutions | None:
    """What is known of a grid, {place: exact values}, that shares the expressions of `base`; corners: those of its
    blocks, solved by themselves. None where arrays find something else there, or nothing."""
    try:
        free, rest = _free(corners), _rest(corners)
        form = None if free is None else _form(base, rest)
    except PhysicsError:
        return None
    if form is None:
        return None
    places = list(given)
    values = _values(base, {name: np.array([float(given[place][name]) for place in places])
                            for name in given[places[0]]})
    if rest:
        found = _at_rest(base, form, values, rest, blocks, places)
        if found is None:
            return None
        matrices, rests = found
        balanced = np.array([one is not None for one in rests])
    else:
        matrices, rests = stacked_matrices(form, values, len(places)), [None] * len(places)
        balanced = matrices.balanced
    natural = StackedModes(matrices, bool(free))
    rests_or_held = balanced | natural.held if base.system.is_linear else balanced
    known = SharedSolutions({place: i for i, place in enumerate(places)}, natural, StackedDamped(matrices, natural),
                            rests, natural.settled & rests_or_held, values, not matrices.C_size.any())
    return known if all(_agrees(problem, known.at(corner)) for corner, problem in corners.items()) else None


def _free(corners: "Mapping[Place, Problem]") -> bool | None:
    """Has the scene one mode without frequency at all corners? None where it has more, or not everywhere."""
    counts = {sum(mode.rigid for mode in problem.modal.modes) for problem in corners.values()}
    return bool(*counts) if counts in ({0}, {1}) else None


def _rest(corners: "Mapping[Place, Problem]") -> dict[Place, Mapping[str, float]]:
    """{corner: {coordinate: value}} at rest; empty where all rest as drawn."""
    found = {corner: problem.configuration.equilibrium for corner, problem in corners.items()}
    return {} if all(one.drawn for one in found.values()) else {corner: one.values for corner, one in found.items()}


def _form(problem: "Problem", rest: Mapping[Any, Any]) -> "Linearisation | None":
    """The Linearisation that holds for all values of a scene whose natural modes arrays may find; None of others."""
    system, scene = problem.system, problem.scene
    table, loops, damping = scene.table, scene.loops, problem.spec.get("damping")
    if not scene.q or scene.pieces or loops is not None or damping is not None or system.named_start or (
            table.called - SMOOTH or table.functions or table.records or problem.numeric.has_free_symbols):
        return None
    form = system.linearisation if rest else system.linearisation_at_reference
    return None if any(form.G.values()) or any(form.drag.values()) else form


def _values(problem: "Problem", exact: "Mapping[str, np.ndarray]") -> "dict[str, Any]":
    """{parameter: number, or array of numbers where it hangs on these}."""
    given = {name: float(value) for name, value in problem.numeric.given.items()}
    still = {v.name: 0.0 for v in problem.scene.v}
    return {**problem.scene.parameters.values(Arrays, {**given, **exact}), problem.scene.time.name: 0.0, **still}


def _at_rest(base: "Problem", form: "Linearisation", values: Mapping[str, Any],
             rest: Mapping[Place, Mapping[str, float]], blocks: Sequence[Block],
             places: Sequence[Place]) -> "tuple[StackedMatrices, list[Equilibrium | None]] | None":
    """(the matrices where it rests, the Equilibrium of each place, None where arrays do not tell); None where the
    places do not lead on to one another."""
    names, number = base.scene.coordinates, {place: i for i, place in enumerate(places)}
    scale = np.array([base.numeric.size_along(name) for name in names])
    near = np.array([_between(place, rest, blocks, names) for place in places])
    found = StackedEquilibria(form, values, names, near, scale)
    for axis in range(len(places[0])):
        before = np.array([number.get((*place[:axis], place[axis] - 1, *place[axis + 1:]), -1) for place in places])
        if not found.follow(before):
            return None
    told = found.settled & ((found.places == 0) | (np.abs(found.places) >= TINY * scale)).all(1)
    rests = [Equilibrium(dict(zip(names, (place + 0.0).tolist(), strict=True)), False, 0.0) if known else None
             for place, known in zip(found.places, told, strict=True)]
    return found.matrices(), rests


def _between(place: Place, rest: Mapping[Place, Mapping[str, float]], blocks: Sequence[Block],
             names: Sequence[str]) -> np.ndarray:
    """The coordinates between those at the corners of the block in which a place lies, by multilinear interpolation."""
    block = next(block for block in blocks
                 if all(low <= i <= high for i, (low, high) in zip(place, block, strict=True)))
    parts = [(i - low) / (high - low) if high > low else 0.0 for i, (low, high) in zip(place, block, strict=True)]
    total = np.zeros(len(names))
    for sides in product(*((0, 1) if high > low else (0,) for low, high in block)):
        corner = tuple(ends[side] for ends, side in zip(block, sides, strict=True))
        share = prod(part if side else 1 - part for part, side in zip(parts, sides, strict=True))
        total += share * np.array([rest[corner][name] for name in names])
    return total


def _agrees(problem: "Problem", known: SharedSolution) -> bool:
    """Has a corner, solved by itself, the modes that arrays found?"""
    if known is None:
        return True
    modal, (natural, damped) = problem.modal, known.modes
    try:
        return _same(modal.modes, natural, _rate) and (damped is None or _same(modal.damped, damped, _eigenvalue))
    except PhysicsError:
        return False


def _same(modes: "Modes", found: "Sequence[DampedMode | Mode]", value: Callable[..., Any]) -> bool:
    return modes is not None and len(modes) == len(found) and all(
        one.kind == other.kind and abs(value(one) - value(other)) <= ALIKE * abs(value(one))
        for one, other in zip(modes, found, strict=True))


def _eigenvalue(mode: "DampedMode") -> complex:
    return mode.eigenvalue


def _rate(mode: "Mode") -> float:
    found: float = mode.omega if mode.growth_rate is None else mode.growth_rate
    return found
