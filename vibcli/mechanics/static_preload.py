"""Static preloads: the tensions that make the drawn position the equilibrium.

In the drawn position r₀ + Σ Nⱼ ∇sⱼ = 0 is linear in the unknown tensions Nⱼ. It is solved on the rows and columns
that a pivoted elimination picks out in floats, in letters, so that every later question sees exact expressions.
"""

from collections.abc import Iterable, Mapping, Sequence
from math import isfinite
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.autonomous import steady
from vibcli.mechanics.linearisation import at_position, residual_terms
from vibcli.mechanics.linearise import linearise, row_of
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.radicals import without_bars

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.mechanics.linearisation import Linearisation
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

LOOSE = 1e-9


def settle_static_preloads(scene: "Scene") -> "tuple[Scene, dict[str, Node]]":
    """(the scene with every `preload: static` replaced by its tension, {name: tension})."""
    names = [record.name for _, record in scene.static_preloads]
    unknowns = [node for node, _ in scene.static_preloads]
    vibrating = scene.vibrating
    form = at_position(steady(vibrating, linearise(vibrating)), vibrating.drawn_position)
    columns = [_without_rounding(scene, _column(form, unknown, _row_of_law(vibrating, record)))
               for unknown, record in scene.static_preloads]
    sums = [scene.table.total(terms) for terms in residual_terms(form)]
    rest = _without_rounding(scene, substitute(sums, dict.fromkeys(unknowns, scene.table.zero)))
    numbers = _floats(scene, [[column[i] for column in columns] + [rest[i]] for i in range(form.n)])
    rows, picked = pivots(_balanced([row[:-1] for row in numbers], scene.units_of(scene.coordinates)))
    tensions = solve_linear([[columns[j][i] for j in picked] + [-rest[i]] for i in rows], scene.table.zero)
    values = dict.fromkeys(unknowns, scene.table.zero)
    values.update({unknowns[j]: textbook(tension) for j, tension in zip(picked, tensions, strict=True)})
    _consistent(scene, numbers, [values[unknown] for unknown in unknowns], names)
    _reached(scene, values)
    for free in set(range(len(unknowns))) - set(picked):
        _harmless(scene, form, unknowns, columns, rows, picked, free)
    return scene.with_preloads(values), {name: values[unknown] for name, unknown in zip(names, unknowns, strict=True)}


def _row_of_law(scene: "Scene", record: "Record") -> "dict[int, Node]":
    """∇s as drawn of a spring with a law; nothing of a linear one."""
    number = {q: i for i, q in enumerate(scene.q)}
    rows = [row_of(law.s, number) for law in scene.laws if law.owner == record.name]
    return {i: substitute([slope], scene.drawn_position)[0] for row in rows for i, slope in row.items()}


def _column(form: "Linearisation", unknown: "Node", of_law: "Mapping[int, Node]") -> "list[Node]":
    """∂r/∂N of one tension, by coordinate: r is linear in it, for F(d₀(N)) = N of a law, too."""
    found = [of_law.get(i, form.table.zero) for i in range(form.n)]
    for force, _, row in form.curved:
        share = _share(force, unknown)
        if not share.is_zero:
            for i, slope in row.items():
                found[i] = found[i] + share * slope
    return found


def _without_rounding(scene: "Scene", column: "list[Node]") -> "list[Node]":
    """A column with zero for what is so by algebra alone, where floats leave a little of it."""
    sizes = [abs(x) for x in evaluate(column, Floats, scene.sample)]
    little = LOOSE * max(sizes, default=0.0)
    return [scene.table.zero if 0 < size <= little and is_zero(without_bars(node, [scene.sample])) else node
            for size, node in zip(sizes, column, strict=True)]


def _share(force: "Node", unknown: "Node") -> "Node":
    """The coefficient of a symbol in a force that is linear in it."""
    one, zero = unknown.table.one, unknown.table.zero
    with_one = substitute([force], {unknown: one})[0]
    return with_one - substitute([force], {unknown: zero})[0] if with_one is not force else zero


def _floats(scene: "Scene", rows: "Sequence[list[Node]]") -> list[list[float]]:
    flat = evaluate([node for row in rows for node in row], Floats, scene.sample)
    width = len(rows[0]) if rows else 0
    return [flat[i * width:(i + 1) * width] for i in range(len(rows))]


def _balanced(rows: list[list[float]], units: Sequence[float]) -> list[list[float]]:
    """Rows by the natural sizes of their coordinates, columns by their largest entry: the same in all units."""
    rows = [[x * unit for x in row] for row, unit in zip(rows, units, strict=True)]
    largest = [max(map(abs, column), default=0.0) or 1.0 for column in zip(*rows, strict=True)]
    return [[x / size for x, size in zip(row, largest, strict=True)] for row in rows]


