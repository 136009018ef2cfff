"""Every formula in every notation, read back and evaluated against the expression that was written."""

import math
import random
import unicodedata
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest
from support import formulas, printed
from support.scenes import kept_problem_of

from vibcli.notation.latex import latex
from vibcli.notation.mathml import mathml
from vibcli.notation.notation_text import read
from vibcli.notation.plain import plain
from vibcli.notation.scene_language import language
from vibcli.notation.typed_tree import typeset
from vibcli.notation.typeset import Stacked
from vibcli.notation.typst import typst
from vibcli.report.document import EVERYTHING, Report
from vibcli.report.sections.equations_of_motion import equation_rows
from vibcli.report.sections.symbolic_modes import turned
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression import Table
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import UNITS
from vibcli.symbolic.parser import parse

WAYS = {**printed.NOTATIONS, "language": (language, formulas.plain)}
LETTERS = ("m", "k", "l1", "L2", "phi", "kf", "m_rot", "x'", "theta2''", "beta", "R")
EXPONENTS = [Fraction(*pair) for pair in ((1, 1), (1, 1), (2, 1), (-1, 1), (-2, 1), (1, 2), (-1, 2), (3, 2), (-3, 2),
                                          (1, 3), (-2, 3), (1, 4))]
NUMBERS = [Fraction(*pair) for pair in ((1, 1), (2, 1), (1, 2), (3, 4), (5, 3), (1, 100), (7, 1000), (12345, 100),
                                        (1, 7), (10**20, 1), (1, 3 * 10**7))]
FUNCTIONS = ("sin", "cos", "tan", "exp", "log", "abs", "sinh", "atan", "sign")


def grown(table, draw, depth):
    """A random expression."""
    kind = draw.random() if depth else 1.0
    if kind < 0.35:
        return table.sum(*((grown(table, draw, depth - 1), draw.choice((1, 1, -1)) * draw.choice(NUMBERS))
                           for _ in range(draw.randint(2, 3))))
    if kind < 0.75:
        return table.product((table.number(draw.choice(NUMBERS[:5])), 1), *(
            (grown(table, draw, depth - 1), draw.choice(EXPONENTS)) for _ in range(draw.randint(1, 3))))
    if kind < 0.85:
        return table.call(draw.choice(FUNCTIONS), grown(table, draw, depth - 1))
    return table.parameter(draw.choice(LETTERS)) if draw.random() < 0.8 else table.number(draw.choice(NUMBERS))


def readable(node, values):
    """Can its value be told from printed digits: no power too large, none of roots of roots, no angle of many turns?"""
    parts = [part for part in reachable([node]) if part.op in ("product", "call")]
    powers = [node.table.power(base, e) for part in parts if part.op == "product" for base, e in part.args]
    if any(e.denominator > 12 for part in parts if part.op == "product" for _, e in part.args):
        return False
    angles = [arg for part in parts if part.op == "call" for arg in part.args]
    return all(1e-30 < abs(size) < 1e30 for size in evaluate([node, *powers], Floats, values)) and all(
        abs(angle) < 30 for angle in evaluate(angles, Floats, values))


@cache
def expressions():
    """[(a random expression, its value, the values of its symbols)]"""
    draw, found = random.Random(14), []
    while len(found) < 300:
        try:
            node = grown(Table(), draw, 3)
        except ZeroDivisionError:       # of a sum of which nothing is left
            continue
        values = {letter: draw.uniform(0.5, 2.0) for letter in LETTERS}
        if readable(node, values):
            found.append((node, evaluate([node], Floats, values)[0], values))
    return found


def value_of(text, read, values):
    try:
        return formulas.value(read(text), values.__getitem__)
    except formulas.Unreadable as error:
        raise AssertionError(text) from error


@pytest.mark.sweep
@pytest.mark.parametrize("name", WAYS)
def test_random_expressions_are_read_back(name):
    write, read = WAYS[name]
    for node, wanted, values in expressions():
        keyed = {formulas.symbol(name): value for letter, value in {**values, "pi": math.pi}.items()
                 for name in (letter, plain.symbol(letter))}
        text = write(node)
        assert formulas.agree(value_of(text, read, keyed), wanted), f"{node}\n{text}"


@pytest.mark.sweep
@pytest.mark.parametrize("name", [name for name, (write, _) in WAYS.items() if isinstance(write, Stacked)])
def test_what_was_typed_is_read_back(name):
    """As the language writes expressions, with brackets that a file may have and the tree has not."""
    write, read = WAYS[name]
    for node, wanted, values in expressions():
        text = language(node)
        keyed = {formulas.symbol(name): value for letter, value in {**values, "pi": math.pi}.items()
                 for name in (letter, plain.symbol(letter))}
        for typed, due in ((text, wanted), (f"2*({text})*3 - ({text} - 1)", 5 * wanted + 1)):
            shown = typeset(parse(typed), typed, write)
            assert formulas.agree(value_of(shown, read, keyed), due), f"{typed}\n{shown}"


ROOT = Path(__file__).parents[3]
FILES = sorted([*(ROOT / "problems").glob("*/*.yaml"), *(ROOT / "vibcli" / "examples").glob("*.yaml")])
SHOWN = (*EVERYTHING, "response", "frequency_response", "shares", "sensitivities", "estimates")
NAMED = ("car_bounce_and_pitch", "press_with_two_blows", "dampers_in_series")
SAMPLE = [path for i, path in enumerate(FILES) if i % 16 == 3 or path.stem in NAMED]


