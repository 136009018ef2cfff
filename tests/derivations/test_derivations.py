"""Every answer of every problem file against a derivation by another route (one module of this folder a file).

A derivation works from the parameter values alone, by statics, momentum, quadrature or numerical differences, and never
imports vibcli; the file's expected value is evaluated by a plain walk over its syntax tree.
"""

import ast
import random
import re
from importlib.util import module_from_spec, spec_from_file_location
from itertools import islice
from pathlib import Path

import pytest
from support.scenes import kept_instances_of, kept_problem_of, number

from vibcli.check.verdicts import verdicts_of
from vibcli.inverse import settled
from vibcli.symbolic.syntax import QuantityRef

HERE = Path(__file__).parent
PROBLEMS = sorted((HERE.parents[1] / "problems").glob("*/*.yaml"))
DERIVATIONS = sorted(path for path in HERE.glob("*.py") if path.stem != "test_derivations")
EXPRESSION, WIDEST, SMALL = 1e-9, 0.005, 1e-10
LEAST_FILES, LEAST_ANSWERS = 45, 300
LITERAL = re.compile(r"\s*[-+]?\s*(\d*)\.?(\d*)(?:[eE]([-+]?\d+))?(\s+[A-Za-z%°µ][\w/*^·%°µ²³-]*)?\s*")


SHARED = HERE.parent / "support" / "transfer_matrices.py"      # which they may import


def derivation(path):
    """The module tests/derivations/STEM.py of a problem file."""
    spec = spec_from_file_location("derivation_" + path.stem, HERE / (path.stem + ".py"))
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def cases(problem, settle=False):
    """[(prefix of the keys, Problem)] of the scene and its cases; `settle`: with what the cases choose."""
    parts = [(f"{name}: ", problem.case(name)) for name in problem.spec.cases]
    return [("", problem)] + [(prefix, settled(part) if settle else part) for prefix, part in parts]


def plain(key):
    return key.replace(" ", "")


def keys_of(problem):
    return [plain(prefix + answer.asked.text) for prefix, part in cases(problem) for answer in part.spec.answers]


def draws(path):
    """The problem with numbers: itself, or with several sets of random positive values for its symbols."""
    draws = kept_instances_of(path)
    return list(islice(draws, draws.wanted))


def tolerance(text):
    """The relative tolerance that the digits of an expected value allow, of expressions that of rounding."""
    match = LITERAL.fullmatch(text)
    if match is None:
        return EXPRESSION
    whole, fraction, _, _ = match.groups()
    digits = (whole + fraction).lstrip("0")
    if len(digits) < 3:
        return EXPRESSION
    return min(0.5 / int(digits), WIDEST) * (1 + 1e-9)


def states(names, drawn, about_zero=False):
    """Random states of motion (q, v, a), near the drawn position or near zero."""
    generator = random.Random("derivations")
    for _ in range(4 + 3 * len(names)):
        near = {name: 0.0 if about_zero else drawn[name] for name in names}
        yield ({name: near[name] + generator.uniform(-0.09, 0.09) for name in names} | {"t": generator.uniform(0, 3)},
               {name: generator.uniform(-2, 2) for name in names},
               {name: generator.uniform(-9, 9) for name in names})


def same_number(expected, found, rtol, scale):
    """Do two numbers agree; where zero is expected, within rounding of the figures of the problem."""
    return abs(expected - found) <= rtol * abs(expected) + (SMALL * scale if expected == 0 else 0)


def same_function(pairs, up_to_factor=False, up_to_constant=False, rtol=1e-8):
    """Do (expected, found) of several states agree, perhaps up to a non-zero factor or to a constant?"""
    if up_to_constant:
        pairs = [(x - pairs[0][0], y - pairs[0][1]) for x, y in pairs[1:]]
    factor = 1.0
    if up_to_factor:
        factor = sum(x * y for x, y in pairs) / sum(y * y for _, y in pairs)
    size = max(abs(x) for x, _ in pairs)
    return size > 0 and factor != 0 and max(abs(x - factor * y) for x, y in pairs) <= rtol * size


def agrees(problem, answer, found):
    """Does an answer of a numeric problem agree with what its derivation found?"""
    tree = answer.asked.tree
    head = tree.head if isinstance(tree, QuantityRef) else None
    of_state = head in ("equation", "motion") or (head in ("T", "V", "Phi") and not tree.indices)
    if head == "stable":
        return found == (answer.expected.text == "true")
    if of_state:
        return same_function(sampled(problem, answer, head, found), up_to_factor=head in ("equation", "motion"),
                             up_to_constant=head == "V")
    expected = float(number(answer.expected.tree, problem.numeric.floats))
    scale = max(map(abs, problem.numeric.floats.values()), default=1.0)
    rtol = number(answer.rtol.tree, problem.numeric.floats) if answer.rtol else tolerance(answer.expected.text)
    return same_number(expected, float(found), rtol, scale)


