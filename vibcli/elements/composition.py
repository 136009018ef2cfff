"""Springs, or dampers, made of parts in series and in parallel, nested: force and energy as functions of the deflection
x of the whole (of dampers its rate), and the deflections of the parts.

In parallel the forces add up. In series Σ dᵢ = x at one force:  k = 1/Σ 1/kᵢ;  of powers c |d|ⁿ sign d with one n
c = (Σ cᵢ^(−1/n))^(−n);  of N equal laws F(x/N);  of others the inner equilibrium is solved where it is asked for.
"""

from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.elements.faults_in_series import not_in_series
from vibcli.elements.force_laws import force_and_energy
from vibcli.elements.series import KEYS
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import evaluable
from vibcli.symbolic.power_law import power_of
from vibcli.symbolic.rationals import HALF
from vibcli.symbolic.rising import rises_where
from vibcli.symbolic.series_of_laws import PartLaw, SeriesOfLaws

if TYPE_CHECKING:
    from collections.abc import Sequence
    from fractions import Fraction

    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node


class Component(NamedTuple):
    """The force and the energy of a part as functions of its deflection; `inner`: [(deflection as a function of that,
    Component)] of its own parts; `shared`: do these share the force, being in series?"""

    force: "Node"
    energy: "Node"
    inner: "tuple[tuple[Node, Component], ...]" = ()
    shared: bool = False


class Group(NamedTuple):
    """Parts in series that are one in closed form: its PartLaw, and the share of its deflection that each has, as
    [(number of the part, share)]."""

    law: PartLaw
    shares: "list[tuple[int, Node]]"


def composed(record: "Record", scene: "Builder", x: "Node", name: str) -> Component | None:
    """What a record with `series` or `parallel` is, or one of its parts; None where it was reported as wrong."""
    for key in KEYS:
        if key in record:
            parts = [composed(part, scene, x, f"{name}.{i + 1}") for i, part in enumerate(record[key])]
            if any(part is None for part in parts):
                return None
            if key == "parallel":
                return _in_parallel(parts, x)
            return _in_series(parts, record[key], scene, x, name)
    if "law" in record:
        local = "v" if "c" in record.element.fields else "d"
        found = force_and_energy(record, scene, local, x, name)
        return None if found is None else Component(*found)
    key = next(key for key in ("k", "c", "torsion") if key in record)
    k = scene.positive(record[key], f"'{key}' of a part of '{name.partition('.')[0]}'")
    if not scene.number(k) > 0:
        return None
    return Component(k * x, k * x * x * HALF)


def stiffness(part: Component, x: "Node") -> "Node | None":
    """k of a part with F = k x; None of others."""
    power = power_of(part.force, x)
    return power[0] if power is not None and power[1] == 1 else None


def _in_parallel(parts: "Sequence[Component]", x: "Node") -> Component:
    """One Component of several side by side; of powers with one exponent it is one again."""
    force, energy = (x.table.total(column) for column in zip(*(part[:2] for part in parts), strict=True))
    powers = [power_of(part.force, x) for part in parts]
    if all(power is not None and power[1] == powers[0][1] for power in powers):
        share = x.table.total([power[0] for power in powers]) / powers[0][0]
        force, energy = parts[0].force * share, parts[0].energy * share
    return Component(force, energy, tuple((x, part) for part in parts))


def _in_series(parts: "Sequence[Component]", records: "Sequence[Record]", scene: "Builder", x: "Node",
               name: str) -> Component | None:
    """One Component of several in series."""
    positive: list[Any] | None = []
    for part, record in zip(parts, records, strict=True):
        found = rises_where(part.force, x)
        rises = found is not None and all(scene.number(node) > 0 for node in found)
        fault = not_in_series(part.force, x, scene)
        if fault is not None:
            where = record["law"].where if "law" in record else record.where
            scene.report(where, f"this part of '{name}' in series {fault.what}", fault.hint)
            return None
        positive = positive + found if rises and positive is not None else None
    groups = _groups(parts, x)
    if len(groups) == 1:
        law, shifts = groups[0].law, [x]
    else:
        unit = ("rad" if "torsion" in records[0] else "m") + ("/s" if "c" in records[0].element.fields else "")
        law, shifts = _solved(groups, x, name, positive, unit)
    inner = {i: shift * share for group, shift in zip(groups, shifts, strict=True) for i, share in group.shares}
    return Component(*law, tuple((inner[i], part) for i, part in enumerate(parts)), True)


