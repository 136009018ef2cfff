"""Natural frequencies, damping and mode shapes."""

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from vibcli.analyses.modal.normalisation import words
from vibcli.base.errors import Inertless
from vibcli.mechanics.factored_system import MOST_DENSE
from vibcli.report.blocks import Section, TableBlock, equations, line, note, paragraph, section, without_empty
from vibcli.report.sections.mode_tables import damped_row, mode_row, polar, repeated, shapes, shapes_told
from vibcli.report.sections.shown_modes import in_letters, shown, shown_damped

if TYPE_CHECKING:
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.report.blocks import Equations, Paragraph
    from vibcli.report.document import Report
    from vibcli.report.own_letters import OwnLetters
    from vibcli.results.problem import Problem

OF_DAMPED = "with the eigenvalue λ: ω = |λ|, ζ = −Re λ/|λ|, decay −Re λ = ζω, logarithmic decrement 2πζ/√(1−ζ²)"
OF_OVERDAMPED = "; with the two of an over-damped mode ω = √(λ₁λ₂), ζ = −(λ₁ + λ₂)/(2ω)"


def frequencies(problem: "Problem", report: "Report") -> Iterator[Section]:
    if problem.numeric.has_free_symbols:
        yield from _frequencies_in_letters(problem, report)
        return
    if not problem.modal.modes:
        why = problem.configuration.linear_system.why_modeless
        yield from section("Natural frequencies", paragraph("none are told: " + why))
        return
    modal = problem.modal
    found = shown(problem, report.wanted)
    before = [modal.modes.alone(found[0].index - 1)] if found and found[0].index > 1 and not modal.modes.finite else []
    same = repeated([*before, *found])
    zero = modal.zero_modes
    if problem.scene.pieces:
        from vibcli.analyses.modal.modes import chosen_at_limit

        zero = dict.fromkeys(zero, "held") if chosen_at_limit(problem.spec) else zero
    rows = [mode_row(mode, zero.get(mode.index), same.get(mode.index, "")) for mode in found]
    head = ("mode", "ω [rad/s]", "f [Hz]", "T [s]", "relative error ≤", "")
    doubts = [] if report.tells("Equilibrium") else list(map(paragraph, _doubts(problem)))
    if problem.scene.pieces and not modal.modes.finite:
        yield from _of_members(problem, found, head, rows, doubts)
        return
    damped = "of the undamped system" if (modal.damps if modal.many else modal.damped) else "undamped"
    yield from section(f"Natural frequencies ({damped})", without_empty(TableBlock(head, tuple(rows)), "–"),
                       _form(problem),
                       _counted(problem, found), *doubts)


def _doubts(problem: "Problem") -> list[str]:
    """What makes the theory of members doubtful, where no equilibrium is told that says it."""
    if not problem.scene.members:
        return []
    from vibcli.mechanics.member_warnings import member_warnings

    return member_warnings(problem.configuration)


def _letters(problem: "Problem") -> "OwnLetters":
    from vibcli.report.own_letters import own_letters

    return own_letters(problem.scene)


def _counted(problem: "Problem", found: "Sequence[Mode]") -> "Paragraph | None":
    """The proof that none is missing: the count just above the last frequency."""
    from vibcli.notation.names import lowered

    modes, last = problem.modal.modes, found[-1]
    if not last.omega:
        return None
    count = modes.counted_above(last)
    if count is None or count < last.index:
        return None
    close = "".join(f" ≈ ω{lowered(number)}" for number in range(last.index + 1, count + 1))
    told = _letters(problem).text
    frequencies = f"ω{lowered(last.index)}{close}"
    frequencies = told(frequencies) if problem.scene.pieces else frequencies
    counted = f"J = {count}" if told("J") == "J" else f"{count} lie up to"
    return paragraph(f"{counted} just above {frequencies}: none is missing")


