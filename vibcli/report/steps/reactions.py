"""The steps to forces: each from the balance of the bodies that it acts on, inertia forces included (d'Alembert); what
is let go for it has a coordinate of its own."""

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Name, Words
from vibcli.report.sections.statics import condition_in_numbers, normals_in_letters
from vibcli.report.sections.too_long import brief
from vibcli.report.steps.agreement import ALIKE, samples_of
from vibcli.report.steps.held import HINT, UNTOLD
from vibcli.report.steps.multipliers import tell_multipliers
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.node import is_number
from vibcli.symbolic.normal_form import is_zero, textbook

READABLE = 24       # letters of an expression, beyond which it is told in numbers where it has them

if TYPE_CHECKING:
    from vibcli.mechanics.inputs_outputs.symbolic_reactions import SymbolicForces
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


def tell_statics(problem: "Problem", sheet: WorkedSolution) -> None:
    """The balance of a scene that cannot move, and what follows for the forces."""
    from vibcli.report.sections.parameters import words_of

    found = problem.symbolic.reactions
    _hold(problem, found, {})
    lines: list[int] = []
    _tell_letters(problem, sheet, found, found.conditions)
    for name, node in found.conditions.items():
        about = words_of(problem, name)
        told = f",  {about}" if about else ""
        lines.append(sheet.write(Words("balance along "), Name(name), Words(f"{told}:  "), *_readable(
            problem, found, node, not problem.system.dimension(name)), " = 0", settles=f"balance[{name}]"))
    known = _values(problem, found, found.supports)
    for signal, node in found.supports.items():
        if not node.is_zero and node is not found.values.get(signal) and signal not in _zero(known):
            lines.append(sheet.write(Words(signal), " = ", *_readable(problem, found, node, "moment" in signal),
                                     settles=f"balance[{signal}]"))
    told = [signal for signal, node in found.values.items() if node is not None and not node.is_zero]
    _tell_values(problem, sheet, found, told, lines)


def _tell_letters(problem: "Problem", sheet: WorkedSolution, found: Any, balances: "dict[str, Node]") -> None:
    """What letters of forces in {coordinate: balance} stand for, and the forces of springs that are put into these,
    beside the first of them."""
    here = {name for node in balances.values() for name in _names(node)}
    told: list[Any] = [part for symbol, signal in found.forces.items() if symbol.name in here
            for part in (Words(",  "), symbol, Words(f" for {signal}"))]
    told += [part for k, (signal, node) in enumerate(_put_in(problem, balances)) for part in (
        Words(f",  {'' if k else 'at rest  '}{signal} = "), node)]
    if told:
        sheet.write(Words("cut free, with  "), Words(told[0].text.removeprefix(",  ")), *told[1:], opens=True)


def _put_in(problem: "Problem", balances: "Mapping[str, Node]") -> list[Any]:
    """[(signal of a spring, its force)] of those that have it from rest as drawn and act along these coordinates."""
    known = {name: node for name, node in problem.system.preloads.items() if not node.is_zero}
    if not known:
        return []
    scene = problem.numeric.scene.with_released_supports()
    acting = {term.owner for term in scene.springs if term.owner in known
              for q, slope in gradient(term.s).items() if getattr(q, "name", None) in balances
              and not is_zero(substitute([slope], scene.drawn_position)[0])}
    springs = problem.spec.get("springs") or {}
    return [(f"{name}.{'moment' if 'torsion' in springs.get(name, {}) else 'force'}", node)
            for name, node in known.items() if name in acting]


def _readable(problem: "Problem", found: "SymbolicForces", node: "Node", turns: bool) -> "list[Node | str | Words]":
    """Parts of a balance, in numbers where it is long and has them; `turns`: of moments."""
    if problem.numeric.has_free_symbols or letters(node) <= READABLE:
        return [brief(node)]
    parts: list[Any] = []
    for value, symbol in condition_in_numbers(problem, found, node):
        alone = symbol.op == "number"
        of_moment = not alone and "moment" in found.forces[symbol]
        unit = ("N·m" if turns else "N") if alone else {(True, False): "m", (False, True): "1/m"}.get(
            (turns, of_moment), "")
        sign, size = (" − " if value < 0 else " + ") if parts else "−" * (value < 0), figure(abs(value))
        if alone:
            parts += [sign + size, Words("\u00a0" + unit)]
        elif unit:
            parts += [f"{sign}({size}", Words("\u00a0" + unit), ")·", symbol]
        else:
            parts += [sign + (f"{size}·" if abs(value) != 1 else ""), symbol]
    return parts or ["0"]


