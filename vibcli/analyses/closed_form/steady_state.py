"""Steady states in letters, for one and two degrees of freedom that are driven at one angular frequency:
y = X sin(Ωt + φ − θ), with Ω and φ of the scene.

A load A sin(Ωt + φ) + B cos(Ωt + φ) is the imaginary part of (A + iΩ·B/Ω) e^{i(Ωt + φ)}; where only cosines drive the
scene it is the real part of (B − iΩ·A/Ω) e^{i(Ωt + φ)}, and y = X cos(Ωt + φ − θ).
"""

from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.frequency_response import from_parts, require_few
from vibcli.base.errors import NotInLetters
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.symbolic_linear import outputs
from vibcli.symbolic.common_denominator import shorter
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import TooLong, expanded, is_zero, textbook
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

WAVES = ("sin", "cos")


class Steady(NamedTuple):
    """formula: the Formula of X and θ; wave: sin or cos; argument: Ωt + φ as a node of the scene; mean: what constants
    of the drive shift y by, None where there are none."""

    formula: Any
    wave: str
    argument: Any
    mean: Any = None


def steady_state(symbolic: "SymbolicSystem", signal: Any) -> Steady:
    """The Steady of a coordinate or signal; NotInLetters where it is none of one harmonic."""
    require_few(symbolic.system)
    scene, n = symbolic.scene, len(symbolic.scene.q)
    rows, direct = outputs(symbolic, signal)
    drive = {**symbolic.excitation, n: direct}
    acting = waves_of_all(scene, drive)
    arguments = {argument for found in acting.values() for argument, _ in found}
    if len(arguments) != 1:
        raise NotInLetters("steady states in letters are those of one harmonic" if arguments else
                           "nothing that oscillates drives this scene", "give the parameters values with --set")
    argument, = arguments
    Omega, wave = gradient(argument)[scene.time], _reference(scene, acting)
    loads = {i: _in_phase(found, argument, wave, Omega) for i, found in acting.items() if found}
    b, d = [{}, {}, {}], [{}, {}, {}]
    for i, parts in loads.items():
        for power, part in enumerate(parts):
            (b if i < n else d)[power][i if i < n else 0] = part
    found = from_parts(symbolic, b, rows, d, Omega)
    if all(is_zero(part) for part in found.denominator):
        raise NotInLetters("this scene is driven at a natural frequency without damping: its amplitude grows with the "
                           "time, and there is no steady state",
                           "give numbers with --set, and see the motion from its start")
    return Steady(found, wave, argument, _mean(symbolic, rows, drive))


def _mean(symbolic: "SymbolicSystem", rows: "list[dict[int, Node]]", drive: "Mapping[int, Node]") -> "Node | None":
    """What the constants in {i: function of the time} do to the signal of these rows."""
    scene, n = symbolic.scene, len(symbolic.scene.q)
    fixed = {i: textbook(node - scene.terms_with(node, scene.time.mask)) for i, node in drive.items()}
    fixed = {i: node for i, node in fixed.items() if not node.is_zero}
    if not fixed:
        return None
    b = [{i: node for i, node in fixed.items() if i < n}, {}, {}]
    found = from_parts(symbolic, b, rows, [{0: fixed[n]} if n in fixed else {}, {}, {}], scene.table.zero, order=1)
    if is_zero(found.denominator[0]):
        raise NotInLetters("nothing holds this scene where what drives it stays displaced", "give numbers with --set")
    return shorter(textbook(found.scale * found.numerator[0] / found.denominator[0]))


