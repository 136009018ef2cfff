"""Means and root mean squares of what a load of one frequency keeps up, of products and powers of signals too: with
τ = Ωt − θ of one degree of freedom

    x = X sin τ,   ẋ = ΩX cos τ,   sin Ωt = p sin τ + q cos τ,   p + iq = X (R + iS)/(A + iB),   R + iS = K − MΩ² + iCΩ

of a load A sin Ωt + B cos Ωt; of several qⱼ = aⱼ sin Ωt + bⱼ cos Ωt; then ⟨sin² τ⟩ = ½, ⟨sin⁴ τ⟩ = ⅜ and so on
(Thomson & Dahleh 1998, section 13.3)."""

import re
from collections.abc import Sequence
from contextlib import suppress
from itertools import islice
from math import prod
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.steady_state import waves_of_all
from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.signals import moving
from vibcli.notation.as_printed import as_printed
from vibcli.quantities.responses_in_letters import at_rest
from vibcli.report.blocks import Words
from vibcli.report.steps.agreement import tidy
from vibcli.report.steps.held_against import tell_found
from vibcli.report.steps.instances import INSTANCES, found_at, instances
from vibcli.report.steps.step import WorkedSolution, number, unit_told
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import expanded
from vibcli.symbolic.radicals import root
from vibcli.symbolic.rationals import ONE, fraction_of
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import NameRef, QuantityRef
from vibcli.symbolic.transfer_between_tables import copied

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import Power

SINE, COSINE = "𝔰", "𝔠"        # of τ, while an average is taken
WITH = "with the real part a and the imaginary part b of each X:  "
ROUNDING = 1e-12        # relative: of a mean that is zero, and the root mean square


