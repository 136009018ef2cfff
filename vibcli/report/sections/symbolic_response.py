"""The motion in time in letters: the steady state of one harmonic, and of one degree of freedom all of it."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain, count
from typing import TYPE_CHECKING, Any, cast

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.report.blocks import (
    Factor,
    Line,
    Name,
    Paragraph,
    Section,
    SumOfTerms,
    Words,
    equations,
    line,
    maths,
    paragraph,
    section,
)
from vibcli.report.sections.requested_signals import symbol
from vibcli.report.sections.symbolic_modes import equilibrium_parts
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression import Table
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import NameRef
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.free_response import FreeMotion
    from vibcli.analyses.closed_form.frequency_response import Formula
    from vibcli.mechanics.symbolic_linear import Tree
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

LETTERS = {"X": ("X", "Z", "R"), "theta": ("theta", "psi", "epsilon"), "omega": ("omega", "omega_0"),
           "r": ("r", "eta", "nu"), "zeta": ("zeta", "xi"),
           "omega_d": ("omega_d", "omega_1"), "beta": ("beta", "nu"), "A": ("A", "P"), "B": ("B", "Q")}
AHEAD = {"sin": ("", "cos"), "cos": ("−", "sin")}       # a quarter period ahead
CONDITIONS = {"under-damped": " < ", "critically damped": " = ", "over-damped": " > "}


def response_in_letters(problem: "Problem", asked: "Iterable[tuple[str, Tree]]") -> Iterator[Section]:
    """Sections of the steady state of signals, (text, tree), and of the motion of one coordinate from its start."""
    from vibcli.analyses.closed_form.powers_of_time import are_powers

    if problem.spec.in_full:
        raise NotInLetters("motions that are integrated are found in numbers",
                           "give the parameters values with --set")
    problem.require_no_members()
    driven, trees = bool(problem.scene.timed and problem.symbolic.excitation), dict(asked)
    growing = driven and are_powers(problem.symbolic)
    steady, untold = _followed(problem, trees, growing) if driven else ({}, ())
    values = {name: node for name, node in problem.symbolic.equilibrium_position.items() if not node.is_zero}
    if values:
        yield from section("Equilibrium, from which motions are counted", paragraph(*equilibrium_parts(values)))
    for number, (name, found) in enumerate(steady.items(), 1):
        shown = _printed(problem, name, trees[name])
        yield from section(f"Steady state of {symbol(name)}", equations([line(shown, " = ", found)])) if (
            growing) else steady_section(problem, name, found, str(number) * (len(steady) > 1), shown)
    yield from section("Not found in letters", *(paragraph(f"{symbol(name)}: {why}") for name, why in untold))
    if len(problem.scene.q) == 1:
        name, = problem.scene.coordinates
        if not driven and name not in trees:
            raise NotInLetters(f"a free motion in letters is found of '{name}' alone", "ask for it, or give numbers "
                               "with --set")
        yield from _from_the_start(problem, steady)
    elif not driven:
        raise NotInLetters("free motions in letters are found for one degree of freedom", "give numbers with --set")


def _followed(problem: "Problem", trees: Mapping[str, Any],
              growing: bool) -> tuple[dict[str, Any], list[tuple[str, str]]]:
    """({text: what a signal follows or keeps up}, [(text, why another is not found)]); the refusal where all are."""
    find = problem.symbolic_following if growing else problem.symbolic_steady_state
    found, untold = {}, []
    for name, tree in trees.items():
        try:
            found[name] = find(name if isinstance(tree, NameRef) else tree)
        except NotInLetters as error:
            untold.append((name, error))
    if untold and not found:
        raise untold[0][1]
    return found, [(name, error.message) for name, error in untold]


def _printed(problem: "Problem", name: str, tree: Any) -> Any:
    """A signal as it stands in an equation: a sum term by term."""
    if isinstance(tree, NameRef):
        return Name(name)
    table, known = Table(), problem.scene.parameters.nodes
    return lower(tree, table, lambda name, primes, _: table.parameter(name) if name in known else table.variable(
        name + "'" * primes))


def letter(problem: "Problem", name: str) -> str:
    """A letter that the scene leaves free."""
    taken = {*problem.scene.parameters.nodes, *problem.spec.coordinates}
    numbered = (f"{name}{k}" for k in count(2))
    return next(one for one in chain(LETTERS[name], numbered) if one not in taken)


def steady_section(problem: "Problem", name: str, steady: Any, number: str, shown: Any = None) -> Iterator[Section]:
    """x = X·sin(Ω·t − θ), X and tan θ, where it resonates and where it rests; shown: the signal in an equation, unless
    that is its name."""
    formula, X, theta = steady.formula, letter(problem, "X") + number, letter(problem, "theta") + number
    lag = () if formula.undamped or formula.ahead else (" − ", Name(theta))
    sign, wave = AHEAD[steady.wave] if formula.ahead else ("", steady.wave)
    mean = () if steady.mean is None or steady.mean.is_zero else (steady.mean, " + " if not sign else " ")
    lines = [line(shown or Name(name), " = ", *mean, sign, Name(X), f"·{wave}(", steady.argument, *lag, ")"),
             line(Name(X), " = ", formula.amplitude)]
    lines += ratio_lines(problem, formula, Name(X))
    if lag:
        lines.append(lag_line(formula, theta))
    told = () if problem.choice is not None else conditions(formula)     # what is chosen holds at this Ω alone
    yield from section(f"Steady state of {symbol(name)}", equations(lines), *told)


def ratio_lines(problem: "Problem", formula: "Formula", size: Any) -> "Iterator[Line]":
    """The amplitude of one degree by r = Ω/ω and ζ, and what these are."""
    from vibcli.analyses.closed_form.dimensionless import CONSTANT, SQUARE, dimensionless
    from vibcli.notation.plain import plain

    found = dimensionless(formula)
    if found is None:
        return
    omega = letter(problem, "omega")
    r, ratio, zeta = (plain.symbol(name) for name in (letter(problem, "r"), omega, letter(problem, "zeta")))
    above = {CONSTANT: "1", SQUARE: f"{r}²"}.get(found.above, f"√(1 + (2·{zeta}·{r})²)")
    below = f"(1 − {r}²)" if found.zeta is None else f"√((1 − {r}²)² + (2·{zeta}·{r})²)"
    one = found.gain.op == "number" and found.gain.coefficient == 1
    yield line(size, " = ", *(() if one else (Factor(found.gain), "·")), f"{above}/{below}")
    beside = () if found.zeta is None else (f",  {zeta} = ", found.zeta)
    yield line(Words("with "), f"{r} = ", Factor(formula.Omega), f"/{ratio},  {ratio} = ", found.omega, *beside)


def lag_line(formula: "Formula", theta: str) -> "Line":
    """tan θ of a lag, or the right angle that it is."""
    if formula.tangent is not None:
        return line(Words("tan "), Name(theta), " = ", formula.tangent)
    sign = {1: "", -1: "−", None: "±"}[formula.side]
    return line(Name(theta), f" = {sign}π/2")


def conditions(formula: "Formula") -> Iterator[Paragraph]:
    """Where an undamped response has no bound and where it vanishes; where a damped one has its peak."""
    for words, place in (("resonance", formula.poles), ("antiresonance", formula.zeros)):
        if place is not None and not _shared(formula.Omega, place):
            yield paragraph(f"{words} at ", maths(formula.Omega, " = ", place))
    if formula.peak is not None and not _shared(formula.Omega, formula.peak[0]):
        place, less, more = formula.peak
        always = place.table.is_positive(textbook(more - less))
        condition = () if always else (" for ", maths(less, " < ", more))
        yield paragraph("peak at ", maths(formula.Omega, " = ", place), *condition)
    if formula.undamped and not formula.short and not formula.vanishes and not _fixed_sign(formula.denominator[0]):
        yield paragraph("resonances where ", maths(formula.denominator[0], " = 0"), hang=4)


def _fixed_sign(node: "Node") -> bool:
    """Is it positive, or negative, or zero, whatever the letters are?"""
    return node.is_zero or node.table.is_positive(node) or node.table.is_positive(-node)


def _shared(Omega: "Node", place: "Node") -> bool:
    """Does Ω follow from letters that its place has, too? Then it is nowhere else."""
    one, other = ({part.name for part in reachable([node]) if part.op == "symbol"} for node in (Omega, place))
    return Omega.op != "symbol" and bool(one & other)


def _from_the_start(problem: "Problem", steady: Mapping[Any, Any]) -> Iterator[Section]:
    from vibcli.analyses.closed_form.free_response import free_motions
    from vibcli.mechanics.initial_state import start_in_letters

    name, = problem.scene.coordinates
    if steady and name not in steady:
        return
    table = Table()
    table.resample(problem.scene.sample)
    copied(list(problem.scene.parameters.nodes.values()), table)
    start = start_in_letters(problem.symbolic)
    general = start is None and not steady
    start = start or ([table.parameter(name + "0"), table.parameter(name + "0'")] if general else [table.zero] * 2)
    massless = problem.symbolic.matrices[0].get((0, 0), problem.scene.table.zero).is_zero
    if massless and not general and not start[1].is_zero:
        raise PhysicsError(f"'{name}' has no inertia: its velocity follows from the forces and cannot be given",
                           f"leave {name}' out")
    start, prefix, meaning = _about_steady(problem, table, copied(start, table), steady.get(name), massless)
    m, c, k = (copied([entries.get((0, 0), problem.scene.table.zero)], table)[0]
               for entries in (problem.symbolic.matrices[i] for i in (0, 1, 3)))
    if not general and not steady and all(node.is_zero for node in start):
        raise NotInLetters("nothing moves: the motion starts at rest in the equilibrium",
                           "give initial: {x: x0} or a force that depends on time")
    rates = {regime: table.parameter(letter(problem, name)) for regime, name in (
        ("undamped", "omega"), ("under-damped", "omega_d"), ("over-damped", "beta"))}
    found = free_motions(m, c, k, start, rates, table.variable("t"), [problem.scene.sample])
    known = _known_regime(problem, m, c, k)
    blocks = [block for motion in found if known in (None, motion.regime)
              for block in _regime(name, motion, prefix, (m, c, k))]
    title = f"Motion of {symbol(name)} from the start" if steady else f"Free motion of {symbol(name)}"
    yield from section(title, *blocks, meaning)


def _about_steady(problem: "Problem", table: Table, start: Any, steady: Any, massless: bool) -> tuple[Any, ...]:
    """(start of the free part, parts of the steady part before it, what its letters mean)."""
    if steady is None:
        return start, (), None
    if not hasattr(steady, "formula"):
        return cast("tuple[Any, ...]", _about_powers(problem, table, start, steady))
    formula, (x, v) = steady.formula, start
    X, theta = (table.parameter(letter(problem, name)) for name in ("X", "theta"))
    at_start, = substitute([steady.argument], {problem.scene.time: problem.scene.table.zero})
    argument, Omega, still = copied([steady.argument, formula.Omega, at_start], table)
    lag = table.zero if formula.undamped else theta
    at = still - lag
    sine, cosine = table.call("sin", at), table.call("cos", at)
    place, speed = (sine, cosine) if steady.wave == "sin" else (cosine, -sine)
    mean, = copied([table.zero if steady.mean is None else steady.mean], table)
    start = x - mean - X * place, v - Omega * X * speed
    prefix = *(() if mean.is_zero else (mean,)), X * table.call(steady.wave, argument - lag)
    if formula.undamped:
        return start, prefix, None
    A, B = (table.parameter(letter(problem, name)) for name in "AB")
    lines = [line(A, " = ", start[0]), line(B, " = ", start[1])]
    return (A, B), prefix, equations(lines[:1] if massless else lines)


def _about_powers(problem: "Problem", table: Table, start: Any, steady: Any) -> Any:
    """The same of a steady part that is a polynomial of the time."""
    scene = problem.scene
    slope = gradient(steady).get(scene.time, scene.table.zero)
    at_start = copied(substitute([steady, slope], {scene.time: scene.table.zero}), table)
    return tuple(textbook(one - other) for one, other in zip(start, at_start, strict=True)), (
        copied([steady], table)[0],), None


def _known_regime(problem: "Problem", m: "Node", c: "Node", k: "Node") -> Any:
    """The regime where no letter decides about it."""
    from vibcli.analyses.closed_form.free_response import CRITICAL, critical, regime_at

    if critical(m, c, k):
        return CRITICAL
    if {part.name for part in reachable([m, c, k]) if part.op == "symbol"} & set(problem.symbolic.letters):
        return None
    return regime_at(*evaluate([m, c, k], Floats, problem.scene.sample))


def _regime(name: str, motion: "FreeMotion", prefix: tuple[Any, ...],
            matrices: "tuple[Node, Node, Node]") -> Iterator[Any]:
    """The words of a regime with its condition, its formula, and what ω stands for."""
    from vibcli.analyses.closed_form.free_response import CRITICAL, critical

    m, c, k = matrices
    relation = CONDITIONS.get(motion.regime)
    if relation and motion.regime == CRITICAL and critical(m, c, k):
        yield paragraph(motion.regime)
    elif relation:
        yield paragraph(f"{motion.regime}, ", maths(c * c, relation, 4 * k * m), ":")
    elif not k.table.is_positive(k):
        yield paragraph("for ", maths(k, " > 0"), ":")
    wave = tuple(node for node in motion.wave if not node.is_zero)
    if motion.decay is None:
        parts = [SumOfTerms((*prefix, *wave))]
    elif len(wave) == 1 and wave[0].op != "sum":
        parts = [SumOfTerms((*prefix, motion.decay * wave[0]))]
    else:
        parts = [*([SumOfTerms(prefix), " + "] if prefix else []), motion.decay, "·(", SumOfTerms(wave), ")"]
    lines = [line(Name(name), " = ", *parts)]
    if motion.value is not None:
        lines.append(line(motion.rate, " = ", motion.value))
    yield equations(lines)
