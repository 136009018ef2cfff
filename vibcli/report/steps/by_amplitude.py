"""The steps to how the frequency of one degree of freedom hangs on its amplitude: at one that is given, by the energy,

    ½ m(q) q̇² + V(q) = E,   V = E where it turns,   2π/ω = 2 ∫ dq/|q̇| between these;

of small ones by Lindstedt's and Poincaré's expansion (Nayfeh & Mook 1979, 2.3), the inertia made constant first:

    ξ = u − μ₁u²/4 + (μ₁² − μ₂)u³/6,   ü + ω₀²u + α₂u² + α₃u³ = 0,   ω = ω₀(1 + κA²),
    κ = 3α₃/(8ω₀²) − 5α₂²/(12ω₀⁴).
"""

from math import tau
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.notation.as_printed import as_printed
from vibcli.quantities.expression import number_of, value_of
from vibcli.report.blocks import Name, SumOfTerms, Words
from vibcli.report.steps.in_motion import short_form
from vibcli.report.steps.period_by_quadrature import TurningPlaces, vanishing
from vibcli.report.steps.step import WorkedSolution, number, unit_told
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.nonlinear.small_amplitudes import EnergyFactors
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

HEAD, LETTERS = "backbone", ("omega0", "alpha2", "alpha3")
LONG = 60           # letters of the energies, beyond which they are not told
SPEED = "{}'^2"     # what the line settles that tells how fast it is
CLOSE, ROUNDING = 1e-9, 1e-13       # relative: of V at both ends, of a V that is zero


def tell_by_amplitude(problem: "Problem", sheet: WorkedSolution) -> None:
    """Write down what leads to the backbones that a scene of one coordinate asks; nothing of others."""
    rules, spec = problem.spec.get("variants"), problem.spec
    every = [*(answer.asked for answer in spec.answers), *(one.asked for one in (rules.ask if rules else ()))]
    asked = list({one.text: one for one in every if one.tree.kind == "quantity" and one.tree.head == HEAD}.values())
    if not asked or len(problem.scene.q) != 1 or spec.members:
        return
    for tell, wanted in ((_tell_energies, [one for one in asked if one.tree.args]),
                         (_tell_expansion, [one for one in asked if not one.tree.args])):
        before = len(sheet.steps)
        try:
            tell(problem, sheet, wanted)
        except (PhysicsError, SpecError):
            del sheet.steps[before:]


def _tell_energies(problem: "Problem", sheet: WorkedSolution, asked: "Sequence[Expression]") -> None:
    """Those at an amplitude; nothing in letters, or of long energies."""
    if not asked or problem.numeric.has_free_symbols:
        return
    free, scene = problem.free_motions, problem.free_motions.scene
    V, M = map(short_form, free.family.well.nodes)
    if letters(V) + letters(M) > LONG:
        return
    E, v = scene.table.parameter(sheet.letter("E"), positive=False), scene.v[0]
    line = next((line.number for line in sheet.steps if line.settles == SPEED.format(scene.coordinates[0])), None)
    if line is None:
        kinetic, node = short_form(M * v ** 2 / 2), 2 * (E - V) / M
        line = sheet.write(Words("free motions keep their energy:  "), SumOfTerms((kinetic, V)), " = ", E,
                           settles="integral of energy")
        line = sheet.write(v ** 2, " = ", node, settles=SPEED.format(scene.coordinates[0]), node=node, uses=[line])
    for i, one in enumerate(asked, 1):
        _tell_period(problem, sheet, one, f"A{i}" if len(asked) > 1 else "A", (E, V, M, line))


