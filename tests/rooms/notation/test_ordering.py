"""Signs before brackets, as books have them."""

import math
import random

import pytest

from vibcli.notation.latex import latex
from vibcli.notation.plain import plain
from vibcli.notation.scene_language import language
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression import Table

SAMPLE = {"a": 1.2, "b": 1.5, "h": 0.5, "k": 30.0, "c": 26.0, "R": 2.0, "r": 1.0}


def _table():
    table = Table()
    table.resample(SAMPLE)
    letters = {name: table.parameter(name) for name in SAMPLE}
    return table, letters | {name: table.variable(name) for name in ("x", "y", "t")}


@pytest.mark.parametrize(("sign", "written"), [(-1, "k·(x − h)"), (1, "k·(h − x)")])
def test_a_minus_goes_into_a_difference_that_ends_with_what_moves(sign, written):
    _, s = _table()
    assert plain(sign * s["k"] * (s["h"] - s["x"])) == written


def test_two_differences_are_turned_together():
    """(h − x)·(b − y) is (x − h)·(y − b)."""
    _, s = _table()
    two = (s["h"] - s["x"]) * (s["b"] - s["y"])
    assert plain(s["k"] * two) == "k·(x − h)·(y − b)" and plain(-s["k"] * two * (s["a"] - s["t"])) == (
        "k·(x − h)·(y − b)·(t − a)")
    assert plain(-s["k"] * two) == "k·(b − y)·(x − h)"


def test_a_minus_goes_into_an_odd_function_of_such_a_difference():
    """−sin(b − t) is sin(t − b); the cosine has no minus to take."""
    table, s = _table()
    late = table.pi * (s["b"] - s["t"]) / s["a"]
    assert plain(-s["h"] * table.call("sin", late)) == "h·sin(π·(t − b)/a)"
    assert plain(s["h"] * table.call("sin", late)) == "h·sin(π·(b − t)/a)"
    assert plain(-s["h"] * table.call("cos", late)) == "−h·cos(π·(b − t)/a)"
    assert "t - b" in latex(-s["h"] * table.call("sin", late))


def test_couplings_are_written_in_the_order_of_their_letters():
    """(a c − b k) φ, whichever is larger."""
    _, s = _table()
    coupling = s["a"] * s["c"] - s["b"] * s["k"]
    assert plain(s["c"] * s["y"] - (s["b"] * s["k"] - s["a"] * s["c"]) * s["x"]) == "(a·c − b·k)·x + c·y"
    assert plain(coupling) == "a·c − b·k"
    assert plain(s["y"] - (s["b"] * s["k"] - s["h"]) * s["x"]) == "(h − b·k)·x + y"


def test_what_has_one_sign_keeps_it():
    """R − r of two radii, R − R cos x, 1 − x, and terms of letters alone."""
    table, s = _table()
    assert plain(-(s["R"] - s["r"]) * s["x"]) == "−(R − r)·x"
    assert plain(-s["y"] * (s["R"] - s["R"] * table.call("cos", s["x"]))) == "−(R − R·cos\u00a0x)·y"
    assert plain(-s["k"] * (1 - s["x"])) == "−k·(1 − x)"
    assert plain(s["h"] - s["R"] * (s["b"] * s["k"] - s["a"] * s["c"])) == "h − R·(b·k − a·c)"
    assert plain(-s["R"] * (s["b"] * s["k"] - s["a"] * s["c"])) == "R·(a·c − b·k)"


def test_more_signs_are_never_made():
    _, s = _table()
    assert plain(-s["k"] * (s["h"] + s["a"] - s["x"])) == "−k·(a + h − x)"


@pytest.mark.parametrize("seed", range(40))
def test_turned_signs_keep_the_value(seed):
    """Of products of differences, sines and cosines of them, alone and in sums, by Python's arithmetic on what is
    written."""
    draw, (table, s) = random.Random(seed), _table()
    names = [*s]

    def difference():
        picked = draw.sample(names, draw.choice((2, 2, 3, 4)))
        found = table.zero
        for name in picked:
            factor = s[draw.choice(names)] if draw.random() < 0.4 else table.one
            found = found + draw.choice((-1, 1, -2)) * s[name] * factor
        return found

    def product():
        found = table.number(draw.choice((-1, 1, -3)))
        for _ in range(draw.choice((1, 2, 3))):
            part = difference()
            kind = draw.random()
            part = table.call("sin", part) if kind < 0.2 else table.call("cos", part) if kind < 0.3 else part
            found = found * (part ** draw.choice((1, 1, 1, 2, -1)))
        return found

    node = product() if seed % 2 else product() + product() * s["x"]
    at = {name: draw.uniform(0.3, 2.0) for name in names}
    value, = evaluate([node], Floats, at)
    written = eval(language(node).replace("^", "**"), {"sin": math.sin, "cos": math.cos}, at)
    assert written == pytest.approx(value, rel=1e-9, abs=1e-9)
