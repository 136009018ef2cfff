"""Accelerations in letters, from rest in the drawn position: M q̈ = −h(q, q̇ = 0, t = 0), which no equilibrium is
needed for; constant where M and h do not change with the motion."""

from typing import TYPE_CHECKING

from vibcli.base.errors import NotInLetters
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.energies import dissipation, kinetic, potential
from vibcli.mechanics.lagrange import LETTERS, equation_of
from vibcli.mechanics.numeric_equations import massless
from vibcli.mechanics.static_preload import solve_linear
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

JUMPS = ("sign", "abs", "min", "max", "step", "ramp")


class Accelerations(NamedTuple):
    """values: {coordinate: expression} of all coordinates, those that follow from constraints included; constant: do
    they stay so as long as the motion lasts?"""

    values: "dict[str, Node]"
    constant: bool


def accelerations(scene: "Scene") -> Accelerations:
    """The Accelerations of a scene; NotInLetters where friction decides or there are too many coordinates."""
    n, zero = len(scene.q), scene.table.zero
    if n > LETTERS:
        raise NotInLetters(f"accelerations of {n} coordinates are not written out", _in_numbers(scene))
    T, V, Phi = kinetic(scene), potential(scene), dissipation(scene)
    equations = [equation_of(scene, i, T, V, Phi) for i in range(n)]
    if any(part.name in JUMPS and any(part.mask & v.mask for v in scene.v) for part in reachable(equations)):
        raise NotInLetters("from rest friction decides which way the scene goes, if at all", _in_numbers(scene))
    rest = dict.fromkeys(scene.a, zero)
    entries = [gradient(node).get(a, zero) for node in equations for a in scene.a]
    loads = substitute(equations, rest)
    drawn = {**scene.drawn_position, **dict.fromkeys(scene.v, zero)}
    found = [textbook(node) for node in substitute([*entries, *loads], drawn)]
    rows = [[*found[i * n:(i + 1) * n], -found[n * n + i]] for i in range(n)]
    for i, name in enumerate(scene.coordinates):
        if rows[i][i].is_zero:
            raise massless(name)
    values = dict(zip(scene.a, map(single, solve_linear(rows, zero)), strict=True))
    names = list(scene.spec.coordinates)
    known = substitute([scene.symbol(name, 2) for name in names], {**drawn, **values})
    moves = [textbook(node).mask for node in (*entries, *loads)]
    return Accelerations(dict(zip(names, map(single, known), strict=True)), not any(moves))


def _in_numbers(scene: "Scene") -> str:
    return f"ask for {scene.coordinates[0]}''(0 s) in numbers"