def _tell_period(problem: "Problem", sheet: WorkedSolution, asked: "Expression", index: str,
                 energies: "tuple[Node, Node, Node, int]") -> None:
    """Where the motion of an amplitude turns, and how long it takes."""
    (E, V, M, line), free, name = energies, problem.free_motions, problem.free_motions.scene.coordinates[0]
    q, unit = free.scene.q[0].name, "m" if problem.system.dimension(name) else "rad"
    ends = free.turning_places(asked.tree.args[0], float(number_of(problem, asked.tree.args[1])))
    left, right, rest = (evaluate([V], Floats, {**problem.numeric.floats, q: place})[0]
                         for place in (*ends, free.family.bottom))
    if abs(left - right) > CLOSE * abs(right - rest):
        return
    height = right if abs(right) > ROUNDING * abs(rest) else 0.0
    amplitude = as_printed(asked.text.split(")(")[-1][:-1])
    turns = sheet.write(Words(f"amplitude, half the range, {amplitude}:  it turns at  "), Name(name), *number(
        ends[0], unit), Words("  and  "), Name(name), *number(ends[1], unit), Words(",  where  "), Name(
            sheet.letter("V")), " = ", E, *number(height, "J"), settles=f"turning places of {asked.text}", uses=[line])
    omega, (T, q_left, q_right) = float(value_of(problem, asked)[0]), (free.scene.table.parameter(sheet.letter(
        letter, index)) for letter in ("T", f"{name}_l", f"{name}_r"))
    turning = TurningPlaces((q_left, ends[0]), (q_right, ends[1]), (T, tau / omega))
    conditions = vanishing(problem, asked.tree, turning, V, M) or (None, None, None)
    last = sheet.write(Words("twice the time from one to the other, the integral of "), "d", Name(name), "/|", Name(
        name + "'"), "|", Words(":  "), T, *number(tau / omega, "s"), settles=f"period of {asked.text}", letter=T.name,
                       value=tau / omega, unit="s", uses=[line, turns], vanishes=conditions[2])
    for (letter, place), condition in zip(turning[:2], conditions[:2], strict=True):
        sheet.write(settles=letter.name, letter=letter.name, value=place, vanishes=condition, joined=True)
    sheet.write(Name(sheet.letter("omega", index)), *number(omega, "rad/s"), settles=asked.text, value=omega,
                unit="rad/s", uses=[last], node=2 * T.table.pi / T, joined=True)


def _tell_expansion(problem: "Problem", sheet: WorkedSolution, asked: "Sequence[Expression]") -> None:
    """κ, its energies expanded to the fourth order; where the equilibrium is known in letters."""
    from vibcli.analyses.nonlinear.small_amplitudes import factors_in_letters

    if not asked:
        return
    factors = factors_in_letters(problem.symbolic)
    expansion = _Expansion(problem, sheet, factors)
    if is_zero(textbook(expansion.kappa - factors.kappa)):
        expansion.write(asked[0])


