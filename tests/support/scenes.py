"""Scenes for tests: a text to a Problem, and the value of an expression by a walk of its own over the syntax tree."""

import math
from functools import cache, wraps
from pathlib import Path
from textwrap import dedent

from vibcli.check.instances import Instances
from vibcli.inverse import settled
from vibcli.language.document.document import read, read_file
from vibcli.quantities.expression import measure
from vibcli.reader.read import read_spec
from vibcli.results.problem import Problem
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import literal_unit
from vibcli.symbolic.syntax import Equation, NameRef, Number, Power, Product, QuantityRef, Sum


def problem(text):
    """The Problem of a scene written out; SpecError where it is invalid."""
    node, diagnostics = read(dedent(text).encode(), "scene.yaml")
    return Problem(read_spec(node, "scene.yaml", diagnostics))


def problem_of(path):
    """The Problem of a file."""
    node, diagnostics, _ = read_file(str(path))
    return Problem(read_spec(node, str(path), diagnostics))


def kept(of_file):
    """One for all tests of a process that only read what it finds, however they name the file."""
    known = cache(of_file)
    return wraps(of_file)(lambda path, *more: known(Path(path).resolve(), *more))


@kept
def kept_problem_of(path):
    """The Problem of a file."""
    return problem_of(path)


@kept
def kept_drawing_of(path, case=""):
    """What is drawn of it, or of one of its cases, to be looked at by several tests."""
    from vibcli.drawing.drawing import draw

    found = kept_problem_of(path)
    return tuple(draw(found.case(case) if case else found))


@kept
def kept_settled_of(path):
    """The same with the first solution for what it chooses."""
    return settled(kept_problem_of(path))


@kept
def kept_instances_of(path, case=""):
    """Its Instances with numbers, of one of its cases where that is named."""
    found = kept_problem_of(path)
    if case:
        return Instances(found.case(case))
    return Instances(found if found.symbolic.letters else kept_settled_of(path))


def number(tree, names, functions=math):
    """The value of a syntax tree; `names`: {name with its primes: number}, `functions`: math or mpmath."""
    if isinstance(tree, Number):
        unit = literal_unit(tree.units)
        exact = tree.value * unit.value
        return functions.fsum([exact.numerator]) / exact.denominator * functions.pi**unit.pi
    if isinstance(tree, NameRef):
        return functions.pi if tree.name == "pi" else names[tree.name + "'" * tree.primes]
    parts = [number(part, names, functions) for part in tree.children]
    if isinstance(tree, Sum):
        return sum(sign * part for (sign, _), part in zip(tree.parts, parts, strict=True))
    if isinstance(tree, Product):
        return _product(tree.parts, parts)
    if isinstance(tree, Power):
        return parts[0] ** parts[1]
    if isinstance(tree, Equation):
        return parts[0] - parts[1]
    return _FUNCTIONS.get(tree.name, getattr(functions, tree.name, None))(*parts)


def _product(factors, parts):
    total = 1
    for (power, _), part in zip(factors, parts, strict=True):
        total = total * part if power > 0 else total / part
    return total


_FUNCTIONS = {"abs": abs, "min": min, "max": max, "sign": lambda x: (x > 0) - (x < 0)}


def value(scene, quantity):
    """The value of a quantity such as omega[1], K[x,y] or stable of a numeric problem."""
    tree = parse(quantity)
    return measure(scene, tree if isinstance(tree, QuantityRef) else QuantityRef(0, 0, quantity, quantity))[0]


def scene_of_potential(V, names="x", within=2):
    """A Problem of the potential energy V in joules of numbers; `within`: a number, None (one turn), or several."""
    pairs = within if isinstance(within, dict) else dict.fromkeys(names, within)
    limits = ", ".join(f"{name}: [-{end}, {end}]" for name, end in pairs.items())
    bounds = f"find: {{equilibria: all, within: {{{limits}}}}}\n" if within else ""
    T = " + ".join(f"{name}'^2" for name in names)
    return problem(f"parameters: {{J: 1 kg*m^2, E: 1 J}}\ncoordinates: [{', '.join(names)}]\n{bounds}"
                   f"energies:\n  T: J/2*({T})\n  V: E*({V})\n")
