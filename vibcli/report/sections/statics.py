"""How constraints tie coordinates, the virtual work of what acts, and the reactions."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.notation.abbreviations import abbreviated
from vibcli.notation.numbers import with_minus
from vibcli.report import blocks
from vibcli.report.blocks import Name, Section, TableBlock, Words, line, maths, note, paragraph, section
from vibcli.report.keys import Key
from vibcli.report.sections.equations_of_motion import numeric_sum, with_lengths, with_numbers
from vibcli.report.sections.equilibrium import slack_ropes
from vibcli.report.sections.fewer_lengths import in_few_lengths
from vibcli.report.sections.numeric_equations import ROUNDING
from vibcli.report.sections.too_long import brief
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

SIGNS = "tension positive; what supports exert on the body, in fixed axes"
NONE = "none: neither a constraint nor a support takes any force"
READABLE = 60           # letters of a condition, beyond which it is written in numbers where it has them
WRITTEN_OUT = 16        # coordinates whose generalised forces are printed


def virtual_work(problem: "Problem", report: "Report") -> Iterator[Section]:
    """δA = Σ Q δq, where there are loads or it is asked for."""
    scene = problem.system.scene_with_multipliers
    if not (scene.forces or "virtual_work" in problem.spec.get("find", ())) or not 0 < len(scene.q) <= WRITTEN_OUT:
        return
    from vibcli.mechanics.virtual_work import generalised_forces
    from vibcli.notation.plain import plain

    names = [plain.symbol(name) for name in scene.coordinates]
    shown, lengths = abbreviated(generalised_forces(scene), report.roots)
    lines = [line("δA = " + " + ".join(f"Q_{name}·δ{name}" for name in names), hang=2)]
    balanced = _balanced(problem)
    jumps = balanced and not problem.numeric.has_free_symbols and problem.configuration.equilibrium.jumps
    for name, node in zip(names, shown, strict=True):
        vanishes = balanced and not (jumps or scene.constraints or node.is_zero or problem.system.sticking is not None)
        lines.append(line(f"Q_{name} = ", brief(node), " = 0" if vanishes else ""))
    moved = any(term.s.mask & scene.time.mask for term in scene.inertias) if scene.timed else False
    driven = ", and of the inertia of driven motion" if moved else ""
    yield from section(f"Virtual work at rest{' in equilibrium' * balanced}", blocks.equations(lines),
                       *with_lengths(lengths), *with_numbers(problem, shown),
                       note(f"of weights, springs and steady loads{driven}"))


def _balanced(problem: "Problem") -> bool:
    """Is there an equilibrium, as far as is known?"""
    try:
        if problem.numeric.has_free_symbols:
            problem.symbolic.equilibrium_position  # noqa: B018
        else:
            problem.configuration.equilibrium  # noqa: B018
    except NotInLetters:
        return True
    except PhysicsError:
        return False
    return True


def _unit(problem: "Problem", signal: str) -> str:
    """N, or N·m of a moment."""
    from vibcli.base.units import FORCE
    from vibcli.language.signals import signal_dimension

    return "N" if signal_dimension(problem.spec, signal) in (None, FORCE) else "N·m"


def reactions(problem: "Problem", report: "Report") -> Iterator[Section]:
    """The reactions in equilibrium, in numbers where the scene has some, and those along a motion."""
    from vibcli.mechanics.inputs_outputs.reactions_along_motion import along_the_motion

    if problem.scene.held:
        yield from _conditions(problem, report)
    title, signs = "Reactions in equilibrium", SIGNS
    if not problem.numeric.has_free_symbols:
        rows = [(reaction.signal, "not fixed by statics" if reaction.value is None else
                 f"{with_minus(reaction.value)} {_unit(problem, reaction.signal)}")
                for reaction in problem.configuration.reactions if reaction.value != 0.0]
        rows += [(signal, f"{with_minus(value)} N") for signal, value in _normals(problem)]
        if any(".drive" in signal for signal, _ in rows):
            signs = signs.replace("supports", "supports and drives")
        pushed = slack_ropes(problem) if problem.scene.held else []
        told = TableBlock(("force", "value"), tuple(rows)) if rows else paragraph(NONE)
        yield from section(title, told, *pushed, note(signs) if rows else None)
    elif problem.scene.held or _balanced_as_drawn(problem):
        told = list(_in_letters(problem, report))
        yield from section(title, *told, note(signs) if told else paragraph(NONE))
    if not problem.scene.held:
        found = along_the_motion(problem.numeric)
        shown, lengths = in_few_lengths(list(found.values()), report.roots)
        yield from section("Reactions along a motion", blocks.equations(
            line(Words(signal), " = ", brief(node)) for signal, node in zip(found, shown, strict=True)),
            *with_lengths(lengths))


def _balanced_as_drawn(problem: "Problem") -> bool:
    """Is the drawn position the equilibrium, as far as is known in letters?"""
    try:
        problem.symbolic.reactions  # noqa: B018
    except PhysicsError:
        return False
    return True


def _in_letters(problem: "Problem", report: "Report") -> list[Any]:
    """Blocks of the reactions as expressions."""
    known = {signal: node for signal, node in problem.symbolic.reactions.values.items()
             if node is None or not node.is_zero}
    known |= dict(normals_in_letters(problem, known, problem.symbolic.place_of_rest))
    if not known:
        return []
    shown, lengths = abbreviated([node for node in known.values() if node is not None], report.roots)
    parts, lines = iter(shown), []
    for signal, node in known.items():
        fixed = ("   ", Words("not fixed by statics")) if node is None else (" = ", brief(next(parts)))
        lines.append(line(Words(signal), *fixed))
    return [blocks.equations(lines), *with_lengths(lengths)]


def _guided(problem: "Problem", known: Mapping[str, Any]) -> "Iterator[tuple[str, tuple[Node, Node]]]":
    """(name, normal in equilibrium) of each body on a surface or guide that takes part along both axes."""
    for name, body in problem.scene.resting.bodies.items():
        if body.normal is not None and all(known.get(f"{name}.reaction.{axis}") for axis in "xy"):
            yield name, body.normal


def _normals(problem: "Problem") -> list[Any]:
    """(B.normal, its value)"""
    from vibcli.mechanics.signals import force

    known = {reaction.signal: reaction.value for reaction in problem.configuration.reactions}
    return [(f"{name}.normal", force(problem.configuration, f"{name}.normal")) for name, _ in _guided(problem, known)]


def normals_in_letters(problem: "Problem", forces: "Mapping[str, Node | None]", place: "Mapping[str, Node]"
                       ) -> "Iterator[tuple[str, Node]]":
    """(B.normal, its expression) where these forces act, as drawn but for what is at a `place` {coordinate: node}."""
    scene = problem.scene.resting
    known = {signal: node for signal, node in forces.items() if node is not None and not node.is_zero}
    at = {scene.symbol(name): node for name, node in zip(place, copied(list(place.values()), scene.table), strict=True)}
    for name, normal in _guided(problem, known):
        nx, ny = substitute(list(normal), {**scene.drawn_position, **at})
        x, y = copied([known[f"{name}.reaction.{axis}"] for axis in "xy"], scene.table)
        yield f"{name}.normal", textbook(nx * x + ny * y)


def _conditions(problem: "Problem", report: "Report") -> Iterator[Section]:
    """The conditions of equilibrium: the virtual work of each coordinate, its constraints let go, and what follows for
    the supports."""
    found = problem.symbolic.reactions
    nodes, count = [*found.conditions.values(), *found.supports.values()], len(found.conditions)
    if not problem.numeric.has_free_symbols and max(map(letters, nodes), default=0) > READABLE:
        shown, lengths = [numeric_sum(condition_in_numbers(problem, found, node)) for node in nodes], []
    else:
        shown, lengths = abbreviated(nodes, report.roots)
        shown = [[brief(node, "")] for node in shown]
    lines = [line(*parts, " = 0", label=Name(name)) for name, parts in zip(found.conditions, shown, strict=False)]
    lines += [line(Words(signal), " = ", *parts)
              for signal, parts in zip(found.supports, shown[count:], strict=True) if parts != ["0"]]
    told = []
    for symbol, signal in found.forces.items():
        told += [", "] * bool(told) + [maths(symbol), f": {signal}"]
    yield from section("Conditions of equilibrium", blocks.equations(lines), *with_lengths(lengths),
                       paragraph("with ", *told, hang=4, aside=True) if told else None)


def condition_in_numbers(problem: "Problem", found: Any, node: "Node") -> "list[tuple[float, Node]]":
    """[(coefficient, symbol)] of a condition, which is linear in the forces of constraints; the constant last."""
    table, floats = node.table, problem.numeric.floats
    slopes = gradient(node)
    used = [symbol for symbol in found.forces if symbol in slopes]
    constant, = substitute([node], dict.fromkeys(used, table.zero))
    terms = constant.args if constant.op == "sum" else ()
    *values, rest = evaluate([*(slopes[symbol] for symbol in used), constant], Floats, floats)
    size = sum(abs(float(c) * x) for (_, c), x in zip(terms, evaluate([part for part, _ in terms], Floats, floats),
                                                     strict=True))
    row = [(value, symbol) for value, symbol in zip(values, used, strict=True) if abs(value) > ROUNDING]
    return row + [(rest, table.one)] * (abs(rest) > ROUNDING * size)


def _values(problem: "Problem") -> Mapping[str, Any]:
    if problem.numeric.has_free_symbols:
        return problem.symbolic.reactions.values
    return {reaction.signal: reaction.value for reaction in problem.configuration.reactions}


REACTIONS = Key("reactions", "{signal: force or moment in equilibrium}, with `find: [reactions]` and of scenes without "
                "freedom, there as expressions where symbols have no value; null where statics leaves it open", _values)