def _of_members(problem: "Problem", found: "list[Mode]", head: tuple[str, str, str, str, str, str],
                rows: Sequence[tuple[str, ...]], doubts: "Sequence[Paragraph]") -> Iterator[Section]:
    """The table of those without end, with wave numbers and the count that proves it complete."""
    from vibcli.report.sections.wave_numbers import wave_numbers

    columns, definition = wave_numbers(problem, found)
    head = (head[0], *(one for one, _ in columns), *map(_letters(problem).text, head[1:]))
    rows = [(row[0], *beta, *row[1:]) for row, *beta in zip(rows, *(told for _, told in columns), strict=True)]
    yield from section(f"Natural frequencies ({'of the undamped system' if problem.modal.damps else 'undamped'})",
                       without_empty(TableBlock(head, tuple(rows)), "–"), definition,
                       _counted(problem, found), *doubts)


def _form(problem: "Problem") -> "Equations | None":
    """The closed form of the frequency of one degree of freedom, if it is readable."""
    if len(problem.scene.coordinates) == 1 and problem.symbolic.linearisable and problem.modal.modes[0].omega:
        form = problem.closed_forms
        if form is not None and form.modes[0].short:
            return equations([line("ω = ", form.modes[0].omega, hang=None)])
    return None


def _frequencies_in_letters(problem: "Problem", report: "Report") -> Iterator[Section]:
    from vibcli.notation.names import lowered
    from vibcli.report.own_letters import of_oscillators
    from vibcli.report.sections.symbolic_modes import damping_blocks, frequency_blocks

    problem.symbolic.equilibrium_position  # noqa: B018, refused where there is none
    if problem.scene.pieces:
        from vibcli.report.sections.frequency_equation import frequency_equation

        known = any(one.title.startswith("Frequency equation") for one in report.sections)
        told = [] if known else list(frequency_equation(problem, report))
        yield from told
        forms = problem.closed_forms
        if forms is not None:
            yield from section("Natural frequencies [rad/s]", equations(_letters(problem).lines(
                line(f"ω{lowered(mode.index)} = ", mode.omega) for mode in in_letters(problem, report.wanted, forms))))
            return
        yield from section("Natural frequencies", paragraph(
            ("numbers: the roots of the frequency equations; " if known or told else
             "no frequency equation is found in letters; ") + "give the parameters values with --set"))
        return
    M, C, _, K = problem.symbolic.matrices
    if not M and not C:
        raise Inertless
    if len(problem.scene.q) == 1 and not M and C and K:
        yield from section("Relaxation", equations([line("λ = ", -(K[0, 0] / C[0, 0]))]))
        return
    forms = problem.closed_forms
    yield from section("Natural frequencies [rad/s]", *of_oscillators(problem.scene, frequency_blocks(problem, forms)))
    yield from section("Damping", *of_oscillators(problem.scene, damping_blocks(forms)))


def damping(problem: "Problem", report: "Report") -> Iterator[Section]:
    if problem.numeric.has_free_symbols or not _damps(problem):
        return
    if problem.modal.many:
        yield from section("Damped modes", paragraph(f"not found of more than {MOST_DENSE} coordinates"))
        return
    head = ("mode", "ω [rad/s]", "ζ", "ω_d [rad/s]", "f_d [Hz]", "T_d [s]", "decay [1/s]", "relative error ≤", "")
    found = shown_damped(problem, report.wanted)
    ended = _none_comes_back(problem) if problem.scene.pieces and problem.modal.damped.finite else None
    if ended is not None and not found:
        yield from section("Damped modes", paragraph(f"none: {ended}"))
        return
    if not found and problem.configuration.rated_beside_dampers:
        yield from section("Damped modes", paragraph("not found where these ratios of modes stand beside dampers"))
        return
    told = _letters(problem).text if problem.scene.pieces else str
    table = TableBlock(tuple(map(told, head)), tuple(dict.fromkeys(map(damped_row, found))))     # λ that is double once
    yield from section("Damped modes", without_empty(table, "–"), paragraph(
        f"no other: {ended}") if ended else _proved(problem.modal.damped, found, told), note(told(
            OF_DAMPED + OF_OVERDAMPED * any(one.zeta is not None and one.zeta > 1 for one in found))))