def sampled(problem, answer, head, found):
    """(file's value, derivation's value) of a function of state, at random states."""
    names = problem.scene.coordinates
    pairs = []
    for q, v, a in states(names, problem.numeric.drawn_floats, head == "equation"):
        symbols = q | problem.numeric.floats | {name: q[name] for name in names}
        symbols |= {f"{n}'": v[n] for n in names} | {f"{n}''": a[n] for n in names}
        arguments = {"V": (q,), "T": (q, v), "Phi": (q, v)}.get(head, (q, v, a))
        pairs.append((float(number(answer.expected.tree, symbols)), float(found(*arguments))))
    return pairs


def derived(path, draw):
    """{key: number or function} that the derivation finds of a problem with numbers."""
    return {plain(key): value for key, value in derivation(path).answers(dict(draw.numeric.floats)).items()}


def answers_of(draw):
    """[(key, problem in numbers, answer)] of a problem with numbers and its cases."""
    return [(plain(prefix + answer.asked.text), part, answer) for prefix, part in cases(draw, settle=True)
            for answer in part.spec.answers]


@pytest.mark.sweep
@pytest.mark.parametrize("path", PROBLEMS, ids=lambda path: path.stem)
def test_answers_agree_with_the_derivation(path):
    """The derivation covers exactly the answers, and agrees; where it is spoiled, none of them agrees."""
    for i, draw in enumerate(draws(path)):
        found, asked = derived(path, draw), answers_of(draw)
        assert sorted(found) == sorted(key for key, *_ in asked)
        differ = sorted(key for key, part, answer in asked if not agrees(part, answer, found[key]))
        assert not differ, f"{path}: {', '.join(differ)}"
        if not i:
            assert not [key for key, part, answer in asked if agrees(part, answer, spoiled(found[key]))]


@pytest.mark.sweep
@pytest.mark.parametrize("path", PROBLEMS, ids=lambda path: path.stem)
def test_the_program_finds_every_answer(path):
    """All that `vibcli check problems` compares, in scenes that other tests solve as well."""
    scene = kept_problem_of(path)
    scene.draw()
    for case in ("", *scene.spec.cases):
        part = scene.case(case) if case else scene
        found = verdicts_of(part, part.spec.answers, case, instances=kept_instances_of(path, case))
        assert not [verdict for verdict in found if not verdict.agrees]
    assert scene.spec.answers or scene.spec.cases


@pytest.mark.sweep
def test_how_many_were_compared():
    assert len(PROBLEMS) >= LEAST_FILES
    assert len({path.stem for path in PROBLEMS}) == len(PROBLEMS)
    assert sum(len(keys_of(kept_problem_of(path))) for path in PROBLEMS) >= LEAST_ANSWERS


def test_every_derivation_belongs_to_a_problem():
    assert {path.stem for path in DERIVATIONS} == {path.stem for path in PROBLEMS}


@pytest.mark.parametrize("path", [*DERIVATIONS, SHARED], ids=lambda path: path.stem)
def test_derivations_do_not_import_what_they_test(path):
    tree = ast.parse(path.read_text())
    names = [alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names]
    names += [node.module or "." for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    known = {"math", "cmath", "mpmath", "numpy", "scipy", "fractions"}
    assert {name.split(".")[0] for name in names if name != "support.transfer_matrices"} <= known
    assert ast.get_docstring(tree), "a derivation says by which route it goes"


def spoiled(value):
    """A wrong answer: a number off by more than its tolerance, a function with one term too much."""
    if isinstance(value, bool):
        return not value
    if callable(value):
        return lambda q, *rest: value(q, *rest) + wrong_term(q, *rest)
    return float(value) * 1.006 + (1e-3 if abs(value) < 1e-9 else 0)


def wrong_term(q, v=None, a=None):
    place = next(iter(q.values()))
    return place**2 if v is None else next(iter(v.values())) ** 2 + place


def test_the_helpers_reject():
    assert same_function([(1, 2), (2, 4)], up_to_factor=True)
    assert not same_function([(1, 2), (2, 4)])
    assert not same_function([(1, 0), (0, 1)], up_to_factor=True)
    assert not same_function([(1, 2), (3, 4), (4, 5.1)], up_to_constant=True)
    assert not same_function([(0, 0), (0, 0)])
    assert not same_number(1.0, 1.0 + 3e-9, tolerance("m*g"), 1.0)
    assert tolerance("21.9 rad/s") == pytest.approx(0.5 / 219)
    assert tolerance("1.02") == pytest.approx(0.5 / 102)
    assert tolerance("0.25") == tolerance("2*k") == EXPRESSION