def tell_forces(problem: "Problem", sheet: WorkedSolution) -> None:
    """Forces of constraints and supports that the scene asks for: at rest, from rest where nothing holds it, or along
    the motion; nothing where they are not told so."""
    asked = [answer.asked for answer in problem.spec.answers]
    text = " ".join(one.text for one in asked)
    at_rest = " ".join(one.text for one in asked if not problem.spec.in_full or any(
        tree.head == "equilibrium" for tree in one.parts.quantities) or not getattr(one.tree, "args", ()))
    everything = "reactions" in (problem.spec.get("find") or ())
    if not everything and "." not in text:      # as every such signal has
        return
    try:
        found, moves = _forces(problem)
    except PhysicsError:
        _along(problem, sheet, text)
        return
    wanted = [signal for signal, node in found.values.items()
              if node is not None and not node.is_zero and (everything or signal in at_rest)]
    if not wanted:
        _along(problem, sheet, text)
    told = {line.settles for line in sheet.steps if f"equilibrium[{line.settles}]" not in text}
    wanted = [signal for signal in wanted if everything or signal not in told]
    if wanted and not found.degree:
        _tell_balance(problem, sheet, found, wanted, moves)
        if everything and not moves:
            _tell_normals(problem, sheet, found)


def _forces(problem: "Problem") -> "tuple[SymbolicForces, dict[Any, Any]]":
    """(the forces at rest, or from rest where nothing holds the scene, {acceleration: its value})."""
    from vibcli.report.sections.accelerations import falls

    if not falls(problem):
        return problem.symbolic.reactions, {}
    return problem.symbolic.forces_from_rest, problem.symbolic.accelerations.values


def _tell_balance(problem: "Problem", sheet: WorkedSolution, found: "SymbolicForces", wanted: list[str],
                  moves: dict[Any, Any]) -> None:
    """The balances with letters for forces and accelerations, then their values."""
    from vibcli.mechanics.inputs_outputs.symbolic_reactions import symbolic_forces

    table = problem.scene.table
    of = {name: table.variable(name + "''") for name in moves}
    shown = symbolic_forces(problem.numeric, of) if moves else found
    _hold(problem, shown, moves, found.values)
    symbols = {symbol for symbol, signal in shown.forces.items() if any(signal in one or one in signal
                                                                       for one in wanted)}
    told = {name: node for name, node in shown.conditions.items() if any(symbol.name in _names(node)
                                                                        for symbol in symbols)}
    balances = {signal: node for signal, node in shown.supports.items() if signal in wanted and not is_zero(
        node - found.values[signal])}
    _tell_letters(problem, sheet, shown, {**balances, **told} if told else {})
    lines = [sheet.write(Words("balance along "), Name(name), Words(":  "), node, " = 0", settles=f"balance[{name}]")
             for name, node in told.items()]
    _tell_values(problem, sheet, found, wanted, lines, balances)


def _tell_normals(problem: "Problem", sheet: WorkedSolution, found: "SymbolicForces") -> None:
    """The force of its path on each body that slides or rolls on one which is neither level nor upright."""
    lines = {line.settles: line.number for line in sheet.steps}
    for signal, node in normals_in_letters(problem, found.values, problem.symbolic.place_of_rest):
        value = _values(problem, found._replace(values={signal: node}), [signal])[signal]
        sides = [lines.get(f"{signal.removesuffix('normal')}reaction.{axis}") for axis in "xy"]
        sheet.write(Words(f"across its path  {signal}"), " = ", brief(node), *(() if value is None else number(
            value, "N")), settles=signal, node=node, value=value, unit="N", uses=sides)


def _names(node: "Node") -> set[str]:
    return {part.name for part in reachable([node]) if part.op == "symbol"}


def _tell_values(problem: "Problem", sheet: WorkedSolution, found: "SymbolicForces", wanted: list[str],
                 lines: list[int], balances: Mapping[Any, Any] | None = None) -> None:
    """The value of each force, that of a support by its balance first."""
    symbols = {signal: symbol for symbol, signal in found.forces.items()}
    values = _values(problem, found, wanted)
    for signal, value in values.items():
        if signal in _zero(values):
            continue
        node, unit = found.values[signal], "N·m" if "moment" in signal else "N"
        shown = [] if value is not None and letters(node) > READABLE else [" = ", brief(node)]
        shown = [*([" = ", balances[signal]] if signal in (balances or {}) else []), *shown]
        parts = [*([symbols[signal]] if signal in symbols else []), *shown, *(() if value is None else number(
            value, unit))]
        head = Words(f"{signal}:  " if signal in symbols else signal)
        sheet.write(head, *parts, settles=signal, node=node, value=value, unit=unit, uses=lines)


