"""What is asked in letters of what a load of one frequency keeps up, by H(iΩ) = s (a + iΩ b)/(c + iΩ d):

    lag  θ = −arg H = atan2(Ω (a d − b c), a c + Ω² b d),   mean power of a dashpot  ½ c |u̇|²,   mean energy of a
    spring  ½ k ⟨Δ²⟩;

resonances and antiresonances of one that has them in closed form, and with one degree of freedom where |H|² is half of
that at the peak, for m|H|² ~ 1/((Ω² − ω² + 2δ²)² + 4δ²ω_d²) at

    Ω² = ω² − 2δ² ∓ 2δω_d,   of an unbalance, with Ω⁴ above,   Ω² = ω⁴/(ω² − 2δ² ± 2δω_d),   of a speed, with Ω²
    above, whose peak is at ω,   Ω = √(ω² + δ²) ∓ δ;

what is shaken through spring and dashpot moves most at Ω² = ω⁴ (√(1 + 8δ²/ω²) − 1)/(4δ²) (Thomson & Dahleh 1998,
section 3.10; Rao 2011, section 3.6)."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters
from vibcli.notation.plain import plain
from vibcli.quantities.in_letters import frequency_of, size_of
from vibcli.report.blocks import Words
from vibcli.report.measured import without_units
from vibcli.report.steps.agreement import samples_of
from vibcli.report.steps.held_against import tell_found
from vibcli.report.steps.instances import found_at, is_found
from vibcli.report.steps.receptances import PARTS, response_at, tell_receptance
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import UNITS, is_measure
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.radicals import without_bars
from vibcli.symbolic.syntax import Call, NameRef, QuantityRef
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.analyses.closed_form.frequency_response import Formula
    from vibcli.language.reader import Expression
    from vibcli.report.steps.step import WorkedLine
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

SIDES = {"1": -1, "2": 1}       # of a peak where it has half its power


def tell_of_kept_up(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is what is asked of a steady state, or read off a frequency response, written down in letters?"""
    tree = asked.tree
    if getattr(tree, "head", "") == "phase" and _is_letter(problem, sheet, asked):
        return True
    at = response_at(tree)
    if getattr(tree, "head", "") == "half_power":
        forms = _half_power(problem, sheet, tree)
    elif at is not None and tell_receptance(problem, sheet, asked):
        return True
    else:
        forms = ((node, [node]) for node in _forms(problem, sheet, tree)) if at is None else _at_a_frequency(
            problem, sheet, tree, at)
    return tell_found(problem, sheet, asked, forms, [sheet.last])


def _at_a_frequency(problem: "Problem", sheet: WorkedSolution, tree: Call,
                    response: QuantityRef) -> "Iterator[tuple[Node, list[Node | str | Words]]]":
    """That by the expression of H; the frequency has a letter where it is a number with a unit."""
    given = frequency_of(problem, response.args[0])
    fixed = all(is_measure(part) for part in reachable([given]) if part.op == "symbol")
    told = given in sheet.frequencies
    Omega = sheet.frequencies.setdefault(given, problem.scene.table.parameter(sheet.letter(
        f"Omega{len(sheet.frequencies) + 1}"))) if fixed else given
    formula = problem.symbolic_frequency_response(*response.indices, Omega)
    head = tree.name if isinstance(tree, Call) else tree.head
    node = textbook(_part(problem, formula, head)) if head in PARTS else size_of(problem, formula)
    samples = [{**one, Omega.name: value} for one in samples_of(problem, {}) for value in evaluate(
        [given], Floats, {**dict.fromkeys(UNITS.values(), 1.0), **one})] if fixed else samples_of(problem, {})
    node = without_bars(node, samples)
    if fixed:
        if not told:
            sheet.write(settles=Omega.name, node=given, letter=Omega.name, joined=True)
        at: list[Any] = [] if told else [Words("with  "), Omega, Words(f" = {plain(without_units(given))} rad/s:  ")]
        yield substitute([node], {Omega: given})[0], [*at, node]
    else:
        yield node, [node]


