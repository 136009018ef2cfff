"""Numbers with units and expressions of the language, read by Python's own parser and a table of units by hand."""

import ast
import re
from fractions import Fraction

from . import jets

UNITS = {"m": 1, "cm": Fraction(1, 100), "mm": Fraction(1, 1000), "kg": 1, "s": 1, "ms": Fraction(1, 1000), "N": 1,
         "kN": 1000, "J": 1, "W": 1, "rad": 1, "Pa": 1, "%": Fraction(1, 100)}
PI_UNITS = {"deg": Fraction(1, 180), "rpm": Fraction(1, 30)}     # multiples of pi
UNIT = r"[A-Za-z%]+(?:\^\d+)?"
NUMBER = re.compile(rf"(?<![\w.])(\d+\.?\d*(?:[eE][-+]?\d+)?)(?:\s+({UNIT}(?:[*/]{UNIT})*))?")
FUNCTIONS = {"sin": jets.sin, "cos": jets.cos, "exp": jets.exp, "sqrt": jets.sqrt, "abs": jets.magnitude,
             "sign": jets.sign, "step": jets.step, "ramp": jets.ramp, "square": jets.square,
             "sawtooth": jets.sawtooth, "tanh": jets.tanh, "atan": jets.atan, "tan": jets.tan, "asin": jets.asin,
             "acos": jets.acos, "sinh": jets.sinh, "cosh": jets.cosh, "log": jets.log, "max": jets.larger,
             "min": jets.smaller, "atan2": jets.atan2}


def _literal(match):
    """A number with its unit as a call that holds an exact ratio and a power of pi."""
    value, power = Fraction(match[1]), 0
    sign = 1
    for mark, name, exponent in re.findall(r"([*/]?)([A-Za-z%]+)(?:\^(\d+))?", match[2] or ""):
        sign = -1 if mark == "/" else 1
        n = sign * int(exponent or 1)
        value *= Fraction(UNITS.get(name) or PI_UNITS[name]) ** n
        power += n * (name in PI_UNITS)
    return f"_number({value.numerator},{value.denominator},{power})"


def read(text):
    """The syntax tree of an expression; x' becomes x__1, x'' x__2."""
    text = NUMBER.sub(_literal, str(text))
    text = re.sub(r"(\w)('+)", lambda m: f"{m[1]}__{len(m[2])}", text).replace("^", "**")
    return ast.parse(text.strip(), mode="eval").body


def names(tree):
    """The names in a tree, functions left out; kept on the tree."""
    if not hasattr(tree, "names"):
        called = {id(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call)}
        tree.names = [node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and id(node) not in called]
    return tree.names


def calls(tree, name):
    """The arguments of all calls of a function."""
    return [node.args for node in ast.walk(tree) if isinstance(node, ast.Call) and node.func.id == name]


def terms(tree, sign=1):
    """The summands of a sum: [(sign, tree)]."""
    if isinstance(tree, ast.BinOp) and isinstance(tree.op, ast.Add | ast.Sub):
        second = sign if isinstance(tree.op, ast.Add) else -sign
        return terms(tree.left, sign) + terms(tree.right, second)
    if isinstance(tree, ast.UnaryOp) and isinstance(tree.op, ast.USub):
        return terms(tree.operand, -sign)
    return [(sign, tree)]


def value(tree, known, number, functions=FUNCTIONS):
    """The value of a tree: `known` gives names, `number(numerator, denominator, power of pi)` literals."""
    if isinstance(tree, ast.Name):
        return number(1, 1, 1) if tree.id == "pi" and tree.id not in known else known[tree.id]
    if isinstance(tree, ast.UnaryOp):
        inner = value(tree.operand, known, number, functions)
        return -inner if isinstance(tree.op, ast.USub) else inner
    if isinstance(tree, ast.Call):
        if tree.func.id == "_number":
            return number(*(part.value for part in tree.args))
        return functions[tree.func.id](*(value(part, known, number, functions) for part in tree.args))
    left, right = value(tree.left, known, number, functions), value(tree.right, known, number, functions)
    kind = type(tree.op)
    if kind is ast.Add:
        return left + right
    if kind is ast.Sub:
        return left - right
    if kind is ast.Mult:
        return left * right
    if kind is ast.Div:
        return left / right
    right = jets.plain(right)
    return left ** (int(right) if right == int(right) else right)