def _values(problem: "Problem", found: "SymbolicForces", wanted: "dict[str, Node] | list[str]") -> dict[str, float]:
    """{signal: number}, None in letters and where statics leaves it open."""
    known = [signal for signal in wanted if found.values.get(signal) is not None]
    values = [None] * len(known) if problem.numeric.has_free_symbols else evaluate(
        [found.values[signal] for signal in known], Floats, problem.numeric.floats)
    return {**dict.fromkeys(wanted), **dict(zip(known, values, strict=True))}


def _zero(values: Mapping[str, float]) -> set[str]:
    """Signals whose numbers are zero but for rounding."""
    size = max((abs(value) for value in values.values() if value is not None), default=0.0)
    return {signal for signal, value in values.items() if value is not None and abs(value) <= ALIKE * size}


def _hold(problem: "Problem", found: "SymbolicForces", moves: "Mapping[str, Node]",
          values: "Mapping[str, Node] | None" = None) -> None:
    """PhysicsError where the values do not fulfil the conditions."""
    values = found.values if values is None else values
    for known in samples_of(problem, {}):
        accelerations = dict(zip((name + "''" for name in moves), evaluate(list(moves.values()), Floats, known),
                                 strict=True))
        of = {symbol.name: evaluate([values[signal]], Floats, known)[0] for symbol, signal in found.forces.items()
              if values.get(signal) is not None}
        for node in found.conditions.values():
            _vanishes(node, {**known, **accelerations, **of}, _names(node) - set(of) - set(known) - set(accelerations))


def _vanishes(node: "Node", values: Mapping[str, float], unknown: Iterable[str]) -> None:
    if unknown:
        return
    terms = [part * c for part, c in node.args] if node.op == "sum" else [node]
    found = [*evaluate(terms, Floats, values), float(node.coefficient) if node.op == "sum" else 0.0]
    if not abs(sum(found)) <= ALIKE * sum(map(abs, found)):
        raise PhysicsError(UNTOLD, HINT)


def _along(problem: "Problem", sheet: WorkedSolution, text: str) -> None:
    """What supports exert along the motion, by the balance in it; at rest, if nothing else is asked."""
    from vibcli.mechanics.inputs_outputs.reactions_along_motion import along_the_motion

    found: Any = along_the_motion(problem.numeric, ties=True)
    for signal, node in found.items():
        if signal in text and text.count(signal) == text.count(f"equilibrium[{signal}]") and (
                problem.symbolic.balanced_as_drawn and all(node.is_zero for node in problem.scene.drawn.values())):
            _at_rest(problem, sheet, signal, node)
        elif signal in text:
            sheet.write(Words(f"by the balance along it  {signal}"), " = ", brief(node), settles=signal, node=node)
    tell_multipliers(problem, sheet, text)


def _at_rest(problem: "Problem", sheet: WorkedSolution, signal: str, node: "Node") -> None:
    """The force while nothing moves, without loads that change with the time."""
    moving = {name + primes for name in problem.scene.coordinates for primes in ("", "'", "''")}
    still = {part: node.table.zero for part in reachable([node]) if getattr(part, "name", None) in moving}
    node, = substitute([node], still)
    node = textbook(node - problem.scene.terms_with(node, problem.scene.time.mask))
    if node.mask:
        return
    value = None if problem.numeric.has_free_symbols else evaluate([node], Floats, problem.numeric.floats)[0]
    if not node.is_zero:
        unit = "N·m" if "moment" in signal else "N"
        sheet.write(Words(f"by the balance at rest  {signal}"), " = ", brief(node), *(
            () if value is None else number(value, unit)), settles=signal, node=node, value=value, unit=unit)


def tell_accelerations(problem: "Problem", sheet: WorkedSolution, lines: Iterable[int]) -> None:
    """The accelerations from rest as drawn of a scene that nothing holds, from its equations."""
    from vibcli.report.sections.accelerations import falls

    if not ("accelerations" in (problem.spec.get("find") or ()) or falls(problem)):
        return
    try:
        found = problem.symbolic.accelerations.values
    except PhysicsError:
        return
    floats = None if problem.numeric.has_free_symbols else problem.numeric.floats
    for name, node in found.items():
        value = None if floats is None else evaluate([node], Floats, floats)[0]
        unit = "m/s²" if problem.system.dimension(name) else "1/s²"
        sheet.write(Words("from rest as drawn  "), Name(name + "''"), *(
            () if is_number(node) and value is not None else (" = ", node)), *(() if value is None else number(
                value, unit)), settles=f"{name}''(0 s)", node=node, value=value, unit=unit, uses=list(lines))