def _forms(problem: "Problem", sheet: WorkedSolution, tree: Any) -> "Iterator[Node]":
    head, args = getattr(tree, "head", getattr(tree, "name", "")), getattr(tree, "args", ())
    if not args:
        return
    first = args[0]
    of_response = isinstance(first, QuantityRef) and first.head == "frf"
    if head == "phase":
        yield from _by_lag(problem, sheet)
        steady = problem.symbolic_steady_state(_named(first))
        lag, quarter = _part(problem, steady.formula, "phase"), problem.scene.table.pi / 2
        yield from (lag, lag - quarter, lag + 3 * quarter) if steady.wave == "cos" else (lag,)
    elif head in ("peak", "antiresonance") and of_response and not first.args:
        if tree.head == "peak" and tree.component != "Omega":
            yield from _peaks(problem, sheet, tree)
        yield from _read_off(problem, tree, problem.symbolic_frequency_response(*first.indices))
        if tree.head == "peak":
            yield from _peaks(problem, sheet, tree)
    elif head == "mean" and isinstance(first, NameRef):
        yield from _means(problem, first)


def _lag_of(sheet: WorkedSolution) -> "WorkedLine | None":
    """The line of the letter of the lag of the only coordinate, where this has a number."""
    theta = sheet.letter("theta")
    return next((line for line in sheet.steps if line.letter == theta), None)