def _damps(problem: "Problem") -> bool:
    return problem.modal.damps if problem.modal.many else problem.modal.damped is not None


def _proved(modes: "Modes", found: "list[DampedMode]",
            in_letters: Callable[[str], str] | type[str]) -> "Paragraph | None":
    """What the argument principle counts; None where the modes are a list."""
    region = modes.proof(found)
    if region is None:
        return None
    size = in_letters("|λ|")
    told = f"{region.count} eigenvalues, conjugates counted, have {size} < {region.radius:.8g} 1/s"
    if region.below:
        told += f", {region.below} of them {size} < {region.inner:.8g} 1/s"
    rest = "" if any(mode.eigenvalue.real for mode in found) else "; nothing damps those above"
    rest = "; whether more grow is left open" if found[-1].growth_rate is not None else rest
    return paragraph(f"{told}, by the argument principle: none is missing{rest}")


def _none_comes_back(problem: "Problem") -> str | None:
    """Why there is no damped mode, or none but one at rest; None where that is not so."""
    from vibcli.analyses.continuous.matched_damper import dies_after

    ended = dies_after(problem.configuration.linear_system)
    letters = "" if {"L", "c0"} & problem.scene.parameters.nodes.keys() else "2L/c₀ = "
    return None if ended is None else (
        f"a wave that arrives at the damper dies; what moves freely has ended after {letters}{ended:.6g} s, in which a "
        "wave runs twice along it")


def modes(problem: "Problem", report: "Report") -> Iterator[Section]:
    names = problem.scene.coordinates
    if len(names) < 2 and not problem.scene.pieces:
        if "modes" in (problem.spec.get("find") or ()):
            yield from _of_one(problem)
        return
    if problem.numeric.has_free_symbols:
        from vibcli.report.own_letters import of_oscillators
        from vibcli.report.sections.symbolic_modes import shape_blocks

        if problem.scene.pieces:        # shapes stand below the frequency equation
            return
        if problem.closed_forms is not None:
            told = of_oscillators(problem.scene, shape_blocks(problem, names, problem.closed_forms))
            yield from section("Mode shapes", *told, note(words("first")))
        return
    members, found = problem.spec.members, shown(problem, report.wanted)
    if found and names:
        yield from _shapes(problem, report, found, "Mode shapes", words(report.normalise, members))
    if found and problem.scene.pieces and not problem.modal.modes.finite:
        from vibcli.report.sections.member_modes import along_members

        yield from along_members(problem, found, report.normalise)
    if not problem.modal.many and problem.modal.damped is not None:
        damped = shown_damped(problem, report.wanted)
        one_each = {mode.index: mode for mode in reversed(damped)}       # two eigenvalues have one shape
        yield from _shapes(problem, report, [one_each[i] for i in sorted(one_each)],
                           "Shapes of the damped modes", words(report.normalise, members, damped=True),
                           only_complex=True)


def _of_one(problem: "Problem") -> Iterator[Section]:
    """What is said where shapes are asked of one coordinate, or of what is driven alone, which has no frequency."""
    if not problem.scene.coordinates:
        raise problem.symbolic.equations.refusal
    yield from section("Mode shapes", paragraph("of one coordinate there is one mode, in which it moves by itself"))


def _shapes(problem: "Problem", report: "Report", modes: "Sequence[DampedMode | Mode]", title: str, normalised: str,
            only_complex: bool = False) -> Iterator[Section]:
    names = problem.scene.coordinates
    found = [problem.modal.shape(mode, report.normalise) for mode in modes[:shapes_told(len(modes))]]
    out_of_phase = any(abs(complex(value).imag) > 1e-9 * abs(value) for shape in found for value in shape)
    numbers = [mode.index for mode in modes]
    if out_of_phase:
        yield from section(title, *shapes(names, numbers, found, polar), note(f"amplitude ∠ phase; {normalised}"))
    elif not only_complex:
        yield from section(title, *shapes(names, numbers, found), note(normalised))
