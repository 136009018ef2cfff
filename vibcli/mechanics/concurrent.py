"""Springs and dampers that end at one place: what they resist with there together, their other ends held.

    K = Σ kᵢ nᵢ nᵢᵀ + Nᵢ/lᵢ (1 − nᵢ nᵢᵀ)        C = Σ cᵢ nᵢ nᵢᵀ

with k the slope of the tension N over the distance l of the ends and n the direction from one to the other
(Kovacić & Radomirović 2018, 9.2). With κᵢ = kᵢ − Nᵢ/lᵢ

    kmax, kmin = ½ (Σ κᵢ ± √(Σ κᵢ² + 2 Σ_{i<j} κᵢ κⱼ cos 2(αᵢ − αⱼ))) + Σ Nᵢ/lᵢ
"""

from typing import TYPE_CHECKING, Any

from vibcli.base.enumeration import listed
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.nonsmooth import KINKED, SIDES
from vibcli.scene.laws import Law
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import is_zero, root_of_square, textbook

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.language.spec import Spec
    from vibcli.scene.energy_terms import Damper, Spring
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node


class Concurrent(NamedTuple):
    """The element `name`: κ along its direction n = (x, y), and N/l in every direction, which is zero of a damper;
    a spring without free length has its whole stiffness in `around`."""

    name: str
    kappa: Any
    x: Any
    y: Any
    around: Any

    @property
    def nodes(self) -> "tuple[Node, ...]":
        """The expressions that it is made of."""
        return self[1:]


class Tensor(NamedTuple):
    """A symmetric tensor in the plane."""

    xx: Any
    xy: Any
    yy: Any


def same_place(spec: "Spec", scene: "Scene", place: str) -> set[str]:
    """The names of a place: itself, and points and bodies that are carried there with it."""
    records, found = spec.get("points") or {}, {place}

    def carried(name: str) -> "tuple[str, tuple[Node, Node]] | None":
        """(body, drawn place) of what a body carries; None of what is fixed or led."""
        if name in scene.bodies:
            return None if scene.bodies[name].frame is None else (name, scene.bodies[name].centre)
        record = records[name]
        return None if "body" not in record or "moves" in record else (record["body"].text, scene.pair(record["at"]))

    here = carried(place)
    for name in (*scene.bodies, *records) if here else ():
        there = carried(name)
        if there and there[0] == here[0] and all(is_zero(a - b) for a, b in zip(here[1], there[1], strict=True)):
            found.add(name)
    return found


def ending_at(spec: "Spec", scene: "Scene", place: str, section: str) -> list[str]:
    """The names of the springs or dampers that end at a place and act along the line of their ends."""
    names = same_place(spec, scene, place)
    return [record.name for record in (spec.get(section) or {}).values() if "torsion" not in record
            and any(getattr(end, "text", None) in names for end in record.get("between", ()))]


def concurrent(spec: "Spec", scene: "Scene", place: str, section: str) -> list[Concurrent]:
    """The springs or dampers at a place; PhysicsError where there are none, or they have no direction."""
    if place in scene.bodies and scene.bodies[place].frame is None:
        raise PhysicsError(f"'{place}' has no place: what acts on it has no direction",
                           "say where it is drawn with `at: [x, y]`")
    names, word = ending_at(spec, scene, place, section), section[:-1]
    if not names:
        elsewhere = [name for name in (*scene.bodies, *(spec.get("points") or {}))
                     if ending_at(spec, scene, name, section)]
        raise PhysicsError(f"no {word} ends at '{place}'", f"{section} end at {listed(elsewhere[:6])}" if elsewhere
                           else "torsion and a `stretch` that is written out have no ends")
    found = [_at_place(spec, scene, name, section) for name in names]
    if any(node.mask & scene.time.mask for one in found for node in one.nodes):
        raise PhysicsError(f"the {section} at '{place}' are carried by what is prescribed in time: their equivalent is "
                           "told where all ends stay", "leave out what turns or drifts with the time")
    return found


def _at_place(spec: "Spec", scene: "Scene", name: str, section: str) -> Concurrent:
    record, table = spec.get(section)[name], scene.table
    (ax, ay), (bx, by) = map(scene.place_of, record["between"])
    dx, dy = bx - ax, by - ay
    terms = scene.terms_of(name)
    if len(terms) == 2:         # no free length: the same in every direction
        return Concurrent(name, table.zero, table.one, table.zero, terms[0].weight)
    term, length = terms[0], scene.distance(dx, dy)
    if section == "dampers":
        return Concurrent(name, _coefficient(scene, term), dx / length, dy / length, table.zero)
    tension = term.force(scene) / length
    return Concurrent(name, _slope(scene, term) - tension, dx / length, dy / length, tension)


def _slope(scene: "Scene", term: "Law | Spring") -> "Node":
    """dN/dl of a spring."""
    if not isinstance(term, Law):
        return term.weight
    second = gradient(term.derivative).get(term.x, scene.table.zero)
    return substitute([second], {term.x: term.s})[0]