def _is_letter(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is the phase that is asked told already, as the lag of the only coordinate?"""
    line, signal = _lag_of(sheet), asked.tree.args[0]
    if line is None or not isinstance(signal, NameRef) or signal.primes or [signal.name] != problem.scene.coordinates:
        return False
    node = problem.scene.table.parameter(line.letter)
    if not is_found(node, found_at(problem, sheet, asked)):
        return False
    sheet.settles_too(line, asked.text, node, line.value, line.unit)
    return True


def _by_lag(problem: "Problem", sheet: WorkedSolution) -> "Iterator[Node]":
    """The same, of a wave that is no sine, and of signals that go with the coordinate, its speed or against it."""
    line = _lag_of(sheet)
    if line is not None:
        node, quarter = problem.scene.table.parameter(line.letter), problem.scene.table.pi / 2
        yield from (node + turn * quarter for turn in (0, -1, 1, -2, 2, 3, -3))


def _named(signal: NameRef) -> str:
    return signal.name + "'" * signal.primes if isinstance(signal, NameRef) else signal


def _part(problem: "Problem", formula: "Formula", head: str) -> "Node":
    """The real or the imaginary part of H, its angle, or its lag."""
    table = problem.scene.table
    a, b, c, d, s, Omega = copied([*formula.numerator, *formula.denominator, formula.scale, formula.Omega], table)
    across, along = Omega * (a * d - b * c), a * c + Omega ** 2 * b * d
    if head in ("phase", "arg"):
        s = table.one if table.is_positive(s) else s
        lag = table.call("atan2", textbook(s * across), textbook(s * along))
        return lag if head == "phase" else -lag
    return (s * along if head == "re" else -(s * across)) / (c ** 2 + Omega ** 2 * d ** 2)


def _read_off(problem: "Problem", tree: QuantityRef, formula: "Formula") -> "Iterator[Node]":
    """Where one degree of freedom has its peak, and how high that is; where what nothing damps stands still."""
    table = problem.scene.table
    if tree.indices != ("1",):
        return
    if tree.head == "antiresonance":
        if formula.zeros is not None:
            yield from copied([formula.zeros], table)
    elif formula.peak is not None:
        Omega, size, at = copied([formula.Omega, formula.amplitude, formula.peak.Omega], table)
        yield at if tree.component == "Omega" else substitute([size], {Omega: at})[0]


def _by_letters(problem: "Problem", sheet: WorkedSolution) -> "tuple[Node, Node, Node] | None":
    """ω, δ and ω_d of one degree of freedom; None where lines do not tell them."""
    named = [sheet.letter(name) for name in ("omega", "delta", "omega_d")]
    if not {line.letter for line in sheet.steps}.issuperset(named):
        return None
    omega, delta, omega_d = map(problem.scene.table.parameter, named)
    return omega, delta, omega_d


def _half_power(problem: "Problem", sheet: WorkedSolution, tree: QuantityRef) -> "Iterator[tuple[Node, list[Any]]]":
    """Where a peak of one degree of freedom has half its power: of a place, of an unbalance, of a speed."""
    known = _by_letters(problem, sheet)
    if known is None or tree.indices[0] not in SIDES:
        return
    table, sense, (omega, delta, omega_d) = problem.scene.table, SIDES[tree.indices[0]], known
    peak, spread, Omega = omega ** 2 - 2 * delta ** 2, 2 * delta * omega_d, table.parameter(sheet.letter("Omega", "h"))
    told = any(line.settles.startswith("half_power") for line in sheet.steps)
    for node, off, size in (
            (table.sqrt(peak + sense * spread), Omega ** 2 - peak, spread),
            (omega ** 2 / table.sqrt(peak - sense * spread), omega ** 4 / Omega ** 2 - peak, spread),
            (table.sqrt(omega ** 2 + delta ** 2) + sense * delta, Omega ** 2 - omega ** 2, 2 * delta * Omega)):
        condition = [Words("|H|² is half of that at its peak at "), Omega, Words("  with  "), off ** 2, " = ",
                     size ** 2, Words(":  ")]
        yield node, [*([] if told else condition), node]


def _peaks(problem: "Problem", sheet: WorkedSolution, tree: QuantityRef) -> "Iterator[Node]":
    """Where the motion of one that is shaken through spring and dashpot is greatest, and of a speed."""
    known = _by_letters(problem, sheet)
    if known is None or tree.indices != ("1",):
        return
    omega, delta, _ = known
    if tree.component != "Omega":
        yield from _heights(problem, tree.args[0], *known)
        return
    squared = 8 * delta ** 2 / omega ** 2
    yield from (omega, omega ** 2 / (2 * delta) * problem.scene.table.sqrt(problem.scene.table.sqrt(1 + squared) - 1))


def _heights(problem: "Problem", response: QuantityRef, omega: "Node", _: "Node", omega_d: "Node") -> "Iterator[Node]":
    """s/(C ω_d) of s/|K − MΩ² + iΩC|, and sω²/(C ω_d) where Ω² stands above."""
    formula = problem.symbolic_frequency_response(*response.indices)
    factor, above, C, Omega = copied([formula.scale, formula.numerator[0], formula.denominator[1], formula.Omega],
                                     problem.scene.table)
    if formula.short and not C.is_zero and formula.numerator[1].is_zero:
        yield from (textbook(size * factor * above) / (C * omega_d) for size in (1, -1, omega ** 2 / Omega ** 2,
                                                                             -(omega ** 2 / Omega ** 2)))


def _means(problem: "Problem", signal: NameRef) -> "Iterator[Node]":
    """Of a power of a dashpot, or of the energy of a spring."""
    owner, _, part = signal.name.partition(".")
    record = (problem.spec.get("dampers" if part == "power" else "springs") or {}).get(owner)
    key = {"power": "c", "energy": "k"}.get(part)
    if record is None or key not in record or signal.primes:
        raise NotInLetters("this mean is found in numbers")
    factor = problem.scene.lower(record[key])
    steady = problem.symbolic_steady_state(f"{owner}.stretch" + "'" * (part == "power"))
    above, below = copied(list(steady.formula.square), problem.scene.table)
    yield factor * above / below / (2 if part == "power" else 4)