def pivots(rows: Sequence[list[float]]) -> tuple[list[int], list[int]]:
    """(rows, columns) of a largest regular block, by elimination with full pivoting on scaled rows."""
    work = [[x / (max(map(abs, row)) or 1.0) for x in row] for row in rows]
    left, open_columns, pivots = set(range(len(work))), set(range(len(work[0]) if work else 0)), []
    while True:
        best, i, j = max(((abs(work[i][j]), i, j) for i in left for j in open_columns), default=(0.0, 0, 0))
        if best <= LOOSE:
            return [i for i, _ in pivots], [j for _, j in pivots]
        pivots.append((i, j))
        left.remove(i)
        open_columns.remove(j)
        for other in left:
            if work[other][j]:
                factor = work[other][j] / work[i][j]
                work[other] = [x - factor * y for x, y in zip(work[other], work[i], strict=True)]


def solve_linear(rows: "Sequence[list[Node]]", zero: "Node") -> "list[Node]":
    """The solution of a regular system [A | b] whose diagonal pivots do not vanish, in letters."""
    work = [list(row) for row in rows]
    for i, row in enumerate(work):
        pivot = row[i]
        for other in work[i + 1:]:
            if other[i].is_zero:
                continue
            factor = other[i] / pivot
            for column in range(i, len(row)):
                other[column] = other[column] - factor * row[column]
    solution = [zero] * len(work)
    for i in reversed(range(len(work))):
        total = work[i][-1]
        for j in range(i + 1, len(work)):
            total = total - work[i][j] * solution[j]
        solution[i] = total / work[i][i]
    return solution


def _consistent(scene: "Scene", numbers: Sequence[list[float]], tensions: "list[Node]", names: list[str]) -> None:
    """All equations must hold, not only those that were solved."""
    values = evaluate(tensions, Floats, scene.sample)
    for i, row in enumerate(numbers):
        terms = [a * N for a, N in zip(row[:-1], values, strict=True)] + [row[-1]]
        if abs(sum(terms)) > LOOSE * sum(map(abs, terms)):
            raise PhysicsError(
                f"no preload of {_listed(names)} makes the drawn position an equilibrium: the condition for "
                f"'{scene.coordinates[i]}' is left with {sum(terms):.6g}",
                "draw the position of equilibrium, or let a spring act along that coordinate",
                scene.static_preloads[0][1].place("preload"))


def _reached(scene: "Scene", values: "dict[Node, Node]") -> None:
    """Every law must have its tension at some deflection."""
    for unknown, record in scene.static_preloads:
        found = [law.s for law in scene.laws if law.owner == record.name]
        numbers = evaluate(substitute(substitute(found, scene.drawn_position), values), Floats, scene.sample)
        if not all(map(isfinite, numbers)):
            tension, = evaluate([values[unknown]], Floats, scene.sample)
            raise PhysicsError(
                f"the drawn position is in equilibrium with the tension {tension:.6g} {_unit(record)} of "
                f"'{record.name}', which its law does not rise to", "draw the position of equilibrium, or take a "
                "stronger law", record.place("preload"))


def _unit(record: "Record") -> str:
    return "N*m" if "torsion" in record else "N"


def _harmless(scene: "Scene", form: "Linearisation", unknowns: "Sequence[Node]", columns: "Sequence[Sequence[Node]]",
              rows: Sequence[int], picked: Sequence[int], free: int) -> None:
    """A tension which the conditions leave open must not change the stiffness."""
    names = [record.name for _, record in scene.static_preloads]
    if any("law" in record for _, record in scene.static_preloads):
        raise _open(scene, names, free)
    shares = solve_linear([[columns[j][i] for j in picked] + [-columns[free][i]] for i in rows], scene.table.zero)
    total = {}
    for j, share in [(free, scene.table.one), *zip(picked, shares, strict=True)]:
        for force, curvature, _ in form.curved:
            weight = _share(force, unknowns[j]) * share
            for pair, second in curvature.items():
                total.setdefault(pair, []).append(weight * second)
    for terms in total.values():
        values = evaluate(terms, Floats, scene.sample)
        if abs(sum(values)) > LOOSE * sum(map(abs, values)):
            raise _open(scene, names, free)


def _open(scene: "Scene", names: Iterable[str], free: int) -> PhysicsError:
    return PhysicsError(f"the conditions of equilibrium do not fix the preloads of {_listed(names)}, and the stiffness "
                        "depends on them", "give the tension of one of them: `preload: 20 N`",
                        scene.static_preloads[free][1].place("preload"))


def _listed(names: Iterable[str]) -> str:
    return " and ".join(f"'{name}'" for name in names)


def take_over(scene: "Scene", preloads: "Mapping[str, Node]") -> "Scene":
    """A variant of a scene with the static preloads {name: node} of the scene itself."""
    if not scene.static_preloads:
        return scene
    from vibcli.symbolic.transfer_between_tables import copied

    tensions = copied([preloads[record.name] for _, record in scene.static_preloads], scene.table)
    return scene.with_preloads(dict(zip([node for node, _ in scene.static_preloads], tensions, strict=True)))
