"""Answers against results: a verdict per line of `answers`.

Numbers are compared within the tolerance of the digits written, expressions to rounding and the result's own error
bound; equations of motion up to a non-zero factor, V up to a constant, at random states. A scene with symbols is
checked at several sets of random values of its symbols.
"""

import random
import re
from fractions import Fraction
from math import isfinite

from vibcli.algebra.evaluate import Floats, evaluate
from vibcli.algebra.meaning import lower, quantities_in, whole_literal
from vibcli.algebra.parse import ExpressionError
from vibcli.asking import coordinate_name
from vibcli.errors import Diagnostic, PhysicsError, SpecError
from vibcli.measured import measure
from vibcli.mechanics.energies import dissipation, kinetic, potential

EXACT, WIDEST, ROUNDING = 1e-9, 0.005, 1e-13
DRAWS, STATES, NEAR, SEPARATE = 3, 5, 1e-4, 12


class Verdict:
    """One answer compared: expected and found (numbers or None), whether they agree, and a remark."""

    __slots__ = ("agrees", "answer", "case", "expected", "found", "refusal", "remark", "tolerance")

    def __init__(self, answer, agrees, expected=None, found=None, tolerance=None, remark=None, case=None):
        self.answer, self.agrees, self.expected, self.found = answer, agrees, expected, found
        self.tolerance, self.remark, self.case, self.refusal = tolerance, remark, case, None


def check(problem):
    """The Verdicts of a problem and of its cases; PhysicsError where a scene has no such answer."""
    verdicts = [_verdict(problem, answer, None) for answer in problem.spec.answers]
    for name, spec in problem.spec.cases.items():
        part = problem.case(name)
        verdicts += [_verdict(part, answer, name) for answer in spec.answers]
    return verdicts


def _verdict(problem, answer, case):
    draws = [problem]
    if problem.symbolic:
        draws = [problem.with_values(values) for values in drawn_values(problem)]
    verdict = None
    for draw in draws:
        try:
            verdict = _compare(draw, answer)
        except PhysicsError as error:
            verdict = Verdict(answer, False, remark="no such answer: " + error.message)
            error.where = error.where or answer.asked.where
            verdict.refusal = error
        if not verdict.agrees:
            break
    verdict.case = case
    return verdict


def drawn_values(problem):
    """Sets of random positive values for the symbols of a scene in which the drawing fits together.

    Reproducible: the values depend on the names alone. They lie near the sample with which the scene was drawn,
    so that signs such as that of R − r are kept.
    """
    scene = problem.scene
    free = [name for name in scene.parameters.free if name not in scene.parameters.definitions]
    for draw in range(DRAWS):
        generator = random.Random(f"{draw} {' '.join(free)}")
        yield {name: Fraction(scene.sample[name]).limit_denominator(1000) * Fraction(generator.randint(850, 1150), 1000)
               for name in free}


def _compare(problem, answer):
    tree = answer.asked.tree
    head = tree[4] if tree[0] == "quantity" else None
    if head in ("equation", "motion"):
        return _compare_equation(problem, answer, head)
    if head in ("T", "V", "Phi"):
        return _compare_energy(problem, answer, head)
    if head == "stable":
        stable = measure(problem, tree)[0]
        wanted = answer.expected.text == "true"
        return Verdict(answer, stable == wanted, wanted, stable)
    found, error = value_of(problem, answer.asked)
    expected, _ = value_of(problem, answer.expected)
    tolerance = _tolerance(problem, answer, expected, error)
    agrees = abs(found - expected) <= tolerance
    remark = None if agrees else likely_mistake(head, expected, found)
    return Verdict(answer, agrees, expected, found, tolerance, remark)


def value_of(problem, expression):
    """(value, relative error bound) of an expression of parameters and quantities."""
    scene, values, worst, tree = problem.scene, dict(problem.floats), 0.0, expression.tree
    for quantity in quantities_in(tree):
        values[quantity[3]], error = measure(problem, quantity)
        worst = max(worst, error)
    table = scene.table

    def symbol(name, primes, part):
        return table.parameter(name, positive=False) if part[0] == "quantity" else scene.parameters.nodes[name]

    value = evaluate([_lowered(expression, table, symbol)], Floats, values)[0]
    if not isfinite(value):
        raise PhysicsError("this is not a finite real number", "mind the signs under roots, and what may vanish",
                           expression.where)
    return value, worst