def tell_average(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is what is asked such a mean, or root of one, and is it written down?"""
    quantities = asked.parts.quantities
    if not quantities or any(one.head not in ("mean", "rms") or len(one.args) != 1 for one in quantities):
        return False
    swing, several = None, list(_of_harmonics(problem, sheet, asked.tree))
    if several:
        return tell_found(problem, sheet, asked, several, [sheet.last])
    with suppress(PhysicsError):
        swing = _of_one(problem, sheet) if len(problem.scene.q) == 1 else _of_several(problem, sheet)
    if swing is None:
        return False
    node, size = (_average(problem, sheet, swing, asked.tree, sizes) for sizes in (False, True))
    found = found_at(problem, sheet, asked)
    if found and all(abs(value) <= ROUNDING * abs(evaluate([size], Floats, known)[0]) for known, value in found):
        text = as_printed(asked.text, {*problem.spec.parameters, *problem.spec.coordinates})
        value, unit = (None, "") if problem.numeric.has_free_symbols else (0.0, unit_told(problem.spec, asked))
        sheet.write(Words(text), *number(0.0, unit), settles=asked.text, node=node.table.zero, value=value, unit=unit,
                    uses=[sheet.last])
        return True
    first = len(problem.scene.q) > 1 and not any(WITH in part.text for line in sheet.steps for part in line.parts
                                                 if isinstance(part, Words))
    return tell_found(problem, sheet, asked, [(node, [*[Words(WITH)] * first, node])], [sheet.last])


def _average(problem: "Problem", sheet: WorkedSolution, swing: "MotionsByWaves", tree: QuantityRef,
             sizes: bool) -> "Node":
    """The expression, also of several means; of their sizes by the root mean square of each, where it is zero."""
    samples = [dict(known) for _, known in islice(instances(problem, sheet), INSTANCES)]

    def average(name: str, primes: int, part: Any) -> "Node":
        if isinstance(part, NameRef):
            return problem.scene.parameters.nodes[name]
        node = swing.put_in(problem, _signal(problem, part.args[0]))
        if part.head == "mean" and not sizes:
            return swing.average(node)
        return root(tidy(swing.average(node ** 2), samples), samples)

    found = lower(tree, problem.scene.table, average)
    return found if sizes else tidy(found, samples)


def _signal(problem: "Problem", tree: "NameRef | Power") -> "Node":
    """It as a function of coordinates, speeds, accelerations and the time; what is steady of it is it."""
    def at(name: str, primes: int, part: NameRef) -> "Node":
        if isinstance(part, NameRef):
            parameters = problem.scene.parameters.nodes
            return parameters[name] if name in parameters and not primes else copied([moving(
                problem.system, name, primes)], problem.scene.table)[0]
        if isinstance(part, QuantityRef) and part.head == "steady" and len(part.args) == 1:
            return _signal(problem, part.args[0])
        raise NotInLetters("this mean is found in numbers")

    return lower(tree, problem.scene.table, at)


class MotionsByWaves(NamedTuple):
    """sin τ and cos τ, and {symbol of the motion or wave of the load: what it is by these}."""

    sine: Any
    cosine: Any
    motions: Any

    def put_in(self, problem: "Problem", node: "Node") -> "Node":
        """A signal by sin τ and cos τ."""
        found, = substitute([node], self.motions)
        if found.mask & problem.scene.time.mask:
            raise NotInLetters("this signal is driven by another wave")
        return found

    def average(self, node: "Node") -> "Node":
        """Of a polynomial of sin τ and cos τ."""
        table, total = node.table, node.table.zero
        for monomial, value in expanded(node).items():
            powers = {atom: e for atom, e in monomial if atom in (self.sine, self.cosine)}
            rest = [(atom, e) for atom, e in monomial if atom not in powers]
            if any(part in (self.sine, self.cosine) for part in reachable([atom for atom, _ in rest])) or any(
                    e.denominator != 1 or e < 0 for e in powers.values()):
                raise NotInLetters("this is no polynomial of waves")
            a, b = (int(powers.get(wave, 0)) for wave in (self.sine, self.cosine))
            if a % 2 == b % 2 == 0:
                moment = fraction_of(_odd(a) * _odd(b)) / _even(a + b)
                total = total + table.product((table.number(value), ONE), (table.number(moment), ONE), *rest)
        return total


def _load(problem: "Problem") -> "tuple[Node, dict[int, dict[str, Node]]] | None":
    """(Ωt + φ, {row: {sin or cos: factor}}) of loads of one frequency; None of others."""
    acting = waves_of_all(problem.scene, problem.symbolic.excitation)
    arguments = {argument for waves in acting.values() for argument, _ in waves}
    if len(arguments) != 1:
        return None
    return arguments.pop(), {i: {kind: node for (_, kind), node in waves.items()} for i, waves in acting.items()}


def _of_harmonics(problem: "Problem", sheet: WorkedSolution, tree: QuantityRef) -> "Iterator[tuple[Node, list[Any]]]":
    """√(Σ Xₖ²/2), and Σ Xₖ²/2, of the only coordinate under several harmonics, or (ΩᵏX)² of a rate of it."""
    first, table = next(iter(getattr(tree, "args", ())), None), problem.scene.table
    square = getattr(first, "kind", "") == "power" and getattr(first.exponent, "value", 0) == 2 and (
        tree.head == "mean")
    signal: Any = first.base if square else first
    lines = [line for line in sheet.steps if re.fullmatch(r"amplitude \d+", line.settles) and line.letter]
    if len(lines) < 2 or not isinstance(signal, NameRef) or problem.scene.coordinates != [signal.name] or not (
            square or tree.head == "rms"):
        return
    (waves,) = waves_of_all(problem.scene, problem.symbolic.excitation).values()
    rates = list(dict.fromkeys(gradient(argument)[problem.scene.time] for argument, _ in waves))
    sizes = [rate ** signal.primes * table.parameter(line.letter) for rate, line in zip(rates, lines, strict=True)]
    node = table.total([size ** 2 for size in sizes]) / 2
    yield (node if square else table.sqrt(node)), [node if square else table.sqrt(node)]


def _of_one(problem: "Problem", sheet: WorkedSolution) -> MotionsByWaves | None:
    """Of the only coordinate, by the letter of its amplitude."""
    (name,), table, load = problem.scene.coordinates, problem.scene.table, _load(problem)
    line = next((line for line in sheet.steps if line.settles == f"amplitude({name})" and line.letter), None)
    if load is None or line is None:
        return None
    argument, rows = load
    M, C, _, K = (part.get((0, 0), table.zero) for part in problem.symbolic.matrices)
    A, B = (rows[0].get(kind, table.zero) for kind in ("sin", "cos"))
    X, Omega = table.parameter(line.letter), gradient(argument)[problem.scene.time]
    R, S, size = K - M * Omega ** 2, C * Omega, A ** 2 + B ** 2
    p, q = X * (R * A + S * B) / size, X * (S * A - R * B) / size
    sine, cosine = (table.parameter(wave, positive=False) for wave in (SINE, COSINE))
    return _swing(problem, [(X * sine, X * cosine)], (argument, Omega), (p * sine + q * cosine, p * cosine - q * sine))


def _of_several(problem: "Problem", sheet: WorkedSolution) -> MotionsByWaves | None:
    """Of several by the letters of the parts of their complex amplitudes."""
    table, load, told = problem.scene.table, _load(problem), {line.letter for line in sheet.steps if line.letter}
    if load is None:
        return None
    argument, rows = load
    kinds = sorted({kind for waves in rows.values() for kind in waves})
    sine, cosine = (table.parameter(wave, positive=False) for wave in (SINE, COSINE))
    places = []
    for k in range(1, len(problem.scene.q) + 1):
        a, b = (sheet.letter(part, f"X{k}") for part in "ab")
        if a not in told:
            return None
        a, b = table.parameter(a), table.parameter(b) if b in told else table.zero
        places.append((a * sine + b * cosine, a * cosine - b * sine) if kinds != ["cos"] else (
            a * cosine - b * sine, -a * sine - b * cosine))
    return _swing(problem, places, (argument, gradient(argument)[problem.scene.time]), (sine, cosine))


def _swing(problem: "Problem", places: "Sequence[tuple[Node, Node]]", frequency: "tuple[Node, Node]",
           waves: "tuple[Node, Node]") -> MotionsByWaves:
    """By [(of a coordinate, of its rate over Ω)], (Ωt + φ, Ω), and what the sine and the cosine of that are."""
    scene, table, (argument, Omega) = problem.scene, problem.scene.table, frequency
    motions = {table.call(kind, argument): node for kind, node in zip(("sin", "cos"), waves, strict=True)}
    for name, q, v, a, (place, rate) in zip(scene.coordinates, scene.q, scene.v, scene.a, places, strict=True):
        motions.update({q: at_rest(problem, name, 0) + place, v: Omega * rate, a: -(Omega ** 2) * place})
    return MotionsByWaves(*(table.parameter(wave, positive=False) for wave in (SINE, COSINE)), motions)


def _odd(n: int) -> int:
    """(n − 1)!! of an even number."""
    return prod(range(1, n, 2))


def _even(n: int) -> int:
    return prod(range(2, n + 1, 2))