def numbers(found):
    """{symbol: number}: the parameters of a scene as they are drawn, its motion small and at random."""
    draw, values = random.Random(3), {**found.scene.sample, **dict.fromkeys(UNITS.values(), 1.0)}
    for scene in (found.system.scene_with_multipliers, found.scene):
        for node in (*scene.q, *scene.v, *scene.a):
            values.setdefault(node.name, draw.uniform(0.02, 0.08))
    return values


@pytest.mark.sweep
@pytest.mark.parametrize("path", SAMPLE, ids=lambda path: path.stem)
def test_reports_are_read_back(path):
    base = kept_problem_of(path)
    for found in (base, *map(base.case, base.spec.cases)):
        if found.spec.choices or found.scene.members:     # ∂²u/∂x² and names of places are not read back
            continue
        report, values = Report(found), numbers(found)
        for name in SHOWN:
            report.add(name)
        lines = printed.of_documents([report.document()])
        assert all(printed.compared(parts, values) for parts in lines if len(parts) > 1 and parts[1] != ":  ")
        for entry in equation_rows(found) if found.system.scene_with_multipliers.q else ():
            printed.compared_texts(entry["text"], entry["latex"], values)
            printed.compared_texts(entry["linear_text"], entry["linear_latex"], values)


@pytest.mark.parametrize("exponent, wanted", [(1, "c·(a·b + 2)"), (-1, "c/(a·b + 2)"), (2, "c·(a·b + 2)²")])
def test_a_sum_of_negative_terms_gives_its_sign_away(exponent, wanted):
    table = Table()
    a, b, c = map(table.parameter, "abc")
    node = table.product((-a * b - 2, exponent), (c, 1))
    assert plain(node).lstrip("−") == wanted
    assert plain(node).startswith("−") == (exponent != 2)
    assert plain(-node).startswith("−") == (exponent == 2)


@pytest.mark.parametrize(("exponent", "wanted"), [
    ((2, 1), "c·x²"), ((3, 1), "c·|x|³"), ((1, 2), "c·√(|x|)"), ((5, 2), "c·|x|^(5/2)"), ((-3, 2), "c/|x|^(3/2)"),
    ((4, 3), "c·|x|^(4/3)"), ((1, 4), "c·|x|^(1/4)")])
def test_powers_of_a_magnitude_are_one_power(exponent, wanted):
    table = Table()
    size = table.call("abs", table.variable("x"))
    assert plain(table.product((size, Fraction(*exponent)), (table.parameter("c"), 1))) == wanted


def test_the_root_of_a_square_is_written_as_a_magnitude():
    table = Table()
    x, y = table.parameter("x", positive=False), table.parameter("y", positive=False)
    square = table.product((x - y, 2))
    assert plain(table.product((square, Fraction(1, 2)))) in ("|x − y|", "|y − x|")
    assert plain(table.product((square, Fraction(-1, 2)), (y, 1))) in ("y/|x − y|", "y/|y − x|")
    assert "√" in plain(table.product((square + 1, Fraction(1, 2))))


def test_what_leads_by_a_quarter_of_a_period_keeps_its_sign():
    table = Table()
    m, k = table.parameter("m"), table.parameter("k")
    for node in (-2 * m, m - k, -m / (k - m), table.one, -table.one, -(m - k) ** 2):
        assert printed.compared(["H = ", *turned(table.node(node))], {"m": 1.3, "k": 0.7}) == 2


@pytest.mark.parametrize(("write", "wanted"), [
    (mathml, f"<msub><mi>Q</mi><mi>arm.u(L/2)</mi></msub>{mathml.operator('·')}<mi>δ</mi><mtext>arm.u(L/2)</mtext>"),
    (latex, r"Q_{\mathrm{arm.u(L/2)}} \, \delta \text{arm.u(L/2)}")])
def test_what_a_member_does_at_a_place_is_one_name(write, wanted):
    assert read("Q_arm.u(L/2)·δarm.u(L/2)", write) == wanted


def test_decimals_stand_above_the_line():
    table = Table()
    x, y = table.parameter("x"), table.parameter("y")
    long, short = table.number(Fraction("3.51601526850015")) / x, table.product(
        (table.number(Fraction(1, 1000)), 1), (x + y, 1), (x, -1))
    assert [write(node) for write in (latex, typst) for node in (long, short)] == [
        r"\frac{3.5160152685}{x}", r"\frac{0.001 \, \left(x + y\right)}{x}",
        "frac(3.5160152685, x)", "frac(0.001 thin (x + y), x)"]


def test_bessel_functions_are_written_with_their_order_below():
    table = Table()
    z = table.parameter("z")
    node = table.call("J0", z) * table.call("Y1", 2 * z)
    assert plain(node) == "J₀(z)·Y₁(2·z)"
    assert {name: write(node) for name, write in (("latex", latex), ("typst", typst))} == {
        "latex": r"J_{0}\left(z\right) \, Y_{1}\left(2 \, z\right)", "typst": "J_(0) (z) thin Y_(1) (2 thin z)"}
    assert "<msub><mi>J</mi><mn>0</mn></msub>" in mathml(node)


def test_rates_are_written_in_single_letters_where_there_are():
    """As texts are compared and found (Unicode normalisation form C)."""
    for letter in "abcdefghjklmnopqrstuvwxyzABCDEFGHJKLMNOPQRSTUVWXYZ":
        for primes in ("'", "''"):
            assert unicodedata.is_normalized("NFC", plain.symbol(letter + primes)), letter