def _lowered(expression, table, symbol):
    try:
        return lower(expression.tree, table, symbol)
    except ExpressionError as error:
        place = expression.scalar.place(error.offset, error.width)
        raise SpecError([Diagnostic(place, error.message, error.hint)]) from None


def _tolerance(problem, answer, expected, error):
    """The absolute tolerance: that given, that of the digits written, or rounding."""
    rounding = (EXACT + 4 * error) * abs(expected) + 1e-300
    if answer.rtol is not None:
        rtol = value_of(problem, answer.rtol)[0]
        if not 0 <= rtol < 1:
            raise SpecError([Diagnostic(answer.rtol.where, f"the tolerance is {rtol:.6g}, expected 0 to 1",
                                        "write for example rtol: 0.5 %")])
        return rtol * abs(expected) + 1e-300
    literal = whole_literal(answer.expected.tree)
    if literal is None:
        return rounding if expected else _small(problem, answer)
    written = re.match(r"\s*[-+]?\s*(\d*)\.?(\d*)(?:[eE]([-+]?\d+))?", answer.expected.text)
    whole, fraction, exponent = written.groups()
    digits = (whole + fraction).lstrip("0")
    if len(digits) < 3:
        return rounding if expected else _small(problem, answer)
    number = abs(float(literal[3]))
    half = 0.5 * 10.0 ** (int(exponent or 0) - len(fraction))
    return min(half / number, WIDEST) * abs(expected) * (1 + EXACT) if number else rounding


def _small(problem, answer):
    """What counts as zero: rounding beside the largest number of its kind."""
    tree = answer.asked.tree
    head = tree[4] if tree[0] == "quantity" else None
    if head in ("M", "C", "K"):
        matrices = dict(zip("MCGK", problem.elements.matrices(), strict=True))
        return 1e-12 * max((abs(float(value)) for value in matrices[head].values()), default=0.0)
    if head == "equilibrium":
        return 1e-12 * _reach(problem, coordinate_name(problem.spec, tree[5][0]))
    if head in ("mode", "zeta"):
        return 1e-11
    if head in ("omega", "frequency", "omega_d", "decay", "growth_rate"):
        return 1e-12 * max((float(mode.omega or mode.growth_rate or 0.0) for mode in problem.modes), default=0.0)
    return 1e-12 * max((abs(v) for v in problem.floats.values()), default=1.0)