def _solved(groups: list[Group], x: "Node", name: str, positive: "list[Node] | None",
            unit: str) -> "tuple[PartLaw, list[Node]]":
    """(PartLaw, deflections of the groups) by inner equilibrium."""
    nodes = [node for group in groups for node in group.law] + (positive or [])
    definitions = x.table.definitions
    symbols = [part for part in evaluable(nodes) if part.op == "symbol" and part is not x and part not in definitions]
    series = SeriesOfLaws(name, [group.law for group in groups], x, symbols, positive, unit)
    law = PartLaw(series.called("force", x, symbols), series.called("energy", x, symbols))
    return law, [series.called(i + 1, x, symbols) for i in range(len(groups))]


def _groups(parts: "Sequence[Component]", x: "Node") -> list[Group]:
    """Powers with one exponent, and equal laws, taken together."""
    alike: dict[Any, list[int]] = {}
    powers = [power_of(part.force, x) for part in parts]
    for i, part in enumerate(parts):
        alike.setdefault(part.force if powers[i] is None else powers[i][1], []).append(i)
    return [_power(parts, powers, numbers) if powers[numbers[0]] else _equal(parts, numbers, x)
            for numbers in alike.values()]


def _power(parts: "Sequence[Component]", powers: "Sequence[tuple[Node, Fraction] | None]", numbers: list[int]) -> Group:
    """Of c |d|ⁿ sign d with one n."""
    first, n = parts[numbers[0]], powers[numbers[0]][1]
    factors = [powers[i][0] for i in numbers]
    table = factors[0].table
    whole = factors[0] if len(factors) == 1 else table.power(table.total([table.power(c, -1 / n) for c in factors]), -n)
    law = PartLaw(first.force * whole / factors[0], first.energy * whole / factors[0])
    return Group(law, [(i, table.power(whole / c, 1 / n)) for i, c in zip(numbers, factors, strict=True)])


def _equal(parts: "Sequence[Component]", numbers: list[int], x: "Node") -> Group:
    """N times F at x/N."""
    table, count = x.table, len(numbers)
    force, energy = substitute(parts[numbers[0]][:2], {x: x / count}) if count > 1 else parts[numbers[0]][:2]
    return Group(PartLaw(force, energy * count), [(i, 1 / table.number(count)) for i in numbers])


def inner_deflections(component: Component, x: "Node", path: str = "") -> "list[tuple[str, Node]]":
    """[(number of a part, 2 or 3.1 of nested ones, its deflection as a function of x)]."""
    found = []
    for i, (own, part) in enumerate(component.inner):
        found.append((f"{path}{i + 1}", own))
        below = inner_deflections(part, x, f"{path}{i + 1}.")
        found += [(number, node) for (number, _), node in zip(
            below, substitute([node for _, node in below], {x: own}), strict=True)]
    return found


def deflection_under(record: "Record", scene: "Builder", component: Component, x: "Node",
                     tension: "Node") -> "Node | None":
    """The deflection at which a spring has a tension, of parts in series the sum of theirs; None where it is not found,
    which is reported."""
    from vibcli.elements.preloaded_law import undeformed

    if not component.shared or stiffness(component, x) is not None:
        return undeformed(record, scene, component.force, x, tension)
    found = [deflection_under(record, scene, part, x, tension) for _, part in component.inner]
    return None if any(node is None for node in found) else scene.table.total(found)
