"""The equilibrium that is reached from the drawn position."""

from collections.abc import Iterator, Mapping
from math import inf, isfinite
from typing import TYPE_CHECKING, Any

from vibcli.base.enumeration import listed
from vibcli.base.errors import Kinked, PhysicsError
from vibcli.notation.numbers import figure, quantity, with_minus
from vibcli.report.blocks import Name, Paragraph, Section, Words, equations, line, maths, paragraph, section, separated
from vibcli.report.keys import Key
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.mechanics.equilibrium.dry_friction import Span
    from vibcli.mechanics.equilibrium.equilibrium import Equilibrium
    from vibcli.report.blocks import Maths
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

MANY = 12       # values told of very many


def equilibrium(problem: "Problem", _: "Report") -> Iterator[Section]:
    try:
        blocks = _in_letters(problem) if problem.numeric.has_free_symbols else _in_numbers(problem)
    except PhysicsError:
        if problem.system.sticking is None:
            raise
        blocks = []
    if problem.system.sticking is not None:
        blocks = [*blocks, *held(problem)]
    preloads = equations(line(Words(f"static preload of {name}: "), *_preload(problem, node, name), hang=None)
                         for name, node in problem.system.preloads.items())
    slack = [] if problem.numeric.has_free_symbols else slack_ropes(problem)
    yield from section("Equilibrium", *blocks, preloads, *slack)


def _in_numbers(problem: "Problem") -> list[Paragraph | None]:
    from vibcli.analyses.modal.bifurcation_distance import bifurcation_warning, stiffness_condition
    from vibcli.analyses.modal.stability import WORDS

    found = problem.configuration.equilibrium
    try:
        stable = WORDS[problem.modal.stability.kind]
    except Kinked:
        stable = "a kink: no small oscillations about it" if found.jumps is None else (
            "a kink: a force jumps there, between whose sides the others are balanced; no small oscillations about it")
    dependent = problem.configuration.dependent_values
    values = [*found.values.items(), *((name, dependent[name]) for name in dependent if name not in found.values)]
    told = separated(maths(Name(name), " = ", *measured(value, problem.system.dimension(name)))
                     for name, value in values[:MANY if problem.modal.many else None])
    if problem.modal.many:
        told = [*told, f", … ({len(values)} in all)"]
    stays = found.drawn or (found.jumps and found.values == problem.numeric.drawn_floats)
    where = "the drawn position" if stays else "shifted from the drawn position"
    bent = [name for name, member in problem.scene.members.items() if stays and member.loaded_along(problem.scene)]
    if bent:
        where += f"; {listed(bent)} {'deflects' if len(bent) == 1 else 'deflect'} from it under what acts along"
    warning = None if stable.startswith("a kink") else bifurcation_warning(stiffness_condition(problem.modal))
    where += "; without friction" if problem.system.sticking is not None else ""
    return [paragraph(*told, f"   ({where})"), _from_start(problem),
            paragraph(f"{stable}; {_balanced(found.residual)}", hang=None),
            *_jumping(found), paragraph(warning) if warning else None, *map(paragraph, _of_members(problem))]


def _jumping(found: "Equilibrium") -> Iterator[Paragraph]:
    """What stands for the jumps in the balance of forces."""
    for node, value in found.jumps.senses.items() if found.jumps else ():
        yield paragraph("balanced with ", maths(node), " = " + with_minus(value), hang=None)


def _of_members(problem: "Problem") -> list[str]:
    """What makes the theory of members doubtful; nothing without members."""
    if not problem.scene.members or problem.numeric.has_free_symbols:
        return []
    from vibcli.mechanics.member_warnings import member_warnings

    return member_warnings(problem.configuration)


def _balanced(residual: float) -> str:
    """How well the forces balance."""
    if not residual:
        return "the forces balance exactly"
    return f"what is left of the forces is {figure(residual, digits=2)} of their terms"


def held(problem: "Problem") -> Iterator[Any]:
    """Where dry friction holds the scene."""
    from vibcli.mechanics.equilibrium.dry_friction import span

    found, table = problem.system.sticking, problem.scene.table
    lines = []
    for row in found.rows:
        if row.within is not None:
            lines.append(line(table.call("abs", row.b), " ≤ ", row.within, label=Name(row.name)))
        else:
            node = table.sum((row.b, ONE), *((a * sigma, ONE) for sigma, a in row.held.items()))
            lines.append(line(node, " = 0", label=Name(row.name)))
    free = {sigma for row in found.rows if row.within is None for sigma in row.held}
    told = [maths("|", sigma, "| ≤ ", bound) for sigma, bound in found.bounds.items() if sigma in free]
    yield paragraph("at rest wherever friction holds it:")
    yield equations(lines)
    if told:
        yield paragraph("with ", *separated(told), hang=4)
    ends = None if problem.numeric.has_free_symbols else span(problem.configuration, found)
    if ends is not None and (told := _span(problem, ends)):
        yield paragraph(*told)


def _span(problem: "Problem", ends: "Span") -> "list[Maths | str]":
    """Words on a Span of places of rest."""
    name, (low, high, whole) = problem.scene.coordinates[0], ends
    if not isfinite(low) and not isfinite(high):
        return ["there is no such place" if low > high else "which is anywhere"] if whole else []
    told = [part for word, end in ((" from ", low), (" to ", high)) if isfinite(end)
            for part in (word, *measured(end, problem.system.dimension(name)))]
    return ["which is " if whole else "one such stretch is ", maths(Name(name), *told)]


