"""Mutated expressions and scenes: whatever is wrong with them, nothing but a diagnostic or a refusal escapes. The tests
try a few, `make fuzz` very many (many.py).
"""

import json
import random
from copy import deepcopy
from pathlib import Path

from support.hostile_texts import EXTREMES, SAME, require_told

from vibcli.base import units
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.work import Work
from vibcli.check.verdicts import check
from vibcli.language.document.document import Mapping, Scalar, Sequence, read
from vibcli.reader.read import read_spec
from vibcli.report.keys import data
from vibcli.report.sections.equations_of_motion import EQUATIONS
from vibcli.report.sections.spectrum_data import frequencies_data
from vibcli.results.problem import Problem
from vibcli.symbolic.evaluation import Floats, evaluate, evaluate_rational
from vibcli.symbolic.expression import Table
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import DimensionCheck, lower
from vibcli.symbolic.syntax import Equation, ExpressionError, parts_of

ROOT = Path(__file__).parents[2]
PATIENCE = 0.004    # of what is usual: a scene that takes long is refused, and what is said then is looked at
SCENES = [path.read_bytes() for path in sorted(
    [*(ROOT / "problems").glob("*/*.yaml"), *(ROOT / "vibcli" / "examples").glob("*.yaml")])]
PIECES = ("0", "1", "2", "-1", "0.5", "1e300", "1e-300", "9**9**9**9", "1e400", "3 m", "2 kg", "5 N/m",
          "8 N*s/m", "30 deg", "4 %", "7 Hz", "3 rad/s", "m", "k", "x", "x'", "x''", "phi", "L", "g", "pi",
          "t", "omega[1]", "J[a, O]", "centre[a].x", "sin(", "sqrt(", "atan2(", "exp(", "log(", "tan(",
          "abs(", "min(", "max(", "(", ")", ",", "+", "-", "*", "/", "^", "**", "=", "'", "[", "]", ".", "µm",
          "°", "²", "φ", "·", "__class__", "\u202e", "?", "e9", " ")
WORDS = ("mass", "inertia", "at", "slide", "pin", "roll", "move", "turn", "weld", "carrier", "k", "c",
         "between", "stretch", "torsion", "preload", "free_length", "shape", "radius", "from", "to", "parts",
         "value", "drawn", "by", "along", "surface", "travel", "swing", "circle", "line", "side", "body", "T",
         "V", "Phi", "M", "C", "K", "relative", "omega[1]", "zeta[1]", "stable", "equation[x]", "gravity",
         "cases", "matrices", "energies", "forces")


def a_text(dice):
    """Pieces in any order, or alternating as operands and operators would."""
    pieces = dice.choices(PIECES, k=dice.randrange(1, 12))
    return ("" if dice.random() < 0.5 else dice.choice((" * ", " + ", " / ", "^", " "))).join(pieces)


def try_expression(text, equation=False):
    """Parse, measure, lower and evaluate; whether all of that went well."""
    known = units.Dimensions()
    try:
        tree = parse(text, "x = 0" if equation else None)
        if not isinstance(tree, Equation):
            DimensionCheck(known, lambda name, primes: units.times(known.of(name), units.TIME, -primes),
                           text=text).dimension(tree)
        table = Table()
        node = lower(tree, table, lambda name, primes, _: table.parameter(name + "'" * primes))
    except ExpressionError as error:
        assert error.message
        assert 0 <= error.offset <= len(text)
        return False
    parts = parts_of(tree)
    names = {name + "'" * primes for name, primes, _, _ in parts.names} | {q.text for q in parts.quantities}
    value, = evaluate([node], Floats, dict.fromkeys(names, 0.75))
    evaluate_rational([node], dict.fromkeys(names, 2))
    return isinstance(value, (int, float))


def try_scene(root, problems):
    """Every stage of a scene, its answers, and its results as JSON; the kind of outcome."""
    try:
        spec = read_spec(root, "s.yaml", problems)
        for problem in (Problem(part, work=Work(PATIENCE)) for part in (spec, *spec.cases.values())):
            small = len(problem.scene.coordinates) <= 6
            if small:
                json.dumps([data([EQUATIONS], problem), problem.symbolic.energies is None], allow_nan=False)
            if not problem.numeric.has_free_symbols:
                json.dumps(frequencies_data(problem), allow_nan=False)
        for verdict in check(Problem(spec, work=Work(PATIENCE))):
            json.dumps([verdict.expected, verdict.found], allow_nan=False)
    except SpecError as error:
        require_told(error)
        return "invalid"
    except PhysicsError as error:
        assert error.message
        return "refused"
    return "solved"