def _states(problem):
    """Random states near the drawn position, in groups: {symbol name: array} and the slices of the groups.

    All at random; at rest, near and very near; velocities alone, accelerations alone; one coordinate alone: so a term
    is seen beside those of its kind, however stiff or heavy the rest of the scene is.
    """
    import numpy as np

    generator = random.Random("states")
    names = problem.scene.coordinates
    groups = [(1, 1, 1, names), (1, 0, 0, names), (NEAR, 0, 0, names), (0, 1, 0, names), (0, 0, 1, names)]
    if 1 < len(names) <= SEPARATE:
        groups += [(*kind, [name]) for name in names for kind in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    each, found = STATES + 3 * len(names), {}
    for name in names:
        scale = _reach(problem, name)
        for primes, (centre, spread) in enumerate(((problem.drawn_floats[name], 1), (0.0, 3), (0.0, 9))):
            found[name + "'" * primes] = centre + spread * scale * np.array([
                group[primes] * (name in group[3]) * generator.uniform(-1, 1) for group in groups for _ in range(each)])
    return found, [slice(i * each, (i + 1) * each) for i in range(len(groups))]


def _worst(wanted, found, groups, rounding=0.0):
    """(index, difference, size of the group) where two functions differ; None where they agree in each group."""
    rounding = max(rounding, ROUNDING * max(abs(wanted).max(), abs(found).max()))
    for group in groups:
        off, size = abs(wanted - found)[group], max(abs(wanted[group]).max(), abs(found[group]).max())
        if not off.max() <= EXACT * size + rounding:
            return group.start + int(off.argmax()), float(off.max()), float(size)
    return None


def _at_states(problem, nodes, states):
    """The values of expressions at all states, arrays of one length."""
    import numpy as np

    from vibcli.algebra.arrays import Arrays

    count = max(map(len, states.values()))
    with np.errstate(all="ignore"):
        values = evaluate(nodes, Arrays, {**problem.floats, **states})
    if not all(np.isfinite(value).all() and np.abs(value).max() < 1e150 for value in values):
        raise PhysicsError("this has no finite value in some positions near the drawn one",
                           "look for roots of what may be negative, and for powers out of range")
    return [np.broadcast_to(value, (count,)) for value in values]


def _reach(problem, name):
    """How far a random state strays: a fraction of the figure, or of a radian."""
    from vibcli.mechanics.equilibrium import figure_size

    return 0.2 * (figure_size(problem) or 1.0) if problem.dimension(name) else 0.3


def _expected_node(problem, expression):
    scene = problem.scene
    symbols = dict(zip(scene.coordinates, zip(scene.q, scene.v, scene.a, strict=True), strict=True))

    def symbol(name, primes, part):
        return symbols[name][primes] if name in symbols else scene.parameters.nodes[name]

    return _lowered(expression, scene.table, symbol)


def _compare_energy(problem, answer, head):
    scene = problem.scene
    ours = {"T": kinetic, "V": potential, "Phi": dissipation}[head](scene)
    expected = _expected_node(problem, answer.expected)
    states, groups = _states(problem)
    wanted, found = _at_states(problem, [expected, ours], states)
    rounding = 0.0
    if head == "V":
        first = [group.start for group in groups for _ in range(group.start, group.stop)]
        rounding = ROUNDING * max(abs(wanted).max(), abs(found).max())
        wanted, found = wanted - wanted[first], found - found[first]
    worst = _worst(wanted, found, groups, rounding)
    i = worst[0] if worst else 0
    return Verdict(answer, worst is None, float(wanted[i]), float(found[i]), None,
                   "values at a random state of motion" if worst else None)


def _compare_equation(problem, answer, head):
    """Are the two left sides proportional at random states?"""
    scene = problem.scene
    i = scene.coordinates.index(coordinate_name(problem.spec, answer.asked.tree[5][0]))
    expected = _expected_node(problem, answer.expected)
    states, groups = _states(problem)
    if head == "equation":
        states = {name: value - problem.drawn_floats.get(name, 0.0) for name, value in states.items()}
        wanted, = _at_states(problem, [expected], states)
        found = _small_oscillation(problem, i, states)
    else:
        from vibcli.mechanics.lagrange import equation_of

        wanted, found = _at_states(problem, [expected, equation_of(scene, i)], states)
    factor = float(wanted @ found / (found @ found)) if found.any() else 0.0
    worst = _worst(wanted, factor * found, groups)
    agrees = factor != 0.0 and worst is None
    remark = f"not proportional: off by {worst[1] / worst[2]:.2g} of its size" if worst else "it is empty"
    return Verdict(answer, agrees, None, None, None, None if agrees else remark)


def _small_oscillation(problem, i, states):
    """The left side of the linear equation of coordinate i at all states."""
    M, C, G, K = problem.elements.matrices()
    total = 0.0
    for j, name in enumerate(problem.scene.coordinates):
        total = total + (M.get((i, j), 0.0) * states[name + "''"] + K.get((i, j), 0.0) * states[name]
                         + (C.get((i, j), 0.0) + G.get((i, j), 0.0)) * states[name + "'"])
    return total


_TURN = 6.283185307179586
MISTAKES = (
    (("omega", "omega_d"), 1 / _TURN, "the expected value looks like a frequency in Hz, not rad/s"),
    (("frequency",), _TURN, "the expected value looks like an angular frequency in rad/s, not Hz"),
    (("period",), 1 / _TURN, "the expected value looks like 1/ω, not 2π/ω"),
    (("equilibrium", "mode"), 180 / 3.141592653589793, "the expected value looks like degrees, not radians"),
    (("omega", "frequency", "omega_d"), 0.5, "half of it: is a factor 4 missing under the root?"),
    (("omega", "frequency", "omega_d"), 2.0, "twice of it: is a factor 4 too much under the root?"),
    (("zeta", "C"), 2.0, "twice of it: c/m instead of c/(2m)?"),
    (("zeta", "C"), 0.5, "half of it: 2c/m instead of c/m?"),
    (("J",), 4.0, "four times: diameter for radius?"),
    (("J",), 0.25, "a quarter: radius for diameter?"),
    (None, -1.0, "the sign differs: which direction is positive?"),
)


def likely_mistake(head, expected, found):
    """A known mistake that explains the ratio, else the ratio."""
    if not found or not expected:
        return None
    ratio = expected / found
    for heads, factor, words in MISTAKES:
        if (heads is None or head in heads) and abs(ratio / factor - 1) < 2e-3:
            return words
    return f"ratio {ratio:.6g}"
