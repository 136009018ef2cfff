"""Constraints G(q, z, t) = 0: dependent coordinates z become functions of the independent ones.

Where a condition holds z with a constant coefficient, z is substituted; otherwise z stays as a symbol whose gradient is
the implicit one, z_q = −G_z⁻¹ G_q, an expression in q and z: its own derivative is the implicit second derivative, so
that all which is derived from z later is exact to any order.
"""

from collections.abc import Callable, Collection, Sequence
from math import isfinite
from typing import TYPE_CHECKING

from vibcli.scene.closed_loops import Loops, nearby
from vibcli.scene.scene import Closure, Freedom, Scene
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.node import union
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

LOOSE = 1e-7


def closed(scene: Scene) -> Scene:
    """The Scene with its dependent coordinates expressed by the others throughout, and the same ones in the scene at
    rest if that is another: {name: expression} in `dependent` of each. What contradicts itself is reported.

    Where the file lists its coordinates, the first of them stay independent as far as can be; else those that no
    condition gives explicitly.
    """
    if scene.matrices:
        from vibcli.scene.tied_matrices import with_energies

        scene = with_energies(scene)
    scenes = (scene, scene.still) if scene.still else (scene,)
    still, raw = scenes[-1], [q for q in scene.q if q not in scene.inputs]
    nodes, *others = [dict(enumerate(textbook(tie.node) for tie in one.constraints)) for one in scenes]
    if _contradictory(scene, nodes.values()):
        return scene
    allowed = raw
    if "coordinates" in scene.spec.sections:
        allowed = [q for _, q in _pivots(still, dict([nodes, *others][-1]), raw)]
    values, order = _explicit(scene, nodes, allowed)
    found = [(scene, nodes, values)]
    for rest in others:
        found.append((still, rest, {}))
        for k, z in order:
            _solve_for(rest, found[-1][2], k, z)
    pivots = _pivots(still, dict(found[-1][1]), [q for q in allowed if q not in values])
    if scene.setting.reports.diagnostics:
        return scene
    left = [q for q in raw if q not in values and q not in {z for _, z in pivots}] + list(scene.inputs)
    settled = [_settled(one, conditions, given, pivots, left, one is not scene) for one, conditions, given in found]
    return settled[0].with_parts(still=settled[1] if others else None)


def _settled(scene: Scene, nodes: "dict[int, Node]", values: "dict[Node, Node]", pivots: "list[tuple[int, Node]]",
             left: "Sequence[Node]", at_rest: bool) -> Scene:
    """The scene in which the dependent coordinates are `values`, or those that `pivots` leave implicit."""
    count, tied = len(scene.q) - len(scene.inputs), [nodes.pop(k) for k, _ in pivots]
    kept = scene.kinematics.keeping(left)
    loops = _implicit(scene, tied, [z for _, z in pivots], values, left, at_rest) if pivots else None
    used = union([node.mask for node in (*(term.weight for term in scene.forces), *scene.energies.values())])
    rates = {scene.symbol(z.name, 1): node for z, node in values.items()}
    rates = {v: kept.rate(node) for v, node in rates.items() if v.mask & used}
    redundant = tuple(scene.constraints[k].name for k in nodes)
    closure = Closure(loops, {z.name: node for z, node in values.items()}, Freedom(count, len(values), redundant))
    if scene.matrices:
        from vibcli.scene.tied_matrices import of_independent

        scene = scene.with_parts(contents=scene.contents._replace(matrices=of_independent(scene, values, left)))
    found = scene.replaced({**values, **rates}, coordinates=kept.defining(values), closure=closure)
    _check_redundant(found, nodes, substitute(list(nodes.values()), values))
    return found


def _contradictory(scene: Scene, nodes: "Collection[Node]") -> bool:
    """A condition without coordinates cannot be met."""
    before = len(scene.setting.reports.diagnostics)
    for constraint, node in zip(scene.constraints, nodes, strict=True):
        if not any(q in gradient(node) for q in scene.q) and not node.is_zero:
            scene.report(constraint.where, f"nothing can move so that the constraint '{constraint.name}' holds",
                         "one of the things that it ties must be able to move")
    return len(scene.setting.reports.diagnostics) > before


