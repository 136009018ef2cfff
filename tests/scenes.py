"""Scenes for tests: a text to a Problem, and the value of an expression by a walk of its own over the syntax tree."""

import math
from textwrap import dedent

from vibcli.language.document.document import read, read_file
from vibcli.quantities.expression import measure
from vibcli.reader.read import read_spec
from vibcli.results.problem import Problem
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import literal_unit


def problem(text):
    """The Problem of a scene written out; SpecError where it is invalid."""
    node, diagnostics = read(dedent(text).encode(), "scene.yaml")
    return Problem(read_spec(node, "scene.yaml", diagnostics))


def problem_of(path):
    """The Problem of a file."""
    node, diagnostics, _ = read_file(str(path))
    return Problem(read_spec(node, str(path), diagnostics))


def number(tree, names, functions=math):
    """The value of a syntax tree; `names`: {name with its primes: number}, `functions`: math or mpmath."""
    kind = tree[0]
    if kind == "number":
        unit = literal_unit(tree[4])
        exact = tree[3] * unit.value
        return functions.fsum([exact.numerator]) / exact.denominator * functions.pi**unit.pi
    if kind == "name":
        return functions.pi if tree[3] == "pi" else names[tree[3] + "'" * tree[4]]
    parts = [number(part, names, functions) for part in _parts(tree)]
    if kind == "sum":
        return sum(sign * part for (sign, _), part in zip(tree[3], parts, strict=True))
    if kind == "product":
        return _product(tree[3], parts)
    if kind == "power":
        return parts[0] ** parts[1]
    if kind == "equation":
        return parts[0] - parts[1]
    return _FUNCTIONS.get(tree[3], getattr(functions, tree[3], None))(*parts)


def _parts(tree):
    if tree[0] in ("sum", "product"):
        return [part for _, part in tree[3]]
    return tree[4] if tree[0] == "call" else tree[3:5]


def _product(factors, parts):
    total = 1
    for (power, _), part in zip(factors, parts, strict=True):
        total = total * part if power > 0 else total / part
    return total


_FUNCTIONS = {"abs": abs, "min": min, "max": max, "sign": lambda x: (x > 0) - (x < 0)}


def value(scene, quantity):
    """The value of a quantity such as omega[1], K[x,y] or stable of a numeric problem."""
    tree = parse(quantity)
    return measure(scene, tree if tree[0] == "quantity" else ("quantity", 0, 0, quantity, quantity, (), "", ()))[0]