def _coefficient(scene: "Scene", term: "Damper | Law") -> "Node":
    """dF/dv of a damper at rest; PhysicsError where it has none, as of dry friction."""
    if not isinstance(term, Law):
        return term.weight
    second = gradient(term.derivative).get(term.x, scene.table.zero)
    try:
        sides = [_beside(scene, [term.derivative, second], term.x, side) for side in (1, -1)]
    except ZeroDivisionError:
        sides = None
    if sides is None or not all(is_zero(a - b) for a, b in zip(*sides, strict=True)):
        raise PhysicsError(f"the force of '{term.owner}' has no slope at rest, so it has no coefficient there",
                           "take it out, or give it a coefficient `c`")
    return sides[0][1]


def _beside(scene: "Scene", nodes: "list[Node]", x: "Node", side: int) -> "list[Node]":
    """Expressions next to x = 0, on one side of what jumps there."""
    rest = {x: scene.table.zero}
    leaps = [part for part in reachable(nodes) if part.name in SIDES and is_zero(substitute([part.args[0]], rest)[0])]
    signs = {part: scene.table.number(SIDES[part.name][side > 0]) for part in leaps}
    return substitute(substitute(nodes, signs), rest)


def tensor(elements: "list[Concurrent]") -> Tensor:
    """Σ κ n nᵀ + N/l of springs or dampers, as expressions."""
    table = elements[0].x.table
    around = table.total([one.around for one in elements])
    xx, xy, yy = (table.total([one.kappa * getattr(one, a) * getattr(one, b) for one in elements])
                  for a, b in ("xx", "xy", "yy"))
    return Tensor(xx + around, xy, yy + around)


def at_rest(elements: "list[Concurrent]", rest: "Mapping[Node, Node]") -> "list[Concurrent]":
    """The same with the coordinates replaced by where they rest, {symbol: node}."""
    new = iter(substitute([node for one in elements for node in one.nodes], rest))
    return [Concurrent(one.name, *(textbook(next(new)) for _ in one.nodes)) for one in elements]


def in_letters(elements: "list[Concurrent]", component: str) -> "Node":
    """max, min, angle, xx, xy or yy as an expression; `angle`: PhysicsError where all directions are equal."""
    K = Tensor(*map(textbook, tensor(elements)))
    table: Table = K.xy.table
    if component in K._fields:
        found: Node = getattr(K, component)
        return found
    if component == "angle":
        if is_zero(K.xy) and is_zero(K.xx - K.yy):
            raise isotropic(elements)
        doubled = [(one.kappa, *_doubled(one.x, one.y)) for one in elements]
        sine, cosine = (table.total([kappa * pair[i] for kappa, *pair in doubled]) for i in (1, 0))
        return table.call("atan2", textbook(sine), textbook(cosine)) / 2
    if is_zero(K.xy):
        return table.call(component, K.xx, K.yy)
    sum_, around = (table.total([getattr(one, name) for one in elements]) for name in ("kappa", "around"))
    root = _difference(elements)
    return textbook(around + sum_ / 2) + (root if component == "max" else -root) / 2


def _difference(elements: list[Concurrent]) -> "Node":
    """kmax − kmin = √(Σ κᵢ² + 2 Σ κᵢ κⱼ cos 2(αᵢ − αⱼ))."""
    pairs = [(one, other, textbook(one.x * other.x + one.y * other.y), textbook(one.y * other.x - one.x * other.y))
             for i, one in enumerate(elements) for other in elements[:i]]
    square = textbook(elements[0].x.table.total([
        *(one.kappa**2 for one in elements),
        *(2 * one.kappa * other.kappa * _doubled(dot, cross)[0] for one, other, dot, cross in pairs)]))
    root = root_of_square(square)
    return square.table.sqrt(square) if root is None else square.table.call("abs", root)


def _doubled(x: "Node", y: "Node") -> "tuple[Node, Node]":
    """(cos 2α, sin 2α) of a direction (cos α, sin α)."""
    for cosine, sine in ((x, y), (-x, -y)):
        if cosine.name != "cos":
            continue
        angle, call = cosine.args[0], cosine.table.call
        for sign in (1, -1):
            if is_zero(sine - sign * call("sin", angle)):
                return call("cos", 2 * angle), sign * call("sin", 2 * angle)
    return textbook(x * x - y * y), textbook(2 * x * y)


def isotropic(elements: "list[Concurrent]") -> PhysicsError:
    """The refusal of an angle where every direction is like the others."""
    word, verb = ("elements", "act") if len(elements) > 1 else ("element", "acts")
    return PhysicsError(f"the {word} {listed([one.name for one in elements])} {verb} alike in every direction: none is "
                        "the stiffest", "ask for max or min, which are equal")


def kinked(elements: "list[Concurrent]") -> bool:
    """Is there anything in them that may bend or jump?"""
    return any(part.name in KINKED for part in reachable([node for one in elements for node in one.nodes]))


def axes_differ(springs: "list[Concurrent]", dampers: "list[Concurrent]") -> "Node":
    """kxy (cxx − cyy) − cxy (kxx − kyy), which vanishes where both pairs share their axes."""
    K, C = tensor(springs), tensor(dampers)
    return textbook(K.xy * (C.xx - C.yy) - C.xy * (K.xx - K.yy))