def _pivots(scene: Scene, nodes: "dict[int, Node]", columns: "list[Node]") -> "list[tuple[int, Node]]":
    """[(number of a condition, coordinate)] of a largest regular block of ∂G/∂q as drawn: coordinates from the last,
    conditions from the first. `nodes`: {number: condition}."""
    zero = scene.table.zero
    slopes = scene.at_drawn(*(gradient(node).get(q, zero) for node in nodes.values() for q in columns))
    flat, n, units = evaluate(slopes, Floats, scene.sample), len(columns), scene.units_of([q.name for q in columns])
    work = {}
    for i, k in enumerate(nodes):
        row = flat[i * n:(i + 1) * n]
        if not all(map(isfinite, row)):
            scene.report(scene.constraints[k].where, f"how '{scene.constraints[k].whole}' changes is not "
                         "defined as drawn", "look for roots of what is zero or negative, and for what divides by zero")
            return []
        row = [x * unit for x, unit in zip(row, units, strict=True)]
        size = max(map(abs, row), default=0.0) or 1.0
        work[k] = [x / size for x in row]
    found = []
    for j in reversed(range(n)):
        largest = max((abs(row[j]) for row in work.values()), default=0.0)
        if largest <= LOOSE:
            continue
        pivot = next(k for k, row in work.items() if abs(row[j]) >= 0.1 * largest)
        found.append((pivot, columns[j]))
        chosen = work.pop(pivot)
        for k, row in work.items():
            if row[j]:
                factor = row[j] / chosen[j]
                work[k] = [x - factor * y for x, y in zip(row, chosen, strict=True)]
    return found


def _explicit(scene: Scene, nodes: "dict[int, Node]",
              allowed: "list[Node]") -> "tuple[dict[Node, Node], list[tuple[int, Node]]]":
    """{z: expression} of coordinates that stand with a constant coefficient in a condition, which is taken out of
    `nodes` ({number: condition}); of those of the shortest condition the last. And [(number, z)] in this order."""
    found, taken, ranked = {}, [], {}
    order = {q: i for i, q in enumerate(scene.q) if q not in scene.inputs}
    while True:
        for k in nodes.keys() - ranked.keys():
            ranked[k] = _shortest(scene, nodes[k], order, allowed)
        choices = [(*rank, k) for k, rank in ranked.items() if rank is not None]
        if not choices:
            return found, taken
        _, place, k = min(choices)
        z = scene.q[-place]
        del ranked[k]
        taken.append((k, z))
        for changed in _solve_for(nodes, found, k, z):
            del ranked[changed]


def _solve_for(nodes: "dict[int, Node]", found: "dict[Node, Node]", k: int, z: "Node") -> list[int]:
    """Take condition k out of `nodes` and z from it, `found` being {z: expression}; the numbers of those with z."""
    node = nodes.pop(k)
    expression = textbook(z - node / gradient(node)[z])
    for other, value in found.items():
        found[other] = _with(value, z, expression)
    found[z] = expression
    moved = {other: _with(value, z, expression) for other, value in nodes.items()}
    changed = [other for other, value in moved.items() if value is not nodes[other]]
    nodes.update(moved)
    return changed


def _shortest(scene: Scene, node: "Node", order: "dict[Node, int]", allowed: "list[Node]") -> tuple[int, int] | None:
    """(number of coordinates in a condition, −place of the last that it gives explicitly), None where it gives none."""
    here = {q: slope for q, slope in gradient(node).items() if q in order}
    given = [order[q] for q, slope in here.items() if q in allowed and not slope.mask and scene.number(slope)]
    return (len(here), -max(given)) if given else None


def _with(node: "Node", z: "Node", expression: "Node") -> "Node":
    """The node with z substituted."""
    return textbook(substitute([node], {z: expression})[0]) if node.mask & z.mask else node