def mutated_text(dice):
    """A scene with a few changes in its bytes: pieces put in, taken out, or taken from another scene."""
    data = bytearray(dice.choice(SCENES))
    for _ in range(dice.randrange(1, 4)):
        start = dice.randrange(len(data))
        end = min(len(data), start + dice.randrange(1, 12))
        other = dice.choice(SCENES)
        place = dice.randrange(len(other))
        put = dice.choice((b"", dice.choice(EXTREMES).encode(), dice.choice(PIECES).encode(), other[place:place + 20]))
        data[start:end if dice.random() < 0.7 else start] = put
    return bytes(data)


def places(node):
    """(container, key) of every value below a node."""
    found, pending = [], [node]
    while pending:
        part = pending.pop()
        if isinstance(part, Mapping):
            found += [(part, key) for key in part.entries]
            pending += [value for _, value in part.entries.values()]
        elif isinstance(part, Sequence):
            found += [(part, index) for index in range(len(part.items))]
            pending += part.items
    return found


def value_at(container, key):
    return container.entries[key][1] if isinstance(container, Mapping) else container.items[key]


def put(container, key, value):
    if isinstance(container, Mapping):
        container.entries[key] = (container.entries[key][0], value)
    else:
        container.items[key] = value


def mutate(root, dice):
    """One change of a tree: a value swapped or replaced, a key renamed or dropped, a value taken from another place."""
    found = places(root)
    if not found:
        return
    container, key = dice.choice(found)
    old, kind = value_at(container, key), dice.randrange(9)
    if kind == 0 and isinstance(container, Mapping):
        del container.entries[key]
    elif kind == 1 and isinstance(container, Mapping):
        name = dice.choice(WORDS)
        node, value = container.entries.pop(key)
        container.entries[name] = (Scalar(name, node.where, False, 0), value)
    elif kind == 2:
        other, place = dice.choice(found)
        put(container, key, deepcopy(value_at(other, place)))       # a file writes each node once
        if dice.random() < 0.5 and not contains(old, other):
            put(other, place, old)
    else:
        text = replaced(old.text, dice) if kind > 3 and isinstance(old, Scalar) else dice.choice(EXTREMES)
        put(container, key, Scalar(text, old.where, False, 0))


def contains(node, sought):
    return node is sought or any(value_at(*place) is sought for place in places(node))


def replaced(text, dice):
    """A value with another sign, factor, unit or operand."""
    if dice.random() < 0.7:
        return dice.choice(SAME).replace("_", text or "0")
    return dice.choice((f"({text})^2", f"1/({text})", f"({text})/0", f"({text})*x", text + " m", text[:-1],
                        f"sin({text})", text.split()[0] if text.split() else "", f"({text})*sqrt(-1)",
                        f"({text})*exp(800)", text.replace("m", "kg"), text + "'", "0"))


def tree_of(dice):
    """A scene as nodes with a few mutations; depth is bounded, as reading bounds it."""
    root, problems = read(dice.choice(SCENES), "s.yaml")
    for _ in range(dice.choice((1, 1, 1, 2, 3))):
        mutate(root, dice)
        if depth(root) > 32:
            return read(dice.choice(SCENES), "s.yaml")
    return root, problems


def test_a_node_stands_in_one_place():
    """As in what is read of a file, where names are looked up by their nodes."""
    root, _ = tree_of(random.Random("nodes 18183 104"))
    nodes = [id(value_at(*place)) for place in places(root)]
    assert len(nodes) == len(set(nodes))


def depth(node, above=0):
    if above > 40 or isinstance(node, Scalar):
        return above
    parts = [value for _, value in node.entries.values()] if isinstance(node, Mapping) else node.items
    return max((depth(part, above + 1) for part in parts), default=above)


def test_expressions():
    dice = random.Random(3)
    good = sum(try_expression(a_text(dice), dice.random() < 0.1) for _ in range(6000))
    assert good > 100


def with_changed_text(dice):
    return read(mutated_text(dice), "s.yaml")


def outcomes_of(draw, count, seed):
    """The outcomes of so many scenes that `draw` makes of a source of chance."""
    dice = random.Random(seed)
    return [try_scene(*draw(dice)) for _ in range(count)]


def test_scenes_with_changes_in_their_text():
    outcomes = outcomes_of(with_changed_text, 150, 5)
    assert min(outcomes.count(kind) for kind in ("solved", "invalid")) > 20


def test_scenes_with_changes_in_their_nodes():
    outcomes = outcomes_of(tree_of, 150, 1)
    assert min(outcomes.count(kind) for kind in ("solved", "invalid", "refused")) >= 3
