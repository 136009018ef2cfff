"""Loads of one frequency as one: A sin(Ωt + φ) + B cos(Ωt + φ) of several phases φ is

    Σ (A cos φ − B sin φ) sin Ωt + (A sin φ + B cos φ) cos Ωt,   as those of axles that lag behind one another are.
"""

from typing import TYPE_CHECKING

from vibcli.report.steps.small import AboutRest
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.symbolic.node import Node

    Loads = dict[int, dict[str, Node]]
    Waves = Mapping[tuple[Node, str], Node]


def by_frequency(about: AboutRest, acting: "Mapping[int, Waves]") -> "list[tuple[Node, Loads]]":
    """[(Ωt + φ, {row: {sin or cos: factor}})] of {row: {(argument, sin or cos): factor}}: a frequency once, none
    negative; with φ where all loads of the frequency share it."""
    found: list[tuple[Node, Loads]] = []
    for i, parts in acting.items():
        for (argument, wave), node in parts.items():
            argument, node = _forwards(about, argument, wave, node)
            loads = next((loads for one, loads in found if one is argument), None)
            if loads is None:
                found.append((argument, loads := {}))
            row = loads.setdefault(i, {})
            row[wave] = row.get(wave, about.table.zero) + node
    groups: list[list[tuple[Node, Loads]]] = []
    for argument, loads in found:
        group = next((group for group in groups if is_zero(_rate(about, group[0][0]) - _rate(about, argument))), None)
        groups.append([(argument, loads)]) if group is None else group.append((argument, loads))
    return [group[0] if len(group) == 1 else _together(about, group) for group in groups]


def _rate(about, argument):
    return gradient(argument)[about.scene.time]


def _forwards(about, argument, wave, node):
    """An argument that grows with the time, and the factor of its wave."""
    rate = _rate(about, argument)
    value = about.value(rate)
    backwards = value < 0 if value is not None else about.table.is_positive(textbook(-rate))
    return (textbook(-argument), -node if wave == "sin" else node) if backwards else (argument, node)


def _together(about, group):
    """Loads of several phases by sin Ωt and cos Ωt."""
    table, rate = about.table, _rate(about, group[0][0])
    sums: Loads = {}
    for argument, loads in group:
        phase = textbook(argument - rate * about.scene.time)
        cosine, sine = table.call("cos", phase), table.call("sin", phase)
        for i, waves in loads.items():
            A, B = (waves.get(wave, table.zero) for wave in ("sin", "cos"))
            row = sums.setdefault(i, {"sin": table.zero, "cos": table.zero})
            row["sin"] += A * cosine - B * sine
            row["cos"] += A * sine + B * cosine
    told = {i: {wave: textbook(node) for wave, node in row.items() if not is_zero(node)} for i, row in sums.items()}
    return rate * about.scene.time, {i: row for i, row in told.items() if row}