def _from_start(problem: "Problem") -> Paragraph | None:
    """How far an equilibrium lies from the start that `equilibrium:` names, None where it names none."""
    found = problem.configuration.equilibrium
    if found.start is None:
        return None
    def told(values: "Mapping[str, float]", sign: str = "") -> "list[str | Maths]":
        return separated(maths(sign, Name(name), " = ", *measured(values[name], problem.system.dimension(name)))
                         for name in problem.scene.coordinates)

    return paragraph("the nearest found to the start ", *told(found.start), ", from there ",
                     *told(found.from_start, "Δ"), hang=None)


def _in_letters(problem: "Problem") -> list[Paragraph | None]:
    from vibcli.report.sections.symbolic_modes import equilibrium_parts

    parts = equilibrium_parts(problem.symbolic.equilibrium_position)
    settled = problem.symbolic.equilibrium
    drawn = problem.symbolic.balanced_as_drawn and problem.symbolic.start is None
    searched = settled is not None and problem.symbolic.start is not None and not settled.named
    return [paragraph(*parts, "   (the drawn position)" if drawn else ""),
            paragraph("the nearest to the start at sample values of the letters", hang=None) if searched else None]


def measured(value: float, dimension: "Mapping[str, Fraction | int]") -> tuple[str, Words]:
    """Parts of a number with its unit."""
    number, unit = quantity(value, dimension)
    return number, Words(unit)


def _preload(problem: "Problem", node: "Node", name: str) -> "tuple[Node | str | Words, ...]":
    if problem.numeric.has_free_symbols:
        return (node,)
    from vibcli.symbolic.evaluation import Floats, evaluate

    unit = "N·m" if "torsion" in problem.spec.get("springs")[name] else "N"
    return node, " = ", figure(evaluate([node], Floats, problem.numeric.floats)[0]), Words(f" {unit}")


def slack_ropes(problem: "Problem") -> list[Paragraph]:
    """What pushes where only a rope could pull."""
    if not any("rope" in record for record in (problem.spec.get("constraints") or {}).values()):
        return []
    from vibcli.mechanics.inputs_outputs.reactions import slack

    return [paragraph(f"{signal} = {with_minus(value)} N would be a push: the rope goes slack", hang=None)
            for signal, value in slack(problem.configuration.reactions)]


def _data(problem: "Problem") -> "dict[str, dict[str, float | Node] | float | list[Any] | None]":
    if problem.numeric.has_free_symbols:
        return EQUILIBRIUM.row(problem.symbolic.equilibrium_position, problem.scene.dependent, *[None] * 5, [])
    from vibcli.analyses.modal.bifurcation_distance import bifurcation_warning, stiffness_condition

    found = problem.configuration.equilibrium
    condition, stable = (None, None) if found.jumps else (
        stiffness_condition(problem.modal), problem.modal.stability.stable)
    values, moved = ({name: of[name] for name in problem.scene.coordinates} if of else of
                     for of in (found.values, found.from_start))
    return EQUILIBRIUM.row(values, problem.configuration.dependent_values, moved, stable, found.residual,
                           condition, condition and bifurcation_warning(condition), _of_members(problem))


EQUILIBRIUM = Key("equilibrium", "the equilibrium reached from the drawn position, or nearest to the place that "
                  "`equilibrium:` names", _data, of=(
    Key("coordinates", "{name: value}"),
    Key("dependent", "{name: value} of the coordinates that constraints tie to the others, as functions of them where "
        "symbols have no value"),
    Key("from_start", "{name: how far it lies from the start that `equilibrium:` names}; null where none is named and "
        "in letters"),
    Key("stable", "true or false (motion that costs no energy counts as stable); null where symbols leave it open, "
        "masses that the scene does not give would decide, or a force jumps there"),
    Key("residual", "what is left of the forces, relative to the sum of the magnitudes of their terms"),
    Key("condition", "by which factor a relative change of the data grows in a frequency squared; null in letters, and "
        "where nothing has inertia"),
    Key("warning", "a sentence where the equilibrium is near a bifurcation, else null"),
    Key("of_members", "sentences: of thick beams, and of members that turn far in equilibrium; a list")))


def _sticking(problem: "Problem") -> dict[str, float | list[str] | None]:
    from vibcli.mechanics.equilibrium.dry_friction import span
    from vibcli.notation.scene_language import language

    found, table = problem.system.sticking, problem.scene.table
    told = []
    for row in found.rows:
        if row.within is not None:
            told.append(f"abs({language(row.b)}) <= {language(row.within)}")
            continue
        told.append(language(table.sum((row.b, ONE), *((a * sigma, ONE) for sigma, a in row.held.items()))) + " = 0")
        told += [f"abs({language(sigma)}) <= {language(found.bounds[sigma])}" for sigma in row.held]
    ends = None if problem.numeric.has_free_symbols else span(problem.configuration, found)
    return STICKING.row(list(dict.fromkeys(told)), *(end if isfinite(end) else None for end in (
        (inf, inf) if ends is None else (ends.low, ends.high))))


STICKING = Key("sticking", "where dry friction holds the scene at rest, in solve and equations; absent where none does",
               _sticking, of=(
    Key("conditions", "equations and inequalities of the coordinates as texts, sigma_1 … being shares of friction"),
    Key("from", "of one coordinate in numbers: the least of a stretch of such places; null where there is no end"),
    Key("to", "the greatest")))