class _Expansion:
    """From V₂, V₃, V₄ and T₀, T₁, T₂ to κ."""

    def __init__(self, problem: "Problem", sheet: WorkedSolution, factors: "EnergyFactors") -> None:
        self.problem, self.sheet, self.factors = problem, sheet, factors
        self.scene = problem.scene.resting
        self.table = self.scene.table
        (V2, V3, V4), (T0, T1, T2) = (tuple(map(textbook, row)) for row in factors)
        self.mu = textbook(T1 / T0), textbook(T2 / T0)
        one, two = self.mu
        self.square = textbook(V2 / T0)
        self.alpha = (textbook(3 * (V3 - one * V2 / 2) / (2 * T0)),
                      textbook(2 * (V4 - 3 * one * V3 / 4 + V2 * (one ** 2 / 16 + (one ** 2 - two) / 3)) / T0))
        self.kappa = textbook(3 * self.alpha[1] / (8 * self.square) - 5 * self.alpha[0] ** 2 / (12 * self.square ** 2))

    def write(self, asked: "Expression") -> None:
        """Write down all of it."""
        sheet, (q,), (v,), (V2, V3, V4), (T0, T1, T2) = self.sheet, self.scene.q, self.scene.v, *self.factors
        T = textbook(T0 + T1 * q + T2 * q ** 2) * v ** 2
        V = textbook(V2 * q ** 2 + V3 * q ** 3 + V4 * q ** 4)
        line = sheet.write(Words("to the fourth order, from rest:  "), Name(sheet.letter("T")), " = ", T, Words(
            " + …,  "), Name(sheet.letter("V")), " = ", V, Words(" + …"), settles="energies to the fourth order")
        u, line = self._straightened(q, line)
        omega0, *alphas = (self.table.parameter(sheet.letter(name), positive=False) for name in LETTERS)
        alphas = [self.table.zero if node.is_zero else head for head, node in zip(alphas, self.alpha, strict=True)]
        restoring = [node * u ** power for node, power in zip((omega0 ** 2, *alphas), (1, 2, 3), strict=True)
                     if not node.is_zero]
        line = sheet.write(Words("so the equation divided by its inertia is  "), Name(u.name + "''"), Words(" + "),
                           SumOfTerms(tuple(restoring)), Words(" + …"), " = 0", settles="equation in u", uses=[line])
        known = [(omega0 ** 2, self.square), *zip(alphas, self.alpha, strict=True)]
        line = self._values([pair for pair in known if not pair[0].is_zero], line)
        self._no_secular_terms(u, omega0, alphas, asked, line)

    def _straightened(self, q: "Node", line: int) -> "tuple[Node, int]":
        """The coordinate in which the inertia is constant; q itself where it is so."""
        one, two = self.mu
        if one.is_zero and two.is_zero:
            return q, line
        u = self.table.parameter(self.sheet.letter("u"), positive=False)
        node = u - one * u ** 2 / 4 + textbook(one ** 2 - two) * u ** 3 / 6
        return u, self.sheet.write(Words("the inertia becomes constant with  "), q, " = ", node, Words(" + …"),
                                   settles="inertia made constant", uses=[line])

    def _values(self, pairs: "Sequence[tuple[Node, Node]]", line: int) -> int:
        for i, (head, node) in enumerate(pairs):
            written = self.sheet.write(head, " = ", node, settles=f"factor {i + 1} of the expansion", node=node,
                                       uses=[line], joined=i > 0)
        return written

    def _no_secular_terms(self, u: "Node", omega0: "Node", alphas: "list[Node]", asked: "Expression",
                          line: int) -> None:
        """The motion by powers of the amplitude, and κ, with which nothing of the third order grows."""
        sheet, (two, three) = self.sheet, alphas
        A, turn = (self.table.parameter(sheet.letter(name), positive=False) for name in ("A", "tau"))
        kappa = self.table.parameter(sheet.letter("kappa"), positive=False)
        cosine = self.table.call("cos", turn)
        second = -two * A ** 2 / (2 * omega0 ** 2) * (1 - self.table.call("cos", 2 * turn) / 3)
        line = sheet.write(Words("with  "), turn, " = ", Words("ω·t,  "), "ω = ", omega0 * (1 + kappa * A ** 2), Words(
            ":  "), u, " = ", _sum(A * cosine, second), Words(" + …"),
            settles="motion by powers of its amplitude", uses=[line])
        secular = (2 * omega0 ** 2 * kappa, 5 * two ** 2 / (6 * omega0 ** 2), -3 * three / 4)
        line = sheet.write(Words("of the third order what stands before "), A ** 3 * cosine, Words(
            " must vanish, else "), u, Words(" grows without end:  "), _sum(*secular), " = 0",
                           settles="no secular term", uses=[line])
        letters_of = 3 * three / (8 * omega0 ** 2) - 5 * two ** 2 / (12 * omega0 ** 4)
        value = None if self.problem.numeric.has_free_symbols else float(value_of(self.problem, asked)[0])
        unit = unit_told(self.problem.spec, asked)
        sheet.write(kappa, " = ", letters_of, " = ", self.kappa, *(() if value is None else number(value, unit)),
                    settles=asked.text, node=self.kappa, value=value, unit=unit, uses=[line])



def _sum(*nodes: "Node") -> SumOfTerms:
    """Those that are not zero."""
    return SumOfTerms(tuple(node for node in nodes if not node.is_zero))
