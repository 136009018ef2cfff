"""The steady state of a scene that something drives to and fro, told without being asked for."""

from collections.abc import Iterator, Sequence
from math import tau
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Name, Section, TableBlock, equations, line, maths, section
from vibcli.report.sections.requested_signals import signals_asked, symbol
from vibcli.report.sections.symbolic_response import ratio_lines

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.report.sections.requested_signals import RequestedSignal
    from vibcli.results.problem import Problem

ENDING = {"step", "ramp", "impulse"}        # what does not go on to and fro


def kept_up(problem: "Problem", report: "Report") -> Iterator[Section]:
    """Nothing where there is no such steady state of small oscillations."""
    scene = problem.scene
    if not scene.timed or scene.pieces or problem.spec.in_full or scene.table.records or scene.table.called & ENDING:
        return
    try:
        found = list(_in_letters(problem) if problem.numeric.has_free_symbols else _in_numbers(problem, report))
    except PhysicsError:
        return
    yield from found


def _in_numbers(problem: "Problem", report: "Report") -> Iterator[Section]:
    from vibcli.report.sections.steady_state import steady_state

    motion = problem.response
    if motion.KIND == "small" and motion.drive:
        asked = signals_asked(problem)
        for one in steady_state(asked, report.wanted.phase):
            if any(isinstance(block, TableBlock) for block in one.blocks):
                yield one
        yield from _transmissibility(problem, asked)


def _base(problem: "Problem") -> str | None:
    """The one place or body that moves the scene where nothing else does; None of others."""
    from vibcli.quantities.signal_dimensions import inputs

    spec, scene = problem.spec, problem.scene
    bases = [name for name in inputs(spec) if name not in spec.coordinates and name not in (spec.get("forces") or {})]
    loaded = any(term.force(scene).mask & scene.time.mask for term in scene.forces)
    return bases[0] if len(bases) == len(scene.driven) == 1 and not loaded else None


def _moved_alike(problem: "Problem", base: str) -> list[str]:
    """The coordinates that are displacements as that of the base is."""
    from vibcli.quantities.signal_dimensions import input_dimension

    moved = input_dimension(problem.spec, base)
    return [name for name in problem.scene.coordinates if problem.system.dimension(name) == moved]


def _transmissibility(problem: "Problem", asked: "Sequence[RequestedSignal]") -> Iterator[Section]:
    """|X/U| of each displacement where one base moves by U to and fro."""
    from vibcli.report.sections.steady_state import harmonics_of

    base, rows = _base(problem), []
    names = _moved_alike(problem, base) if base else ()
    for one in asked:
        for Omega, X, _ in harmonics_of(one.signal) if one.text in names else ():
            if Omega and X:
                value, error = problem.frequency_response(one.text, base).at(Omega)
                rows.append((maths(Name(one.text)), figure(Omega), figure(Omega / tau), figure(abs(value), error)))
    yield from section(f"Transmissibility, of what '{base}' moves by",
                       TableBlock(("", "Ω [rad/s]", "f [Hz]", "|X/U|"), tuple(rows)) if rows else None)


def _transmissibility_in_letters(problem: "Problem") -> Iterator[Section]:
    base = _base(problem)
    lines = []
    for name in _moved_alike(problem, base) if base else ():
        formula = problem.symbolic_frequency_response(name, base, problem.symbolic_steady_state(name).formula.Omega)
        ratio = f"{symbol(name)}/U" if formula.undamped else f"|{symbol(name)}/U|"
        lines += [line(f"{ratio} = ", formula.amplitude), *ratio_lines(problem, formula, ratio)]
    yield from section(f"Transmissibility, of what '{base}' moves by", equations(lines))


def _in_letters(problem: "Problem") -> Iterator[Section]:
    from vibcli.report.sections.symbolic_response import steady_section

    names = problem.scene.coordinates
    for number, name in enumerate(names, 1):
        yield from steady_section(problem, name, problem.symbolic_steady_state(name), str(number) * (len(names) > 1))
    yield from _transmissibility_in_letters(problem)