def waves(scene: "Scene", node: "Node") -> "dict[tuple[Node, str], Node]":
    """{(argument Ωt + φ, sin or cos): coefficient} of a function of the time."""
    try:
        terms = expanded(node)
    except (TooLong, ZeroDivisionError):
        raise NotInLetters("what drives this scene is too long in letters", "give numbers with --set") from None
    found, time, table = {}, scene.time.mask, scene.table
    for monomial, value in terms.items():
        moving = [(atom, e) for atom, e in monomial if atom.mask & time]
        rest = table.product((table.number(value), ONE), *(pair for pair in monomial if pair not in moving))
        if not moving:
            continue
        atom, e = moving[0]
        slope = gradient(atom.args[0]).get(scene.time) if atom.name in WAVES else None
        if len(moving) > 1 or e != 1 or slope is None or slope.mask:
            raise NotInLetters("steady states in letters are those of sin(Omega*t) and cos(Omega*t)",
                               "give the parameters values with --set")
        key = atom.args[0], atom.name
        found[key] = found.get(key, table.zero) + rest
    return found


def waves_of_all(scene: "Scene", drive: "Mapping[int, Node]") -> "dict[int, dict[tuple[Node, str], Node]]":
    """{i: waves} of functions of the time, no frequency being negative; those of one frequency all by the sine and
    cosine of one argument, the shortest: sin(Ωt + φ) = cos φ sin Ωt + sin φ cos Ωt."""
    acting = {i: _forwards(scene, waves(scene, node)) for i, node in drive.items()}
    groups: list[list[Node]] = []
    for argument in dict.fromkeys(argument for found in acting.values() for argument, _ in found):
        rate = gradient(argument)[scene.time]
        group = next((group for group in groups if is_zero(gradient(group[0])[scene.time] - rate)), None)
        (groups.append([argument]) if group is None else group.append(argument))
    base = {argument: min(group, key=lambda one: len(one.args) if one.op == "sum" else 0)
            for group in groups for argument in group}
    return {i: _about(scene, found, base) for i, found in acting.items()}


def _forwards(scene: "Scene", found: "Mapping[tuple[Node, str], Node]") -> "dict[tuple[Node, str], Node]":
    """Waves whose arguments grow with the time."""
    told = {}
    for (argument, wave), node in found.items():
        if scene.number(gradient(argument)[scene.time]) < 0:
            argument, node = textbook(-argument), -node if wave == "sin" else node
        told[argument, wave] = told.get((argument, wave), scene.table.zero) + node
    return told


def _about(scene: "Scene", found: "Mapping[tuple[Node, str], Node]",
           base: "Mapping[Node, Node]") -> "dict[tuple[Node, str], Node]":
    """Waves by the arguments that stand for theirs."""
    told, table = {}, scene.table
    for (argument, wave), node in found.items():
        ahead = textbook(argument - base[argument])
        if ahead.is_zero:
            parts = {wave: node}
        else:
            along, across = (table.call(name, ahead) for name in ("cos", "sin"))
            parts = {"sin": along * node, "cos": across * node} if wave == "sin" else {
                "cos": along * node, "sin": -across * node}
        for kind, part in parts.items():
            key = base[argument], kind
            told[key] = told.get(key, table.zero) + part
    return told


def _reference(scene: "Scene", acting: "Mapping[int, dict[tuple[Node, str], Node]]") -> str:
    """sin or cos: the one that drives, or in which the file says what drives; sin where it says both."""
    said = [*scene.driven.values(), *(term.weight for term in scene.forces)]
    for kinds in ({wave for found in acting.values() for _, wave in found},
                  {part.name for part in reachable(said) if part.op == "call" and part.name in WAVES
                   and part.mask & scene.time.mask}):
        if len(kinds) == 1:
            return kinds.pop()
    return "sin"


def _in_phase(found: "Mapping[tuple[Node, str], Node]", argument: "Node", wave: str,
              Omega: "Node") -> "tuple[Node, Node]":
    """(part in phase, that ahead over Ω) of A sin + B cos."""
    A, B = (found.get((argument, name), Omega.table.zero) for name in WAVES)
    ahead = textbook((B if wave == "sin" else -A) / Omega)
    return A if wave == "sin" else B, ahead
