"""Accelerations from rest as drawn, and the forces of constraints and supports then, where no equilibrium is needed."""

from collections.abc import Iterator, Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NoEquilibrium, NotInLetters, PhysicsError
from vibcli.base.units import FORCE, TIME, times
from vibcli.notation.abbreviations import abbreviated
from vibcli.notation.numbers import with_minus, with_unit
from vibcli.report import blocks
from vibcli.report.blocks import Name, Section, Words, line, note, paragraph, section
from vibcli.report.keys import Key
from vibcli.report.sections.equations_of_motion import with_lengths
from vibcli.report.sections.numeric_equations import ROUNDING
from vibcli.report.sections.statics import SIGNS, normals_in_letters
from vibcli.report.sections.too_long import brief
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.report.blocks import Line
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

SOON = 1e-3             # seconds: as far as a motion is followed of which the start alone is asked
FORCES = "Forces then"
CONSTANT = "they stay so as long as all ropes pull and all contacts hold"


def accelerations(problem: "Problem", report: "Report") -> Iterator[Section]:
    """The accelerations and forces, where they are asked for or there is no equilibrium."""
    asked = "accelerations" in problem.spec.get("find", ())
    if not asked and not falls(problem):
        return
    try:
        found, forces = problem.symbolic.accelerations, problem.symbolic.forces_from_rest.values
    except NotInLetters:
        if not _from_drawn(problem):
            raise
        values, forces = _from_motion(problem)
        yield from section("Accelerations from rest as drawn", blocks.equations(
            line(Name(name + "''"), " = ", Words(_with_unit(problem, name + "''", value)))
            for name, value in values.items()))
        yield from section(FORCES, blocks.equations(
            line(Words(signal), " = ", Words(_with_unit(problem, signal, value))) for signal, value in forces.items()),
            note(SIGNS))
        return
    names = {name + "''": node for name, node in found.values.items()}
    lines, lengths = _lines(problem, report, names, {name: Name(name) for name in names})
    yield from section("Accelerations from rest as drawn", blocks.equations(lines), *with_lengths(lengths),
                       paragraph(CONSTANT) if found.constant else None)
    forces = {signal: node for signal, node in forces.items() if node is None or not node.is_zero}
    forces |= dict(normals_in_letters(problem, forces, {}))
    lines, lengths = _lines(problem, report, forces, {signal: Words(signal) for signal in forces})
    yield from section(FORCES, blocks.equations(lines), *with_lengths(lengths), note(SIGNS))


def falls(problem: "Problem") -> bool:
    """Is no equilibrium reached, as nothing holds the scene?"""
    if problem.scene.held or not problem.scene.q:
        return False
    if not problem.numeric.has_free_symbols:
        return problem.configuration.falls
    try:
        problem.symbolic.equilibrium_position  # noqa: B018
    except NoEquilibrium:
        return True
    except PhysicsError:
        return False
    return False


def _from_drawn(problem: "Problem") -> bool:
    """Does the motion of a scene in numbers start at rest as drawn?"""
    return not problem.numeric.has_free_symbols and problem.spec.get("initial") is None and falls(problem)


def _lines(problem: "Problem", report: "Report", nodes: "Mapping[str, Node]",
           labels: Mapping[str, Name | Words]) -> "tuple[list[Line], list[Any]]":
    """Lines `label = expression = number`, and the symbols for lengths in them."""
    known = {key: node for key, node in nodes.items() if node is not None}
    shown, lengths = abbreviated(list(known.values()), report.roots)
    shown = dict(zip(known, shown, strict=True))
    numbers = {}
    if not problem.numeric.has_free_symbols:
        numbers = dict(zip(known, evaluate(list(known.values()), Floats, problem.numeric.floats), strict=True))
    lines = []
    for key in nodes:
        if key not in known:
            lines.append(line(labels[key], "   ", Words("not fixed by statics")))
            continue
        value = [Words(_with_unit(problem, key, numbers[key]))] if key in numbers else []
        letters = [brief(shown[key])] if not value or shown[key].op != "number" else []
        lines.append(line(labels[key], *(part for said in letters + value for part in (" = ", said))))
    return lines, lengths


def _with_unit(problem: "Problem", key: str, value: float) -> str:
    """An acceleration x'' or a force with its unit."""
    from vibcli.language.signals import signal_dimension

    if not key.endswith("''"):
        return with_unit(value, signal_dimension(problem.spec, key) or FORCE)
    dimension = problem.system.dimension(key[:-2])
    return with_unit(value, times(dimension, TIME, -2)) if dimension else f"{with_minus(value)} rad/s²"


def _from_motion(problem: "Problem") -> tuple[dict[str, float], dict[str, float]]:
    """({coordinate: acceleration}, {signal: force but for those that are zero}) in numbers at the start of the motion
    that begins as drawn."""
    import numpy as np

    from vibcli.mechanics.inputs_outputs.reactions import Released
    from vibcli.results.full_response import FullResponse

    motion, released, scene = FullResponse(problem.until(SOON)), Released(problem.numeric), problem.scene

    def value(node: "Node", forces: "dict[str, str]") -> float:
        return float(motion.signal_of(node, forces).values(np.zeros(1))[0])

    accelerations, forces = {name: value(scene.symbol(name, 2), {}) for name in problem.spec.coordinates}, {}
    for signal in (*(tie.signal for tie in released.scene.constraints), *(q.name for q in released.held)):
        symbol = scene.table.variable("force " + signal)
        with suppress(PhysicsError):        # what rigid bodies alone leave open
            forces[signal] = value(symbol, {symbol.name: signal})
    size = max(map(abs, forces.values()), default=0.0)
    return accelerations, {signal: force for signal, force in forces.items() if abs(force) > ROUNDING * size}


def _values(problem: "Problem") -> "dict[str, bool | dict[str, float | Node] | None]":
    try:
        problem.symbolic.accelerations  # noqa: B018
    except NotInLetters:
        if not _from_drawn(problem):
            raise
        values, forces = _from_motion(problem)
        return ACCELERATIONS.row(values, None, forces)
    return ACCELERATIONS.row(problem.symbolic.accelerations.values, problem.symbolic.accelerations.constant,
                             problem.symbolic.forces_from_rest.values)


ACCELERATIONS = Key("accelerations", "from rest as drawn, with `find: [accelerations]` and where no equilibrium is "
                    "reached: expressions, where friction decides numbers", _values, of=(
    Key("values", "{coordinate: acceleration}"),
    Key("constant", "do they stay so as long as ropes and contacts hold? null where friction decides"),
    Key("forces", "{signal: force of a constraint or support then}; null where rigid bodies alone leave it open")))