def _implicit(scene: Scene, nodes: "Sequence[Node]", waiting: "list[Node]", values: "dict[Node, Node]",
              left: "Sequence[Node]", at_rest: bool) -> Loops:
    """Adds the dependents `waiting` to `values` as symbols with implicit gradients; returns the Loops."""
    table = scene.table
    depends = [x for x in (*left, scene.time) if any(x in gradient(node) for node in nodes)]
    symbols = {z: table.dependent(z.name, union([x.mask for x in depends]), at_rest) for z in waiting}
    partial = [[gradient(node).get(x, table.zero) for x in (*waiting, *depends)] for node in nodes]
    moved = substitute([node for row in partial for node in row], symbols)
    width = len(waiting) + len(depends)
    rows = [moved[i * width:(i + 1) * width] for i in range(len(nodes))]
    drawn = {**scene.drawn, **{symbols[z]: scene.drawn[z] for z in waiting}, scene.time: table.zero}
    solution = solved(rows, scene.units_of([z.name for z in waiting]),
                      lambda nodes: evaluate(substitute(nodes, drawn), Floats, scene.sample))
    for z, slopes in zip(waiting, solution, strict=True):
        symbols[z].keep_gradient({x: -slope for x, slope in zip(depends, slopes, strict=True) if not slope.is_zero})
    for other, node in values.items():
        values[other] = substitute([node], symbols)[0]
    values.update(symbols)
    return Loops([z.name for z in waiting], nodes, [node for row in partial for node in row[:len(waiting)]],
                 [scene.unit_of(z.name) for z in waiting])


def solved(rows: "Sequence[list[Node]]", units: Sequence[float],
           numbers: "Callable[[Sequence[Node]], Sequence[float]]") -> "list[list[Node]]":
    """A⁻¹B of rows [A | B] in letters, A having a column for each of the units: sparse elimination; pivots are not
    small as drawn, in these."""
    n = len(units)
    work = [{j: node for j, node in enumerate(row) if not node.is_zero} for row in rows]
    order, free, answers = [], set(range(n)), {}
    while free:
        if _dense(work, free, {*range(n)} - {c for _, c in order}):
            answers = _pair(work, sorted(free), n)
            break
        candidates = [(i, j) for i in free for j in work[i] if j < n and j not in {c for _, c in order}]
        found = numbers([work[i][j] for i, j in candidates])
        sizes = {(i, j): abs(x) * units[j] for (i, j), x in zip(candidates, found, strict=True)}
        largest = {i: max((size for (k, _), size in sizes.items() if k == i), default=0.0) for i in free}
        count = {}
        for _, j in candidates:
            count[j] = count.get(j, 0) + 1
        i, j = min((pair for pair in candidates if sizes[pair] >= 0.1 * largest[pair[0]] and sizes[pair] > 0),
                   key=lambda pair: ((len(work[pair[0]]) - 1) * (count[pair[1]] - 1), pair))
        order.append((i, j))
        free.remove(i)
        for other in free:
            if j in work[other]:
                factor = work[other].pop(j) / work[i][j]
                _reduce(work[other], work[i], factor, j)
    for i, j in reversed(order):
        found = {k: node for k, node in work[i].items() if k >= n}
        for k, node in work[i].items():
            if k < n and k != j:
                _reduce(found, answers[k], node, None)
        answers[j] = {k: node / work[i][j] for k, node in found.items()}
    zero = rows[0][0].table.zero
    return [[answers[j].get(k, zero) for k in range(n, len(rows[0]))] for j in range(n)]


def _dense(work: "Sequence[Collection[int]]", free: Collection[int], columns: Collection[int]) -> bool:
    """Are two rows left, each with two columns?"""
    return len(free) == 2 and all(j in work[i] for i in free for j in columns)


def _pair(work: "list[dict[int, Node]]", free: list[int], n: int) -> "dict[int, dict[int, Node]]":
    """The two unknowns of two rows by Cramer's rule, which divides by nothing else than their determinant."""
    one, two = (work[i] for i in free)
    a, b = (j for j in one if j < n)
    det = one[a] * two[b] - one[b] * two[a]
    zero = det.table.zero
    right = sorted({k for k in (*one, *two) if k >= n})
    found = {a: {k: two[b] * one.get(k, zero) - one[b] * two.get(k, zero) for k in right},
             b: {k: one[a] * two.get(k, zero) - two[a] * one.get(k, zero) for k in right}}
    return {j: {k: node / det for k, node in row.items() if not node.is_zero} for j, row in found.items()}


def _reduce(row: "dict[int, Node]", other: "dict[int, Node]", factor: "Node", skip: int | None) -> None:
    """row − factor·other, in place."""
    for k, node in other.items():
        if k != skip:
            value = row[k] - factor * node if k in row else -(factor * node)
            if value.is_zero:
                row.pop(k, None)
            else:
                row[k] = value


def _check_redundant(scene: Scene, numbers: "dict[int, Node]", nodes: "Sequence[Node]") -> None:
    """Conditions which the others imply as drawn must be implied in all positions."""
    for k, node in zip(numbers, nodes, strict=True):
        if is_zero(node):
            continue
        terms = [scene.table.scaled(part, c) for part, c in node.args] if node.op == "sum" else [node]
        if not all(abs(size) <= 1e-9 for size in _rates(scene, node)):
            constraint = scene.constraints[k]
            scene.report(constraint.where, f"the constraint '{constraint.whole}' contradicts the others: they "
                         "prescribe different motions in time", "take one of them out")
            continue
        for values in (nearby(scene, attempt) for attempt in range(4)):
            sizes = evaluate([node, *terms], Floats, values) if values is not None else (0.0,)
            if not abs(sizes[0]) <= 1e-9 * sum(map(abs, sizes[1:])):
                constraint = scene.constraints[k]
                scene.report(constraint.where, f"the constraint '{constraint.whole}' locks the scene in the drawn "
                             "position: it contradicts the other constraints as soon as anything moves",
                             _way_out(scene, constraint.whole))
                break


def _way_out(scene: Scene, name: str) -> str:
    """The hint for a constraint that contradicts others; a member is one that keeps its length."""
    if name in scene.members:
        return f"'{name}' keeps its length: let what holds it move along it too, as in [x, y, psi], or give it `EA`"
    return "take it out, or draw the position so that all constraints can hold while it moves"


def _rates(scene: Scene, node: "Node") -> list[float]:
    """∂G/∂t as drawn of a condition that follows from the others there, relative to the terms it is summed from."""
    slope = gradient(node).get(scene.time)
    if slope is None:
        return []
    terms = [scene.table.scaled(part, c) for part, c in slope.args] if slope.op == "sum" else [slope]
    sizes = evaluate(scene.at_drawn(slope, *terms), Floats, scene.sample)
    return [sizes[0] / (sum(map(abs, sizes[1:])) or 1.0)]


def words_of_locked(scene: Scene) -> str:
    """What is said of a scene whose constraints leave no freedom."""
    if scene.held and not scene.dependent:
        return "nothing moves in this scene: all its bodies are clamped"
    if any(node.mask & scene.time.mask for node in scene.dependent.values()) or not scene.dependent:
        return "nothing moves freely: all motion is prescribed as a function of the time"
    bodies = ", ".join(f"'{name}'" for name, body in scene.bodies.items() if body.moves)
    names = list(dict.fromkeys(f"'{constraint.whole}'" for constraint in scene.constraints))
    verb = "the constraint {} locks" if len(names) == 1 else "the constraints {} lock"
    count = scene.freedom.coordinates
    tied = "its one coordinate is tied by a condition" if count == 1 else (
        f"{count} coordinates are tied by as many independent conditions")
    return f"{verb.format(', '.join(names))} the scene: {bodies} cannot move, as {tied}"
